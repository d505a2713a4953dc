#pragma once
// Offset curves with their arcs: measured as they are, or drawn with chords.

#include "shared/offset/types/curve.h"

namespace dobra::offset {
inline namespace types {

/// A piece without arcs.
struct Chords {
  geom::Polyline polyline;
  std::vector<std::uint32_t> base_edge;  ///< For each segment the base segment that it belongs to, see OffsetEdge.
};

inline constexpr double default_arc_tolerance = 1e-3;

/// @param base       the curve that `piece` is parallel to, as it was given to offset().
/// @param tolerance  greatest distance of a chord from its arc, in D; above 0, at most 0.5.
Chords chords(const OffsetPiece& piece, const geom::Polyline& base, double tolerance = default_arc_tolerance);

/// m; arcs count in full.
double length(const OffsetPiece& piece, const geom::Polyline& base);

/// m2, positive if anticlockwise; arcs count in full. 0 if open.
double signed_area(const OffsetPiece& piece, const geom::Polyline& base);

}  // namespace types
}  // namespace dobra::offset
