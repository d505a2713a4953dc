#pragma once
// The lines that part blocks, and the cells of the plane between them. Page: docs/algorithms/blocks.md

#include <vector>

#include "recon/faults/fault.h"
#include "recon/section/arrangement.h"
#include "shared/base/disjoint_sets.h"

namespace recon::faults {

/// Each fault as long as it reaches: an end at the border goes on straight, beyond the section or to the first other
/// fault; one that ends on another fault a little past that, whose course is rounded; a tip stays.
/// @param size  of the section, m.
std::vector<geom::Polyline> parting_lines(const std::vector<Fault>& faults, double size);

/// A rectangle round the section that all parting lines of ends at the border run out of.
geom::Polyline frame_of(const geom::Box& box, double size);

/// By face of an arrangement the cell that it belongs to: faces with an edge in common along which neither one of the
/// first `parting` lines nor the one after them, the frame, runs.
base::DisjointSets cells_of(const section::Arrangement& arrangement, std::size_t parting);

}  // namespace recon::faults
