#include "recon/input/unit_horizons.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/recon/shapes.h"

namespace recon::input {
namespace {

using geom::Point;
using test::item;

ReadSection read_of(SectionInput input) {
  input.horizons_from_units = true;
  auto read = read_section(input, {}, {});
  EXPECT_TRUE(read) << to_string(read.error());
  return read ? std::move(*read) : ReadSection{};
}

std::string refusal_of(SectionInput input) {
  input.horizons_from_units = true;
  const auto read = read_section(input, {}, {});
  EXPECT_FALSE(read);
  return read ? "" : to_string(read.error());
}

std::vector<std::string> names_of(const ReadSection& read) { return horizon_names(read.section); }
using Names = std::vector<std::string>;

/// Points that a line has beside those that it needs for its course do not count.
double distance_between(const geom::Polyline& a, const geom::Polyline& b) {
  double most = 0.0;
  for (const auto& [one, other] : {std::pair(&a, &b), {&b, &a}}) {
    for (const Point p : one->points) most = std::max(most, geom::distance(*other, p));
  }
  return most;
}

bool tells(const ReadSection& read, const std::string& what) {
  return std::any_of(read.remarks.begin(), read.remarks.end(),
                     [&](const std::string& remark) { return remark.find(what) != std::string::npos; });
}

TEST(UnitHorizons, SharedEdgesBecomeHorizonsNamedByTheUnitBelowFromTheTopDown) {
  SectionInput input;
  input.units = {item("C", {{0, -30}, {100, -30}, {100, -12}, {50, -20}, {0, -10}}),
                 item("A", {{0, 0}, {60, 5}, {100, 0}, {100, 20}, {0, 20}}),
                 item("B", {{0, -10}, {50, -20}, {100, -12}, {100, 0}, {60, 5}, {0, 0}})};
  const ReadSection read = read_of(input);
  ASSERT_EQ(names_of(read), (Names{"B", "C"}));
  EXPECT_EQ(read.section.horizons[0].line.points, (std::vector<Point>{{0, 0}, {60, 5}, {100, 0}}));
  EXPECT_EQ(read.section.horizons[1].line.points, (std::vector<Point>{{0, -10}, {50, -20}, {100, -12}}));
}

TEST(UnitHorizons, AFaultCutsTopsIntoPiecesAndItsEdgesAreNone) {
  // The fault x = 50 + 0.1 z, drawn as the polygons' edges are, beside them, and as a line that goes on.
  for (const double beside : {0.0, 0.04, -0.06}) {
    SectionInput input;
    input.units = {item("A_1", {{0, 0}, {50, 0}, {52, 20}, {0, 20}}),
                   item("B_1", {{0, -20}, {48, -20}, {50, 0}, {0, 0}}),
                   item("A_2", {{49, -10}, {100, -10}, {100, 20}, {52, 20}, {50, 0}}),
                   item("B_2", {{47, -30}, {100, -30}, {100, -10}, {49, -10}, {48, -20}})};
    input.faults = {item("F", {{53 + beside, 30}, {46 + beside, -40}})};
    const ReadSection read = read_of(input);
    ASSERT_EQ(names_of(read), (Names{"B (1)", "B (2)"})) << beside;
    EXPECT_EQ(read.section.horizons[0].piece_of, "B");
    const geom::Polyline left{{{0, 0}, {50 + beside, 0}}, false};
    const geom::Polyline right{{{49 + beside, -10}, {100, -10}}, false};
    EXPECT_LE(distance_between(read.section.horizons[0].line, left), 0.12 * std::abs(beside) + 1e-12) << beside;
    EXPECT_LE(distance_between(read.section.horizons[1].line, right), 0.12 * std::abs(beside) + 1e-12) << beside;
    EXPECT_LE(geom::distance(read.section.lines[0].line, read.section.horizons[0].line.points.back()), 1e-12);
    EXPECT_FALSE(tells(read, "run together")) << beside;
    EXPECT_TRUE(tells(read, "'B_1', 'B_2' are taken as pieces of unit 'B'"));
  }
}

/// A wavy surface, and polygons between such surfaces whose edges were drawn twice with errors.
double surface(std::size_t i, double x) { return -100.0 * static_cast<double>(i) + 20.0 * std::sin(x / 80.0); }

HorizonInput untidy(std::size_t i, double error, std::mt19937& random) {
  std::uniform_real_distribution<double> some(-error, error);
  std::vector<Point> points;
  for (int k = 0; k <= 50; ++k) points.push_back({20.0 * k, surface(i, 20.0 * k) + some(random)});
  for (int k = 70; k >= 0; --k) points.push_back({1000.0 / 70.0 * k, surface(i + 1, 1000.0 / 70.0 * k) + some(random)});
  points.push_back(points.front());
  return item("U" + std::string(1, static_cast<char>('a' + i)), points);
}

TEST(UnitHorizons, EdgesDrawnTwiceWithGapsAndOverlapsGiveOneHorizonFromSideToSide) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    const double error = seed % 2 == 0 ? 0.4 : 0.05;
    SectionInput input;
    for (std::size_t i = 0; i < 5; ++i) input.units.push_back(untidy(i, error, random));
    const ReadSection read = read_of(input);
    ASSERT_EQ(names_of(read), (Names{"Ub", "Uc", "Ud", "Ue"})) << seed;
    for (std::size_t i = 0; i < 4; ++i) {
      const geom::Polyline& line = read.section.horizons[i].line;
      EXPECT_EQ(line.points.front().x, 0.0);
      EXPECT_EQ(line.points.back().x, 1000.0);
      for (const Point p : line.points)
        EXPECT_NEAR(p.y, surface(i + 1, p.x), error + 0.7) << seed;  // 0.65: a chord's rise
      EXPECT_LT(geom::length(line), 1030.0);
    }
  }
}

TEST(UnitHorizons, AGapWiderThanTheToleranceIsNoEdgeAndAGivenToleranceBridgesIt) {
  SectionInput input;
  input.units = {item("A", {{0, 2}, {100, 2}, {100, 20}, {0, 20}}),
                 item("B", {{0, -20}, {100, -20}, {100, 0}, {0, 0}})};
  EXPECT_NE(refusal_of(input).find("share_edges"), std::string::npos);
  input.share_edges = 3.0;
  EXPECT_EQ(names_of(read_of(input)), Names{"B"});
}

TEST(UnitHorizons, AUnitWithinAnotherHasATopAndABase) {
  SectionInput input;
  input.units = {item("lens", {{30, 0}, {50, -5}, {70, 0}, {50, 5}}),
                 item("A", {{0, -20}, {100, -20}, {100, 20}, {0, 20}}),
                 item("B", {{0, -40}, {100, -40}, {100, -20}, {0, -20}})};
  const ReadSection read = read_of(input);
  ASSERT_EQ(names_of(read), (Names{"lens", "base of lens", "B"}));
  EXPECT_EQ(read.section.horizons[0].line.points, (std::vector<Point>{{30, 0}, {50, 5}, {70, 0}}));
  EXPECT_EQ(read.section.horizons[1].line.points, (std::vector<Point>{{30, 0}, {50, -5}, {70, 0}}));
  EXPECT_TRUE(tells(read, "unit 'lens' ends within unit 'A'"));
}

TEST(UnitHorizons, AnOverturnedLimbStaysInItsHorizon) {
  // The edge goes right, back to the left beneath itself, and right again.
  const std::vector<Point> edge = {{0, 0}, {60, 10}, {65, 0}, {30, -10}, {35, -20}, {100, -15}};
  std::vector<Point> upper = edge;
  upper.insert(upper.end(), {{100, 40}, {0, 40}});
  std::vector<Point> lower = edge;
  lower.insert(lower.end(), {{100, -60}, {0, -60}});
  SectionInput input;
  input.units = {item("young", upper), item("old", lower)};
  const ReadSection read = read_of(input);
  ASSERT_EQ(names_of(read), Names{"old"});
  EXPECT_EQ(read.section.horizons[0].line.points, edge);
}

TEST(UnitHorizons, AnUprightEdgeIsTheTopOfNeitherAndIsTold) {
  SectionInput input;
  input.units = {item("west", {{0, 0}, {50, 0}, {51, 10}, {49, 20}, {51, 30}, {50, 40}, {0, 40}}),
                 item("east", {{50, 0}, {100, 0}, {100, 40}, {50, 40}, {51, 30}, {49, 20}, {51, 10}}),
                 item("base", {{0, -20}, {100, -20}, {100, 0}, {50, 0}, {0, 0}})};
  const ReadSection read = read_of(input);
  EXPECT_EQ(names_of(read), Names{"base"});
  EXPECT_TRUE(tells(read, "the edge between 'west' and 'east'"));
}

TEST(UnitHorizons, PolygonsThatMeetInAPointAreApart) {
  SectionInput input;
  input.units = {item("T", {{0, 0}, {50, 0}, {100, 0}, {100, 10}, {0, 10}}), item("M_1", {{0, 0}, {0, -10}, {50, 0}}),
                 item("M_2", {{50, 0}, {100, -10}, {100, 0}}),
                 item("L", {{0, -10}, {0, -20}, {100, -20}, {100, -10}, {50, 0}})};
  const ReadSection read = read_of(input);
  ASSERT_EQ(names_of(read), (Names{"M (1)", "M (2)", "L"}));
  EXPECT_EQ(read.section.horizons[2].line.points, (std::vector<Point>{{0, -10}, {50, 0}, {100, -10}}));
}

TEST(UnitHorizons, NumberedUnitsThatLieOnEachOtherAreUnitsOfTheirOwn) {
  SectionInput input;
  for (int i = 0; i < 3; ++i) {
    const double z = -10.0 * i;
    input.units.push_back(item("Unit_" + std::to_string(i + 1), {{0, z}, {100, z}, {100, z - 10}, {0, z - 10}}));
  }
  EXPECT_EQ(names_of(read_of(input)), (Names{"Unit_2", "Unit_3"}));
}

TEST(UnitHorizons, ATopographyIsNoHorizonAndAnErodedUnitIsInPieces) {
  SectionInput input;
  input.units = {item("A_1", {{0, 0}, {40, 0}, {0, 20}}), item("A_2", {{60, 0}, {100, 0}, {100, 20}, {60, 0}}),
                 item("B", {{0, -30}, {100, -30}, {100, 0}, {60, 0}, {50, -5}, {40, 0}, {0, 0}})};
  input.topographies = {item("today", {{0, 20}, {40, 0}, {50, -5}, {60, 0}, {100, 20}})};
  const ReadSection read = read_of(input);
  ASSERT_EQ(names_of(read), (Names{"B (1)", "B (2)"}));
  EXPECT_EQ(read.section.horizons[1].line.points, (std::vector<Point>{{60, 0}, {100, 0}}));
}

TEST(UnitHorizons, WhatCannotBeMadeIsRefused) {
  SectionInput none;
  none.horizons = {item("A", {{0, 0}, {100, 0}})};
  EXPECT_NE(refusal_of(none).find("no polygon"), std::string::npos);
  SectionInput twice;
  twice.units = {item("A", {{0, 0}, {100, 0}, {100, 20}, {0, 20}}),
                 item("B", {{0, -20}, {100, -20}, {100, 0}, {0, 0}})};
  twice.horizons = {item("B", {{0, -5}, {100, -5}})};
  EXPECT_NE(refusal_of(twice).find("horizon 'B'"), std::string::npos);
  SectionInput along;  // the one edge that they share is a fault
  along.units = {item("A", {{0, 0}, {50, 0}, {50, 20}, {0, 20}}), item("B", {{50, 0}, {100, 0}, {100, 20}, {50, 20}})};
  along.faults = {item("F", {{50, 30}, {50, -10}})};
  EXPECT_NE(refusal_of(along).find("no fault"), std::string::npos);
}

/// Three layers of 300 m over 1000 m whose shared edges were drawn twice, `gap` apart (negative: one over the other),
/// with sides that lean, in any order in the file.
SectionInput layers_with_gaps(double gap_left, double gap_right, double lean, const std::vector<std::size_t>& order) {
  std::vector<HorizonInput> items;
  for (const std::size_t i : order) {
    const auto side = [&](double x, double z) { return Point{x + lean * z, z}; };
    const double top = -300.0 * static_cast<double>(i);
    const double base = top - 300.0;
    items.push_back(item(std::string(1, static_cast<char>('Q' + i)),
                         {side(0, base + gap_left), side(500, base + 20 + 0.5 * (gap_left + gap_right)),
                          side(1000, base + gap_right), side(1000, top), side(500, top + 20), side(0, top)}));
  }
  SectionInput input;
  input.units = items;
  return input;
}

TEST(UnitHorizons, NoEndOfAHorizonTurnsIntoAGap) {
  for (const double gap : {0.05, 0.4, 1.1, -0.3, -1.0}) {
    for (const double lean : {0.0, 0.3, -0.5}) {
      for (const auto& [left, right] : {std::pair(gap, gap), {gap, 0.0}, {0.0, gap}}) {
        for (const auto& order : std::vector<std::vector<std::size_t>>{{0, 1, 2}, {2, 1, 0}, {1, 2, 0}}) {
          const ReadSection read = read_of(layers_with_gaps(left, right, lean, order));
          const std::string which = fmt::format("{} {} {} {}", left, right, lean, order[0]);
          ASSERT_EQ(names_of(read), (Names{"R", "S"})) << which;
          for (std::size_t i = 0; i < 2; ++i) {
            const std::vector<Point>& points = read.section.horizons[i].line.points;
            const double z = -300.0 * static_cast<double>(i + 1);
            EXPECT_LE(geom::distance(points.front(), {lean * z, z}), 1.5 * std::abs(gap) + 0.05) << which;
            EXPECT_LE(geom::distance(points.back(), {1000.0 + lean * z, z}), 1.5 * std::abs(gap) + 0.05) << which;
            // Edges dip by 0.04 and a little: no piece dips more steeply.
            for (std::size_t k = 1; k < points.size(); ++k)
              EXPECT_LT(std::abs(points[k].y - points[k - 1].y), 0.1 * (points[k].x - points[k - 1].x)) << which;
          }
        }
      }
    }
  }
}

TEST(UnitHorizons, EveryUnitHasItsTopHoweverItsSidesLeanAndItsEdgesOverlap) {
  std::mt19937_64 random(11);
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<>(from, to)(random); };
  std::vector<std::size_t> order{0, 1, 2};
  for (int run = 0; run < 200; ++run) {
    const double lean = run % 4 == 0 ? -0.8 : run % 4 == 1 ? -0.5 : uniform(-1, 1);
    const double overlap = run % 8 == 0 ? 0.3 : std::pow(10.0, uniform(-9, 0));
    const double width = run % 2 == 0 ? 100.0 * std::round(uniform(8, 90)) : uniform(800, 9000);
    std::shuffle(order.begin(), order.end(), random);
    SectionInput input;
    for (const std::size_t i : order) {
      const double base = -300.0 * static_cast<double>(i + 1);
      const double top = base + 300.0 + (i == 0 ? 0.0 : run % 3 == 0 ? -overlap : overlap);
      const auto at = [&](double x, double z) { return Point{x + lean * z, z}; };
      input.units.push_back(
          item(std::string(1, static_cast<char>('Q' + i)), {at(0, base), at(width, base), at(width, top), at(0, top)}));
    }
    const ReadSection read = read_of(input);
    const std::string which = fmt::format("run {}: lean {} overlap {} width {}", run, lean, overlap, width);
    ASSERT_EQ(names_of(read), (Names{"R", "S"})) << which;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::vector<Point>& points = read.section.horizons[i].line.points;
      const double z = -300.0 * static_cast<double>(i + 1);
      EXPECT_LE(geom::distance(points.front(), {lean * z, z}), 1.5 * overlap + 1e-12) << which;
      EXPECT_LE(geom::distance(points.back(), {width + lean * z, z}), 1.5 * overlap + 1e-12) << which;
      for (const Point p : points) EXPECT_LE(std::abs(p.y - z), overlap + 1e-12) << which;
    }
  }
}

TEST(UnitHorizons, AUnitThatOthersCoverIsTold) {
  SectionInput input;
  input.units = {item("A", {{0, 0}, {100, 0}, {100, 20}, {0, 20}}),
                 item("old B", {{0, -20}, {100, -20}, {100, 0}, {0, 0}}),
                 item("B", {{0, -20}, {100, -20}, {100, 0}, {0, 0}})};
  const ReadSection read = read_of(input);
  EXPECT_EQ(names_of(read), (Names{"B"}));
  EXPECT_TRUE(tells(read, "unit 'old B' at (0, -20) lies wholly under 'B'"));
  input.units.erase(input.units.begin());
  EXPECT_NE(refusal_of(input).find("unit 'old B' at (0, -20) lies wholly under 'B'"), std::string::npos);
}

}  // namespace
}  // namespace recon::input
