#pragma once
// Gaps between the polygons of a section that reach its side: no ring closes them, so they are no face of their own.
// Page: docs/algorithms/units.md, "Open gaps".

#include <vector>

#include "recon/section/arrangement.h"
#include "recon/section/section_faces.h"

namespace recon::section {

/// What no polygon covers, with one polygon upright over it and another upright under it, or one on its left and
/// another on its right, and no topography that makes it air. What has rock on its left and right and on one more side
/// is a valley, and none, unless it is deeper than it is wide.
/// @param arrangement  of the polygons, numbered as the section's
/// @param holders      of its faces
/// @cost  O(n log n) for n edges of the outer boundary that stand upright over few others
std::vector<Misfit> open_gaps(const Section& section, const Arrangement& arrangement,
                              const std::vector<std::vector<std::uint32_t>>& holders);

}  // namespace recon::section
