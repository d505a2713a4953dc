#pragma once
// Curves of drawing files as chains of cubics.

#include <vector>

#include "shared/base/result.h"
#include "shared/geom/cubic_path.h"

namespace quebra::sketch {

/// centre + cos(t) u + sin(t) v, t from `start` over `sweep` radians; u and v are conjugate half axes.
struct EllipseArc {
  dobra::geom::Point centre;
  dobra::geom::Vector u;
  dobra::geom::Vector v;
  double start = 0.0;
  double sweep = 0.0;
};

/// Forty cubics a quarter: within 2e-9 of the greater radius. It begins and ends at the points given, which lie on it.
dobra::base::Result<dobra::geom::CubicPath> ellipse_arc(const EllipseArc& arc, dobra::geom::Point from,
                                                        dobra::geom::Point to);

/// A chain of cubic Beziers: points 0-3, 3-6, ...; a quadratic or a straight one is raised to a cubic.
/// @error DegenerateCurve if the number of points makes no such chain.
dobra::base::Result<dobra::geom::CubicPath> bezier(std::vector<dobra::geom::Point> points);

}  // namespace quebra::sketch
