#pragma once
// Borders that only cut a surface (seams of closed ones, lines between two charts of one face) are where the division
// put them; here their nodes are freed: they move where the triangles around are better, and sides of them are flipped,
// so that no seam is seen in the mesh. Page: docs/algorithms/free_borders.md.

#include <span>
#include <string>

#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::mesh {

struct FreeBorderOptions {
  int passes = 4;      ///< Over all nodes concerned.
  int rings = 2;       ///< Nodes so many sides away move too.
  double gain = 1e-3;  ///< Least gain in the worst alpha around, of a move or a flip.
};

/// Frees the sides of `set` among the constraints, and takes the set away. Nodes of the border, of other sets and of
/// several faces stay; so does a node at a pole. Places go on beyond a closed chart's end where a node has passed it.
/// @param surfaces  the charts of the mesh, in the order of its faces.
/// @param owner     one a chart: charts of one number are of one face.
/// @return how many moves and flips were kept.  @cost O(sides of the set), a few surface points each
std::size_t free_borders(SurfaceMesh& mesh, std::span<const trim::TrimmedSurface> surfaces,
                         std::span<const std::size_t> owner, const std::string& set,
                         const FreeBorderOptions& options = {});

}  // namespace dobra::surf::mesh
