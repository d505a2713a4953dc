#pragma once
// Fewer points for the same line, on the user's request only. Source: [douglas1973reduction].

#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace dobra::geom {

struct SimplifyOptions {
  double tolerance = 0.0;  ///< Greatest distance, m, of a dropped point from the segment that replaces it.
};

/// A subset of the points in the same order. An open chain keeps its ends; a closed contour is cut at its
/// lexicographically least point and the point farthest from it, so that the start vertex does not matter, and keeps at
/// least three points. The result of a simple polyline need not be simple: check it.
/// @error InvalidOption for a negative tolerance; what validate() finds.
/// @cost  O(n log n) for usual lines, O(n^2) at worst.
base::Result<Polyline> simplify(const Polyline& polyline, const SimplifyOptions& options);

/// Without points nearer than `least`, m, to the one before. An open chain keeps its ends.
Polyline without_near_points(Polyline polyline, double least);

}  // namespace dobra::geom
