// Trees: what matrices cannot be first, then sharing, scaling of operands, and against classification by the tree.

#include "shared/solid/csg/csg.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "shared/solid/shape/instance.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

using namespace csg;
using shape::block;
Tree block_leaf(geom::Vector3 size) {
  return leaf(fmt::format("block {} {} {}", size.x, size.y, size.z), block(size).value());
}
Solid evaluated(const Tree& tree) { return Evaluator().evaluate(tree).value().solid; }

TEST(Placement, MatricesThatFlattenOrAreNotAffineAreRefused) {
  EXPECT_FALSE(check_matrix({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1}));
  EXPECT_FALSE(check_matrix({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1}));
  EXPECT_FALSE(check_matrix({NAN, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
  EXPECT_TRUE(check_matrix(identity));
  std::vector<geom::Point3> far{{1e300, 0, 0}};
  EXPECT_FALSE(place(far, scaled({}, {1e10, 1, 1})));
}

TEST(Placement, RightAnglesAreExact) {
  std::vector<geom::Point3> points{{1, 2, 3}};
  EXPECT_EQ(place(points, turned({}, {0, 0, 1}, 90)).value(), 0U);
  EXPECT_EQ(points[0], (geom::Point3{-2, 1, 3}));
  EXPECT_EQ(place(points, turned({1, 1, 1}, {1, 0, 0}, -270)).value(), 0U);
  EXPECT_EQ(points[0], (geom::Point3{-2, -1, 1}));
  EXPECT_TRUE(mirrors(scaled({}, {1, -1, 1})));
  EXPECT_FALSE(mirrors(turned({}, {1, 2, 3}, 77)));
  for (const geom::Vector3 d : {geom::Vector3{0, 0, -2}, geom::Vector3{1, 0, 0}, geom::Vector3{1, -2, 0.5}}) {
    std::vector<geom::Point3> z{{0, 0, 1}};
    ASSERT_TRUE(place(z, along(d)));
    EXPECT_NEAR(dot(z[0] - geom::Point3{}, normalised(d)), 1.0, 1e-15);
    EXPECT_FALSE(mirrors(along(d)));
  }
}

TEST(Csg, SOL_l_ScalingOneOperandIsNotScalingTheOther) {
  const Tree a = block_leaf({2, 2, 1});
  const Tree b = placed(block_leaf({1, 1, 1}), moved_by({0.5, 0.5, 0}));
  const Matrix twice = scaled({0, 0, 0}, {2, 2, 2});
  const double first = volume(evaluated(combined(Operation::Difference, {placed(a, twice), b})));
  const double second = volume(evaluated(combined(Operation::Difference, {a, placed(b, twice)})));
  const double both = volume(evaluated(placed(combined(Operation::Difference, {a, b}), twice)));
  EXPECT_EQ(first, 32.0 - 1.0);
  EXPECT_EQ(second, 4.0 - 1.0);  // [1, 3]^2 of [0, 2]^2
  EXPECT_EQ(both, 8.0 * 3.0);
}

TEST(Csg, SharedSubtreesAreComputedOnceAndEditsAlongTheirPathAlone) {
  const auto tree = [](double size) {
    const Tree shared = combined(Operation::Union, {block_leaf({1, 1, 1}), block_leaf({2, 0.5, 0.5})});
    const Tree other = combined(Operation::Union, {block_leaf({size, 3, 3}), block_leaf({3, 3, size})});
    return combined(Operation::Difference, {other, shared, placed(shared, moved_by({0, 0, 0}))});
  };
  Evaluator evaluator;
  const Evaluated before = evaluator.evaluate(tree(3)).value();
  EXPECT_EQ(evaluator.computed(), 6U);  // three blocks (one size twice), two unions, the difference
  ASSERT_TRUE(evaluator.evaluate(tree(3)));
  EXPECT_EQ(evaluator.computed(), 0U);
  const Evaluated after = evaluator.evaluate(tree(4)).value();
  EXPECT_EQ(evaluator.computed(), 4U);  // two blocks, one union, the difference
  EXPECT_EQ(volume(before.solid), 27.0 - 1.25);
  EXPECT_EQ(volume(after.solid), 9.0 * 4 + 9.0 * 4 - 27.0 - 1.25);
}

TEST(Csg, AMirroredTreeKeepsItsInsideInside) {
  const Tree a = combined(Operation::Difference, {block_leaf({2, 2, 2}), block_leaf({1, 1, 1})});
  EXPECT_EQ(volume(evaluated(placed(a, scaled({0, 0, 0}, {-1, 1, 1})))), 7.0);
  const Tree turned_away = placed(a, turned({0, 0, 0}, {1, 1, 1}, 40));
  const Evaluated out = Evaluator().evaluate(turned_away).value();
  EXPECT_GT(out.rounded, 0U);
  EXPECT_NEAR(volume(out.solid), 7.0, 1e-13);
}

TEST(Csg, TellsOperationsThatLeaveNothingOrMeetNowhere) {
  const Tree a = block_leaf({1, 1, 1});
  const Tree b = placed(a, moved_by({1, 0, 0}));
  const Evaluated out = Evaluator().evaluate(combined(Operation::Intersection, {a, b})).value();
  EXPECT_TRUE(out.solid.empty());
  ASSERT_EQ(out.contacts.size(), 1U);
  EXPECT_EQ(out.contacts[0].second, Contact::Face);
}

TEST(Csg, WhatWasDerivedIsPlacedAsItIs) {
  int calls = 0;
  const Tree doubled = derived("whole", block_leaf({1, 2, 3}), [&](const Solid& s) -> base::Result<Solid> {
    ++calls;
    return s;
  });
  Evaluator evaluator;
  const Tree two = combined(Operation::Union, {doubled, placed(doubled, moved_by({5, 0, 0}))});
  EXPECT_EQ(volume(evaluator.evaluate(two).value().solid), 12.0);
  EXPECT_EQ(calls, 2);  // in two places
  ASSERT_TRUE(evaluator.evaluate(two));
  EXPECT_EQ(calls, 2);
}

}  // namespace
}  // namespace dobra::solid
