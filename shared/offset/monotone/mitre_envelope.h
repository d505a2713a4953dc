#pragma once
// Second step of the monotone engine (envelope.h): mitres of corners whose arcs are not whole on the envelope of the
// stadia. A tip may come out below a stadium that hides the corner's arc, so these quads are looked at by themselves.
//  1  Mitre quads of arcs that are partly on the curve of the stadia are laid over it; where they are few, the lowest a
//  stretch. 2  Nearly all others are then above the whole curve within D of their corner, which takes one comparison to
//  tell,
//     or above the parts of the curve over which they stand. They are dropped.
//  3  The lower boundaries of what is left are merged by halves into their envelope, which is laid over the curve.

#include "shared/offset/monotone/stadium_stack.h"

namespace dobra::offset::monotone {

/// @param stacked  as stack_stadia made it; on return without cut corners, and if any of their mitres may be visible,
///                 ended by arcs: (point, arc of start_cap) may be first, (tip, arc of the last segment) is last, one
///                 point follows it.
/// @param left     what stack_stadia left: whose arcs may be on the curve.
/// @return         true if so.
/// @cost           O(n + k log k), k = corners cut whose mitres are below part of the curve.
bool add_cut_mitres(Stacked& stacked, const BaseCurve& base, geom::Vector forward, double distance,
                    const JoinRule& joins, const StadiaLeft& left);

}  // namespace dobra::offset::monotone
