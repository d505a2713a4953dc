#pragma once
// The curve of a monotone base (all its directions within an open half-plane) with arcs at its
// corners. Seen in that direction U is the region between two graphs, and the lower one is the lower envelope of the
// segments' stadia (all points within D of one segment). Taken in order any two stadia cross there once, the later one
// being lower after the crossing. Hence one pass with a stack gives the envelope exactly: a new stadium removes what
// lies in it from the tail. Every place on the stack is decided by one sign and computed from the same numbers, so that
// rounding cannot contradict it. Source: offset curves of monotone chains as lower envelopes of pseudo-lines,
// [agarwal2000davenport].

#include <optional>

#include "shared/offset/monotone/stadium_stack.h"

namespace dobra::offset::monotone {

/// A direction that all segments go along, if there is one. Exact. @cost O(n), once for all distances.
std::optional<geom::Vector> monotone_direction(const BaseCurve& base);

/// @param forward  monotone_direction(base).
/// @param left     see stack_stadia.
/// @return the curve; nothing if nothing of it is left; several pieces if mitres come out below the ends.
/// @pre    base open.
/// @cost   O(n + k log k), k = corners whose mitres are cut but come out below part of the curve.
std::vector<OffsetPiece> monotone_offset(const BaseCurve& base, geom::Vector forward, double distance,
                                         const OffsetOptions& options, StadiaLeft& left);

}  // namespace dobra::offset::monotone
