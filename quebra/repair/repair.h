#pragma once
// Finds what is wrong with drawn geometry, says where, and mends what can be mended without a guess: repeated and
// nearly repeated points, curves drawn twice, spikes, slivers, gaps between ends, boundaries that cross themselves or
// each other. Crossing boundaries are rebuilt on the planar subdivision: outlines are united, holes are cut out. Page:
// docs/algorithms/domain_repair.md.

#include <string>
#include <vector>

#include "quebra/sketch/finding.h"
#include "quebra/sketch/sketch.h"
#include "shared/base/result.h"

namespace quebra::repair {

struct Repaired {
  sketch::Sketch sketch;
  std::vector<sketch::Finding> findings;  ///< In the order in which they were mended.
};

/// Arcs, splines, cracks and internal lines are left as they are, but for gaps that a straight curve can close.
/// @error NotFinite; BadDomain for an outline that stays open (stray_lines.h).  @cost O(n log n + crossings) for n
/// points.
dobra::base::Result<Repaired> repair(sketch::Sketch sketch, const sketch::RepairOptions& options = {});

}  // namespace quebra::repair
