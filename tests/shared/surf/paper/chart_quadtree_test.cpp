#include "shared/surf/paper/chart_quadtree.h"

#include <algorithm>
#include <cmath>

#include "shared/surf/mesh/division.h"
#include "tests/shared/surf/mesh/faces.h"
#include "tests/support/surface_stand_ins.h"

namespace dobra::surf::paper {
namespace {

using geom::Box;
using geom::Point;
using mesh::ChartInput;
using mesh::test::flat;
using mesh::test::halved;
using mesh::test::pi;

ChartQuadtree tree_of(const ChartInput& input, const QuadtreeOptions& options) {
  auto tree = ChartQuadtree::build(input, options);
  EXPECT_TRUE(tree.ok()) << (tree ? "" : base::to_string(tree.error()));
  return *std::move(tree);
}

bool touch(const Box& a, const Box& b) {
  const double x = std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x);
  const double y = std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y);
  return (std::abs(x) < 1e-12 && y > 1e-12) || (std::abs(y) < 1e-12 && x > 1e-12);
}

void expect_balanced(const ChartQuadtree& tree) {
  const auto leaves = tree.leaves();
  for (const auto a : leaves) {
    for (const auto b : leaves) {
      if (!touch(tree.box(a), tree.box(b))) continue;
      const auto one = tree.cells()[a].level, two = tree.cells()[b].level;
      ASSERT_LE(std::max(one, two) - std::min(one, two), 1u);
    }
  }
}

TEST(ChartQuadtree, RefusesWhatMeansNothingAndWhatIsTooMuch) {
  const ChartInput input = halved({.surface = flat(10, 5)}, 1, 15);
  EXPECT_EQ(ChartQuadtree::build(input, {.largest = 0.0}).error().code, base::ErrorCode::InvalidOption);
  EXPECT_EQ(ChartQuadtree::build(input, {.largest = 1.0, .turn = -1.0}).error().code, base::ErrorCode::InvalidOption);
  EXPECT_EQ(ChartQuadtree::build(input, {.largest = 1e-6}).error().code, base::ErrorCode::TooManyElements);
  EXPECT_EQ(ChartQuadtree::build(input, {.largest = 1.0, .most_cells = 60}).error().code,
            base::ErrorCode::TooManyElements);
}

TEST(ChartQuadtree, SUR_c_TheFirstCellsAreAsManyAsTheMiddleLinesAreLong) {
  const ChartQuadtree tree = tree_of(halved({.surface = flat(10, 5)}, 0.5, 15), {.largest = 0.5});
  EXPECT_EQ(tree.first_cells(), (std::array<std::uint32_t, 2>{20, 10}));
}

TEST(ChartQuadtree, SUR_d_CurvatureDividesAQuarterCylinderTwice) {
  const trim::TrimmedSurface face{.surface = *Surface::cylinder({}, 1.0, {{0, 0}, {0.5 * pi, 2.0}})};
  const ChartQuadtree tree = tree_of(halved(face, 1, 10), {.largest = 1.0, .turn = 10.0, .nodes = false});
  EXPECT_EQ(tree.first_cells(), (std::array<std::uint32_t, 2>{2, 2}));
  EXPECT_EQ(tree.leaves().size(), 64u);
  for (const auto leaf : tree.leaves()) EXPECT_EQ(tree.cells()[leaf].level, 2u);
}

TEST(ChartQuadtree, SUR_e_LeavesOfTheCoonsSurfaceAreBalancedSmallAndHoldOneNode) {
  for (const auto& s : test::stand_ins()) {
    if (s.name != "6a" && s.name != "8f") continue;
    const ChartInput input = halved(s.face, s.largest, s.turn);
    const ChartQuadtree tree = tree_of(input, {.largest = s.largest, .turn = s.turn});
    expect_balanced(tree);
    EXPECT_TRUE(tree.crowded().empty());
    for (const auto leaf : tree.leaves()) {
      EXPECT_LE(tree.cells()[leaf].nodes.size(), 1u);
      const Box box = tree.box(leaf);
      const Point centre = box.centre();
      // By chords of eight pieces, not by the tree's two.
      const auto real = [&](Point a, Point b) {
        double sum = 0.0;
        for (int i = 0; i < 8; ++i) {
          sum += distance(input.surface.at(geom::interpolate(a, b, i / 8.0)),
                          input.surface.at(geom::interpolate(a, b, (i + 1) / 8.0)));
        }
        return sum;
      };
      const double along = real({box.low.x, centre.y}, {box.high.x, centre.y});
      const double across = real({centre.x, box.low.y}, {centre.x, box.high.y});
      EXPECT_LE(std::max(along, across), 1.01 * s.largest);
      EXPECT_NEAR(tree.cells()[leaf].size, 0.5 * (along + across), 0.01 * s.largest);
    }
  }
}

TEST(ChartQuadtree, SUR_e_TheCriticalCaseIsRuledByTheAngleAndBalanced) {
  // L = 3, A = 3 degrees on the Coons surface.
  const test::StandIn s = test::stand_ins()[0];
  const ChartInput input = halved(s.face, 3.0, 3.0);
  const ChartQuadtree tree = tree_of(input, {.largest = 3.0, .turn = 3.0});
  expect_balanced(tree);
  std::uint32_t deepest = 0;
  for (const auto leaf : tree.leaves()) deepest = std::max(deepest, tree.cells()[leaf].level);
  EXPECT_GE(deepest, 3u);
}

TEST(ChartQuadtree, NodesThatLieTogetherStopItAtItsDeepestLevelAndAreNamed) {
  trim::TrimmedSurface face{.surface = flat(10, 5)};
  face.points = {{.at = {5.0, 2.5}}, {.at = {5.0 + 1e-6, 2.5 + 1e-6}}};
  const ChartQuadtree tree = tree_of(halved(face, 1, 15), {.largest = 1.0});
  ASSERT_EQ(tree.crowded().size(), 1u);
  EXPECT_EQ(tree.cells()[tree.crowded()[0]].level, 12u);
}

TEST(ChartQuadtree, ASizeAskedForAtAPointIsFollowed) {
  trim::TrimmedSurface face{.surface = flat(10, 5)};
  face.points = {{.at = {5.1, 2.6}, .name = "", .size = 0.1}};
  const ChartQuadtree tree = tree_of(halved(face, 1, 15), {.largest = 1.0});
  EXPECT_LE(tree.size_at({5.1, 2.6}), 0.1);
  EXPECT_GE(tree.size_at({0.5, 2.5}), 0.4);
  expect_balanced(tree);
}

TEST(ChartQuadtree, AKinkDoesNotDivideCellsWithoutEnd) {
  const Curve bent = *Curve::nurbs(1, {0, 0, 0.5, 1, 1}, {{0, 0, 0}, {5, 0, 3}, {10, 0, 0}});
  const trim::TrimmedSurface face{.surface = *Surface::extruded(bent, {0, 10, 0})};
  const ChartQuadtree tree = tree_of(halved(face, 1, 10), {.largest = 1.0, .turn = 10.0});
  EXPECT_LT(tree.leaves().size(), 2000u);
}

TEST(ChartQuadtree, EveryPlaceHasTheLeafThatHoldsIt) {
  const test::StandIn s = test::stand_ins()[0];
  const ChartQuadtree tree = tree_of(halved(s.face, 1, 10), {.largest = 1.0, .turn = 10.0});
  for (int i = 0; i < 500; ++i) {
    const Point uv{std::fmod(0.123 + 0.6180339 * i, 1.0), std::fmod(0.456 + 0.7548776 * i, 1.0)};
    EXPECT_TRUE(tree.box(tree.leaf_at(uv)).grown(1e-9).contains(uv));
    bool found = false;
    Box around;
    around.add(uv);
    tree.for_leaves(around, [&](ChartQuadtree::CellIndex leaf) { found = found || leaf == tree.leaf_at(uv); });
    EXPECT_TRUE(found);
  }
}

}  // namespace
}  // namespace dobra::surf::paper
