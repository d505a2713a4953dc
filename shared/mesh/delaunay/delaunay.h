#pragma once
// Delaunay and constrained Delaunay triangulation of given points and edges; no point is added.
// Incremental insertion in a randomised Hilbert order, walks, Lawson flips, cavity retriangulation for the edges, all
// by exact predicates: the result is right for every finite input. Page: docs/algorithms/delaunay.md.

#include <span>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/mesh/delaunay/mesh_input.h"
#include "shared/mesh/delaunay/planar_domain.h"

namespace dobra::mesh::delaunay {

/// The Delaunay triangulation of the convex hull of `points`.
/// @param points n points, m; equal ones become one node.
/// @return       the mesh, and the node of each point.
/// @error        NotFinite; CannotMesh if all points lie on one line.
/// @cost         O(n log n) expected; about 1 us a point.
/// @source       [lawson1977], [amenta2003brio]
base::Result<ExtractedMesh> delaunay(std::span<const geom::Point> points, const base::Progress& progress = {});

/// The constrained Delaunay triangulation of a planar straight-line graph: every input edge is an edge of the mesh, or
/// a chain of edges where input points lie exactly on it, and every other edge has an empty circle as far as it can
/// see.
/// @param outside whether only what the boundary edges enclose is kept, or the whole convex hull.
/// @error         see build_domain (planar_domain.h)
/// @source        [anglada1997]
base::Result<ExtractedMesh> constrained_delaunay(const MeshInput& input, Outside outside,
                                                 const base::Progress& progress = {});

}  // namespace dobra::mesh::delaunay
