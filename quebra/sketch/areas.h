#pragma once
// Neighbouring materials as they are drawn: polygons that share sides. A shared side becomes one internal line, the
// rest of the contours the boundary.  Page: docs/algorithms/domain_repair.md.

#include "quebra/sketch/sketch.h"

namespace quebra::sketch {

/// Fills `sketch.interfaces`. Cuts the closed straight rings of `sketch.areas` where they begin and cease to be shared
/// by two areas. Vertices nearer than `tolerance` to another area's side count as on it. Areas that lie in each other
/// along a side are left as they are.
/// @cost O(n log n) for n vertices
void part_shared_sides(Sketch& sketch, double tolerance);

}  // namespace quebra::sketch
