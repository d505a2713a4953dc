#pragma once
// Points with weights: what rational splines are sums of.

#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point3.h"
#include "shared/surf/spline_basis.h"

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

/// Bezier's control points of a part of a spline curve.
std::vector<Homogeneous> bezier_net(const SplineBasis& basis, const std::vector<Homogeneous>& points, double from,
                                    double to);

/// No second derivative of a rational Bezier patch on the unit square is longer, m.
struct NetBounds {
  double uu = 0.0, uv = 0.0, vv = 0.0;
  /// @param net  control points, those of a row (v) beside each other; one column for a curve.
  NetBounds(const std::vector<Homogeneous>& net, std::size_t count_u, std::size_t count_v);
};

}  // namespace dobra::surf
