// Octrees and voxels: what must be told as unknown first; then counts of leaves and volumes from formulas.

#include "shared/solid/partition/octree.h"

#include <gmock/gmock.h>

#include <random>

#include "tests/shared/solid/shapes.h"

namespace dobra::solid::partition {
namespace {

using base::ErrorCode;
using geom::Point3;
using shapes::box_solid;

constexpr Box<3> unit{{0, 0, 0}, {1, 1, 1}};

Octree octree(const Solid& solid, int depth, const Box<3>& box = unit) { return octree_of(solid, box, depth).value(); }

Solid ball(double radius, Point3 centre = {}) { return shapes::solid(shapes::sphere(centre, radius, 12, 24)); }

TEST(Octree, WhatIsNoTreeIsRefused) {
  const Solid cube = box_solid({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(octree_of(cube, unit, -1).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(octree_of(cube, unit, 13).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(octree_of(cube, {{0, 0, 0}, {1, 0, 1}}, 3).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(voxels_of(cube, {{0, 0, 0}, {1, 0, 1}, {2, 2, 2}}).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(voxels_of(cube, {{0, 0, 0}, {1, 1, 1}, {2, 0, 2}}).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(voxels_of(cube, {{0, 0, NAN}, {1, 1, 1}, {2, 2, 2}}).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(voxels_of(cube, {{0, 0, 0}, {1, 1, 1}, {65535, 65535, 65535}}).error().code, ErrorCode::TooManyElements);
  EXPECT_EQ(octree(Solid(), 4).volume().high, 0.0);
}

TEST(Octree, REP_a_BoxesHaveTheLeavesOfTheNotes) {
  const Octree half = octree(box_solid({0, 0, 0}, {0.5, 0.5, 0.5}), 6);
  EXPECT_EQ(half.leaves().size(), 8U);
  EXPECT_EQ(half.count(Fill::Full), 1U);
  EXPECT_EQ(half.count(Fill::Partial), 0U);
  EXPECT_EQ(half.volume().low, 0.125);
  EXPECT_EQ(half.volume().high, 0.125);
  const Octree quarter = octree(box_solid({0, 0, 0}, {0.25, 0.25, 0.25}), 6);
  EXPECT_EQ(quarter.leaves().size(), 15U);
  EXPECT_EQ(quarter.count(Fill::Full), 1U);
  EXPECT_EQ(quarter.volume().low, 1.0 / 64.0);
  // The whole box and nothing are one leaf each.
  EXPECT_EQ(octree(box_solid({0, 0, 0}, {1, 1, 1}), 6).leaves().size(), 1U);
  EXPECT_EQ(octree(box_solid({2, 0, 0}, {3, 1, 1}), 6).leaves().size(), 1U);
}

TEST(Octree, REP_a_VoxelsOfHalfTheSizeAreEightTimesAsMany) {
  const Solid block = box_solid({0, 0, 0}, {0.5, 0.75, 0.25});
  std::size_t before = 0;
  for (std::uint32_t n = 4; n <= 16; n *= 2) {
    const double edge = 1.0 / n;
    const auto fills = voxels_of(block, {{0, 0, 0}, {edge, edge, edge}, {n, n, n}}).value();
    const auto full = static_cast<std::size_t>(std::count(fills.begin(), fills.end(), Fill::Full));
    EXPECT_EQ(std::count(fills.begin(), fills.end(), Fill::Partial), 0);
    EXPECT_EQ(full, std::size_t{n} * n * n * 3 / 32);
    if (before != 0) {
      EXPECT_EQ(full, 8 * before);
    }
    before = full;
  }
}

/// Leaves that touch, by all pairs.
template <std::size_t D>
std::size_t touching(const Orthtree<D>& tree, typename Orthtree<D>::Node n) {
  const Box<D> own = tree.box(n);
  std::size_t count = 0;
  for (const auto m : tree.leaves()) {
    const Box<D> other = tree.box(m);
    bool touches = m != n;
    for (std::size_t k = 0; k < D; ++k) touches = touches && own.low[k] <= other.high[k] && other.low[k] <= own.high[k];
    count += touches ? 1 : 0;
  }
  return count;
}

TEST(Octree, REP_a_InnerCellsHaveTwentySixNeighboursAndEightInThePlane) {
  const auto chequered = [](const auto& at) {
    std::uint32_t sum = 0;
    for (const std::uint32_t i : at) sum += i;
    return sum % 2 == 0 ? Fill::Full : Fill::Empty;
  };
  const Octree space = Octree::from_bottom(unit, 2, chequered);
  ASSERT_EQ(space.leaves().size(), 64U);
  EXPECT_EQ(space.neighbours(space.leaf_at({0.3, 0.3, 0.3})).size(), 26U);
  EXPECT_EQ(space.neighbours(space.leaf_at({0.1, 0.1, 0.1})).size(), 7U);
  const Quadtree plane = Quadtree::from_bottom({{0, 0}, {1, 1}}, 2, chequered);
  EXPECT_EQ(plane.neighbours(plane.leaf_at({0.3, 0.3})).size(), 8U);
  EXPECT_EQ(plane.neighbours(plane.leaf_at({0.1, 0.3})).size(), 5U);
  // In a tree with leaves of many sizes, against all pairs.
  const Octree tree = octree(ball(0.4, {0.5, 0.4, 0.6}), 4);
  for (const auto n : tree.leaves()) EXPECT_EQ(tree.neighbours(n).size(), touching(tree, n));
}

TEST(Octree, BottomUpIsTopDown) {
  const Solid solid = ball(0.4, {0.5, 0.4, 0.6});
  const Octree top = octree(solid, 4);
  const VoxelGrid grid{{0, 0, 0}, {1.0 / 16, 1.0 / 16, 1.0 / 16}, {16, 16, 16}};
  const auto fills = voxels_of(solid, grid).value();
  const Octree bottom = Octree::from_bottom(
      unit, 4, [&](const std::array<std::uint32_t, 3>& at) { return fills[(at[2] * 16 + at[1]) * 16 + at[0]]; });
  EXPECT_TRUE(top == bottom);
  EXPECT_FALSE(top == octree(solid, 3));
  const Bounds bounds = volume(grid, fills);
  EXPECT_DOUBLE_EQ(bounds.low, top.volume().low);
  EXPECT_DOUBLE_EQ(bounds.high, top.volume().high);
}

TEST(Octree, BoundsHoldTheVolumeAndCloseIn) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(0.3, 0.7);
  for (int trial = 0; trial < 5; ++trial) {
    const Solid solid =
        shapes::solid(shapes::moved(shapes::rotated(shapes::prism(shapes::gear(5, 0.2, 0.3), -0.2, 0.2),
                                                    {number(random), number(random), number(random)}, number(random)),
                                    {number(random), number(random), number(random)}));
    const double exact = volume(solid);
    double before = 10.0;
    for (const int depth : {2, 3, 4, 5}) {
      const Bounds bounds = octree(solid, depth, {{-1, -1, -1}, {2, 2, 2}}).volume();
      EXPECT_LE(bounds.low, exact);
      EXPECT_GE(bounds.high, exact);
      EXPECT_LE(bounds.high - bounds.low, before);
      before = bounds.high - bounds.low;
    }
  }
}

TEST(Octree, FullAndEmptyCellsAreWhatTheirPointsAre) {
  const Solid solid = shapes::subtract({box_solid({0.1, 0.1, 0.1}, {0.9, 0.8, 0.7}), ball(0.25, {0.5, 0.4, 0.5})});
  const PointLocator locator(solid);
  const Octree tree = octree(solid, 5);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> number(0.0, 1.0);
  std::size_t partial = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point3 p{number(random), number(random), number(random)};
    const Fill fill = tree.fill(tree.leaf_at({p.x, p.y, p.z}));
    partial += fill == Fill::Partial ? 1 : 0;
    if (fill != Fill::Partial) {
      EXPECT_EQ(fill == Fill::Full, locator.locate(p) == Location::Inside);
    }
  }
  EXPECT_GT(partial, 50U);
  EXPECT_LT(partial, 1000U);
}

TEST(Octree, REP_b_UnionAndIntersectionHaveTheExactVolumes) {
  const Octree a = octree(box_solid({0, 0, 0}, {0.5, 0.5, 0.5}), 5);
  const Octree b = octree(box_solid({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}), 5);
  const auto exactly = [](const Octree& tree) {
    EXPECT_EQ(tree.volume().low, tree.volume().high);
    return tree.volume().low;
  };
  EXPECT_EQ(exactly(combine(a, b, SetOperation::Intersection)), 1.0 / 64.0);
  EXPECT_EQ(exactly(combine(a, b, SetOperation::Union)), 15.0 / 64.0);
  EXPECT_EQ(exactly(combine(a, b, SetOperation::Difference)), 7.0 / 64.0);
  EXPECT_EQ(exactly(combine(b, a, SetOperation::Difference)), 7.0 / 64.0);
  EXPECT_TRUE(combine(a, b, SetOperation::Union) == combine(b, a, SetOperation::Union));
}

TEST(Octree, REP_b_APairThatBecomesFullIsMerged) {
  const Octree low = octree(box_solid({0, 0, 0}, {1, 1, 0.5}), 5);
  const Octree high = octree(box_solid({0, 0, 0.5}, {1, 1, 1}), 5);
  EXPECT_EQ(low.leaves().size(), 8U);
  const Octree both = combine(low, high, SetOperation::Union);
  EXPECT_EQ(both.leaves().size(), 1U);
  EXPECT_EQ(both.fill(0), Fill::Full);
  EXPECT_EQ(combine(low, high, SetOperation::Intersection).leaves().size(), 1U);
  EXPECT_EQ(combine(low, low, SetOperation::Difference).leaves().size(), 1U);
  // What two partial cells have in common is not known.
  EXPECT_EQ(combined(Fill::Partial, Fill::Partial, SetOperation::Union), Fill::Partial);
  EXPECT_EQ(combined(Fill::Partial, Fill::Partial, SetOperation::Intersection), Fill::Partial);
  EXPECT_EQ(combined(Fill::Partial, Fill::Full, SetOperation::Difference), Fill::Empty);
}

TEST(Octree, ClashesAreSureOnlyWhereTheyAre) {
  const Box<3> box{{0, 0, 0}, {4, 4, 4}};
  const auto of = [&](const Solid& solid) { return octree(solid, 5, box); };
  const Octree cube = of(box_solid({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(clash(cube, of(box_solid({1, 0, 0}, {2, 1, 1}))), Clash::None);  // a common face
  EXPECT_EQ(clash(cube, of(box_solid({0.5, 0, 0}, {2, 1, 1}))), Clash::Sure);
  EXPECT_EQ(clash(of(ball(0.5, {1.03, 1, 1})), of(ball(0.5, {2.05, 1, 1}))), Clash::Maybe);  // 0.02 apart
  EXPECT_EQ(clash(of(ball(0.5, {1, 1, 1})), of(ball(0.5, {3, 1, 1}))), Clash::None);
}

TEST(Octree, BlockModelsNameTheFirstSolid) {
  const std::vector<Solid> solids{box_solid({0, 0, 0}, {2, 2, 1}), box_solid({0, 0, 0}, {2, 2, 2}), Solid()};
  const auto model = block_model(solids, {{0, 0, 0}, {1, 1, 1}, {2, 3, 2}}).value();
  EXPECT_THAT(model, testing::ElementsAre(0, 0, 0, 0, no_solid, no_solid, 1, 1, 1, 1, no_solid, no_solid));
}

TEST(Octree, SizesAreThoseOfTheCells) {
  const Box<3> cube = cube_round(std::vector{box_solid({1, 2, 3}, {2, 4, 7})});
  EXPECT_EQ(cube, (Box<3>{{1, 2, 3}, {5, 6, 7}}));
  const Octree tree = octree(box_solid({0, 0, 0}, {0.25, 0.25, 0.25}), 6);
  const auto sizes = sizes_by(tree);
  EXPECT_EQ(sizes({0.1, 0.1, 0.1}), 0.25);
  EXPECT_EQ(sizes({0.9, 0.9, 0.9}), 0.5);
  EXPECT_EQ(sizes({2, 0, 0}), 1.0);
  const SectionFrame level{{0, 0, 0.1}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(sizes_by(tree, level)({0.1, 0.9}), 0.5);
  EXPECT_EQ(sizes_by(tree, level)({0.1, 0.1}), 0.25);
}

}  // namespace
}  // namespace dobra::solid::partition
