#pragma once
// Where in a region a map changes areas least and most: the extremes of det F - 1, not samples of them.
//   det F of a cell has no extreme inside the cell. In a column it is a ratio of functions of (fraction f, depth d),
//   each linear in d for one f and, for one d, in f; in a strip of a ruled band the ratio of two linear functions of
//   (u, v). So along one of the two directions it is monotone, and the extremes lie on the contour of the region, on
//   lines that rulings start from, or on the medial axis. Along a cell's side (rung, ruling) it is monotone too.
// Page: docs/algorithms/ledger.md

#include <optional>
#include <span>

#include "recon/maps/section_map.h"

namespace recon::maps {

/// Extremes of det F - 1, each with a place that has it (or comes as near to it as one likes, at the side of a cell).
struct AreaChange {
  double least = 0.0;
  double greatest = 0.0;
  geom::Point least_at;
  geom::Point greatest_at;
};

/// Counts a value at a place in.
void include(std::optional<AreaChange>& change, double value, geom::Point at);

/// In the region with the given contours, its holes among them.
/// @param contours  closed, the region on their left.
/// @param lines     lines that rulings start from: of a stack the horizons; what of them lies in the region counts.
/// @return nothing if no cell of the map lies along any of them.
/// @cost a trace of the contours, O(log n) or less a cell that they cross.
std::optional<AreaChange> area_change_in(std::span<const geom::Polyline> contours, const SectionMap& map,
                                         std::span<const geom::Polyline> lines = {});

/// In what lies between two horizons, of which the map says in which cells they lie: the same without looking for them.
/// A column map names the cell of every vertex of a line that it maps. Of two neighbours in a stack of lines the region
/// is made of strips, whose corners decide. Only what joins the ends is traced.
/// @param upper, lower  mapped by this map.
std::optional<AreaChange> area_change_between(const MappedLine& upper, const MappedLine& lower, const SectionMap& map);

}  // namespace recon::maps
