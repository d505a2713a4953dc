#pragma once
// Triangles that are right in the chart and look against the surface: on a steep flank that bends, a straight side of
// the chart leaves its chord in space by more than the triangle is high. Flips put the nodes on the side of such a side
// that they are on in space. Page: docs/algorithms/surface_front.md.

#include <vector>

#include "shared/base/progress.h"
#include "shared/surf/mesh/chart_space.h"

namespace dobra::surf::mesh {

/// Flips sides as long as the area that looks against the surface grows less by it. All triangles stay anticlockwise in
/// the chart.
/// @param rounds  at most; in each what is round the folded triangles is looked at
/// @return the nodes round the flips; none where nothing folds.
/// @error  Cancelled.
/// @cost   O(n) looks at the normals of the nodes, and a jet of the surface where these leave doubt
base::Result<std::vector<ChartSpace::Vertex>> unfold(ChartSpace::Kernel& kernel, ChartSpace& space, int rounds,
                                                     const base::Progress& progress);

}  // namespace dobra::surf::mesh
