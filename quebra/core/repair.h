#pragma once
// Finds what is wrong with drawn geometry, says where, and mends what can be mended without a guess: repeated and
// nearly repeated points, curves drawn twice, spikes, slivers, gaps between ends, boundaries that cross themselves or
// each other. Crossing boundaries are rebuilt on the planar subdivision: outlines are united, holes are cut out. Page:
// docs/algorithms/domain_repair.md.

#include <string>
#include <vector>

#include "quebra/core/domain.h"

namespace quebra::core {

/// The widest gap that is closed, m.  @param size  the drawing's diagonal, m
double gap_limit(const RepairOptions& options, double size);

const char* name_of(Wrong wrong);

struct Repaired {
  Sketch sketch;
  std::vector<Finding> findings;  ///< In the order in which they were mended.
};

/// Arcs, splines, cracks and internal lines are left as they are, but for gaps that a straight curve can close.
/// @error NotFinite; BadDomain for an outline that stays open (stray_lines.h).  @cost O(n log n + crossings) for n
/// points.
dobra::base::Result<Repaired> repair(Sketch sketch, const RepairOptions& options = {});

}  // namespace quebra::core
