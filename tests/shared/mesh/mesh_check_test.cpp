#include "shared/mesh/mesh_check.h"

#include <gtest/gtest.h>

#include <limits>

#include "shared/mesh/delaunay/delaunay.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh {
namespace {

TriangleMesh one_triangle() {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}};
  mesh.triangles = {{NodeId(0), NodeId(1), NodeId(2)}};
  mesh.regions = {0};
  return mesh;
}

TEST(MeshCheck, ATriangleHasOneLoopAndNoHole) {
  const TopologyCounts counts = topology_of(one_triangle());
  EXPECT_TRUE(check(one_triangle()));
  EXPECT_EQ(counts.loops, 1U);
  EXPECT_EQ(counts.components, 1U);
  EXPECT_EQ(counts.holes(), 0U);
  EXPECT_TRUE(counts.euler_holds());
}

TEST(MeshCheck, AFrameHasOneHole) {
  delaunay::MeshInput input = test::square(3.0, 3);
  add_chain(input, {{1, 1}, {2, 1}, {2, 2}, {1, 2}}, delaunay::Closure::Closed, {"hole", delaunay::EdgeKind::Boundary});
  const TriangleMesh mesh = constrained_delaunay(input, delaunay::Outside::Remove).value().mesh;
  EXPECT_TRUE(check(mesh));
  EXPECT_EQ(topology_of(mesh).holes(), 1U);
  EXPECT_DOUBLE_EQ(area(mesh), 8.0);
}

TEST(MeshCheck, TwoTrianglesThatTouchAtANodeAreTwoComponents) {
  TriangleMesh mesh = one_triangle();
  mesh.points.push_back({-1, 0});
  mesh.points.push_back({0, -1});
  mesh.triangles.push_back({NodeId(0), NodeId(3), NodeId(4)});
  mesh.regions.push_back(0);
  EXPECT_TRUE(check(mesh));
  EXPECT_EQ(topology_of(mesh).components, 2U);
  EXPECT_EQ(topology_of(mesh).umbrellas, 6U);
}

TEST(MeshCheck, NamesAnInvertedTriangleWithItsPlace) {
  TriangleMesh mesh = one_triangle();
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
  const auto result = check(mesh);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().place->item, "triangle 0");
}

TEST(MeshCheck, FindsTrianglesOneOnTopOfTheOther) {
  TriangleMesh mesh = one_triangle();
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.regions.push_back(0);
  EXPECT_FALSE(check(mesh));
}

TEST(MeshCheck, FindsNodesOutOfRangeNotFiniteAndSetsOfNoEdge) {
  TriangleMesh mesh = one_triangle();
  mesh.triangles[0][2] = NodeId(7);
  EXPECT_FALSE(check(mesh));
  mesh = one_triangle();
  mesh.points[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(check(mesh).error().code, base::ErrorCode::NotFinite);
  mesh = one_triangle();
  mesh.points.push_back({5, 5});
  mesh.constraint_sets["c"] = {{NodeId(0), NodeId(3)}};
  EXPECT_EQ(check(mesh).error().place->item, "edge set 'c'");
  mesh = one_triangle();
  mesh.regions.clear();
  EXPECT_FALSE(check(mesh));
}

}  // namespace
}  // namespace dobra::mesh
