#pragma once
// Meshes of faces become one mesh in space: nodes by their common numbers, cracks opened, sets and regions kept; and
// what can be said of such a mesh. Page: docs/algorithms/surface_border.md.

#include <array>
#include <span>
#include <vector>

#include "shared/base/angle.h"
#include "shared/base/result.h"
#include "shared/mesh/openmesh.h"
#include "shared/mesh/polygon_mesh.h"
#include "shared/surf/mesh/division.h"
#include "shared/surf/mesh/surface_mesh.h"

namespace dobra::surf::mesh {

/// What a mesher makes of a ChartInput.
struct FaceMesh {
  /// In the chart, anticlockwise; its first points are those of the input, in their order. Sets as in the input.
  dobra::mesh::TriangleMesh chart;
  std::vector<geom::Point3> at;  ///< One a point of `chart`: where it is in space; those of the input as given there.
};

/// Nodes of the division keep their numbers, those inside follow face by face. Triangles of which two corners are one
/// node (at a pole) are left out. A face with a name and without regions is a region of that name, numbered from above
/// the greatest that is given; triangles of other faces keep their tags. Sides of sets that two faces share are
/// internal, and stand in `constraint_sets`, once. Sets without a name are left out. Cracks are opened by the rule of
/// mesh::open_lips, tips are the node sets "NAME_start" and "NAME_end".
/// @param faces  one a face of the division.
/// @error CannotMesh: a mesh that does not begin with the points of its input; those of check and of open_lips.
/// @cost  O(n log n)
base::Result<SurfaceMesh> assemble(std::span<const trim::TrimmedSurface> surfaces, const Division& division,
                                   std::span<const FaceMesh> faces);

/// That, without a look at the mesh and without opening cracks: for those who mend it first.
/// @error CannotMesh: a mesh that does not begin with the points of its input
base::Result<SurfaceMesh> join(std::span<const trim::TrimmedSurface> surfaces, const Division& division,
                               std::span<const FaceMesh> faces);

/// @error CannotMesh or NotFinite with the place {x, y, z}: arrays that do not fit, corners that do not exist or are
///        not finite, a triangle without area, two on the same three nodes, a side that two triangles of one face use
///        in one direction, or two of two faces where there is no third, a set with a side that is none.
/// @cost  O(n log n)
base::Result<void> check(const SurfaceMesh& mesh);

struct SurfaceQuality {
  std::size_t nodes = 0;  ///< Of triangles.
  std::size_t triangles = 0;
  double area = 0.0;  ///< m2.
  double alpha_mean = 0.0;
  double alpha_90 = 0.0;  ///< Fraction of the triangles with alpha >= 0.90, 0..1.
  double alpha_min = 0.0;
  TriangleId worst;  ///< The triangle of alpha_min; none in an empty mesh.
  base::Angle angle_min, angle_max;
  double side_min = 0.0, side_max = 0.0;    ///< m.
  std::array<std::size_t, 20> histogram{};  ///< Triangles by alpha, bins of 0.05 from 0.
  /// Each counted once; the mesh is cut where three triangles and more share a side: one for each of them.
  std::size_t edges = 0, boundary_edges = 0;
  std::size_t components = 0, loops = 0;  ///< Parts joined through sides; closed contours of the boundary.
  std::int64_t euler = 0;                 ///< Umbrellas of nodes - edges + triangles.
  double deficit = 0.0;                   ///< Sum over nodes inside of 2 pi less the angles there.
  double turning = 0.0;                   ///< Sum over nodes of the boundary of pi less the angles, once an umbrella.
  /// |deficit + turning - 2 pi euler|: nought but for rounding on every mesh that is what it seems (Gauss and Bonnet).
  double gauss_bonnet = 0.0;
};

/// @pre check(mesh)  @cost O(n log n)
SurfaceQuality quality_of(const SurfaceMesh& mesh);

/// Faces in the order of the triangles; points that no triangle has stay.
dobra::mesh::PolygonMesh to_polygon_mesh(const SurfaceMesh& mesh);
/// @error CannotMesh where the mesh is not manifold.
base::Result<dobra::mesh::OpenMeshTriangles> to_openmesh(const SurfaceMesh& mesh);

}  // namespace dobra::surf::mesh
