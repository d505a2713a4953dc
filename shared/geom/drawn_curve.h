#pragma once
// Curves that a user draws by a few points, of the kinds of curve that this module has, as the polylines that
// everything else works on: one entry for all kinds, discretised by the one discretiser. Page:
// docs/algorithms/curves.md.

#include <span>

#include "shared/geom/bezier.h"
#include "shared/geom/cubic_path.h"
#include "shared/geom/discretise.h"

namespace dobra::geom {

enum class DrawnAs {
  Line,            ///< Straight from point to point.
  Hermite,         ///< Cubics between the points with the given tangents.
  Spline,          ///< The natural cubic spline through the points; closed if the last repeats the first.
  Bezier,          ///< One Bezier curve with the points as vertices.
  BSpline,         ///< The uniform cubic B-spline of the points, near them.
  RationalBezier,  ///< One Bezier curve with a weight for every vertex.
};

struct DrawnCurve {
  std::vector<Point> points;
  std::vector<Vector> tangents = {};  ///< Hermite: one a point, derivatives by the parameter of a piece, 0 to 1.
  std::vector<double> weights = {};   ///< RationalBezier: one a point, > 0.
};

/// The spline with chord-length knots through the points: natural, or closed if the last repeats the first.
/// @error DegenerateCurve for too few points or equal neighbours; NotFinite.
base::Result<CubicPath> spline_through(std::vector<Point> points);

/// @return an open chain, or a closed one where the curve ends at its beginning.
/// @error  InvalidOption: tangents or weights that the kind has not, or not one a point; DegenerateCurve: too few
///         points; those of discretise.
base::Result<Polyline> drawn(const DrawnCurve& curve, DrawnAs as, const DiscretiseOptions& options = {});

}  // namespace dobra::geom
