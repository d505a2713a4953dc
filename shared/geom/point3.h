#pragma once
// Points in space.

namespace dobra::geom {

/// Coordinates in m; x to the east, y to the north, z upwards.
struct Point3 {
  double x = 0.0, y = 0.0, z = 0.0;
  friend constexpr bool operator==(const Point3&, const Point3&) = default;
};

}  // namespace dobra::geom
