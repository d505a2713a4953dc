#pragma once
// Fewer nodes that have not six neighbours: sides are flipped where the triangles are better afterwards, once the nodes
// around have found their places. A flip alone makes most places worse at first; so nodes around are moved before it is
// judged. Page: docs/algorithms/surface_front.md.

#include <cstdint>
#include <span>
#include <vector>

#include "shared/base/progress.h"
#include "shared/surf/mesh/chart_space.h"

namespace dobra::surf::mesh {

struct TidyOptions {
  int rounds = 3;                   ///< Over all nodes that have not six neighbours.
  int sweeps = 3;                   ///< Of the nodes around, before a flip is judged.
  double least_gain = 0.005;        ///< Of the sum of all alphas around.
  std::uint32_t most_around = 600;  ///< Triangles of all nodes that a flip moves, each counted for each node.
  double spared = 0.8;              ///< No triangle comes below the worst that was there, or below this.
};

/// @param fixed  one flag a vertex: nodes that stay.
/// @return the nodes round flips that were kept.  @error Cancelled.  @cost O(n), and 10 us for each flip that is tried
base::Result<std::vector<ChartSpace::Vertex>> tidy(ChartSpace::Kernel& kernel, ChartSpace& space,
                                                   std::span<const std::uint8_t> fixed, const TidyOptions& options,
                                                   const base::Progress& progress);

}  // namespace dobra::surf::mesh
