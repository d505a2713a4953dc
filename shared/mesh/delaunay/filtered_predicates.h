#pragma once
// The predicates of geom/predicates.h with their first stage inline: most signs of a triangulation are decided there,
// in a few nanoseconds; the others are asked of geom/predicates.h. The answers are the same, exact ones. Source:
// [shewchuk1997predicates].

#include <cmath>

#include "shared/geom/predicates.h"

namespace dobra::mesh::delaunay {

/// orient2d with an inline first stage.
inline geom::Sign filtered_orientation(geom::Point a, geom::Point b, geom::Point c) {
  constexpr double bound = 4.0 * 0x1p-53;
  constexpr double safe_sum = 0x1p-900;
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double sum = std::abs(left) + std::abs(right);
  // An overflow makes `sum` infinite or not a number, and then the comparison is false.
  if (sum > safe_sum && std::abs(left - right) > bound * sum) return geom::sign_of(left - right);
  return geom::orient2d(a, b, c);
}

/// incircle with an inline first stage.
inline geom::Sign filtered_incircle(geom::Point a, geom::Point b, geom::Point c, geom::Point d) {
  constexpr double bound = 16.0 * 0x1p-53;
  constexpr double safe_sum = 0x1p-700;
  const geom::Vector u = a - d;
  const geom::Vector v = b - d;
  const geom::Vector w = c - d;
  const double vw = v.x * w.y;
  const double wv = w.x * v.y;
  const double wu = w.x * u.y;
  const double uw = u.x * w.y;
  const double uv = u.x * v.y;
  const double vu = v.x * u.y;
  const double uu = u.x * u.x + u.y * u.y;
  const double vv = v.x * v.x + v.y * v.y;
  const double ww = w.x * w.x + w.y * w.y;
  const double determinant = uu * (vw - wv) + vv * (wu - uw) + ww * (uv - vu);
  const double permanent =
      uu * (std::abs(vw) + std::abs(wv)) + vv * (std::abs(wu) + std::abs(uw)) + ww * (std::abs(uv) + std::abs(vu));
  if (permanent > safe_sum && std::abs(determinant) > bound * permanent) return geom::sign_of(determinant);
  return geom::incircle(a, b, c, d);
}

}  // namespace dobra::mesh::delaunay
