#include "shared/mesh/front/smooth.h"

#include <gtest/gtest.h>

#include "shared/mesh/delaunay/delaunay.h"
#include "shared/mesh/front/triangulate.h"
#include "shared/mesh/mesh_check.h"
#include "shared/mesh/quality.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::front {
namespace {

/// A bad mesh with an inner constraint: random points in a square.
TriangleMesh random_mesh(std::uint64_t seed) {
  delaunay::MeshInput input = test::square(1.0, 8);
  add_chain(input, {{0.25, 0.25}, {0.5, 0.3}, {0.75, 0.7}}, delaunay::Closure::Open,
            {"line", delaunay::EdgeKind::Constraint});
  for (const geom::Point p : test::random_points(300, seed)) {
    input.points.push_back({0.02 + 0.96 * p.x, 0.02 + 0.96 * p.y});
  }
  return constrained_delaunay(input, delaunay::Outside::Remove).value().mesh;
}

TEST(Smooth, SUR_i_MeanAlphaDoesNotFallFromZeroToThreeToFivePasses) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const TriangleMesh start = random_mesh(seed);
    TriangleMesh three = start;
    TriangleMesh five = start;
    smooth(three, {.passes = 3});
    smooth(five, {.passes = 5});
    const double mean = quality_of(start).alpha_mean;
    EXPECT_GE(quality_of(three).alpha_mean, mean - 0.002);
    EXPECT_GE(quality_of(five).alpha_mean, quality_of(three).alpha_mean - 0.002);
    EXPECT_GT(quality_of(five).alpha_mean, mean + 0.02);
  }
}

TEST(Smooth, SUR_i_NoElementIsInvertedAndTheLeastAlphaDoesNotDrop) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    TriangleMesh mesh = random_mesh(seed);
    const double before = quality_of(mesh).alpha_min;
    for (int pass = 0; pass < 5; ++pass) {
      smooth(mesh, {.passes = 1, .phi = 1.0});
      EXPECT_TRUE(check(mesh));
      EXPECT_GE(quality_of(mesh).alpha_min, before);
    }
  }
}

TEST(Smooth, SUR_i_BoundaryAndConstraintNodesStay) {
  const TriangleMesh start = random_mesh(4);
  TriangleMesh mesh = start;
  EXPECT_GT(smooth(mesh), 0U);
  const auto fixed = fixed_nodes(start);
  for (std::size_t n = 0; n < fixed.size(); ++n) {
    if (fixed[n] == 0) continue;
    EXPECT_EQ(mesh.points[n], start.points[n]);
  }
  EXPECT_NEAR(area(mesh), area(start), 1e-13);
}

TEST(Smooth, SUR_i_PhiZeroLeavesTheMeshUnchanged) {
  const TriangleMesh start = random_mesh(5);
  TriangleMesh mesh = start;
  EXPECT_EQ(smooth(mesh, {.phi = 0.0}), 0U);
  EXPECT_EQ(mesh, start);
}

TEST(Smooth, RescueNeverLowersTheWorstAndRaisesTheShareOfGoodTrianglesOfAFairMesh) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    TriangleMesh mesh = random_mesh(seed);
    const double worst = quality_of(mesh).alpha_min;
    smooth(mesh, {.passes = 3, .phi = 0.0, .rescue = 0.9});
    EXPECT_TRUE(check(mesh));
    EXPECT_GE(quality_of(mesh).alpha_min, worst);
  }
  MeshOptions without;
  without.smoothing.rescue = 0.0;
  const delaunay::MeshInput input = test::quarter_plate(test::graded(1.0, 5.0, 44, 1.15), 785, 10, {});
  EXPECT_GT(quality_of(triangulate(input).value()).alpha_90,
            quality_of(triangulate(input, without).value()).alpha_90 + 0.01);
}

TEST(Smooth, TheMiddleNodeOfASquareGoesToTheMean) {
  delaunay::MeshInput input = test::square(1.0, 1);
  input.points.push_back({0.3, 0.6});
  TriangleMesh mesh = constrained_delaunay(input, delaunay::Outside::Remove).value().mesh;
  smooth(mesh, {.passes = 1, .phi = 1.0});
  EXPECT_NEAR(mesh.points[4].x, 0.5, 1e-15);
  EXPECT_NEAR(mesh.points[4].y, 0.5, 1e-15);
}

TEST(Smooth, FlipsRestoreTheDelaunayMeshAndKeepConstraintsAndRegions) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {2, -0.1}, {4, 0}, {2, 0.1}};
  mesh.triangles = {{NodeId(0), NodeId(1), NodeId(2)}, {NodeId(0), NodeId(2), NodeId(3)}};
  mesh.regions = {0, 0};
  TriangleMesh kept = mesh;
  kept.constraint_sets["c"] = {{NodeId(2), NodeId(0)}};
  TriangleMesh two_regions = mesh;
  two_regions.regions = {0, 1};
  EXPECT_EQ(flip_to_delaunay(mesh), 1U);
  EXPECT_TRUE(check(mesh));
  EXPECT_EQ(flip_to_delaunay(mesh), 0U);
  EXPECT_EQ(flip_to_delaunay(kept), 0U);
  EXPECT_EQ(flip_to_delaunay(two_regions), 0U);
}

}  // namespace
}  // namespace dobra::mesh::front
