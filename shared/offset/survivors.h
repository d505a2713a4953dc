#pragma once
// Tier 1, first half: which pieces of the raw outline may still belong to the curve.
// One pass with a stack. A piece, or a part of one, is removed only on proof that it lies in the pill (or mitre) of one segment:
// pills are convex, so both ends prove it. All proofs keep a margin well above rounding, so nothing valid or merely touching is
// ever removed; what is left over too much is found by the second half (sections.h).

#include <vector>

#include "shared/offset/outline.h"

namespace dobra::offset {

/// In the order of the walk. @cost O(n), some 50 ns a segment and side.
std::vector<Piece> survivors(const Outline& outline);

}  // namespace dobra::offset
