#pragma once
// Fills what an advancing front has left: the sides that still stand are the edges of a constrained Delaunay
// triangulation, whose triangles between them get interior points and become part of the mesh. Where sides cross, the
// triangles behind them are taken away again, layer by layer, until none do. All tests are exact, so that it always
// ends: either the gaps are filled, or sides cross with nothing of the front behind them and that is said.
// Page: docs/algorithms/advancing_front.md.

#include "shared/mesh/front/advancing_front.h"

namespace dobra::mesh::front {

/// Fills the gaps of `front` in `kernel` and removes the cells that the front replaced: when done, the cells with
/// region >= 0 are the constrained Delaunay triangulation of the domain and the nodes of the front and of the gaps.
/// @error SelfIntersection if sides cross or enclose nothing, and no triangle of the front is behind them.
/// @cost  O(g log g) for g sides and triangles of the gaps; where sides cross, a few times as much.
std::unique_ptr<FillEngine> gap_filler(delaunay::DelaunayKernel& kernel, Front& front, const sizing::SizeField& field,
                                       const FrontalOptions& options);

}  // namespace dobra::mesh::front
