#include "shared/mesh/delaunay/delaunay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "shared/geom/intersect.h"
#include "shared/geom/predicates.h"
#include "shared/mesh/mesh_check.h"
#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::delaunay {
namespace {

using base::ErrorCode;
using geom::Point;

std::set<Edge> constrained_edges(const TriangleMesh& mesh) {
  std::set<Edge> edges;
  for (const auto* sets : {&mesh.boundary_sets, &mesh.constraint_sets}) {
    for (const auto& [name, list] : *sets) {
      for (const Edge& edge : list) edges.insert({std::min(edge[0], edge[1]), std::max(edge[0], edge[1])});
    }
  }
  return edges;
}

/// Every edge that is not constrained has an empty circle, by the exact predicate; every constraint edge is an edge.
void expect_constrained_delaunay(const TriangleMesh& mesh) {
  const auto valid = check(mesh);
  ASSERT_TRUE(valid) << to_string(valid.error());
  const auto constrained = constrained_edges(mesh);
  const auto neighbours = neighbours_of(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners& corner = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const NodeId a = corner[i];
      const NodeId b = corner[(i + 1) % 3];
      if (!neighbours[t][i].valid() || constrained.count({std::min(a, b), std::max(a, b)}) != 0) continue;
      for (const NodeId apex : mesh.corners(neighbours[t][i])) {
        if (apex == a || apex == b) continue;
        EXPECT_NE(geom::incircle(mesh.point(corner[0]), mesh.point(corner[1]), mesh.point(corner[2]), mesh.point(apex)),
                  geom::Sign::Positive);
      }
    }
  }
}

double total_length(const TriangleMesh& mesh, const std::vector<Edge>& edges) {
  double sum = 0.0;
  for (const Edge& edge : edges) sum += geom::distance(mesh.point(edge[0]), mesh.point(edge[1]));
  return sum;
}

/// Up to `tries` random edges between the points that cross no earlier one.
void add_random_constraints(MeshInput& input, std::uint64_t seed, int tries) {
  std::mt19937_64 random(seed);
  input.sets.push_back({"constraints", EdgeKind::Constraint});
  const auto at = [&](NodeId node) { return input.points[node.index()]; };
  for (int k = 0; k < tries; ++k) {
    const NodeId a(random() % input.points.size());
    const NodeId b(random() % input.points.size());
    bool free = true;
    for (const InputEdge& edge : input.edges) {
      const auto meeting = geom::intersect({at(a), at(b)}, {at(edge.nodes[0]), at(edge.nodes[1])});
      free = free && !(meeting.kind == geom::IntersectionKind::Point && meeting.start.proper());
    }
    if (free) input.edges.push_back({{a, b}, static_cast<std::uint32_t>(input.sets.size() - 1)});
  }
}

TEST(Delaunay, QUE_b_FiveHundredRandomPointsWithConstraintsAreConstrainedDelaunay) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    MeshInput input;
    input.points = test::random_points(500, seed);
    for (const Point corner : {Point{0, 0}, Point{1, 0}, Point{1, 1}, Point{0, 1}}) input.points.push_back(corner);
    add_random_constraints(input, seed, 300);
    const TriangleMesh mesh = constrained_delaunay(input, Outside::KeepHull).value().mesh;
    expect_constrained_delaunay(mesh);
    // All constraints are present: the union of their mesh edges is as long as they are.
    double wanted = 0.0;
    for (const InputEdge& edge : input.edges) {
      wanted += geom::distance(input.points[edge.nodes[0].index()], input.points[edge.nodes[1].index()]);
    }
    EXPECT_GT(input.edges.size(), 30U);
    EXPECT_NEAR(total_length(mesh, mesh.constraint_sets.at("constraints")), wanted, 1e-12 * wanted);
    EXPECT_NEAR(area(mesh), 1.0, 1e-14);
    EXPECT_EQ(mesh.triangles.size(), 2 * mesh.points.size() - 2 - boundary_edges(mesh).size());
  }
}

TEST(Delaunay, QUE_b_HoldsOnGridsWhereEverythingIsCocircularAndConstraintsPassThroughPoints) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    std::mt19937_64 random(seed);
    const std::size_t side = 3 + random() % 8;
    const std::size_t count = 5 + random() % 60;
    MeshInput input;
    for (const Point corner : {Point{0, 0}, Point{1, 0}, Point{0, 1}}) input.points.push_back(corner);
    for (std::size_t i = 0; i < count; ++i) {
      const auto x = static_cast<double>(random() % side);
      input.points.push_back({x, static_cast<double>(random() % side)});
    }
    add_random_constraints(input, seed, 40);
    SCOPED_TRACE(seed);
    expect_constrained_delaunay(constrained_delaunay(input, Outside::KeepHull).value().mesh);
  }
}

TEST(Delaunay, ConstraintIntoATangleOfOtherConstraintsKeepsThemAll) {
  // Spikes hang from both sides into the cavity of the long edge.
  MeshInput input;
  input.sets.push_back({"c", EdgeKind::Constraint});
  input.points = {{0, 0}, {20, 0}};
  for (int i = 1; i < 20; ++i) {
    const double height = i % 2 == 0 ? 1e-3 : 2e-3;
    input.points.push_back({double(i), 5.0 + (i % 3)});
    input.points.push_back({double(i), height});
    input.points.push_back({double(i) + 0.5, -height});
    input.points.push_back({double(i) + 0.5, -5.0 - (i % 4)});
  }
  for (std::size_t p = 2; p + 1 < input.points.size(); p += 2) input.edges.push_back({{NodeId(p), NodeId(p + 1)}, 0});
  input.edges.push_back({{NodeId(0), NodeId(1)}, 0});
  const TriangleMesh mesh = constrained_delaunay(input, Outside::KeepHull).value().mesh;
  expect_constrained_delaunay(mesh);
  EXPECT_EQ(mesh.constraint_sets.at("c").size(), input.edges.size());
}

TEST(Delaunay, AConstraintThroughAVertexIsSplitThereExactly) {
  MeshInput input;
  input.points = {{0, 0}, {3, 3}, {1, 1}, {3, 0}, {0, 3}};
  input.sets.push_back({"diagonal", EdgeKind::Constraint});
  input.edges.push_back({{NodeId(0), NodeId(1)}, 0});
  const TriangleMesh mesh = constrained_delaunay(input, Outside::KeepHull).value().mesh;
  EXPECT_THAT(mesh.constraint_sets.at("diagonal"),
              testing::ElementsAre(Edge{NodeId(0), NodeId(2)}, Edge{NodeId(2), NodeId(1)}));
}

TEST(Delaunay, CrossingConstraintsAreReportedWithThePlace) {
  MeshInput input;
  input.points = {{0, 0}, {2, 2}, {0, 2}, {2, 0}};
  input.sets.push_back({"cross", EdgeKind::Constraint});
  input.edges = {{{NodeId(0), NodeId(1)}, 0}, {{NodeId(2), NodeId(3)}, 0}};
  const auto result = constrained_delaunay(input, Outside::KeepHull);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::SelfIntersection);
  EXPECT_EQ(result.error().place->x, 1.0);
  EXPECT_EQ(result.error().place->y, 1.0);
}

TEST(Delaunay, EqualPointsBecomeOneNode) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}, {1, 0}, {0, 0}};
  const ExtractedMesh result = delaunay(points).value();
  EXPECT_EQ(result.mesh.points.size(), 3U);
  EXPECT_EQ(result.node_of_point[1], result.node_of_point[3]);
  EXPECT_EQ(result.node_of_point[0], result.node_of_point[4]);
}

TEST(Delaunay, CollinearFewOrInfinitePointsAreNamedErrors) {
  EXPECT_EQ(delaunay({}).error().code, ErrorCode::CannotMesh);
  const std::vector<Point> line{{0, 0}, {1, 1}, {2, 2}, {3, 3}};
  EXPECT_EQ(delaunay(line).error().code, ErrorCode::CannotMesh);
  const std::vector<Point> infinite{{0, 0}, {1, 0}, {0, std::numeric_limits<double>::infinity()}};
  EXPECT_EQ(delaunay(infinite).error().code, ErrorCode::NotFinite);
}

TEST(Delaunay, ParityTellsHolesAndIslandsApart) {
  MeshInput input = test::square(5.0, 1);
  add_chain(input, {{1, 1}, {1, 4}, {4, 4}, {4, 1}}, Closure::Closed, {"hole", EdgeKind::Boundary});
  add_chain(input, {{2, 2}, {3, 2}, {3, 3}, {2, 3}}, Closure::Closed, {"island", EdgeKind::Boundary});
  const TriangleMesh mesh = constrained_delaunay(input, Outside::Remove).value().mesh;
  EXPECT_DOUBLE_EQ(area(mesh), 25.0 - 9.0 + 1.0);
  EXPECT_EQ(topology_of(mesh).components, 2U);
  EXPECT_EQ(topology_of(mesh).holes(), 1U);
  EXPECT_DOUBLE_EQ(test::boundary_area(mesh), 17.0);
}

TEST(Delaunay, SeedsMarkRegionsUpToInterfacesAndOpenHoles) {
  MeshInput input = test::square(4.0, 1);
  add_chain(input, {{2, 0}, {2, 4}}, Closure::Open, {"interface", EdgeKind::Interface});
  add_chain(input, {{0, 2}, {2, 2}}, Closure::Open, {"constraint", EdgeKind::Constraint});
  input.regions.push_back({{1, 1}, 5});
  const TriangleMesh mesh = constrained_delaunay(input, Outside::Remove).value().mesh;
  double left = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    left += mesh.regions[t] == 5 ? area(mesh, TriangleId(t)) : 0.0;
  EXPECT_DOUBLE_EQ(left, 8.0);
  add_chain(input, {{3, 1}, {3.5, 1}, {3.5, 2}, {3, 2}}, Closure::Closed, {"window", EdgeKind::Interface});
  EXPECT_DOUBLE_EQ(area(constrained_delaunay(input, Outside::Remove).value().mesh), 16.0);
  input.holes.push_back({3.25, 1.5});
  EXPECT_DOUBLE_EQ(area(constrained_delaunay(input, Outside::Remove).value().mesh), 15.5);
}

TEST(Delaunay, WhatLiesOutsideIsNamed) {
  MeshInput input = test::square(1.0, 1);
  add_chain(input, {{2, 0}, {3, 1}}, Closure::Open, {"far", EdgeKind::Constraint});
  EXPECT_EQ(constrained_delaunay(input, Outside::Remove).error().code, ErrorCode::OutsideDomain);
  input = test::square(1.0, 1);
  input.regions.push_back({{4, 4}, 1});
  EXPECT_EQ(constrained_delaunay(input, Outside::Remove).error().code, ErrorCode::OutsideDomain);
  input = test::square(1.0, 1);
  input.edges.pop_back();
  const auto open = constrained_delaunay(input, Outside::Remove);
  EXPECT_EQ(open.error().code, ErrorCode::CannotMesh);
  EXPECT_TRUE(open.error().place->x.has_value());
  input = test::square(1.0, 1);
  input.edges[0].set = 9;
  EXPECT_EQ(constrained_delaunay(input, Outside::Remove).error().code, ErrorCode::InvalidOption);
}

TEST(Delaunay, CancelEndsIt) {
  base::CancelToken token;
  token.cancel();
  const auto points = test::random_points(100, 1);
  EXPECT_EQ(delaunay(points, base::Progress(token, nullptr)).error().code, ErrorCode::Cancelled);
}

}  // namespace
}  // namespace dobra::mesh::delaunay
