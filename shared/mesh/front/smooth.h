#pragma once
// Better shapes without new nodes: moving nodes and flipping sides.
//   X0 <- X0 + phi * sum_i w_i (X_i - X0) / sum_i w_i,   w = 1 in the plane, i over the neighbours of the node.
// A move is kept only if the least alpha of the triangles round the node does not drop (halved steps are tried first),
// so that no element can be inverted. Nodes are moved one after the other, in order, because the guard looks at the
// neighbours where they are: two nodes moved at once could invert a triangle.
// Page: docs/algorithms/smooth.md. Source: [miranda2009surface].

#include <cstddef>
#include <span>

#include "shared/base/progress.h"
#include "shared/mesh/delaunay/delaunay_kernel.h"
#include "shared/mesh/triangle_mesh.h"

namespace dobra::mesh::front {

struct SmoothOptions {
  int passes = 3;       ///< Sweeps over all nodes; [miranda2009surface] finds 3 enough.
  double phi = 0.75;    ///< Step, 0 (nothing moves) to 1 (to the mean of the neighbours).
  double enough = 2.0;  ///< Nodes whose triangles all have at least this alpha stay; above 1 none does for that reason.
  /// Towards the mean of the places where each triangle of the star would be equilateral, by 1 / size, instead of that
  /// of the neighbours; kept if the sum of all alphas grows and none falls below the least one or `spared`.
  bool equilateral = false;
  double spared = 0.8;
  double least_step = 0.0;  ///< Nodes that are nearer to that place than this part of a side rest.
  int halvings = 2;         ///< How often a step that the guard refuses is halved before the node stays.
  /// Nodes with a triangle below this alpha are then moved towards where their triangles would be equilateral, the bad
  /// ones counting more: its gain may cost the others half as much. 0: never, equation 18 alone.
  double rescue = 0.0;
  double rescue_step = 0.25;  ///< How far, of the way.
};

/// Moves the nodes that are neither on the boundary nor in a set. The connectivity does not change.
/// @return how many moves were kept.  @cost O(passes * n)
/// @pre    0 <= phi <= 1
std::size_t smooth(TriangleMesh& mesh, const SmoothOptions& options = {});
/// The same with the nodes that must stay given: one flag a node. @pre every boundary node is among them.
std::size_t smooth(TriangleMesh& mesh, std::span<const std::uint8_t> fixed, const SmoothOptions& options);

/// Rounds of smoothing and flips in a kernel, where `triangulate` works. In later rounds only what has changed or is
/// not good enough is looked at.
/// @param fixed  0: to be moved, 1: stays, 2: rests until something round it moves or is flipped
/// @error Cancelled.  @pre one flag a vertex; the kernel is Delaunay.
base::Result<void> improve(delaunay::DelaunayKernel& kernel, std::span<const std::uint8_t> fixed,
                           const SmoothOptions& options, int rounds, const base::Progress& progress);

/// Flips sides until every one that is neither a boundary nor in an edge set is Delaunay (exactly); regions keep apart.
/// @return number of flips.  @cost O(n + flips)
std::size_t flip_to_delaunay(TriangleMesh& mesh);

}  // namespace dobra::mesh::front
