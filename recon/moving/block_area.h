#pragma once
// The part of the plane, far beyond the section, that faults part off with a block: every line of the block lies in it,
// though it runs along the border of the rock or over it.

#include <span>
#include <vector>

#include "recon/faults/fault.h"

namespace recon::moving {

/// @param inside  a point of every block.
/// @param moving  the fault that they move along, whose path may go on along others; null: none.
/// @return anticlockwise contours and clockwise holes, one or more a block; neighbours share their edges.
/// @error those of Arrangement.
base::Result<std::vector<geom::Polyline>> area_of_blocks(const section::Section& section,
                                                         const std::vector<faults::Fault>& faults,
                                                         const faults::Fault* moving,
                                                         std::span<const geom::Point> inside);

}  // namespace recon::moving
