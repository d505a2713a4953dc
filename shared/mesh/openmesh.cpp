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

base::Result<OpenMeshTriangles> to_openmesh(std::span<const geom::Point3> points, std::span<const Corners> corners,
                                            std::span<const std::int32_t> regions) {
  OpenMeshTriangles triangles;
  OpenMesh::FPropHandleT<int> region;
  triangles.add_property(region, region_property);
  for (const geom::Point3 p : points) triangles.add_vertex(OpenMesh::Vec3d(p.x, p.y, p.z));
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const Corners& corner = corners[t];
    const auto vertex = [&](std::size_t i) { return OpenMesh::VertexHandle(static_cast<int>(corner[i].index())); };
    const auto face = triangles.add_face(vertex(0), vertex(1), vertex(2));
    if (!face.is_valid()) {
      const geom::Point3 at = points[corner[0].index()];
      base::Place place;
      place.item = fmt::format("triangle {}", t);
      place.x = at.x;
      place.y = at.y;
      if (at.z != 0.0) place.z = at.z;
      return base::Error{base::ErrorCode::CannotMesh,
                         "the mesh touches itself at a node, which OpenMesh cannot hold: separate the parts", place};
    }
    triangles.property(region, face) = regions[t];
  }
  return triangles;
}

base::Result<OpenMeshTriangles> to_openmesh(const TriangleMesh& mesh) {
  DOBRA_TRY_VOID(check(mesh));
  std::vector<geom::Point3> points;
  for (const geom::Point p : mesh.points) points.push_back({p.x, p.y, 0.0});
  return to_openmesh(points, mesh.triangles, mesh.regions);
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
