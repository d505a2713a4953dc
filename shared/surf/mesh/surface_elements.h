#pragma once
// Meshes of elements in space, for analysis and files: a mesh::ElementMesh that holds x and y of its nodes, and beside
// it their heights. Whatever asks only which node belongs to which element, side or set takes the ElementMesh as it is;
// a writer takes the heights as one argument more. Page: docs/algorithms/surface_border.md.

#include <span>
#include <vector>

#include "shared/base/result.h"
#include "shared/mesh/element_mesh.h"
#include "shared/mesh/recombine.h"
#include "shared/surf/mesh/division.h"
#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::mesh {

struct SurfaceElements {
  /// Its points are x and y alone, so mesh::check, areas and shapes of it say nothing here. It has no tips, whose
  /// directions are of a plane: the node sets "NAME_start" and "NAME_end" name them.
  dobra::mesh::ElementMesh mesh;
  std::vector<double> heights;       ///< z, m, one a node.
  std::vector<geom::Point> places;   ///< One an entry of mesh.nodes: where it lies in the chart of the element's face.
  std::vector<std::uint32_t> faces;  ///< One an element: which of the surfaces.

  [[nodiscard]] geom::Point3 point(NodeId node) const {
    return {mesh.points[node.index()].x, mesh.points[node.index()].y, heights[node.index()]};
  }
  friend bool operator==(const SurfaceElements&, const SurfaceElements&) = default;
};

/// A T3 a triangle; sets become side sets and node sets, of an internal edge the side on its left.
/// @pre check(mesh)  @cost O(n log n)
SurfaceElements elements_of(const SurfaceMesh& mesh);

/// T6 and Q8 of T3 and Q4. The mid-side node is the point of the surface next to the middle of the chord; that of a
/// side in `middles` the one there; that of a side of two faces lies on both.
/// @param surfaces  the ones that were meshed, in their order.
SurfaceElements to_second_order(const SurfaceElements& elements, std::span<const trim::TrimmedSurface> surfaces,
                                const Middles& middles = {});

/// Pairs of triangles of one face become quadrilaterals where shapes in space let them, as mesh::recombine does.
SurfaceElements recombine(const SurfaceElements& elements, const dobra::mesh::RecombineOptions& options = {});

/// An element as it looks at a right angle to its mean plane: a mesh of one element, x and y in that plane.
dobra::mesh::ElementMesh flattened(const SurfaceElements& elements, dobra::mesh::ElementId element);

/// @error CannotMesh or NotFinite with the place {x, y, z}: arrays that do not fit, nodes that do not exist, two
/// elements
///        on one side of an edge, an element that is flat, re-entrant or folded (by `flattened`: its Jacobian is not
///        positive everywhere).  @cost O(n log n)
base::Result<void> check(const SurfaceElements& elements);

}  // namespace dobra::surf::mesh
