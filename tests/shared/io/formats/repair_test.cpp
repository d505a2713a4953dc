#include "shared/io/formats/repair.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace dobra::io::formats {
namespace {

using geom::Point;
using testing::ElementsAre;
using testing::HasSubstr;

lines::Feature line(std::string name, std::string kind, std::vector<Point> points) {
  return {.parts = {{std::move(points), false}}, .name = std::move(name), .kind = std::move(kind)};
}

std::vector<Repair> repaired(std::vector<lines::Feature>& features, const RepairOptions& options) {
  const auto done = repair(features, options);
  EXPECT_TRUE(done.ok()) << base::to_string(done.error());
  return done.ok() ? *done : std::vector<Repair>{};
}

TEST(Repair, NothingIsDoneUnlessItIsAskedFor) {
  std::vector<lines::Feature> features{line("a", "", {{5, 0}, {0, 0}, {0, 1e-9}, {1, 0}}),
                                       line("a", "", {{1, 0}, {2, 0}})};
  const std::vector<lines::Feature> before = features;
  EXPECT_TRUE(repaired(features, {}).empty());
  EXPECT_EQ(features, before);
}

TEST(Repair, ShuffledPointsOfAnOverturnedFoldComeBackInOrder) {
  // Recumbent: the limbs lie one above the other, nearer than the fold is long.
  std::vector<Point> fold;
  for (int i = 0; i <= 300; ++i) {
    const double t = i / 100.0;
    fold.push_back({40.0 * std::sin(2.0 * t) + 3.0 * t, 10.0 * t + 2.0 * std::cos(7.0 * t)});
  }
  std::vector<Point> shuffled = fold;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937_64(3));
  std::vector<lines::Feature> features{line("top", "horizon", shuffled)};
  const auto done = repaired(features, {.order = PointOrder::AlongTheCurve});
  if (features[0].parts[0].points.front() != fold.front()) std::reverse(fold.begin(), fold.end());
  EXPECT_EQ(features[0].parts[0].points, fold);
  ASSERT_EQ(done.size(), 1U);
  EXPECT_EQ(done[0].what, "order");
  EXPECT_EQ(done[0].item, "horizon 'top'");
  EXPECT_THAT(done[0].text, HasSubstr("301 points put in order"));
  // In order already, one way or the other: nothing to do.
  EXPECT_TRUE(repaired(features, {.order = PointOrder::AlongTheCurve}).empty());
}

TEST(Repair, PointsOnAStraightLineAndPointsFeaturesAreOrderedToo) {
  std::vector<lines::Feature> features{
      line("a", "", {{4, 4}, {0, 0}, {2, 2}}),
      {.type = lines::FeatureType::Points, .parts = {{{{9, 1}, {0, 0}, {5, 2}}, false}}}};
  EXPECT_EQ(repaired(features, {.order = PointOrder::AlongTheCurve}).size(), 2U);
  EXPECT_THAT(features[0].parts[0].points, ElementsAre(Point{0, 0}, Point{2, 2}, Point{4, 4}));
  EXPECT_EQ(features[1].type, lines::FeatureType::Lines);
  EXPECT_THAT(features[1].parts[0].points, ElementsAre(Point{0, 0}, Point{5, 2}, Point{9, 1}));
}

TEST(Repair, ACloudOfPointsIsNoCurveAndIsRefusedWithAPlace) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Point> cloud(200);
  for (Point& p : cloud) p = {uniform(random), uniform(random)};
  std::vector<lines::Feature> features{line("cloud", "", cloud)};
  const auto done = repair(features, {.order = PointOrder::AlongTheCurve});
  ASSERT_FALSE(done.ok());
  EXPECT_THAT(base::to_string(done.error()), HasSubstr("'cloud': the points do not lie along one curve"));
  EXPECT_TRUE(done.error().place->x.has_value());
}

TEST(Repair, NearPointsAreDroppedAndTheEndsStay) {
  std::vector<lines::Feature> features{line("a", "", {{0, 0}, {0.05, 0}, {1, 0}, {1.95, 0}, {2, 0}})};
  const auto done = repaired(features, {.duplicates = 0.1});
  EXPECT_THAT(features[0].parts[0].points, ElementsAre(Point{0, 0}, Point{1, 0}, Point{2, 0}));
  ASSERT_EQ(done.size(), 1U);
  EXPECT_THAT(done[0].text, HasSubstr("2 points nearer than 0.1 m"));
  EXPECT_NEAR(done[0].moved, 0.05, 1e-12);
}

TEST(Repair, PartsOfOneNameAreJoinedWhicheverWayTheyWereDrawn) {
  std::vector<lines::Feature> features{line("a", "horizon", {{0, 0}, {1, 0}}), line("b", "horizon", {{1, 0.1}, {9, 9}}),
                                       line("a", "horizon", {{3, 0}, {2, 0}, {1.2, 0}}),
                                       line("a", "horizon", {{3, 0}, {4, 0}}), line("", "", {{4.1, 0}, {5, 0}})};
  const auto done = repaired(features, {.gaps = 0.3});
  ASSERT_EQ(features.size(), 3U);
  EXPECT_THAT(features[0].parts[0].points,
              ElementsAre(Point{0, 0}, Point{1, 0}, Point{1.2, 0}, Point{2, 0}, Point{3, 0}, Point{4, 0}));
  ASSERT_EQ(done.size(), 2U);
  EXPECT_NEAR(done[0].moved, 0.2, 1e-12);
  EXPECT_EQ(done[1].moved, 0.0);
}

TEST(Repair, PartsThatRoundingHasPartedShareOnePoint) {
  std::vector<lines::Feature> features{line("a", "horizon", {{0, 0}, {1, 1}}),
                                       line("a", "horizon", {{1 + 1e-13, 1}, {2, 1}})};
  repaired(features, {.gaps = 0.3});
  EXPECT_THAT(features[0].parts[0].points, ElementsAre(Point{0, 0}, Point{1, 1}, Point{2, 1}));
}

TEST(Repair, AUnitThatEndsNearItsBeginningIsClosed) {
  std::vector<lines::Feature> features{line("u", "unit", {{0, 0}, {0, 2}, {2, 2}, {2, 0}, {0.1, 0}})};
  EXPECT_EQ(repaired(features, {.gaps = 0.3}).size(), 1U);
  EXPECT_EQ(features[0].type, lines::FeatureType::Polygons);
  EXPECT_GT(geom::signed_area(features[0].parts[0]), 3.9);
}

TEST(Repair, EndsNearAFaultAreMovedOntoItAndShareItsVertex) {
  std::vector<lines::Feature> features{line("short", "horizon", {{0, 1}, {4.8, 1}}),
                                       line("over", "horizon", {{0, 2}, {4, 2}, {5.3, 2}}),
                                       line("far", "horizon", {{0, 3}, {4, 3}}), line("F", "fault", {{5, 0}, {5, 10}})};
  const auto done = repaired(features, {.snap = 0.5});
  EXPECT_THAT(features[0].parts[0].points, ElementsAre(Point{0, 1}, Point{5, 1}));
  EXPECT_THAT(features[1].parts[0].points, ElementsAre(Point{0, 2}, Point{4, 2}, Point{5, 2}));
  EXPECT_THAT(features[2].parts[0].points, ElementsAre(Point{0, 3}, Point{4, 3}));
  EXPECT_THAT(features[3].parts[0].points, ElementsAre(Point{5, 0}, Point{5, 1}, Point{5, 2}, Point{5, 10}));
  ASSERT_EQ(done.size(), 2U);
  EXPECT_NEAR(done[0].moved, 0.2, 1e-12);
  EXPECT_NEAR(done[1].moved, 0.3, 1e-12);
  EXPECT_THAT(to_string(done[0]),
              HasSubstr("snap: horizon 'short': an end moved onto fault 'F', at (5, 1), moved 0.2 m"));
}

TEST(Repair, ThinPolygonsAndSpikesAreRemoved) {
  const auto polygon = [](std::string name, std::vector<Point> points) {
    lines::Feature made{
        .type = lines::FeatureType::Polygons, .parts = {{std::move(points), true}}, .name = std::move(name)};
    EXPECT_TRUE(lines::normalise(made, {0}).ok());
    return made;
  };
  std::vector<lines::Feature> features{
      polygon("sliver", {{0, 0}, {10, 0}, {10, 0.05}, {0, 0.05}}),
      polygon("spiked", {{0, 0}, {4, 0}, {4, 2}, {9, 2.01}, {4, 2.02}, {4, 4}, {0, 4}}),
      polygon("good", {{0, 0}, {1, 0}, {1, 1}, {0, 1}})};
  const std::vector<lines::Feature> before = features;
  const auto done = repaired(features, {.slivers = 0.1});
  ASSERT_EQ(features.size(), 2U);
  EXPECT_EQ(features[0].name, "spiked");
  EXPECT_NEAR(geom::signed_area(features[0].parts[0]), 16.0, 0.03);
  EXPECT_NEAR(features[0].parts[0].box().high.x, 4.0, 0.01);
  EXPECT_EQ(features[1], before[2]);
  EXPECT_EQ(std::count_if(done.begin(), done.end(), [](const Repair& r) { return r.what == "sliver"; }), 1);
  EXPECT_GE(std::count_if(done.begin(), done.end(), [](const Repair& r) { return r.what == "spike"; }), 1);
}

TEST(Repair, BadTolerancesAreRefused) {
  std::vector<lines::Feature> features{line("a", "", {{0, 0}, {1, 0}})};
  for (const RepairOptions& options :
       {RepairOptions{.duplicates = 0.0}, RepairOptions{.gaps = -1.0}, RepairOptions{.snap = NAN}}) {
    const auto done = repair(features, options);
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, base::ErrorCode::InvalidOption);
  }
}

lines::Feature polygon(std::string name, std::vector<Point> points) {
  return {.type = lines::FeatureType::Polygons,
          .parts = {{std::move(points), true}},
          .name = std::move(name),
          .kind = "unit"};
}

TEST(Repair, PolygonsShareTheirEdgesAndThoseOfLines) {
  std::vector<lines::Feature> features{line("top", "horizon", {{0, 10}, {10, 10}}),
                                       polygon("A", {{0, 5}, {10, 5}, {10, 10.02}, {0, 9.98}}),
                                       polygon("B", {{0, 0}, {10, 0}, {10.01, 5.01}, {6, 4.98}, {0.01, 5}})};
  const auto done = repaired(features, {.edges = 0.1});
  ASSERT_EQ(done.size(), 2U);
  EXPECT_EQ(done[0].what, "edge");
  EXPECT_EQ(done[0].item, "unit 'A'");
  EXPECT_NEAR(done[0].moved, 0.02, 1e-12);
  EXPECT_THAT(features[1].parts[0].points,
              ElementsAre(Point{0, 5}, Point{6, 5}, Point{10, 5}, Point{10, 10}, Point{0, 10}));
  EXPECT_THAT(features[2].parts[0].points,
              ElementsAre(Point{0, 0}, Point{10, 0}, Point{10, 5}, Point{6, 5}, Point{0, 5}));
  EXPECT_TRUE(repaired(features, {.edges = 0.1}).empty());
}

TEST(Repair, AnEdgePassesThroughTheVerticesBesideIt) {
  std::vector<lines::Feature> features{polygon("A", {{0, 5}, {4, 5.05}, {10, 5}, {10, 10}, {0, 10}}),
                                       polygon("B", {{0, 0}, {10, 0}, {10, 5}, {0, 5}})};
  EXPECT_TRUE(repaired(features, {.edges = 0.1}).empty());  // nothing moves
  EXPECT_THAT(features[1].parts[0].points,
              ElementsAre(Point{0, 0}, Point{10, 0}, Point{10, 5}, Point{4, 5.05}, Point{0, 5}));
}

}  // namespace
}  // namespace dobra::io::formats
