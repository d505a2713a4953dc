#pragma once
// From an input to the constrained Delaunay triangulation of its points and edges, with the cells told apart: outside
// and holes (region -1), inside (region >= 0). What delaunay.h returns as it is and triangulate.h refines.

#include <vector>

#include "shared/base/progress.h"
#include "shared/mesh/delaunay/delaunay_kernel.h"
#include "shared/mesh/delaunay/mesh_input.h"

namespace dobra::mesh::delaunay {

/// What becomes of the triangles outside the boundary edges.
enum class Outside {
  Remove,    ///< Only what the boundary encloses is kept; a boundary is needed.
  KeepHull,  ///< All triangles of the convex hull are kept, whatever the edges.
};

struct PlanarDomain {
  DelaunayKernel kernel;
  std::vector<DelaunayKernel::Vertex> vertex_of_point;  ///< One an input point; equal points share one.
  std::vector<std::size_t> chain_first;  ///< Edge i is the chain chain[chain_first[i]] .. chain[chain_first[i+1]-1].
  std::vector<DelaunayKernel::Vertex> chain;  ///< Empty for an edge whose ends are equal points.
};

/// @error NotFinite; InvalidOption (an edge refers to a point or set that does not exist); CannotMesh (fewer than three
///        points, all collinear, boundary not closed, nothing inside); SelfIntersection with the place where two edges
///        cross; OutsideDomain (an internal edge, point or seed outside).
/// @cost  O(n log n) expected, and O(k^2) for an edge that crosses k triangles.
base::Result<PlanarDomain> build_domain(const MeshInput& input, Outside outside, const base::Progress& progress);

/// A mesh out of a kernel, with the way back from input points.
struct ExtractedMesh {
  TriangleMesh mesh;
  std::vector<NodeId> node_of_point;   ///< One an input point; none if the point lies outside.
  std::vector<NodeId> node_of_vertex;  ///< One a vertex of the kernel; none of a vertex of no triangle.
};

/// The cells with region >= 0. Input points keep their order and come first; then the inserted ones, in order.
ExtractedMesh extract(const PlanarDomain& domain, const MeshInput& input);

}  // namespace dobra::mesh::delaunay
