#pragma once
// The area that closed rings enclose together, as polygons: unions, differences and mending, by the winding numbers of
// the faces into which the rings part the plane. Page: docs/algorithms/subdivision.md.

#include <span>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace dobra::topo {

/// What counts as inside, by the winding number of the rings: anticlockwise ones add one, clockwise ones take one away.
enum class Inside { Positive, Odd };

/// @param rings  closed; they may cross, touch and overlap themselves and each other.
/// @return       simple rings that do not cross: each contour anticlockwise, followed by its holes clockwise. Crossings
///               are rounded to doubles; what is no wider than that rounding is left out.
/// @error        NotFinite, DegenerateCurve (a ring of no length); Cancelled.
/// @cost         O((n + crossings) log n) for segments that are short against the whole.
base::Result<std::vector<geom::Polyline>> region(std::span<const geom::Polyline> rings, Inside inside,
                                                 const base::Progress& progress = {});

}  // namespace dobra::topo
