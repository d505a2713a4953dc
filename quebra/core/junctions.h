#pragma once
// Where the curves of a domain meet: crossings and ends that lie on another curve become nodes of both. Crossings of
// straight pieces are exact; those with arcs and smooth curves are refined from their chords by Newton's method. Points
// that fall together (within the tolerance) are one, an end before a vertex before a computed crossing.

#include <vector>

#include "quebra/core/model.h"
#include "shared/base/result.h"

namespace quebra::core {

/// Fills domain.junctions. @pre ends that meet are equal.
/// @param places     one a curve.
/// @param tolerance  m; what is nearer is one point.
/// @error SelfIntersection with the place: boundary curves that meet away from their ends, curves that overlap, a curve
///        that crosses itself.
/// @cost  O(n log n + meetings) for n chords.
dobra::base::Result<void> find_junctions(Domain& domain, const std::vector<dobra::base::Place>& places, double tolerance);

}  // namespace quebra::core
