#pragma once
// Where surfaces meet lines, planes and each other. Page: docs/algorithms/surface_search.md.

#include "shared/surf/surface.h"

namespace dobra::surf {

/// A point that a surface and a line share.
struct LineHit {
  double t = 0.0;  ///< Of the line: from + t * way.
  geom::Point uv;
  geom::Point3 at;
  bool tangent = false;  ///< The line touches the surface there and does not pass through it.
};

/// All points that a surface shares with a line through `from`, by t; each to 1e-12 of the size. A point on a border of
/// the chart has that border's parameter exactly; on a seam, it is told once, and so is a pole.
/// @param from_t, to_t  the part of the line that is asked for, ends included.
/// @error NotFinite; DegenerateCurve: no way; InvalidOption: the line lies in the surface, or so near to it that
///        no points can be told apart, with a place of it.
base::Result<std::vector<LineHit>> intersect_line(const Surface& surface, geom::Point3 from, geom::Vector3 way,
                                                  double from_t = -1e300, double to_t = 1e300);

}  // namespace dobra::surf
