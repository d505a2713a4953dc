#pragma once
// Second step of tier 0 (envelope.h): mitres of corners whose arcs are not whole on the pills' envelope. A tip may come out below
// a pill that hides the corner's arc, so these kites are looked at by themselves: those that lie in one pill are dropped, the
// others' lower boundaries reduced to their envelope by halving, and that is laid over the pills'.
// Everything is a graph over the forward axis: whatever rounding does, the result cannot cross itself.

#include "shared/offset/pill_stack.h"

namespace dobra::offset {

/// The arcs about the first and the last point of the base stand before and after the parts of a curve.
inline constexpr std::uint32_t start_cap = (1U << 31) - 1;

/// @param stacked  as stack_pills made it; on return without cut corners, and if any of their mitres is visible, ended by
///                 arcs: (point, arc of start_cap) may be first, (tip, arc of the last segment) is last, one point follows it.
/// @return         true if so.
/// @cost           O(n + k log k), k = corners cut that no single pill hides.
bool add_cut_mitres(Stacked& stacked, const BaseCurve& base, geom::Vector forward, double distance, const Filling& filling);

}  // namespace dobra::offset
