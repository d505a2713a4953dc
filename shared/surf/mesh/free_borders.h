#pragma once
// Takes borders out of a mesh that only the charts needed: the seam of a closed surface, the cut between two poles.
// Sides across them are flipped and nodes on them and near them are moved, so that nothing shows where they were. Page:
// docs/algorithms/free_borders.md. Source: [miranda2009surface] for smoothing on the surface.

#include <set>
#include <span>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/surface.h"

namespace dobra::surf::mesh {

struct FreeBorderOptions {
  int rounds = 6;      ///< Of flips and moves.
  int rings = 3;       ///< Nodes up to so many sides from an artificial border may move.
  double gain = 1e-3;  ///< A flip makes the least of six angles larger by this, radians; a move the measure of a star.
};

/// The sets `artificial` of `mesh.boundary_sets`, whose sides stand twice, once in each direction, are no border any
/// more: the sets go, and the mesh around them is improved. Nodes of other sets stay where they are, and sides of other
/// sets are not flipped. Every triangle looks to the side of its surface's normal at its corners before and after.
/// @param surfaces  one a face of the mesh, with the chart that `places` are in. A node that has moved over a seam has
///                  the places of that side: the corners of one triangle may then lie on both sides of the chart.
/// @return how many moves and flips were made.  @error Cancelled
/// @cost   O(n) for n triangles to find the neighbours, and a closest point for each move.
base::Result<std::size_t> free_borders(SurfaceMesh& mesh, std::span<const Surface> surfaces,
                                       const std::set<std::string>& artificial, const FreeBorderOptions& options = {},
                                       const base::Progress& progress = {});

}  // namespace dobra::surf::mesh
