#pragma once
// The new mesh, freed of its charts: nodes move on the old mesh to where the triangles round them are better, and sides
// are flipped, so that no line between charts is seen. Internal to remesh.h. Page: docs/algorithms/remesh.md.

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/param/sheet.h"
#include "shared/surf/remesh/triangle_tree.h"

namespace dobra::surf::remesh {

struct PolishOptions {
  int passes = 12;         ///< Over all nodes concerned, at most.
  double poor = 0.97;      ///< Nodes of triangles of a lesser alpha move, and their neighbours.
  double gain = 1e-3;      ///< Least gain in the least alpha around, or in the mean.
  double sharpest = 60.0;  ///< Degrees: no flip folds the mesh by more.
};

/// Nodes of the border and of sets stay, and sides of sets. The alpha of a triangle that faces against the old mesh
/// counts below nought, so folds are undone where they can be. Charts are left behind: all triangles are of one face,
/// and places are nought.
/// @param tree  of the points and triangles of `before`
/// @return the triangles that face against the old mesh  @error Cancelled  @cost O(n log n)
base::Result<std::vector<dobra::mesh::TriangleId>> polish(mesh::SurfaceMesh& mesh, const param::Sheet& before,
                                                          const TriangleTree& tree, const base::Progress& progress = {},
                                                          const PolishOptions& options = {});

}  // namespace dobra::surf::remesh
