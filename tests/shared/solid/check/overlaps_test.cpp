// Solids that should stand side by side: what they have in common, first where it is hard to see.

#include "shared/solid/check/overlaps.h"

#include <gmock/gmock.h>

#include "shared/solid/cap.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid::check {
namespace {

using namespace shapes;

TEST(Overlaps, NeighboursThatTouchHaveNone) {
  const std::vector<Solid> touching{box_solid({0, 0, 0}, {1, 1, 1}), box_solid({1, 0, 0}, {2, 1, 1}),
                                    box_solid({1, 1, 1}, {2, 2, 2}), Solid()};
  EXPECT_THAT(overlaps(touching).value(), testing::IsEmpty());
  EXPECT_THAT(overlaps({}).value(), testing::IsEmpty());
}

TEST(Overlaps, RoundingOfNeighboursThatWereTurnedIsNone) {
  for (int i = 1; i < 20; ++i) {
    const auto turned = [&](PolygonMesh mesh) { return solid(rotated(std::move(mesh), {1, 2, 3}, 0.1 * i)); };
    // The common face of the first is a part of that of the second.
    const std::vector<Solid> solids{turned(box({0, 0, 0}, {1, 1, 1})), turned(box({1, -0.3, -0.2}, {2, 1.7, 1.4}))};
    EXPECT_THAT(overlaps(solids).value(), testing::IsEmpty()) << i;
  }
}

TEST(Overlaps, EachPairIsToldWithItsVolumeAndAPlaceInIt) {
  // A frame round a post: the middle of what they have in common is in neither, but for the second pair.
  const Solid frame = subtract({box_solid({0, 0, 0}, {4, 4, 1}), box_solid({1, 1, -1}, {3, 3, 2})});
  const Solid post = box_solid({0.5, 0.5, -1}, {3.5, 3.5, 3});
  const Solid slab = box_solid({-1, -1, 2.5}, {5, 5, 3.5});
  const auto found = overlaps(std::vector<Solid>{frame, post, slab}).value();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].first, 0U);
  EXPECT_EQ(found[0].second, 1U);
  EXPECT_DOUBLE_EQ(found[0].volume, 9.0 - 4.0);
  EXPECT_NE(PointLocator(frame).locate(found[0].at), Location::Outside);
  EXPECT_EQ(found[1].second, 2U);
  EXPECT_DOUBLE_EQ(found[1].volume, 4.5);
  EXPECT_EQ(PointLocator(slab).locate(found[1].at), Location::Inside);
}

TEST(SectionOverlaps, ArePairsOfSolidsThatCoverTheSameOfThePlane) {
  const std::vector<Solid> solids{box_solid({0, 0, 0}, {2, 2, 2}), box_solid({1, 1, 0}, {3, 3, 2}),
                                  box_solid({1.5, 1.5, 0}, {1.75, 1.75, 2}), box_solid({2, 0, 0}, {3, 1, 2})};
  const Section section = Sections(solids).cut({0, 0, 1, -1}).value();
  ASSERT_EQ(section.overlaps.size(), 2U);
  EXPECT_DOUBLE_EQ(section.overlaps[0].area, 1.0);
  EXPECT_EQ(section.overlaps[0].second, 1U);
  EXPECT_DOUBLE_EQ(section.overlaps[1].area, 0.0625);
  EXPECT_EQ(section.overlaps[1].second, 2U);
  const geom::Point at = section.overlaps[0].at;
  EXPECT_TRUE(at.x >= 1.0 && at.x <= 2.0 && at.y >= 1.0 && at.y <= 2.0) << at.x << ' ' << at.y;
  // Neighbours cover nothing twice.
  const std::vector<Solid> neighbours{solids[0], solids[3]};
  EXPECT_THAT(Sections(neighbours).cut({0.1, 0.2, 1, -1}).value().overlaps, testing::IsEmpty());
}

}  // namespace
}  // namespace dobra::solid::check
