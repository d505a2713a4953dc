#pragma once
// Where a part of a boundary model lies: an affine map of space.

#include "shared/geom/point3.h"

namespace dobra::io::brep {

/// Sends (a, b, c) to origin + a x + b y + c z: a motion, with a scale or a mirror where a file has one.
struct Placement {
  geom::Vector3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
  geom::Point3 origin{};

  friend bool operator==(const Placement&, const Placement&) = default;
  [[nodiscard]] geom::Vector3 of(geom::Vector3 v) const { return v.x * x + v.y * y + v.z * z; }
  [[nodiscard]] geom::Point3 of(geom::Point3 p) const { return origin + of(p - geom::Point3{}); }
  /// First b, then a.
  friend Placement operator*(const Placement& a, const Placement& b) {
    return {a.of(b.x), a.of(b.y), a.of(b.z), a.of(b.origin)};
  }
  /// The volume of the unit cube, negative for a mirror.
  [[nodiscard]] double scale_of_volume() const { return dot(x, cross(y, z)); }
  /// @pre scale_of_volume() != 0
  [[nodiscard]] Placement inverse() const {
    const double volume = scale_of_volume();
    const geom::Vector3 a = cross(y, z) / volume, b = cross(z, x) / volume, c = cross(x, y) / volume;  // rows
    Placement back{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}, {}};
    back.origin = back.origin - back.of(origin - geom::Point3{});
    return back;
  }
};

}  // namespace dobra::io::brep
