#pragma once
// Fills what an advancing front has left: the sides that still stand are the edges of a constrained Delaunay
// triangulation, whose triangles between them get interior points and become part of the mesh. Exact, so that it always
// ends: either the gaps are filled, or two sides cross and that is said. Page: docs/algorithms/advancing_front.md.

#include "shared/mesh/advancing_front.h"

namespace dobra::mesh {

/// Fills the gaps of `front` in `kernel` and removes the cells that the front replaced: afterwards the cells with
/// region >= 0 are the constrained Delaunay triangulation of the domain and the nodes of the front and of the gaps.
/// @error SelfIntersection if sides of the front cross or enclose nothing: `kernel` is then spoilt; TooManyElements;
///        Cancelled.
/// @cost  O(g log g) for g sides and triangles of the gaps.
base::Result<void> fill_gaps(DelaunayKernel& kernel, Front& front, const SizeField& field,
                             const FrontalOptions& options, const base::Progress& progress);

}  // namespace dobra::mesh
