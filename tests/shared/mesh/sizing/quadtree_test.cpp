#include "shared/mesh/sizing/quadtree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/shared/mesh/mesh_shapes.h"

namespace dobra::mesh::sizing {
namespace {

using Direction = Quadtree::Direction;
constexpr std::array directions{Direction::Left, Direction::Right, Direction::Down, Direction::Up};

std::vector<SizedEdge> edges_of(const delaunay::MeshInput& input) {
  std::vector<SizedEdge> edges;
  for (const delaunay::InputEdge& edge : input.edges) {
    const bool boundary = input.sets[edge.set].kind == delaunay::EdgeKind::Boundary;
    edges.push_back({{input.points[edge.nodes[0].index()], input.points[edge.nodes[1].index()]},
                     boundary ? SizeRole::Boundary : SizeRole::Internal});
  }
  return edges;
}

void expect_invariants(const std::vector<SizedEdge>& edges, double factor) {
  const Quadtree tree = Quadtree::build(edges, {.refinement_factor = factor}).value();
  double covered = 0.0;
  double largest = 0.0;
  for (const QuadCellId leaf : tree.leaves()) {
    covered += tree.side(leaf) * tree.side(leaf);
    largest = std::max(largest, tree.side(leaf));
    for (const Direction direction : directions) {
      double along = 0.0;
      for (const QuadCellId other : tree.neighbours(leaf, direction)) {
        EXPECT_TRUE(tree.is_leaf(other));
        EXPECT_LE(std::abs(tree.cell(leaf).level - tree.cell(other).level), 1);
        along += tree.side(other);
      }
      EXPECT_TRUE(along == 0.0 || along >= tree.side(leaf));
    }
  }
  EXPECT_NEAR(covered, std::pow(tree.side(QuadCellId(0)), 2), 1e-12 * covered);
  double largest_at_boundary = 0.0;
  for (const SizedEdge& edge : edges) {
    const geom::Point middle = geom::midpoint(edge.segment.from, edge.segment.to);
    EXPECT_LT(tree.size_at(middle) * factor, edge.segment.length());
    if (edge.role == SizeRole::Boundary)
      largest_at_boundary = std::max(largest_at_boundary, edge.segment.length() / factor);
  }
  EXPECT_LE(largest, largest_at_boundary);
}

TEST(Quadtree, QUE_c_BalancedAndEachLeafNoLargerThanAskedOnTheQuarterPlates) {
  for (const double factor : {0.5, 1.0, 2.0}) {
    expect_invariants(edges_of(test::que_d()), factor);
    expect_invariants(edges_of(test::que_e()), factor);
  }
}

TEST(Quadtree, QUE_c_BalancedAndEachLeafNoLargerThanAskedOnTheContours) {
  if (test::contours_folder().empty()) GTEST_SKIP() << dobra::test::no_data;
  for (const auto& file : std::filesystem::directory_iterator(test::contours_folder())) {
    if (file.path().extension() != ".txt" && file.path().extension() != ".dat") continue;
    SCOPED_TRACE(file.path().filename().string());
    expect_invariants(edges_of(test::read_contour(file.path())), 1.0);
  }
}

TEST(Quadtree, AUniformSquareGetsUniformCells) {
  const Quadtree tree = Quadtree::build(edges_of(test::square(1.0, 5))).value();
  // Edges of 0.2: cells of 1/8 are the first below.
  EXPECT_EQ(tree.leaves().size(), 64U);
  EXPECT_DOUBLE_EQ(tree.size_at({0.5, 0.5}), 0.125);
}

TEST(Quadtree, AnEdgeTenThousandTimesSmallerGradesByTwoToOneWithFewCells) {
  std::vector<SizedEdge> edges = edges_of(test::square(1.0, 2));
  edges.push_back({{{0.5, 0.5}, {0.5 + 5e-5, 0.5}}, SizeRole::Internal});
  expect_invariants(edges, 1.0);
  EXPECT_LT(Quadtree::build(edges).value().cell_count(), 2000U);
}

TEST(Quadtree, PointsOutsideBelongToTheNearestLeaf) {
  const Quadtree tree = Quadtree::build(edges_of(test::square(1.0, 5))).value();
  EXPECT_EQ(tree.leaf_at({-3.0, 9.0}), tree.leaf_at({0.0, 0.9999}));
  EXPECT_TRUE(tree.neighbours(tree.leaf_at({-3.0, 0.5}), Direction::Left).empty());
}

TEST(Quadtree, RefusesAFactorOfZeroTooManyCellsAndNoLength) {
  const auto edges = edges_of(test::square(1.0, 64));
  EXPECT_EQ(Quadtree::build(edges, {.refinement_factor = 0.0}).error().code, base::ErrorCode::InvalidOption);
  EXPECT_EQ(Quadtree::build(edges, {.max_cells = 100}).error().code, base::ErrorCode::TooManyElements);
  EXPECT_EQ(Quadtree::build({}).error().code, base::ErrorCode::CannotMesh);
}

TEST(Quadtree, AnIndexedTreeFindsTheSameLeaves) {
  Quadtree tree({{0, 0}, {3, 2}});
  for (const geom::Point p : test::random_points(200, 3)) tree.refine_at({3.0 * p.x, 2.0 * p.y}, 0.3 * p.x * p.y, 1.0);
  Quadtree indexed = tree;
  indexed.index_leaves();
  for (const geom::Point p : test::random_points(2000, 4)) {
    const geom::Point at{4.0 * p.x - 0.5, 4.0 * p.y - 1.0};
    EXPECT_EQ(indexed.leaf_at(at), tree.leaf_at(at));
  }
  tree.refine_at({1.5, 1.0}, 1e-4, 1.0);
  indexed.refine_at({1.5, 1.0}, 1e-4, 1.0);
  EXPECT_EQ(indexed.leaf_at({1.5, 1.0}), tree.leaf_at({1.5, 1.0}));
}

}  // namespace
}  // namespace dobra::mesh::sizing
