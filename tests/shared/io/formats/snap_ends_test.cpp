// Ends beside the line that they abut: what must not be moved first, then where they go, then random lines.

#include "shared/io/formats/snap_ends.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "shared/geom/intersect.h"

namespace dobra::io::formats::snap_ends_test {
namespace {

using geom::Point;
using geom::Segment;
using testing::ElementsAre;

lines::Feature line(std::string name, std::string kind, std::vector<Point> points) {
  return {.type = lines::FeatureType::Lines,
          .parts = {{std::move(points), false}},
          .name = std::move(name),
          .kind = std::move(kind)};
}
std::vector<Point> points(const std::vector<lines::Feature>& features, const std::string& name) {
  for (const lines::Feature& feature : features) {
    if (feature.name == name) return feature.parts[0].points;
  }
  return {};
}
std::vector<SnappedEnd> snap(std::vector<lines::Feature>& features, double reach) {
  RepairOptions options;
  options.snap = reach;
  return snap_ends(features, options);
}
void stays(std::vector<lines::Feature> features, double reach) {
  const std::vector<lines::Feature> before = features;
  EXPECT_TRUE(snap(features, reach).empty());
  EXPECT_EQ(features, before);
}

TEST(SnapEnds, NoLineIsFoldedOrVanishes) {
  const lines::Feature fault = line("F", "fault", {{5, -10}, {5, 10}});
  // Both ends would come to the tip.
  stays({line("a", "horizon", {{4.9, 0.1}, {5.1, 0.1}}), line("F", "fault", {{5, 0}, {5, -10}})}, 0.5);
  // A line that is shorter than the way is not turned round.
  std::vector<lines::Feature> little{line("a", "horizon", {{5.1, 0}, {5.3, 0}}), fault};
  EXPECT_EQ(snap(little, 0.5).size(), 1U);
  EXPECT_THAT(points(little, "a"), ElementsAre(Point{5, 0}, Point{5.3, 0}));
  // It goes away from the fault: its other end is moved, not this one back over it.
  std::vector<lines::Feature> away{line("a", "horizon", {{5.1, 0}, {9, 0}}), fault};
  EXPECT_EQ(snap(away, 0.5).size(), 1U);
  EXPECT_THAT(points(away, "a"), ElementsAre(Point{5, 0}, Point{9, 0}));
  // Last sides that are shorter than the way to the fault, some of them back.
  std::vector<lines::Feature> hooked{line("a", "horizon", {{0, 0}, {4.9, 0}, {4.7, 0.1}, {4.6, 0.1}}), fault};
  EXPECT_EQ(snap(hooked, 0.5).size(), 1U);
  EXPECT_LT(geom::distance(points(hooked, "a").back(), Point{5, 0.1}), 1e-12);
  const auto made = points(hooked, "a");
  for (std::size_t i = 0; i + 2 < made.size(); ++i)
    EXPECT_GE(geom::dot(made[i + 1] - made[i], made[i + 2] - made[i + 1]), 0.0) << i;
}

TEST(SnapEnds, NothingIsCrossedOnTheWay) {
  const lines::Feature fault = line("F", "fault", {{5, -10}, {5, 10}});
  // Another horizon, or the line itself, lies between the end and the fault.
  stays({line("a", "horizon", {{0, 0}, {4.6, 0}}), line("b", "horizon", {{3, -3}, {4.8, -1}, {4.8, 1}, {3, 3}}), fault},
        0.5);
  stays({line("a", "horizon", {{0, -3}, {4.8, -3}, {4.8, 3}, {0, 3}, {0, 0}, {4.6, 0}}), fault}, 0.5);
  // A fault between counts itself.
  std::vector<lines::Feature> two{line("a", "horizon", {{0, 0}, {4.7, 0}}), fault,
                                  line("G", "fault", {{4.9, -10}, {4.9, 10}})};
  EXPECT_EQ(snap(two, 0.5).size(), 1U);
  EXPECT_EQ(points(two, "a").back(), (Point{4.9, 0}));
  // Ends that would cross each other both stay.
  stays({line("a", "horizon", {{4, 0.5}, {4.6, 0.1}}), line("b", "horizon", {{4, -0.5}, {4.55, 0.12}}), fault}, 0.5);
}

TEST(SnapEnds, WhatMeetsTheFaultAtASmallAngleMovesByLessThanTheReachAndMakesNoSliver) {
  // 0.3 beyond the fault, which it crosses 15 before its end.
  for (const bool bends : {false, true}) {
    std::vector<Point> way{{0, 1}, {50, 0}, {65, -0.3}};
    if (bends) way.insert(way.begin() + 2, {58, -0.2});
    std::vector<lines::Feature> features{line("a", "horizon", way), line("F", "fault", {{-10, 0}, {100, 0}})};
    features[0].parts[0].points[1].y = 0.02;
    const auto done = snap(features, 0.5);
    ASSERT_EQ(done.size(), 1U);
    EXPECT_LT(done[0].moved, 0.5);
    const auto made = points(features, "a");
    for (std::size_t i = 0; i + 1 < made.size(); ++i) EXPECT_GE(made[i].y, 0.0);
    EXPECT_LT(geom::distance(made.back(), Point{65, 0}), 1e-12);
  }
}

TEST(SnapEnds, AnEndAtATipOrABendOfTheFaultTakesItsVertex) {
  std::vector<lines::Feature> features{line("tip", "horizon", {{0, 0.2}, {5.1, 0.2}}),
                                       line("bend", "horizon", {{0, -5}, {4.8, -5}}),
                                       line("F", "fault", {{5, 0}, {5, -5}, {8, -9}})};
  EXPECT_EQ(snap(features, 0.5).size(), 2U);
  EXPECT_EQ(points(features, "tip").back(), (Point{5, 0}));
  EXPECT_EQ(points(features, "bend").back(), (Point{5, -5}));
  EXPECT_EQ(points(features, "F").size(), 3U);
}

TEST(SnapEnds, ABedThatEndsOnTheSideThatIsMovedStaysOnIt) {
  std::vector<lines::Feature> features{line("a", "horizon", {{0, 0}, {4.9, 0}}),
                                       line("b", "horizon", {{0, -4}, {2, 0}}),
                                       line("F", "fault", {{4, -10}, {6, 10}})};
  EXPECT_EQ(snap(features, 0.5).size(), 1U);
  EXPECT_THAT(points(features, "a"), testing::Contains(Point{2, 0}));
}

TEST(SnapEnds, LinesThatAreToldSoMayEndOnOthers) {
  std::vector<lines::Feature> features{line("cut", "horizon", {{0, 0}, {10, 0}}),
                                       line("bed", "horizon", {{0, -3}, {6, -0.2}}),
                                       line("thin", "horizon", {{0, -0.2}, {3, -2}})};
  const std::vector<lines::Feature> before = features;
  RepairOptions options;
  options.snap = 0.3;
  EXPECT_TRUE(snap_ends(features, options).empty());
  options.may_snap = [](const lines::Feature&, const lines::Feature& onto) { return onto.kind == "horizon"; };
  EXPECT_EQ(snap_ends(features, options).size(), 1U);
  EXPECT_EQ(points(features, "bed").back(), (Point{6, 0}));
  EXPECT_EQ(points(features, "cut"), (std::vector<Point>{{0, 0}, {6, 0}, {10, 0}}));
  EXPECT_EQ(features[2], before[2]);  // ends side by side are no end on a line
  features = before;
  options.on_line = 0.25;
  EXPECT_TRUE(snap_ends(features, options).empty());
  EXPECT_EQ(features, before);
}

TEST(SnapEnds, OfTwoLinesTheOneThatIsCrossedFirstWins) {
  RepairOptions options;
  options.snap = 0.5;
  for (const bool first : {true, false}) {
    // 0.3 beyond F, 0.2 before G: nearer to G.
    std::vector<lines::Feature> features{line("a", "horizon", {{0, 0}, {5.3, 0}}),
                                         line("F", "fault", {{5, -10}, {5, 10}}),
                                         line("G", "fault", {{5.5, -10}, {5.5, 10}})};
    options.first_crossing = first;
    EXPECT_EQ(snap_ends(features, options).size(), 1U);
    EXPECT_EQ(points(features, "a").back(), (Point{first ? 5.0 : 5.5, 0})) << first;
    // Beyond both, and the second one nearer still.
    features = {line("a", "horizon", {{0, 0}, {5.3, 0}}), line("F", "fault", {{5, -10}, {5, 10}}),
                line("G", "fault", {{5.2, -10}, {5.2, 10}})};
    EXPECT_EQ(snap_ends(features, options).size(), 1U);
    EXPECT_EQ(points(features, "a").back(), (Point{first ? 5.0 : 5.2, 0})) << first;
    // F is crossed at so small an angle that the crossing is far, and lies 0.3 off; G only 0.2.
    features = {line("a", "horizon", {{0, 1}, {50, 0.02}, {65, -0.3}}), line("F", "fault", {{-10, 0}, {100, 0}}),
                line("G", "fault", {{65, -0.5}, {60, -10}})};
    EXPECT_EQ(snap_ends(features, options).size(), 1U);
    EXPECT_LT(geom::distance(points(features, "a").back(), first ? Point{65, 0} : Point{65, -0.5}), 1e-12) << first;
    // F is crossed too, but far from the end, which only comes back near it.
    features = {line("a", "horizon", {{-5, 5}, {0, -5}, {10, -5}, {20, -0.3}}),
                line("F", "fault", {{-10, 0}, {100, 0}}), line("G", "fault", {{19.5, -10}, {21, -0.2}, {30, -0.2}})};
    const double from_g = geom::distance(Segment{{19.5, -10}, {21, -0.2}}, {20, -0.3});
    ASSERT_GT(from_g, 0.5);
    EXPECT_EQ(snap_ends(features, options).size(), 1U);
    EXPECT_LT(geom::distance(points(features, "a").back(), Point{20, 0}), 1e-12) << first;
  }
}

bool meet(const std::vector<Point>& a, const std::vector<Point>& b) {
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    for (std::size_t k = 0; k + 1 < b.size(); ++k) {
      const auto met = geom::intersect({a[i], a[i + 1]}, {b[k], b[k + 1]});
      if (met.kind == geom::IntersectionKind::Point && met.start.proper()) return true;
    }
  }
  return false;
}

TEST(SnapEnds, RandomLinesCrossNothingNewAndDoNotDependOnTheirOrder) {
  std::size_t moved = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    std::vector<lines::Feature> features;
    const auto add = [&](const char* kind, double size, std::size_t count) {
      Point at{10 * any(random), 10 * any(random)};
      const double turn = 6.28 * any(random);
      std::vector<Point> made;
      for (std::size_t i = 0; i < count; ++i) {
        made.push_back(at);
        const double way = turn + 1.5 * (any(random) - 0.5);
        at = at + size * any(random) * geom::Vector{std::cos(way), std::sin(way)};
      }
      features.push_back(line(kind + std::to_string(features.size()), kind, made));
    };
    for (int i = 0; i < 3; ++i) add("fault", 6, 4);
    for (int i = 0; i < 6; ++i) add("horizon", i < 3 ? 3 : 0.4, 5);
    const std::vector<lines::Feature> before = features;
    const double reach = 0.5;
    for (const SnappedEnd& end : snap(features, reach)) {
      EXPECT_LT(end.moved, reach) << seed;
      const auto fault = features[end.onto].parts[0].points;
      EXPECT_EQ(std::count(fault.begin(), fault.end(), end.at), 1) << seed;
      ++moved;
    }
    for (std::size_t i = 0; i < features.size(); ++i) {
      for (std::size_t k = i + 1; k < features.size(); ++k) {
        if (features[i].kind != "horizon" || features[k].kind != "horizon") continue;
        if (meet(features[i].parts[0].points, features[k].parts[0].points)) {
          EXPECT_TRUE(meet(before[i].parts[0].points, before[k].parts[0].points)) << seed << " " << i << " " << k;
        }
      }
    }
    std::vector<lines::Feature> shuffled = before;
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    snap(shuffled, reach);
    for (const lines::Feature& feature : features) EXPECT_EQ(points(shuffled, feature.name), feature.parts[0].points);
  }
  EXPECT_GT(moved, 300U);
}

}  // namespace
}  // namespace dobra::io::formats::snap_ends_test
