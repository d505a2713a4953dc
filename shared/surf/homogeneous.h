#pragma once
// Points with weights: what rational splines are sums of.

#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point3.h"

namespace dobra::surf {

/// w times the point, and w.
struct Homogeneous {
  double x = 0.0, y = 0.0, z = 0.0, w = 0.0;
  friend constexpr Homogeneous operator*(double f, const Homogeneous& a) {
    return {f * a.x, f * a.y, f * a.z, f * a.w};
  }
  constexpr Homogeneous& operator+=(const Homogeneous& a) {
    x += a.x, y += a.y, z += a.z, w += a.w;
    return *this;
  }
  [[nodiscard]] constexpr geom::Point3 point() const { return {x / w, y / w, z / w}; }
  [[nodiscard]] constexpr geom::Vector3 vector() const { return {x, y, z}; }
};

constexpr geom::Vector3 from_origin(geom::Point3 p) { return {p.x, p.y, p.z}; }

/// Control points with their weights; all 1 where none are given.
/// @error InvalidOption: not `wanted` of them, a weight that is not positive; NotFinite. Counted from 1.
base::Result<std::vector<Homogeneous>> homogeneous(const std::vector<geom::Point3>& points, std::vector<double> weights,
                                                   std::size_t wanted);

/// Diagonal of the box of the points, m.
double extent(const std::vector<Homogeneous>& points);

}  // namespace dobra::surf
