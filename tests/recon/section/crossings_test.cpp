#include "recon/section/crossings.h"

#include <gtest/gtest.h>

#include "tests/recon/shapes.h"

namespace recon::section {
namespace {

TEST(Crossings, ASimpleLineHasNone) { EXPECT_TRUE(self_crossings(test::cosine()).empty()); }

TEST(Crossings, ALoopIsFoundWithItsPlace) {
  const geom::Polyline line{{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, -2}}, false};
  const std::vector<SelfCrossing> found = self_crossings(line);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].first, 0u);
  EXPECT_EQ(found[0].second, 3u);
  EXPECT_EQ(found[0].place, (geom::Point{2, 0}));
}

TEST(Crossings, ASpikeThatFoldsBackOntoItselfIsFound) {
  const std::vector<SelfCrossing> found = self_crossings({{{0, 0}, {2, 0}, {2, 3}, {2, 0}, {4, 0}}, false});
  EXPECT_FALSE(found.empty());
}

TEST(Crossings, SmallLoopsAreCutAtTheCrossing) {
  geom::Polyline line{{{0, 0}, {50, 0}, {50.5, 0}, {50.5, 0.2}, {50.25, 0.2}, {50.25, -0.2}, {100, -0.2}}, false};
  const auto cut = without_loops(line);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->line.points, (std::vector<geom::Point>{{0, 0}, {50, 0}, {50.25, 0}, {50.25, -0.2}, {100, -0.2}}));
  EXPECT_EQ(cut->places, (std::vector<geom::Point>{{50.25, 0}}));
}

TEST(Crossings, ASpikeIsCutToItsFoot) {
  const auto cut = without_loops({{{0, 0}, {50, 0}, {50, 0.3}, {50, 0}, {100, 0}}, false});
  ASSERT_TRUE(cut);
  EXPECT_TRUE(self_crossings(cut->line).empty());
  EXPECT_NEAR(geom::length(cut->line), 100.0, 1e-12);
}

TEST(Crossings, ALongLoopIsNotCutButRefusedWithItsPlace) {
  const auto cut = without_loops({{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, -2}}, false});
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().code, base::ErrorCode::BadSection);
  ASSERT_TRUE(cut.error().place && cut.error().place->x);
  EXPECT_EQ(*cut.error().place->x, 2.0);
}

}  // namespace
}  // namespace recon::section
