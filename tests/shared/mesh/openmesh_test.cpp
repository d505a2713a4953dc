#include "shared/mesh/openmesh.h"

#include <gtest/gtest.h>

#include "shared/mesh/front/triangulate.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh {
namespace {

TEST(OpenMeshConversion, ThereAndBackGivesTheSamePointsTrianglesAndRegions) {
  delaunay::MeshInput input = test::que_d();
  input.regions.push_back({{3, 3}, 7});
  TriangleMesh mesh = front::triangulate(input).value();
  const OpenMeshTriangles there = to_openmesh(mesh).value();
  EXPECT_EQ(there.n_faces(), mesh.triangles.size());
  EXPECT_EQ(there.n_vertices(), mesh.points.size());
  const TriangleMesh back = from_openmesh(there).value();
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.regions, mesh.regions);
  EXPECT_DOUBLE_EQ(area(back), area(mesh));
  EXPECT_EQ(all_edges(back), all_edges(mesh));
}

TEST(OpenMeshConversion, ABrokenMeshIsRefused) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}};
  mesh.triangles = {{NodeId(0), NodeId(2), NodeId(1)}};
  mesh.regions = {0};
  EXPECT_FALSE(to_openmesh(mesh));
}

}  // namespace
}  // namespace dobra::mesh
