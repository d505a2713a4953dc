#pragma once
// Finds what is wrong with drawn geometry, says where, and mends what can be mended without a guess: repeated and nearly
// repeated points, curves drawn twice, spikes, slivers, gaps between ends, boundaries that cross themselves or each other. Crossing
// boundaries are rebuilt on the planar subdivision: outlines are united, holes are cut out.
// Page: docs/algorithms/domain_repair.md.

#include <string>
#include <vector>

#include "quebra/core/domain.h"

namespace quebra::core {

struct RepairOptions {
  double same_point = 1e-7;  ///< Points nearer than this fraction of the drawing's diagonal are one.
  double gap = 1e-3;         ///< Ends nearer than this fraction that meet nothing are joined.
  double spike = 0.01;       ///< Corners sharper than this are spikes, degrees.
};

const char* name_of(Wrong wrong);

struct Repaired {
  Sketch sketch;
  std::vector<Finding> findings;  ///< In the order in which they were mended.
};

/// Arcs, splines, cracks and internal lines are left as they are, but for gaps that a straight curve can close.
/// @error NotFinite.  @cost O(n log n + crossings) for n points.
dobra::base::Result<Repaired> repair(Sketch sketch, const RepairOptions& options = {});

}  // namespace quebra::core
