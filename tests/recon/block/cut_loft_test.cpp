// Sections cut out of blocks between several sections: lines and areas by closed forms, the sections themselves at
// their own traces, seen from behind, with sides that bend, and what is not of the block told.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "recon/block/cut.h"
#include "recon/block/loft.h"
#include "shared/geom/polyline.h"
#include "tests/recon/block/sections.h"

namespace recon::block::cut_loft_test {
namespace {

using dobra::io::lines::Trace;
using geom::Point;
using test::told;
using testing::HasSubstr;

section::Section level(double width, std::array<double, 3> z) {
  section::Section section;
  section.horizons = {test::horizon("top", {{0, z[0]}, {width, z[0]}}),
                      test::horizon("middle", {{0, z[1]}, {0.3 * width, z[1]}, {width, z[1]}}),
                      test::horizon("base", {{0, z[2]}, {width, z[2]}})};
  return test::made(std::move(section));
}

Block lofted(const std::vector<LoftedSection>& sections) {
  auto made = loft(sections);
  EXPECT_TRUE(made) << (made ? "" : to_string(made.error()));
  return made ? std::move(*made) : Block{};
}

BlockCut cut_along(const Block& block, Point from, Point to) {
  const auto frame = cut_over(block, from, to);
  EXPECT_TRUE(frame);
  auto made = cut(block, *frame);
  EXPECT_TRUE(made) << (made ? "" : to_string(made.error()));
  return made ? std::move(*made) : BlockCut{};
}

double area(const BlockCut& cut, const std::string& unit) {
  for (const CutUnit& each : cut.units) {
    if (each.name == unit) return each.area;
  }
  return 0.0;
}
/// By the lines of the section.
double drawn_area(const BlockCut& cut) {
  double sum = 0.0;
  EXPECT_TRUE(cut.section.faces);
  if (cut.section.faces) {
    for (const auto& unit : cut.section.faces->units) sum += unit.area;
  }
  return sum;
}
std::string codes(const BlockCut& cut) {
  std::string all;
  for (const base::Finding& finding : cut.findings) all += finding.code + " ";
  return all;
}

/// The same points, but for those in straight lines.
void same_line(const geom::Polyline& is, const geom::Polyline& wanted, double within = 1e-9) {
  EXPECT_LT(geom::distance(is.points.front(), wanted.points.front()), within);
  EXPECT_LT(geom::distance(is.points.back(), wanted.points.back()), within);
  for (const Point p : is.points) EXPECT_LT(geom::distance(wanted, p), within);
  for (const Point p : wanted.points) EXPECT_LT(geom::distance(is, p), within);
}

TEST(CutLoft, EqualSectionsGiveTheSectionBackBetweenThem) {
  const section::Section drawn = test::layers();
  const Block block = lofted({{"a", drawn, {0, 0, 1, 0}}, {"b", drawn, {0, 64, 1, 0}}});
  for (const double y : {0.0, 1e-3, 32.0, 64.0}) {
    const BlockCut made = cut_along(block, {0, y}, {100, y});
    EXPECT_EQ(codes(made), "") << y;
    ASSERT_EQ(made.section.horizons.size(), 3U) << y;
    for (std::size_t h = 0; h < 3; ++h) {
      EXPECT_EQ(made.section.horizons[h].name, drawn.horizons[h].name);
      same_line(made.section.horizons[h].line, drawn.horizons[h].line);
    }
    EXPECT_FALSE(made.section.border);
    EXPECT_NEAR(made.area, 2200.0, 1e-9);  // 100 by 20 and a triangle of 100 by 4
    EXPECT_NEAR(drawn_area(made), 2200.0, 1e-9);
  }
}

TEST(CutLoft, PiecesAndFaultsKeepTheirNamesAndABlindFaultIsTold) {
  const section::Section drawn = test::faulted();
  const Block block = lofted({{"a", drawn, {0, 0, 1, 0}}, {"b", drawn, {0, 64, 1, 0}}});
  const BlockCut made = cut_along(block, {0, 40}, {100, 40});
  // The fault has one unit on both sides, and bounds it where it is displaced.
  ASSERT_EQ(codes(made), "cut_left_out cut_in_pieces ");
  EXPECT_THAT(made.findings[0].message, HasSubstr("fault 'F' between its pieces, fault 'blind'"));
  ASSERT_EQ(made.section.horizons.size(), 4U);
  for (std::size_t h = 0; h < 4; ++h) {
    EXPECT_EQ(made.section.horizons[h].name, drawn.horizons[h].name);
    EXPECT_EQ(made.section.horizons[h].piece_of, drawn.horizons[h].piece_of);
    same_line(made.section.horizons[h].line, drawn.horizons[h].line);
  }
  ASSERT_EQ(made.section.lines.size(), 2U);
  for (const auto& line : made.section.lines) {
    EXPECT_EQ(line.kind, section::LineKind::Fault);
    EXPECT_EQ(line.piece_of, "F");
    for (const Point p : line.line.points) EXPECT_LT(geom::distance(drawn.lines[0].line, p), 1e-9);
  }
  EXPECT_NEAR(drawn_area(made), made.area, 1e-9);
}

TEST(CutLoft, BedsThatChangeEvenlyHaveTheirMeansBetween) {
  // Widths 100 and 160, tops 0 and 40, middles -10 and 20, bases -30 and 15: all beds are planes.
  const Block block =
      lofted({{"a", level(100, {0, -10, -30}), {0, 0, 1, 0}}, {"b", level(160, {40, 20, 15}), {0, 60, 1, 0}}});
  for (const double part : {0.0, 0.25, 0.5, 0.9, 1.0}) {
    const auto at = [part](double a, double b) { return a + part * (b - a); };
    const BlockCut made = cut_along(block, {-10, 60 * part}, {200, 60 * part});
    EXPECT_EQ(codes(made), "") << part;
    EXPECT_NEAR(area(made, "top - middle"), at(100, 160) * at(10, 20), 1e-8) << part;
    EXPECT_NEAR(area(made, "middle - base"), at(100, 160) * at(20, 5), 1e-8) << part;
    ASSERT_EQ(made.section.horizons.size(), 3U);
    same_line(made.section.horizons[1].line, {{{10, at(-10, 20)}, {10 + at(100, 160), at(-10, 20)}}, false});
  }
  // Aslant, and ending within: the mean thickness by the length.
  const BlockCut aslant = cut_along(block, {10, 15}, {90, 45});
  EXPECT_EQ(codes(aslant), "");
  EXPECT_NEAR(area(aslant, "top - middle"), std::hypot(80, 30) * 15.0, 1e-8);
  EXPECT_NEAR(area(aslant, "middle - base"), std::hypot(80, 30) * 12.5, 1e-8);
  EXPECT_NEAR(drawn_area(aslant), std::hypot(80, 30) * 27.5, 1e-8);
  // From behind.
  const BlockCut behind = cut_along(block, {90, 45}, {10, 15});
  EXPECT_NEAR(area(behind, "top - middle"), std::hypot(80, 30) * 15.0, 1e-8);
  same_line(behind.section.horizons[0].line, {{{0, 30}, {std::hypot(80, 30), 10}}, false});
}

TEST(CutLoft, EachOfThreeObliqueSectionsComesBackAtItsTrace) {
  const double c = std::cos(0.3), s = std::sin(0.3);
  const std::vector<LoftedSection> sections{{"a", level(100, {0, -10, -30}), {5e5, 7e6, 1, 0}},
                                            {"b", level(120, {5, -8, -20}), {5e5 - 10, 7e6 + 60, c, s}},
                                            {"c", level(90, {9, 0, -20}), {5e5 + 20, 7e6 + 200, 1, 0}}};
  const Block block = lofted(sections);
  for (const LoftedSection& each : sections) {
    const double width = box_of(each.section).high.x;
    const Point from{each.trace.x, each.trace.y};
    const BlockCut made = cut_along(block, from, from + width * geom::Vector{each.trace.east, each.trace.north});
    ASSERT_EQ(made.section.horizons.size(), 3U) << each.name;
    for (std::size_t h = 0; h < 3; ++h)
      same_line(made.section.horizons[h].line, each.section.horizons[h].line, 2e-6);  // 7e6 m from the origin
    EXPECT_NEAR(made.area,
                width * (each.section.horizons[0].line.points[0].y - each.section.horizons[2].line.points[0].y), 2e-4)
        << each.name;
  }
}

TEST(CutLoft, SidesThatBendGetABorderAndLoseNoArea) {
  section::Section slanted;
  slanted.horizons = {test::horizon("top", {{0, 0}, {100, 0}}), test::horizon("base", {{30, -20}, {150, -20}})};
  section::Section upright;
  upright.horizons = {test::horizon("top", {{0, 0}, {100, 0}}), test::horizon("base", {{0, -20}, {100, -20}})};
  const Block block = lofted(
      {{"a", test::made(std::move(upright)), {0, 0, 1, 0}}, {"b", test::made(std::move(slanted)), {0, 60, 1, 0}}});
  const BlockCut made = cut_along(block, {-50, 10}, {200, 50});
  EXPECT_NEAR(drawn_area(made), made.area, 1e-9 * made.area);
  EXPECT_TRUE(made.section.border);
  EXPECT_FALSE(told(made.findings, "cut_area"));
}

TEST(CutLoft, PolygonsComeBackAsPolygons) {
  section::Section section;
  section.units = {test::unit("A", {{0, 0}, {10, 0}, {10, 10}, {0, 10}}),
                   test::unit("B", {{10, 0}, {30, 0}, {30, 10}, {10, 10}})};
  const section::Section drawn = test::made(std::move(section));
  const Block block = lofted({{"a", drawn, {0, 0, 1, 0}}, {"b", drawn, {5, 50, 1, 0}}});
  const BlockCut made = cut_along(block, {0, 20}, {60, 20});
  ASSERT_EQ(made.section.units.size(), 2U) << codes(made);
  EXPECT_EQ(made.section.units[0].name, "A");
  EXPECT_NEAR(geom::signed_area(made.section.units[0].contour), 100.0, 1e-9);
  EXPECT_NEAR(geom::signed_area(made.section.units[1].contour), 200.0, 1e-9);
  EXPECT_NEAR(made.section.units[0].contour.box().low.x, 2.0, 1e-9);
}

TEST(CutLoft, AHangingWallStaysOnItsSideWhoeverLooks) {
  section::Section drawn = test::faulted();
  drawn.lines[0].hanging_wall = section::HangingWall::Right;
  section::Section turned = drawn;  // drawn from the other end
  for (auto& horizon : turned.horizons) {
    for (Point& p : horizon.line.points) p.x = 100 - p.x;
    horizon.line = geom::reversed(std::move(horizon.line));
  }
  for (auto& line : turned.lines) {
    for (Point& p : line.line.points) p.x = 100 - p.x;
  }
  turned.lines[0].hanging_wall = section::HangingWall::Left;
  turned = test::made(std::move(turned));
  // The section in front is drawn from its left end or from its right end, and looked at from behind.
  for (const Block& block : {lofted({{"a", drawn, {0, 0, 1, 0}}, {"b", drawn, {0, 64, 1, 0}}}),
                             lofted({{"a", turned, {100, 0, -1, 0}}, {"b", turned, {100, 64, -1, 0}}}),
                             lofted({{"b", drawn, {0, 64, 1, 0}}, {"a", turned, {100, 0, -1, 0}}})}) {
    const BlockCut made = cut_along(block, {0, 40}, {100, 40});
    ASSERT_EQ(made.section.lines.size(), 2U);
    for (const auto& line : made.section.lines) {
      EXPECT_EQ(line.hanging_wall, section::HangingWall::Right);
      EXPECT_GT(line.line.points.front().y, line.line.points.back().y);  // downwards
    }
    const BlockCut behind = cut_along(block, {100, 40}, {0, 40});
    for (const auto& line : behind.section.lines) EXPECT_EQ(line.hanging_wall, section::HangingWall::Left);
  }
}

TEST(CutLoft, AMissIsToldAndEmpty) {
  const Block block = lofted({{"a", test::layers(), {0, 0, 1, 0}}, {"b", test::layers(), {0, 64, 1, 0}}});
  const BlockCut beside = cut_along(block, {0, 70}, {100, 70});
  EXPECT_TRUE(beside.empty());
  EXPECT_TRUE(told(beside.findings, "cut_misses"));
  const BlockCut before = cut_along(block, {-50, 10}, {-20, 10});
  EXPECT_TRUE(before.empty());
  EXPECT_TRUE(told(before.findings, "cut_misses"));
}

}  // namespace
}  // namespace recon::block::cut_loft_test
