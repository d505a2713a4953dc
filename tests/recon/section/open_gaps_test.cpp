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

Corners box(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

void add_ground(Section& section, const Corners& points) {
  section.lines.push_back({LineId(section.lines.size()), LineKind::Topography, "ground", {points, false}, {}});
}

TEST(OpenGaps, StepsValleysAndWhatIsDrawnUnequallyDeepAreNoGaps) {
  const Corners low = box(0, -20, 300, 0);
  // Steps of a topography, to either side; beds that end one after the other at the side.
  EXPECT_TRUE(open_of(drawn({{"L", low}, {"A", box(0, 0, 100, 40)}})).empty());
  EXPECT_TRUE(open_of(drawn({{"L", low}, {"A", box(0, 0, 100, 40)}, {"B", box(100, 0, 200, 20)}})).empty());
  EXPECT_TRUE(open_of(drawn({{"L", low}, {"A", box(0, 0, 200, 10)}, {"B", box(50, 10, 150, 20)}})).empty());
  // Valleys between slopes of two units, over a third one, and down to where the two meet; with cliffs.
  const Corners left{{0, 0}, {120, 0}, {60, 50}, {0, 60}}, right{{180, 0}, {300, 0}, {300, 70}, {250, 50}};
  EXPECT_TRUE(open_of(drawn({{"L", low}, {"A", left}, {"B", right}})).empty());
  const Corners west{{0, 0}, {150, 0}, {60, 50}, {0, 60}}, east{{150, 0}, {300, 0}, {300, 70}, {250, 50}};
  EXPECT_TRUE(open_of(drawn({{"A", west}, {"B", east}})).empty());
  EXPECT_TRUE(open_of(drawn({{"L", low}, {"A", box(0, 0, 100, 60)}, {"B", box(200, 0, 300, 60)}})).empty());
  // A slope that hangs over another unit is told as far as it does, and makes no gap of the valley.
  const Corners overhang{{0, 0}, {110, 0}, {115, 30}, {0, 40}}, far{{190, 0}, {300, 0}, {300, 40}, {195, 40}};
  const auto hanging = open_of(drawn({{"L", low}, {"A", overhang}, {"B", far}}));
  ASSERT_EQ(hanging.size(), 1u);
  EXPECT_DOUBLE_EQ(hanging[0].area, 5.0 * 30.0 / 2.0);
  // The same under the section: the unit in the middle is drawn less deep.
  EXPECT_TRUE(
      open_of(drawn({{"A", box(0, -60, 100, 0)}, {"M", box(100, -10, 200, 0)}, {"B", box(200, -60, 300, 0)}})).empty());
  // A bay of one unit that another one faces.
  const Corners bay{{0, 0}, {50, 0}, {50, 10}, {10, 10}, {10, 30}, {50, 30}, {50, 40}, {0, 40}};
  EXPECT_TRUE(open_of(drawn({{"A", bay}})).empty());
}

TEST(OpenGaps, AnUprightStripIsToldWithItsAreaHeightAndMiddle) {
  const auto open = open_of(drawn({{"A", box(0, 0, 50, 40)}, {"B", box(60, 0, 100, 40)}}));
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0].between, "A, B");
  EXPECT_DOUBLE_EQ(open[0].area, 400.0);
  EXPECT_TRUE(open[0].upright);
  EXPECT_DOUBLE_EQ(open[0].open_over, 40.0);
  EXPECT_EQ(open[0].place, (geom::Point{55, 20}));
  EXPECT_EQ(words_of(open[0]),
            "gap of 400 m2, 40 m high and open at the top or the bottom of the drawing, between the units A, B");
}

TEST(OpenGaps, StripsBetweenUnitsOfUnequalHeightHairsAndBlocksFarApartAreTold) {
  const auto area = [](const std::vector<std::pair<std::string, Corners>>& units) {
    const auto open = open_of(drawn(units));
    EXPECT_EQ(open.size(), 1u);
    return open.empty() ? 0.0 : open[0].area;
  };
  // As far as both face each other.
  EXPECT_DOUBLE_EQ(area({{"A", box(0, -30, 50, 40)}, {"B", box(60, 0, 100, 25)}}), 250.0);
  EXPECT_DOUBLE_EQ(area({{"A", box(0, 0, 50, 40)}, {"B", box(500, 0, 550, 40)}}), 450.0 * 40.0);
  EXPECT_NEAR(area({{"A", box(0, 0, 50, 40)}, {"B", box(50 + 1e-5, 0, 100, 40)}}), 40e-5, 1e-9);
  EXPECT_NEAR(area({{"A", box(0, 0, 50, 40)}, {"B", {{50, 0}, {100, 0}, {100, 40}, {50.01, 40}}}}), 0.2, 1e-9);
  // Rounding is no gap.
  EXPECT_TRUE(open_of(drawn({{"A", box(0, 0, 50, 40)}, {"B", box(50 + 1e-12, 0, 100, 40)}})).empty());
  // Over a unit that goes on below, and under one that goes on above; a wedge that closes below.
  EXPECT_DOUBLE_EQ(area({{"L", box(0, -20, 100, 0)}, {"A", box(0, 0, 50, 40)}, {"B", box(60, 0, 100, 40)}}), 400.0);
  EXPECT_DOUBLE_EQ(area({{"U", box(0, 40, 100, 60)}, {"A", box(0, 0, 50, 40)}, {"B", box(60, 0, 100, 40)}}), 400.0);
  EXPECT_DOUBLE_EQ(area({{"A", box(0, 0, 50, 40)}, {"B", {{50, 0}, {100, 0}, {100, 40}, {60, 40}}}}), 200.0);
}

TEST(OpenGaps, StripsThatLeanAreToldOnce) {
  // Across a corner of the section, from its left side to its top: neither way of looking sees both ends.
  const Corners under{{0, 0}, {100, 0}, {100, 100}, {60, 100}, {0, 40}}, corner{{0, 50}, {50, 100}, {0, 100}};
  const auto across = open_of(drawn({{"A", under}, {"B", corner}}));
  ASSERT_EQ(across.size(), 1u);
  EXPECT_NEAR(across[0].area, (60.0 * 60.0 - 50.0 * 50.0) / 2.0, 1e-9);
  // From upright to nearly level, 10 m to the right, 100 m high.
  for (const double lean : {-300.0, -40.0, -1.0, 1.0, 40.0, 90.0, 110.0, 300.0}) {
    const Corners left{{-400, 0}, {0, 0}, {lean, 100}, {-400, 100}},
        right{{10, 0}, {500, 0}, {500, 100}, {10 + lean, 100}};
    const auto open = open_of(drawn({{"A", left}, {"B", right}}));
    ASSERT_EQ(open.size(), 1u) << lean;
    EXPECT_NEAR(open[0].area, 1000.0, 1e-9) << lean;
    EXPECT_TRUE(open[0].upright) << lean;  // it is open at the top and the bottom
  }
}

TEST(OpenGaps, SeveralUprightStripsAreSeveral) {
  const auto open = open_of(drawn({{"A", box(0, 0, 50, 40)}, {"B", box(60, 0, 100, 40)}, {"C", box(105, 0, 200, 40)}}));
  ASSERT_EQ(open.size(), 2u);
  EXPECT_DOUBLE_EQ(open[0].area + open[1].area, 400.0 + 200.0);
}

TEST(OpenGaps, UnderATopographyAValleyIsAGapAndOverItNothingIs) {
  const std::vector<std::pair<std::string, Corners>> valley{
      {"L", box(0, -20, 300, 0)}, {"A", box(0, 0, 100, 60)}, {"B", box(200, 0, 300, 60)}};
  Section section = drawn(valley);
  add_ground(section, {{-1, 60}, {301, 60}});
  const auto open = open_of(section);
  ASSERT_EQ(open.size(), 1u);
  EXPECT_DOUBLE_EQ(open[0].area, 6000.0);
  Section gorge = drawn({{"L", box(0, -20, 100, 0)}, {"A", box(0, 0, 50, 40)}, {"B", box(60, 0, 100, 40)}});
  EXPECT_EQ(open_of(gorge).size(), 1u);
  add_ground(gorge, {{0, 40}, {50, 40}, {50, 0}, {60, 0}, {60, 40}, {100, 40}});
  EXPECT_TRUE(open_of(gorge).empty());
}

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
  const Corners touching{{0, -6}, {10, -6}, {10, 0}, {0, 0}}, beside{{10, 0}, {20, 0}, {20, 5}, {10, 5}};
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
  const auto told = misfit_remarks(*made);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].text,
            "gap of 15 m2, 10 m wide and open at the side of the drawing, between the units A, B at (5, -0.75)");
}

}  // namespace
}  // namespace recon::section
