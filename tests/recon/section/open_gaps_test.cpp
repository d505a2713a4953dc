// Gaps between polygons that no ring closes: strips across a section, wedges, notches, what is air.

#include "recon/section/open_gaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/recon/shapes.h"

namespace recon::section {
namespace {

using Corners = std::vector<geom::Point>;

Section drawn(const std::vector<std::pair<std::string, Corners>>& units) {
  Section section = test::section_of({{{{0, 100}, {10, 100}}, false}, {{{0, -100}, {10, -100}}, false}});
  for (const auto& [name, points] : units)
    section.units.push_back({UnitId(section.units.size()), name, {points, true}, {}, {}});
  return section;
}

std::vector<Misfit> open_of(const Section& section) {
  const auto made = faces_of(section);
  EXPECT_TRUE(made) << to_string(made.error());
  std::vector<Misfit> open;
  for (const Misfit& misfit : made->misfits) {
    if (misfit.open_over > 0.0) open.push_back(misfit);
  }
  return open;
}

const Corners upper{{0, 0}, {10, 0}, {10, 5}, {0, 5}};

TEST(OpenGaps, AStripAcrossTheSectionIsToldWithItsAreaWidthAndMiddle) {
  for (const bool reversed : {false, true}) {
    Corners lower{{0, -6}, {10, -6}, {10, -1}, {0, -2}};
    if (reversed) std::reverse(lower.begin(), lower.end());
    const auto open = open_of(drawn({{"A", upper}, {"B", lower}}));
    ASSERT_EQ(open.size(), 1u);
    EXPECT_EQ(open[0].what, "gap");
    EXPECT_EQ(open[0].between, "A, B");
    EXPECT_DOUBLE_EQ(open[0].area, 15.0);
    EXPECT_DOUBLE_EQ(open[0].open_over, 10.0);
    EXPECT_DOUBLE_EQ(open[0].place.x, 5.0);
    EXPECT_DOUBLE_EQ(open[0].place.y, -0.75);
  }
}

TEST(OpenGaps, TwoStripsAreTwoAndAMissingUnitIsOne) {
  const Corners second{{0, -5}, {10, -5}, {10, -2}, {0, -2}}, third{{0, -9}, {10, -9}, {10, -8}, {0, -8}};
  const auto two = open_of(drawn({{"A", upper}, {"B", second}, {"C", third}}));
  ASSERT_EQ(two.size(), 2u);
  EXPECT_DOUBLE_EQ(two[0].area + two[1].area, 20.0 + 30.0);
  const auto one = open_of(drawn({{"A", upper}, {"C", third}}));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_DOUBLE_EQ(one[0].area, 80.0);
}

TEST(OpenGaps, AWedgeThatClosesAtOneSideIsTold) {
  const auto open = open_of(drawn({{"A", upper}, {"B", {{0, -6}, {10, -6}, {10, -2}, {0, 0}}}}));
  ASSERT_EQ(open.size(), 1u);
  EXPECT_DOUBLE_EQ(open[0].area, 10.0);
}

TEST(OpenGaps, PolygonsThatTouchInTheMiddlePartTheGap) {
  const auto open = open_of(drawn({{"A", upper}, {"B", {{0, -6}, {10, -6}, {10, -2}, {4, 0}, {0, -1}}}}));
  ASSERT_EQ(open.size(), 2u);
  EXPECT_DOUBLE_EQ(open[0].area + open[1].area, 2.0 + 6.0);
}

TEST(OpenGaps, AShortPolygonBetweenLongOnesLeavesANotchAtTheSide) {
  const Corners middle{{0, -2}, {7, -2}, {7, 0}, {0, 0}}, low{{0, -6}, {10, -6}, {10, -2}, {0, -2}};
  const auto open = open_of(drawn({{"A", upper}, {"M", middle}, {"B", low}}));
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0].between, "A, B");
  EXPECT_DOUBLE_EQ(open[0].area, 6.0);
  EXPECT_DOUBLE_EQ(open[0].open_over, 3.0);
}

TEST(OpenGaps, WhatIsNoOpenGapIsNotTold) {
  const Corners touching{{0, -6}, {10, -6}, {10, 0}, {0, 0}}, beside{{11, 0}, {20, 0}, {20, 5}, {11, 5}};
  const Corners over{{0, -6}, {10, -6}, {10, 1}, {0, 1}};
  // A bed that hangs over: air under the overturned limb, over itself.
  const Corners hook{{0, 0}, {10, 0}, {10, 9}, {3, 9}, {3, 8}, {9, 8}, {9, 1}, {0, 1}};
  EXPECT_TRUE(open_of(drawn({{"A", upper}, {"B", touching}})).empty());
  EXPECT_TRUE(open_of(drawn({{"A", upper}, {"B", beside}})).empty());
  EXPECT_TRUE(open_of(drawn({{"A", upper}, {"B", over}})).empty());
  EXPECT_TRUE(open_of(drawn({{"A", hook}, {"B", {{0, -6}, {10, -6}, {10, 0}, {0, 0}}}})).empty());
  // A gap that is closed on all sides is a face, told as such.
  EXPECT_TRUE(open_of(drawn({{"A", upper}, {"B", {{0, -6}, {10, -6}, {10, 0}, {5, -2}, {0, 0}}}})).empty());
  // Air over a topography; within a border every place is asked for.
  Section section = drawn({{"A", upper}, {"B", {{0, -6}, {10, -6}, {10, -1}, {0, -2}}}});
  section.lines.push_back({LineId(0), LineKind::Topography, "ground", {{{-1, -0.5}, {11, -0.5}}, false}, {}});
  EXPECT_TRUE(open_of(section).empty());
  section.lines.clear();
  section.border = geom::Polyline{{{0, -6}, {10, -6}, {10, 5}, {0, 5}}, true};
  EXPECT_TRUE(open_of(section).empty());
  const auto made = faces_of(section);
  ASSERT_EQ(made->misfits.size(), 1u);
  EXPECT_DOUBLE_EQ(made->misfits[0].area, 15.0);
}

TEST(OpenGaps, RandomStripsHaveTheAreaBetweenTheirLines) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int run = 0; run < 40; ++run) {
    // Two lines with vertices of their own; the area between by the rule of trapezoids of each.
    double between = 0.0;
    const auto line = [&](double level, double sign) {
      Corners points{{0.0, level - uniform(random)}};
      while (points.back().x < 95.0)
        points.push_back({points.back().x + 1.0 + uniform(random), level - uniform(random)});
      points.push_back({100.0, level - uniform(random)});
      for (std::size_t i = 1; i < points.size(); ++i)
        between += sign * 0.5 * (points[i].x - points[i - 1].x) * (points[i].y + points[i - 1].y);
      return points;
    };
    Corners roof = line(10.0, 1.0), floor = line(8.9, -1.0);
    roof.push_back({100.0, 20.0}), roof.push_back({0.0, 20.0});
    floor.push_back({100.0, 0.0}), floor.push_back({0.0, 0.0});
    const auto open = open_of(drawn({{"A", roof}, {"B", floor}}));
    ASSERT_EQ(open.size(), 1u) << run;
    EXPECT_NEAR(open[0].area, between, 1e-9 * between) << run;
    EXPECT_DOUBLE_EQ(open[0].open_over, 100.0) << run;
  }
}

TEST(OpenGaps, TheRemarkSaysHowWideTheGapIsAndWhere) {
  const Section section = drawn({{"A", upper}, {"B", {{0, -6}, {10, -6}, {10, -1}, {0, -2}}}});
  const auto made = faces_of(section);
  ASSERT_TRUE(made);
  const auto told = remarks_of(*made, section);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0],
            "gap of 15 m2, 10 m wide and open at the side of the drawing, between the units A, B at (5, -0.75)");
}

}  // namespace
}  // namespace recon::section
