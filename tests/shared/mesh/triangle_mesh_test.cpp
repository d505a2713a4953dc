#include "shared/mesh/triangle_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shared/mesh/delaunay/delaunay.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh {
namespace {

/// The unit square cut along the diagonal 0-2.
TriangleMesh two_triangles() {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{NodeId(0), NodeId(1), NodeId(2)}, {NodeId(0), NodeId(2), NodeId(3)}};
  mesh.regions = {0, 0};
  return mesh;
}

TEST(TriangleMesh, AreaIsTheSumOfSignedAreas) {
  const TriangleMesh mesh = two_triangles();
  EXPECT_DOUBLE_EQ(area(mesh, TriangleId(0)), 0.5);
  EXPECT_DOUBLE_EQ(area(mesh), 1.0);
}

TEST(TriangleMesh, NeighboursMeetAcrossTheDiagonalOnly) {
  const auto neighbours = neighbours_of(two_triangles());
  EXPECT_EQ(neighbours[0][2], TriangleId(1));
  EXPECT_EQ(neighbours[1][0], TriangleId(0));
  EXPECT_FALSE(neighbours[0][0].valid() || neighbours[0][1].valid() || neighbours[1][1].valid());
}

TEST(TriangleMesh, FiveEdgesFourOfThemOnTheBoundaryWithTheDomainOnTheirLeft) {
  const TriangleMesh mesh = two_triangles();
  EXPECT_EQ(all_edges(mesh).size(), 5U);
  EXPECT_THAT(boundary_edges(mesh),
              testing::UnorderedElementsAre(Edge{NodeId(0), NodeId(1)}, Edge{NodeId(1), NodeId(2)},
                                            Edge{NodeId(2), NodeId(3)}, Edge{NodeId(3), NodeId(0)}));
}

TEST(TriangleMesh, StarsListEachTriangleAtItsThreeNodes) {
  const NodeStars stars = stars_of(two_triangles());
  EXPECT_EQ(stars.triangles.size(), 6U);
  EXPECT_EQ(stars.first[1] - stars.first[0], 2U);
  EXPECT_EQ(stars.first[2] - stars.first[1], 1U);
}

TEST(TriangleMesh, NodesOfTheBoundaryAndOfSetsAreFixed) {
  delaunay::MeshInput input = test::square(1.0, 1);
  input.points.push_back({0.4, 0.5});
  input.points.push_back({0.6, 0.5});
  TriangleMesh mesh = constrained_delaunay(input, delaunay::Outside::Remove).value().mesh;
  EXPECT_THAT(fixed_nodes(mesh), testing::ElementsAre(1, 1, 1, 1, 0, 0));
  mesh.node_sets["kept"] = {NodeId(5)};
  EXPECT_THAT(fixed_nodes(mesh), testing::ElementsAre(1, 1, 1, 1, 0, 1));
}

}  // namespace
}  // namespace dobra::mesh
