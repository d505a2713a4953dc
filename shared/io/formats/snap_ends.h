#pragma once
// Ends of lines that stop beside the line that they abut: on which place of it they belong.
// Page: docs/algorithms/repair.md.

#include <vector>

#include "shared/io/formats/repair.h"

namespace dobra::io::formats {

struct SnappedEnd {
  std::size_t feature = 0;
  std::size_t onto = 0;  ///< The feature that it ends on now.
  geom::Point at;        ///< Where; a vertex of both.
  double moved = 0.0;    ///< m
};

/// Moves ends nearer than `options.snap` to a line that they may be moved onto, each by less than that; what overshoots
/// it by less is cut off. The nearest line comes first; with `options.first_crossing` one that the line crosses before
/// its end, of several the first. An end stays where it is if its line would turn back, or would cross itself or
/// another line that it did not cross. The order of the features does not matter.
/// @pre  options.snap > 0; no heights.
/// @cost O(n log n) for n sides.
std::vector<SnappedEnd> snap_ends(std::vector<lines::Feature>& features, const RepairOptions& options);

}  // namespace dobra::io::formats
