// OpenMesh grows its arrays by vectors that it leaves uninitialised on purpose; g++ says so where it inlines them.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

#include "shared/mesh/openmesh.h"

#include <fmt/format.h>

#include "shared/mesh/mesh_check.h"

namespace dobra::mesh {

namespace {

constexpr const char* region_property = "region";

}  // namespace

base::Result<OpenMeshTriangles> to_openmesh(const TriangleMesh& mesh) {
  DOBRA_TRY_VOID(check(mesh));
  OpenMeshTriangles triangles;
  OpenMesh::FPropHandleT<int> region;
  triangles.add_property(region, region_property);
  for (const geom::Point p : mesh.points) triangles.add_vertex(OpenMesh::Vec3d(p.x, p.y, 0.0));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners& corner = mesh.triangles[t];
    const auto vertex = [&](std::size_t i) { return OpenMesh::VertexHandle(static_cast<int>(corner[i].index())); };
    const auto face = triangles.add_face(vertex(0), vertex(1), vertex(2));
    if (!face.is_valid()) {
      base::Place place;
      place.item = fmt::format("triangle {}", t);
      place.x = mesh.point(corner[0]).x;
      place.y = mesh.point(corner[0]).y;
      return base::Error{base::ErrorCode::CannotMesh,
                         "the mesh touches itself at a node, which OpenMesh cannot hold: separate the parts", place};
    }
    triangles.property(region, face) = mesh.regions[t];
  }
  return triangles;
}

base::Result<TriangleMesh> from_openmesh(const OpenMeshTriangles& triangles) {
  TriangleMesh mesh;
  OpenMesh::FPropHandleT<int> region;
  const bool has_regions = triangles.get_property_handle(region, region_property);
  for (const auto vertex : triangles.all_vertices()) {
    mesh.points.push_back({triangles.point(vertex)[0], triangles.point(vertex)[1]});
  }
  for (const auto face : triangles.faces()) {
    Corners corners;
    std::size_t i = 0;
    for (const auto vertex : face.vertices()) corners[i++] = NodeId(static_cast<std::size_t>(vertex.idx()));
    mesh.triangles.push_back(corners);
    mesh.regions.push_back(has_regions ? triangles.property(region, face) : 0);
  }
  DOBRA_TRY_VOID(check(mesh));
  return mesh;
}

}  // namespace dobra::mesh
