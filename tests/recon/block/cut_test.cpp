#include "recon/block/cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "shared/geom/contour.h"
#include "tests/recon/block/sections.h"

namespace recon::block {
namespace {

using test::horizon;
using test::line;
using test::Point;
using test::told;
using test::unit;

constexpr double degree = std::numbers::pi / 180.0;

BlockCut cut_along(const Block& block, Point from, Point to) {
  const auto frame = cut_over(block, from, to);
  EXPECT_TRUE(frame) << to_string(frame.error());
  auto made = frame ? cut(block, *frame) : base::Result<BlockCut>(frame.error());
  EXPECT_TRUE(made) << to_string(made.error());
  return made ? std::move(*made) : BlockCut{};
}

void expect_points(const std::vector<Point>& was, const std::vector<Point>& is, const std::string& name) {
  ASSERT_EQ(was.size(), is.size()) << name;
  double size = 1.0;
  for (const Point p : was) size = std::max({size, std::abs(p.x), std::abs(p.y)});
  for (std::size_t i = 0; i < was.size(); ++i) EXPECT_LE(geom::distance(was[i], is[i]), 1e-12 * size) << name << i;
}

/// All lines of one section are in the other, in their order, with their names and points.
void expect_same(const section::Section& was, const section::Section& is) {
  ASSERT_EQ(was.horizons.size(), is.horizons.size());
  for (std::size_t i = 0; i < was.horizons.size(); ++i) {
    EXPECT_EQ(was.horizons[i].name, is.horizons[i].name);
    EXPECT_EQ(was.horizons[i].piece_of, is.horizons[i].piece_of);
    EXPECT_EQ(was.horizons[i].role, is.horizons[i].role);
    expect_points(was.horizons[i].line.points, is.horizons[i].line.points, was.horizons[i].name);
  }
  ASSERT_EQ(was.lines.size(), is.lines.size());
  for (std::size_t i = 0; i < was.lines.size(); ++i) {
    EXPECT_EQ(was.lines[i].name, is.lines[i].name);
    EXPECT_EQ(was.lines[i].kind, is.lines[i].kind);
    EXPECT_EQ(was.lines[i].order, is.lines[i].order);
    EXPECT_EQ(was.lines[i].hanging_wall, is.lines[i].hanging_wall);
    expect_points(was.lines[i].line.points, is.lines[i].line.points, was.lines[i].name);
  }
  ASSERT_EQ(was.units.size(), is.units.size());
  for (std::size_t i = 0; i < was.units.size(); ++i) {
    EXPECT_EQ(was.units[i].name, is.units[i].name);
    expect_points(was.units[i].contour.points, is.units[i].contour.points, was.units[i].name);
  }
  ASSERT_EQ(was.border.has_value(), is.border.has_value());
  if (was.border) expect_points(was.border->points, is.border->points, "border");
  ASSERT_EQ(was.markers.size(), is.markers.size());
  for (std::size_t i = 0; i < was.markers.size(); ++i)
    expect_points(was.markers[i].points, is.markers[i].points, "marker");
  ASSERT_EQ(was.block_names.size(), is.block_names.size());
  for (std::size_t i = 0; i < was.block_names.size(); ++i) {
    EXPECT_EQ(was.block_names[i].name, is.block_names[i].name);
    expect_points({was.block_names[i].at}, {is.block_names[i].at}, "block");
  }
}

/// A section with all that one can have.
section::Section everything() {
  section::Section section = test::faulted();
  section.lines[0].order = 2;
  section.lines[0].hanging_wall = section::HangingWall::Right;
  section.lines.push_back(line(section::LineKind::Pin, "pin", {{3, 10}, {3, -30}}));
  section.lines.push_back(line(section::LineKind::Datum, "datum", {{0, 12}, {100, 12}}));
  section.horizons[0].role = section::BedRole::Growth;
  section.markers.push_back({section::MarkerId(0), "well", {{20, -3}, {20, -7}}, {}});
  section.block_names = {{"foot", {10, -15}, ""}, {"hanging", {90, -10}, "east"}};
  section.border = geom::Polyline{{{0, -28}, {100, -28}, {100, 5}, {0, 5}}, true};
  return test::made(std::move(section));
}

TEST(BlockCut, ItsOwnTraceGivesTheSectionBack) {
  const section::Section was = everything();
  for (const double azimuth : {90.0, 0.0, 37.0, 211.3}) {
    for (const Point origin : {Point{0, 0}, Point{678123.4, 7391234.5}}) {
      const dobra::io::lines::Trace trace{origin.x, origin.y, std::sin(azimuth * degree), std::cos(azimuth * degree)};
      const Block block = test::block(was, 40.0, trace);
      const Point to{origin.x + 100.0 * trace.east, origin.y + 100.0 * trace.north};
      const BlockCut cut = cut_along(block, origin, to);
      ASSERT_FALSE(cut.empty()) << azimuth;
      expect_same(was, cut.section);
      EXPECT_NEAR(cut.area, block.area, 1e-9 * block.area);
      // Anywhere along strike, too: at the end, and between.
      for (const double y : {40.0, 13.7}) {
        const geom::Point3 a = block.on_map({0, y, 0});
        const geom::Point3 b = block.on_map({100, y, 0});
        const BlockCut other = cut_along(block, {a.x, a.y}, {b.x, b.y});
        ASSERT_FALSE(other.empty()) << azimuth << ' ' << y;
        EXPECT_NEAR(other.area, block.area, 1e-6 * block.area);
        if (origin == Point{0, 0}) expect_same(was, other.section);
      }
    }
  }
}

TEST(BlockCut, AlongStrikeThroughAFaultTheFaultBoundsTheSection) {
  // At x = 45 the fault, at z = -2, is the roof of what lies over the base at z = -20: no horizon is there.
  const Block block = test::block(test::faulted(), 64.0);
  const BlockCut cut = cut_along(block, {45, 0}, {45, 64});
  ASSERT_TRUE(cut.section.faces);
  EXPECT_NEAR(cut.area, 18.0 * 64.0, 1e-9);
  EXPECT_FALSE(told(cut.findings, "cut_area"));
  EXPECT_FALSE(told(cut.findings, "cut_flawed"));
  ASSERT_TRUE(cut.section.border);
  EXPECT_NEAR(geom::signed_area(*cut.section.border), 18.0 * 64.0, 1e-9);
  // The block of that section is the one it came from, as far as it goes.
  const Block again = test::block(cut.section, 5.0);
  EXPECT_NEAR(again.volume, 18.0 * 64.0 * 5.0, 1e-8);
  // Beside the fault nothing needs a border.
  EXPECT_FALSE(cut_along(block, {20, 0}, {20, 64}).section.border);
}

TEST(BlockCut, PolygonsComeBackToo) {
  section::Section section;
  section.units = {unit("salt", {{0, -10}, {10, -10}, {10, 0}, {0, 0}}),
                   unit("lens", {{4, -6}, {6, -6}, {6, -4}, {4, -4}})};
  const Block block = test::block(test::made(section), 5.0);
  const BlockCut cut = cut_along(block, {0, 0}, {10, 0});
  expect_same(section, cut.section);
  ASSERT_EQ(cut.units.size(), 2U);
  EXPECT_NEAR(cut.units[0].area, 96.0, 1e-10);
}

TEST(BlockCut, AtAnAngleToStrikeBedsHaveTheirApparentDip) {
  // A bed that dips by 30 degrees to the east; strike is north.
  const double dip = 30.0 * degree;
  section::Section section;
  section.horizons = {horizon("top", {{0, 0}, {100, -100 * std::tan(dip)}}),
                      horizon("base", {{0, -10}, {100, -10 - 100 * std::tan(dip)}})};
  const Block block = test::block(test::made(section), 500.0);
  for (const double angle : {5.0, 30.0, 60.0, 75.0, 120.0, -20.0}) {  // from the section to the cut
    const Point from{angle > 90.0 ? 100.0 : 0.0, angle < 0.0 ? 400.0 : 0.0};
    const BlockCut cut =
        cut_along(block, from, {from.x + 500.0 * std::cos(angle * degree), from.y + 500.0 * std::sin(angle * degree)});
    ASSERT_EQ(cut.section.horizons.size(), 2U) << angle;
    const std::vector<Point>& top = cut.section.horizons[0].line.points;
    const double apparent = std::atan2(top.back().y - top.front().y, top.back().x - top.front().x);
    // tan a = tan d sin (angle between strike and section), of the bed as it falls to the east.
    EXPECT_NEAR(std::tan(apparent), -std::tan(dip) * std::cos(angle * degree), 1e-12);
    EXPECT_NEAR(cut.area, 10.0 * 100.0 / std::abs(std::cos(angle * degree)), 1e-8) << angle;
    EXPECT_NEAR(top.back().x - top.front().x, 100.0 / std::abs(std::cos(angle * degree)), 1e-9);
    EXPECT_FALSE(told(cut.findings, "cut_area"));
  }
}

TEST(BlockCut, SeenFromBehindLeftIsRight) {
  section::Section section = everything();
  section.left_end = "W";
  section.right_end = "E";
  const Block block = test::block(section, 40.0);
  const BlockCut cut = cut_along(block, {100, 20}, {0, 20});
  ASSERT_EQ(cut.section.lines.size(), section.lines.size());
  EXPECT_EQ(cut.section.lines[0].hanging_wall, section::HangingWall::Left);
  EXPECT_EQ(cut.section.left_end, "E");
  EXPECT_EQ(cut.section.right_end, "W");
  const std::vector<Point>& was = section.horizons[0].line.points;
  const std::vector<Point>& is = cut.section.horizons[0].line.points;
  for (std::size_t i = 0; i < was.size(); ++i) {
    EXPECT_EQ(is[was.size() - 1 - i].x, 100.0 - was[i].x);
    EXPECT_EQ(is[was.size() - 1 - i].y, was[i].y);
  }
  EXPECT_NEAR(cut.area, block.area, 1e-9);
}

TEST(BlockCut, AlongStrikeBedsAreLevel) {
  const Block block = test::block(test::layers(), 40.0);
  const BlockCut cut = cut_along(block, {25, 0}, {25, 40});
  ASSERT_EQ(cut.section.horizons.size(), 3U);
  const std::vector<Point> expected{{0, 2}, {40, 2}};
  EXPECT_EQ(cut.section.horizons[0].line.points, expected);
  EXPECT_NEAR(cut.area, 40.0 * 22.0, 1e-9);
  EXPECT_EQ(cut.section.faces->units.size(), 2U);
}

TEST(BlockCut, AnOverturnedBedIsCutInPieces) {
  section::Section section;
  section.horizons = {horizon("top", {{0, 0}, {60, 10}, {40, 20}, {100, 30}}), horizon("base", {{0, -40}, {100, -40}})};
  const Block block = test::block(test::made(section), 10.0);
  const BlockCut cut = cut_along(block, {50, 0}, {50, 10});
  ASSERT_EQ(cut.section.horizons.size(), 4U);
  EXPECT_EQ(cut.section.horizons[0].piece_of, "top");
  EXPECT_EQ(cut.section.horizons[1].piece_of, "top");
  EXPECT_NE(cut.section.horizons[0].name, cut.section.horizons[1].name);
  EXPECT_TRUE(told(cut.findings, "cut_in_pieces"));
  EXPECT_NEAR(cut.area, 10.0 * (25.0 / 3.0 + 40.0 + 65.0 / 3.0 - 15.0), 1e-8);
}

TEST(BlockCut, APlaneThatMissesOrTouchesGivesNothingAndSaysSo) {
  const Block block = test::block(test::layers(), 40.0);
  for (const auto& [from, to] : {std::pair(Point{0, 41}, Point{100, 41}), std::pair(Point{0, -1}, Point{100, -1}),
                                 std::pair(Point{101, 0}, Point{101, 40})}) {
    const BlockCut cut = cut_along(block, from, to);
    EXPECT_TRUE(cut.empty());
    EXPECT_TRUE(cut.section.horizons.empty());
    EXPECT_TRUE(told(cut.findings, "cut_misses"));
  }
  const BlockCut corner = cut_along(block, {101, 0}, {100, 40});  // an edge of the block
  EXPECT_TRUE(told(corner.findings, "cut_touches_edge"));
  const BlockCut touching = cut_along(block, {90, 50}, {110, 30});
  EXPECT_TRUE(touching.empty());
  EXPECT_TRUE(told(touching.findings, "cut_touches_edge"));
  EXPECT_FALSE(cut_over(block, {1, 1}, {1, 1}));
  EXPECT_FALSE(cut_over(block, {1, 1}, {1, std::nan("")}));
}

TEST(BlockCut, APlaneAlongAnUprightFaultTellsThatItTakesOneSide) {
  section::Section section;
  section.horizons = {horizon("top", {{0, 0}, {100, 0}}), horizon("base", {{0, -40}, {100, -40}})};
  section.units.push_back(unit("left", {{0, -40}, {50, -40}, {50, 0}, {0, 0}}));
  section.units.push_back(unit("right", {{50, -40}, {100, -40}, {100, 0}, {50, 0}}));
  const Block block = test::block(test::made(section), 10.0);
  const BlockCut along = cut_along(block, {50, 0}, {50, 10});
  EXPECT_TRUE(told(along.findings, "cut_in_face"));
  EXPECT_NEAR(along.area, 400.0, 1e-9);
  EXPECT_FALSE(told(cut_along(block, {49, 0}, {49, 10}).findings, "cut_in_face"));
  EXPECT_FALSE(told(cut_along(block, {0, 0}, {100, 0}).findings, "cut_in_face"));  // an end of the block
  EXPECT_FALSE(told(cut_along(block, {100, 0}, {0, 0}).findings, "cut_in_face"));
}

TEST(BlockCut, WhatLeavesTheBlockEndsAtItsEnd) {
  const Block block = test::block(test::layers(), 40.0);
  const BlockCut cut = cut_along(block, {20, 0}, {60, 40});  // 45 degrees, from start to end
  ASSERT_EQ(cut.section.horizons.size(), 3U);
  const double root = std::sqrt(2.0);
  const std::vector<Point>& top = cut.section.horizons[0].line.points;
  ASSERT_EQ(top.size(), 3U);
  EXPECT_NEAR(top[0].x, 0.0, 1e-12);
  EXPECT_NEAR(top[0].y, 1.6, 1e-12);
  EXPECT_NEAR(top[1].x, 30.0 * root, 1e-12);
  EXPECT_NEAR(top[2].x, 40.0 * root, 1e-12);
  EXPECT_NEAR(top[2].y, 3.2, 1e-12);
  EXPECT_NEAR(cut.area, root * (20.0 * 40.0 + 0.5 * (1.6 + 4.0) * 30.0 + 0.5 * (4.0 + 3.2) * 10.0), 1e-9);
  EXPECT_FALSE(told(cut.findings, "cut_area"));
  EXPECT_EQ(cut.section.faces->units.size(), 2U);
}

TEST(BlockCut, ATraceThatEndsBeforeTheBlockGivesNothing) {
  const Block block = test::block(test::layers(), 40.0);
  for (const auto& [from, to] : {std::pair(Point{-90, 20}, Point{-1, 20}), std::pair(Point{101, 20}, Point{190, 20}),
                                 std::pair(Point{-90, 20}, Point{0, 20}), std::pair(Point{50, 41}, Point{50, 90}),
                                 std::pair(Point{10, -60}, Point{20, -1}), std::pair(Point{190, 20}, Point{100, 20})}) {
    const BlockCut cut = cut_along(block, from, to);
    EXPECT_TRUE(cut.empty()) << from.x;
    EXPECT_TRUE(cut.section.horizons.empty());
    EXPECT_EQ(cut.area, 0.0);
    EXPECT_TRUE(told(cut.findings, "cut_misses"));
  }
  EXPECT_FALSE(cut_along(block, {-90, 20}, {1, 20}).empty());
}

TEST(BlockCut, TheSectionEndsWhereTheTraceEnds) {
  const Block block = test::block(test::layers(), 40.0);
  const BlockCut cut = cut_along(block, {20, 10}, {60, 10});
  ASSERT_EQ(cut.section.horizons.size(), 3U);
  EXPECT_EQ(cut.section.horizons[0].line.points, (std::vector<Point>{{0, 1.6}, {30, 4}, {40, 3.2}}));
  EXPECT_EQ(cut.section.horizons[1].line.points, (std::vector<Point>{{0, -10}, {40, -10}}));
  ASSERT_EQ(cut.units.size(), 2U);
  EXPECT_NEAR(cut.units[0].area, 400.0 + 0.5 * 5.6 * 30.0 + 0.5 * 7.2 * 10.0, 1e-10);
  EXPECT_NEAR(cut.units[1].area, 400.0, 1e-10);
  EXPECT_EQ(cut.units[0].parts, 1U);
  EXPECT_TRUE(cut.findings.empty());
  EXPECT_EQ(cut.section.faces->units.size(), 2U);
  // From behind, and askew: 30 m east and 40 m north.
  const BlockCut behind = cut_along(block, {60, 10}, {20, 10});
  EXPECT_EQ(behind.section.horizons[0].line.points, (std::vector<Point>{{0, 3.2}, {10, 4}, {40, 1.6}}));
  EXPECT_NEAR(behind.area, cut.area, 1e-10);
  const BlockCut askew = cut_along(block, {40, -10}, {64, 22});
  const std::vector<Point>& top = askew.section.horizons[0].line.points;
  ASSERT_EQ(top.size(), 3U);
  EXPECT_NEAR(top[0].x, 12.5, 1e-12);  // the block begins there
  EXPECT_NEAR(top[1].x, 10.0 / 0.6, 1e-12);
  EXPECT_EQ(top[2].x, 40.0);
  EXPECT_NEAR(top[2].y, 4.0 * 36.0 / 50.0, 1e-12);
  EXPECT_NEAR(askew.units[1].area, 275.0, 1e-10);
  EXPECT_FALSE(told(askew.findings, "cut_area"));
}

TEST(BlockCut, WhatLiesBeyondTheTraceIsLeftOut) {
  const Block block = test::block(everything(), 40.0);
  const BlockCut cut = cut_along(block, {15, 20}, {65, 20});
  ASSERT_TRUE(cut.section.border);
  EXPECT_EQ(cut.section.border->box().low, (Point{0, -28}));
  EXPECT_EQ(cut.section.border->box().high, (Point{50, 5}));
  EXPECT_EQ(geom::signed_area(*cut.section.border), 50.0 * 33.0);
  EXPECT_TRUE(cut.section.block_names.empty());
  ASSERT_EQ(cut.section.markers.size(), 1U);
  for (const section::SectionLine& line : cut.section.lines) {
    EXPECT_NE(line.name, "pin");
    EXPECT_NE(line.name, "blind");  // it only touches the plane at the trace's end
  }
  ASSERT_EQ(cut.section.horizons.size(), 3U);  // "base (2)" begins at x = 70
  EXPECT_EQ(cut.section.horizons[1].line.points.back(), (Point{50, -4}));
  EXPECT_NEAR(cut.area, 50.0 * 33.0, 1e-9);
}

TEST(BlockCut, TwoTracesThatFollowEachOtherHaveTheAreasOfTheWhole) {
  std::mt19937 random(5);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  section::Section section;
  section.units = {unit("c", {{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 20}, {30, 20}, {30, 30}, {0, 30}}),
                   unit("in", {{10, 10}, {30, 10}, {30, 20}, {10, 20}})};
  const Block block = test::block(test::made(section), 20.0);
  const auto areas = [&](Point from, Point to) {
    std::map<std::string, double> found;
    const BlockCut cut = cut_along(block, from, to);
    for (const CutUnit& unit : cut.units) found[unit.name] += unit.area;
    double drawn = 0.0;
    for (const section::Unit& unit : cut.section.units) drawn += geom::signed_area(unit.contour);
    EXPECT_NEAR(drawn, cut.area, 1e-9);
    return found;
  };
  for (int i = 0; i < 60; ++i) {
    const Point a{draw(-5, 35), draw(-5, 25)};
    const Point c{draw(-5, 35), draw(-5, 25)};
    const Point b = a + draw(0.1, 0.9) * (c - a);
    auto whole = areas(a, c);
    auto first = areas(a, b);
    auto second = areas(b, c);
    for (const char* name : {"c", "in"}) EXPECT_NEAR(first[name] + second[name], whole[name], 1e-8) << i << name;
  }
}

TEST(BlockCut, PolygonsThatLeaveTheBlockAreClosedAlongItsEnd) {
  section::Section section;  // a C that opens to the right, and what is in it
  section.units = {unit("c", {{0, 0}, {30, 0}, {30, 10}, {10, 10}, {10, 20}, {30, 20}, {30, 30}, {0, 30}}),
                   unit("in", {{10, 10}, {30, 10}, {30, 20}, {10, 20}})};
  const Block block = test::block(test::made(section), 20.0);
  const BlockCut cut = cut_along(block, {20, 0}, {0, 20});  // x from 20 down to 0
  double area = 0.0;
  for (const section::Unit& unit : cut.section.units) area += geom::signed_area(unit.contour);
  EXPECT_NEAR(area, 20.0 * std::sqrt(2.0) * 30.0, 1e-9);
  const BlockCut right = cut_along(block, {12, 0}, {32, 20});  // x from 12: the C falls into two
  ASSERT_EQ(right.section.units.size(), 3U);
  EXPECT_EQ(right.section.units[0].piece_of, "c");
  EXPECT_EQ(right.section.units[1].piece_of, "c");
  for (const section::Unit& unit : right.section.units)
    EXPECT_NEAR(geom::signed_area(unit.contour), 18.0 * std::sqrt(2.0) * 10.0, 1e-9);
}

TEST(BlockCut, ALevelPlaneGivesAMap) {
  const Block block = test::block(test::layers(), 40.0);
  const auto frame = cut_by(block, {0.0, 0.0, 1.0, 10.0});  // z = -10: the middle horizon lies in it
  ASSERT_TRUE(frame);
  const auto map = cut(block, *frame);
  ASSERT_TRUE(map);
  EXPECT_NEAR(map->area, 4000.0, 1e-9);
  const auto through = cut(block, cut_by(block, {0.0, 0.0, 1.0, -2.0}).value());
  ASSERT_TRUE(through);
  EXPECT_NEAR(through->area, 50.0 * 40.0, 1e-9);
  EXPECT_EQ(through->section.horizons.size(), 2U);  // both limbs of the top
  EXPECT_FALSE(cut_by(block, {0.0, 0.0, 0.0, 1.0}));
}

TEST(BlockCut, RandomPlanesCutWhatTheirSolidsHave) {
  std::mt19937 random(3);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  section::Section section;
  for (int k = 0; k < 4; ++k) {
    std::vector<Point> points;
    for (int i = 0; i <= 25; ++i) points.push_back({4.0 * i, 8.0 * std::sin(0.4 * i) - 12.0 * k + draw(-0.5, 0.5)});
    section.horizons.push_back(horizon("h" + std::to_string(k), points));
  }
  section.lines = {line(section::LineKind::Fault, "F", {{30, 20}, {70, -60}})};
  const Block block = test::block(test::made(section), 60.0);
  for (int i = 0; i < 60; ++i) {
    const Point from{draw(0, 100), draw(0, 60)};
    const double angle = draw(-80.0, 80.0) * degree;
    const Point start{from.x - 900.0 * std::cos(angle), from.y - 900.0 * std::sin(angle)};
    const BlockCut cut = cut_along(block, start, {from.x + 900.0 * std::cos(angle), from.y + 900.0 * std::sin(angle)});
    ASSERT_FALSE(cut.empty());
    EXPECT_TRUE(cut.findings.empty()) << cut.findings.front().message;
    ASSERT_EQ(cut.section.horizons.size(), 4U);
    // Every point of a horizon lies on the horizon of the section that was extruded, at its place.
    for (std::size_t h = 0; h < 4; ++h) {
      for (const Point p : cut.section.horizons[h].line.points) {
        const double x = start.x + p.x * std::cos(angle);
        EXPECT_LE(geom::distance(section.horizons[h].line, {x, p.y}), 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace recon::block
