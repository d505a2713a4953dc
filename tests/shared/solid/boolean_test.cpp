#include "shared/solid/boolean.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <optional>

#include "shared/solid/check/validate.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

using namespace shapes;

TEST(Boolean, SOL_i_HoldsForTwoBoxesThatOverlapInACorner) {
  const Solid a = box_solid({0, 0, 0}, {2, 2, 2});
  const Solid b = box_solid({1, 1, 1}, {3, 3, 3});
  const Combined both = combined({a, b}, Operation::Intersection);
  EXPECT_EQ(both.contact, Contact::Volume);
  EXPECT_EQ(volume(both.solid), 1.0);
  EXPECT_EQ(both.solid.counts(), (Counts{8, 12, 6, 0, 1, 0}));
  const Solid all = unite({a, b});
  EXPECT_EQ(volume(all), 15.0);
  EXPECT_EQ(all.counts(), (Counts{20, 30, 12, 0, 1, 0}));
  const Solid rest = subtract({a, b});
  EXPECT_EQ(volume(rest), 7.0);
  EXPECT_EQ(rest.counts(), (Counts{14, 21, 9, 0, 1, 0}));
  EXPECT_EQ(volume(subtract({b, a})), 7.0);
}

TEST(Boolean, SOL_j_RegularisesAndTellsTheContact) {
  const Solid a = box_solid({0, 0, 0}, {2, 2, 2});
  const auto meet = [&](Point3 low, Point3 high) {
    return combined({a, box_solid(low, high)}, Operation::Intersection);
  };
  EXPECT_EQ(meet({2, 0, 0}, {4, 2, 2}).contact, Contact::Face);
  EXPECT_EQ(meet({2, 1, 0}, {4, 3, 2}).contact, Contact::Face);
  EXPECT_EQ(meet({2, 2, 0}, {4, 4, 2}).contact, Contact::Edge);
  EXPECT_EQ(meet({2, 2, 1}, {4, 4, 3}).contact, Contact::Edge);  // part of an edge
  EXPECT_EQ(meet({2, 2, 2}, {4, 4, 4}).contact, Contact::Vertex);
  EXPECT_EQ(meet({3, 0, 0}, {4, 2, 2}).contact, Contact::Nothing);
  for (const Point3 low : {Point3{2, 0, 0}, Point3{2, 1, 0}, Point3{2, 2, 0}, Point3{2, 2, 2}, Point3{3, 0, 0}}) {
    EXPECT_TRUE(meet(low, low + geom::Vector3{2, 2, 2}).solid.empty());
  }
  EXPECT_EQ(volume(meet({1, 1, 1}, {3, 3, 3}).solid), 1.0);
}

TEST(Boolean, SOL_j_DoublesTheEdgeInWhichTwoBoxesTouch) {
  const Solid both = unite({box_solid({0, 0, 0}, {1, 1, 1}), box_solid({1, 1, 0}, {2, 2, 1})});
  EXPECT_EQ(both.counts(), (Counts{16, 24, 12, 0, 2, 0}));
  // Two arms of an L shape that come together again in an edge: one shell, the edge still twice.
  const Solid l =
      unite({box_solid({0, 0, 0}, {2, 1, 1}), box_solid({0, 0, 0}, {1, 1, 2}), box_solid({1, 0, 1}, {2, 1, 2})});
  EXPECT_EQ(volume(l), 4.0);
  const Solid ring = unite({box_solid({0, 0, 0}, {3, 1, 1}), box_solid({0, 0, 0}, {1, 3, 1}),
                            box_solid({1, 2, 0}, {2, 3, 1}), box_solid({2, 1, 0}, {3, 2, 1})});
  EXPECT_EQ(ring.counts().shells, 1U);
  EXPECT_TRUE(euler_holds(ring.counts()));
  EXPECT_EQ(volume(ring), 7.0);
}

TEST(Boolean, MakesOneFaceOfCoplanarNeighbours) {
  const Solid row =
      unite({box_solid({0, 0, 0}, {1, 1, 1}), box_solid({1, 0, 0}, {2, 1, 1}), box_solid({2, 0, 0}, {3, 1, 1})});
  EXPECT_EQ(row.counts(), (Counts{8, 12, 6, 0, 1, 0}));
  const Solid named = unite({solid(box({0, 0, 0}, {1, 1, 1}), "sand"), solid(box({1, 0, 0}, {2, 1, 1}), "clay")});
  EXPECT_EQ(named.counts(), (Counts{12, 20, 10, 0, 1, 0}));
  std::size_t sand = 0;
  for (std::size_t f = 0; f < named.face_count(); ++f) sand += named.name(FaceId(f)) == "sand" ? 1U : 0U;
  EXPECT_EQ(sand, 5U);
}

TEST(Boolean, TellsHandlesRingsAndCavities) {
  const Solid block = box_solid({0, 0, 0}, {3, 3, 3});
  const Solid through = subtract({block, box_solid({1, 1, -1}, {2, 2, 4})});
  EXPECT_EQ(through.counts(), (Counts{16, 24, 10, 2, 1, 1}));
  const Solid hollow = subtract({block, box_solid({1, 1, 1}, {2, 2, 2})});
  EXPECT_EQ(hollow.counts(), (Counts{16, 24, 12, 0, 2, 0}));
  EXPECT_THAT(shell_volumes(hollow), testing::ElementsAre(27.0, -1.0));
}

TEST(Boolean, SOL_c_HasTheNumbersOfABlockWithAThroughAndABlindHole) {
  const Solid s =
      subtract({box_solid({0, 0, 0}, {6, 3, 3}), box_solid({1, 1, -1}, {2, 2, 4}), box_solid({4, 1, 1}, {5, 2, 3})});
  EXPECT_EQ(s.counts(), (Counts{24, 36, 15, 3, 1, 1}));
}

TEST(Boolean, RowsOfBoxesAreUnitedAlikeAlongEveryAxis) {
  // Each overlaps the next by one; heights by turns 1, 2, 3. Whole numbers, so that sums are exact.
  constexpr int count = 150;
  const auto height = [](int i) { return 1.0 + i % 3; };
  double expected = height(count - 1);  // slice by slice along the row
  for (int i = 0; i < count; ++i) expected += height(i) + std::max(height(i), i > 0 ? height(i - 1) : 0.0);
  std::optional<Counts> counts;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Solid> row;
    for (int i = 0; i < count; ++i) {
      const double at = 2.0 * i;
      const auto corner = [&](double along, double across, double up) {
        return axis == 0   ? Point3{along, across, up}
               : axis == 1 ? Point3{up, along, across}
                           : Point3{across, up, along};
      };
      row.push_back(box_solid(corner(at, 0, 0), corner(at + 3.0, 1, height(i))));
    }
    const Solid all = unite(row);
    EXPECT_EQ(volume(all), expected) << axis;
    EXPECT_THAT(check::violations(all), testing::IsEmpty());
    if (!counts) counts = all.counts();
    EXPECT_EQ(all.counts(), *counts) << axis;
  }
}

}  // namespace
}  // namespace dobra::solid
