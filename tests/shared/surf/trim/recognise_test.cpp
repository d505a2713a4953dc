// Faces of charts: what lines bound, by closed forms of areas (Green's formula along the edges themselves).

#include "shared/surf/trim/recognise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shared/surf/trim/chart_curves.h"
#include "shared/surf/trim/common_edges.h"
#include "tests/shared/surf/surface_shapes.h"
#include "tests/shared/surf/trim/chart_checks.h"

namespace dobra::surf::trim {
namespace {

using geom::Point;
using geom::Point3;
using geom::Vector3;
using namespace surf::test;

Surface square(double size = 1.0) { return *Surface::plane({}, {{0, 0}, {size, size}}); }

TEST(Recognise, AChartWithoutLinesIsOneFace) {
  for (const Named& each : all_kinds()) {
    const auto found = recognise(each.surface, {});
    ASSERT_TRUE(found.ok()) << each.name << found.error().message;
    ASSERT_EQ(found->faces().size(), 1U) << each.name;
    const TrimmedSurface& face = found->faces()[0];
    ASSERT_EQ(face.loops.size(), 1U);
    EXPECT_EQ(face.loops[0].edges.size(), 4U);
    const geom::Box& chart = each.surface.chart();
    EXPECT_NEAR(chart_area(face), chart.width() * chart.height(), 1e-12 * chart.width() * chart.height()) << each.name;
    check_loops(face);
    EXPECT_TRUE(found->findings().empty());
  }
}

TEST(Recognise, AHoleAndALineInside) {
  const TrimLine line{{{straight({6, 2}, {8, 8}, "crack")}, ChartLine::Kind::Crack}};
  const auto found = recognise(square(10), std::vector{circle({3, 5}, 1.5), line});
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->faces().size(), 2U);
  const auto plate = found->pick({1, 1}), disk = found->pick({3, 5});
  ASSERT_TRUE(plate.ok() && disk.ok());
  const TrimmedSurface& with_hole = found->faces()[*plate];
  EXPECT_NEAR(chart_area(with_hole), 100 - pi * 2.25, 1e-10);
  EXPECT_NEAR(chart_area(found->faces()[*disk]), pi * 2.25, 1e-10);
  ASSERT_EQ(with_hole.loops.size(), 2U);
  EXPECT_LT(loop_area(with_hole.loops[1]), 0.0);
  ASSERT_EQ(with_hole.lines.size(), 1U);
  EXPECT_EQ(with_hole.lines[0].kind, ChartLine::Kind::Crack);
  EXPECT_EQ(with_hole.lines[0].edges.at(0).name, "crack");
  EXPECT_TRUE(found->faces()[*disk].lines.empty());
  // The border that both have is one curve.
  EXPECT_TRUE(with_hole.loops[1].edges[0].shared.has_value());
  EXPECT_EQ(with_hole.loops[1].edges[0].shared, found->faces()[*disk].loops[0].edges[0].shared);
  EXPECT_NE(with_hole.loops[1].edges[0].against, found->faces()[*disk].loops[0].edges[0].against);
}

TEST(Recognise, ARingMayRunAlongSeveralSidesOfTheChart) {
  const auto ring = [](const std::vector<Point3>& corners) {
    const Curve curve = *Curve::polyline(corners);
    const ChartEdge edge{.curve = curve, .from = curve.low(), .to = curve.high(), .name = "ring"};
    return TrimLine{{{edge}, ChartLine::Kind::Interface}, true, true};
  };
  const auto found =
      recognise(square(10), std::vector{ring({{3, 0, 0}, {10, 0, 0}, {10, 10, 0}, {3, 10, 0}, {3, 0, 0}})});
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->faces().size(), 2U);
  EXPECT_NEAR(chart_area(found->faces()[*found->pick({5, 5})]), 70.0, 1e-9);
  EXPECT_NEAR(chart_area(found->faces()[*found->pick({1, 5})]), 30.0, 1e-9);
  // The cap of a sphere: along the pole and both sides of the seam.
  const Surface ball = *Surface::sphere({}, 2.0, {{0, -pi / 2}, {2 * pi, pi / 2}});
  const auto cap = recognise(
      ball, std::vector{ring({{0, 1.4, 0}, {2 * pi, 1.4, 0}, {2 * pi, pi / 2, 0}, {0, pi / 2, 0}, {0, 1.4, 0}})});
  ASSERT_TRUE(cap.ok()) << cap.error().message;
  ASSERT_EQ(cap->faces().size(), 2U);
  EXPECT_NEAR(chart_area(cap->faces()[*cap->pick({3, 1.5})]), 2 * pi * (pi / 2 - 1.4), 1e-9);
}

TEST(Recognise, ALineThatPassesItsOwnEndsHasTwoLobes) {
  // A figure of eight through its own beginning: two lobes, turned into each other by half a turn.
  const std::vector<Point3> eight{{5, 5, 0}, {7, 7, 0}, {8, 5, 0}, {7, 3, 0}, {5, 5, 0},
                                  {3, 7, 0}, {2, 5, 0}, {3, 3, 0}, {5, 5, 0}};
  const Curve curve = *Curve::through(eight);
  const ChartEdge edge{.curve = curve, .from = curve.low(), .to = curve.high(), .name = "eight"};
  const auto found = recognise(square(10), std::vector{TrimLine{{{edge}, ChartLine::Kind::Interface}, true, true}});
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->faces().size(), 3U);
  const auto right = found->pick({7, 5}), left = found->pick({3, 5}), outside = found->pick({1, 1});
  ASSERT_TRUE(right.ok() && left.ok() && outside.ok());
  ASSERT_TRUE(*right != *left && *left != *outside);
  const double lobes = chart_area(found->faces()[*right]) + chart_area(found->faces()[*left]);
  EXPECT_GT(lobes, 12.0);
  EXPECT_NEAR(chart_area(found->faces()[*outside]) + lobes, 100.0, 1e-9);
}

TEST(Recognise, AClosedLineThatBoundsNothingLiesInsideOneFace) {
  TrimLine ring = circle({5, 5}, 2), across{{{straight({0, 5}, {10, 5})}}};
  ring.bounds = across.bounds = false;
  ring.line.kind = ChartLine::Kind::Interface;
  const auto found = recognise(square(10), std::vector{ring, across});
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->faces().size(), 1U);
  const TrimmedSurface& face = found->faces()[0];
  ASSERT_EQ(face.loops.size(), 1U);
  EXPECT_EQ(face.loops[0].edges.size(), 6U);  // both sides that the line meets are cut there
  ASSERT_EQ(face.lines.size(), 2U);
  EXPECT_EQ(face.lines[0].kind, ChartLine::Kind::Interface);
  EXPECT_EQ(face.lines[0].edges.size(), 2U);  // in two where the other one crosses
  EXPECT_EQ(face.lines[1].edges.size(), 3U);
  EXPECT_LE(geom::distance(face.lines[1].edges[1].start(), {3, 5}), 1e-12);
}

TEST(Recognise, CirclesThatCrossMakeLensAndLunes) {
  const auto found = recognise(square(4), std::vector{circle({1.5, 2}, 1), circle({2.5, 2}, 1)});
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->faces().size(), 4U);
  const double lens = 2 * pi / 3 - std::sqrt(3.0) / 2;  // of unit circles, middles 1 apart
  EXPECT_NEAR(chart_area(found->faces()[*found->pick({2, 2})]), lens, 1e-10);
  EXPECT_NEAR(chart_area(found->faces()[*found->pick({0.7, 2})]), pi - lens, 1e-10);
  EXPECT_NEAR(chart_area(found->faces()[*found->pick({0.1, 0.1})]), 16 - 2 * pi + lens, 1e-10);
  for (const TrimmedSurface& face : found->faces()) check_loops(face);
  const std::vector<std::size_t> both{*found->pick({2, 2}), *found->pick({0.7, 2})};
  const TrimmedSurface kept = found->united(both, CommonLines::Keep), dropped = found->united(both, CommonLines::Drop);
  EXPECT_NEAR(chart_area(kept), pi, 1e-10);
  ASSERT_EQ(kept.loops.size(), 1U);
  EXPECT_EQ(kept.lines.size(), 1U);
  EXPECT_TRUE(dropped.lines.empty());
  EXPECT_NEAR(chart_area(dropped), pi, 1e-10);
}

TEST(Recognise, SidesOfLinesAreKnownOfFacesHoweverThin) {
  for (const double over : {0.5, 0.02, 1e-3, 1e-5}) {
    const auto found = recognise(square(10), std::vector{circle({4, 5}, 1), circle({6 - over, 5}, 1)});
    ASSERT_TRUE(found.ok()) << found.error().message;
    ASSERT_EQ(found->faces().size(), 4U);
    const double cap = std::acos(1 - over / 2) - (1 - over / 2) * std::sqrt(over - over * over / 4), lens = 2 * cap;
    const auto within = [&](std::vector<std::size_t> lines) {
      const auto sides = found->sides_of(lines);
      EXPECT_TRUE(sides.ok());
      const std::size_t plate = *found->pick({0.1, 0.1});
      double area = 0.0;
      for (std::size_t f = 0; sides && f < sides->size(); ++f)
        area += (*sides)[f] != (*sides)[plate] ? chart_area(found->faces()[f]) : 0.0;
      return area;
    };
    EXPECT_NEAR(within({0}), pi, 1e-9) << over;
    EXPECT_NEAR(within({1}), pi, 1e-9) << over;
    EXPECT_NEAR(within({0, 1}), 2 * pi - 2 * lens, 1e-9) << over;  // in one of them
    EXPECT_EQ(within({}), 0.0);
  }
}

TEST(Recognise, ALineThatClosesOnlyRoundTheSurfaceHasNoSides) {
  const Surface pipe = *Surface::cylinder({}, 1, {{0, 0}, {2 * pi, 4}});
  const auto along = recognise(pipe, std::vector{TrimLine{{{straight({2, 0}, {2, 4})}}}});
  ASSERT_TRUE(along.ok()) << along.error().message;
  const auto sides = along->sides_of(std::vector<std::size_t>{0});
  ASSERT_FALSE(sides.ok());
  EXPECT_EQ(sides.error().code, base::ErrorCode::CannotMesh);
  EXPECT_TRUE(sides.error().place.has_value());
  // Over the seam it is a line as anywhere else.
  const auto round = recognise(pipe, std::vector{circle({0.1, 2}, 1)});
  ASSERT_TRUE(round.ok()) << round.error().message;
  const auto both = round->sides_of(std::vector<std::size_t>{0});
  ASSERT_TRUE(both.ok());
  EXPECT_NE(both->at(*round->pick({0.1, 2})), both->at(*round->pick({3, 2})));
  EXPECT_EQ(round->pick({6.2, 2}).value(), round->pick({0.1, 2}).value());
}

TEST(Recognise, ACrackAlongOtherLinesIsACrackWithItsNameAndDirection) {
  const auto line = [](Point a, Point b, const char* name, ChartLine::Kind kind) {
    return TrimLine{{{straight(a, b, name)}, kind}, false, false};
  };
  const TrimLine wall = line({5, 0}, {5, 10}, "w", ChartLine::Kind::Constraint);
  const TrimLine crack = line({5, 7}, {5, 3}, "k", ChartLine::Kind::Crack);
  for (const auto& lines : {std::vector{wall, crack}, std::vector{crack, wall}}) {
    const auto found = recognise(square(10), lines);
    ASSERT_TRUE(found.ok()) << found.error().message;
    ASSERT_EQ(found->faces().size(), 1U);
    double opened = 0.0, along = 0.0;
    for (const ChartLine& each : found->faces()[0].lines) {
      for (const ChartEdge& edge : each.edges) {
        const bool is_crack = each.kind == ChartLine::Kind::Crack;
        EXPECT_EQ(edge.name, is_crack ? "k" : "w");
        (is_crack ? opened : along) += edge.end().y - edge.start().y;
      }
    }
    EXPECT_NEAR(opened, -4.0, 1e-12);
    EXPECT_NEAR(along, 6.0, 1e-12);
    const auto common = found->on_cracks(std::vector<std::size_t>{0});
    ASSERT_EQ(common.size(), 1U);
    EXPECT_EQ(common[0].crack, "k");
    EXPECT_EQ(common[0].others, std::vector<std::string>{"w"});
    EXPECT_NEAR(common[0].at.y, 5.0, 1e-12);
  }
}

TEST(Recognise, LinesThatTouchOverlapAndEndAnywhere) {
  // Two lines that overlap in part, one that ends in the other, one that dangles, all from border to border or less.
  std::vector<TrimLine> lines;
  for (const auto& [a, b] : {std::pair{Point{0, 1}, Point{3, 1}},
                             {{2, 1}, {4, 1}},
                             {{1, 1}, {1, 4}},
                             {{3, 3}, {3.5, 2}},
                             {{3.5, 0}, {3.5, 0.5}},
                             {{0, 0}, {4, 0}}})
    lines.push_back({{{straight(a, b)}}});
  const auto found = recognise(square(4), lines);
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->faces().size(), 3U);
  EXPECT_NEAR(chart_area(found->faces()[*found->pick({2, 0.5})]), 4.0, 1e-12);
  EXPECT_NEAR(chart_area(found->faces()[*found->pick({0.5, 2})]), 3.0, 1e-12);
  const TrimmedSurface& wide = found->faces()[*found->pick({2, 2})];
  EXPECT_NEAR(chart_area(wide), 9.0, 1e-12);
  EXPECT_EQ(wide.lines.size(), 1U);
  EXPECT_EQ(found->faces()[*found->pick({2, 0.5})].lines.size(), 1U);  // attached to the border, still inside
  for (const TrimmedSurface& face : found->faces()) check_loops(face);
}

TEST(Recognise, ALineBetweenHoleAndBorderIsALineInside) {
  const TrimLine bridge{{{straight({0, 2}, {1, 2})}}};
  const auto found = recognise(square(4), std::vector{circle({2, 2}, 1), bridge});
  ASSERT_TRUE(found.ok()) << found.error().message;
  const TrimmedSurface& face = found->faces()[*found->pick({0.1, 0.1})];
  ASSERT_EQ(face.loops.size(), 2U);
  EXPECT_GT(loop_area(face.loops[0]), 0.0);
  EXPECT_NEAR(loop_area(face.loops[1]), -pi, 1e-10);
  EXPECT_EQ(face.lines.size(), 1U);
  check_loops(face);
}

TEST(Recognise, AHoleThatTouchesTheBorder) {
  const auto found = recognise(square(4), std::vector{circle({1, 2}, 1)});
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->faces().size(), 2U);
  EXPECT_NEAR(chart_area(found->faces()[*found->pick({3, 3})]), 16 - pi, 1e-9);
  EXPECT_NEAR(chart_area(found->faces()[*found->pick({1, 2})]), pi, 1e-9);
  // Circles that touch each other, one within the other and side by side.
  const auto nested = recognise(square(8), std::vector{circle({4, 4}, 2), circle({3, 4}, 1), circle({6.5, 4}, 0.5)});
  ASSERT_TRUE(nested.ok()) << nested.error().message;
  ASSERT_EQ(nested->faces().size(), 4U);
  EXPECT_NEAR(chart_area(nested->faces()[*nested->pick({5, 4})]), 3 * pi, 1e-9);
  EXPECT_NEAR(chart_area(nested->faces()[*nested->pick({0.5, 0.5})]), 64 - 4.25 * pi, 1e-9);
}

TEST(Recognise, TheSameCircleDrawnTwiceIsOne) {
  TrimLine turned = circle({2, 2}, 1, 1.0);
  std::swap(turned.line.edges[0].from, turned.line.edges[0].to);
  const auto found = recognise(square(4), std::vector{circle({2, 2}, 1), turned});
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->faces().size(), 2U);
  EXPECT_NEAR(chart_area(found->faces()[*found->pick({2, 2})]), pi, 1e-10);
}

TEST(Recognise, GapsAreClosedAndToldAndWideOnesRefused) {
  for (const double gap : {1e-9, 1e-7, 1e-5, 1e-3, 1e-2}) {
    const TrimLine loop{{{straight({0.2, 0.2}, {0.8, 0.2}), straight({0.8, 0.2 + gap}, {0.8, 0.8}),
                          straight({0.8 + gap, 0.8}, {0.2, 0.8 - gap}), straight({0.2, 0.8}, {0.2, 0.2 - gap})}},
                        true};
    const auto found = recognise(square(), std::vector{loop});
    if (gap > 2e-3) {
      ASSERT_FALSE(found.ok());
      EXPECT_EQ(found.error().code, base::ErrorCode::CannotMesh);
      ASSERT_TRUE(found.error().place && found.error().place->z && found.error().place->u);
      EXPECT_NEAR(*found.error().place->u, 0.2, 0.02);  // where the loop begins and ends
      continue;
    }
    ASSERT_TRUE(found.ok()) << gap << found.error().message;
    ASSERT_EQ(found->faces().size(), 2U) << gap;
    EXPECT_NEAR(chart_area(found->faces()[*found->pick({0.5, 0.5})]), 0.36, 3 * gap + 1e-12);
    EXPECT_EQ(found->findings().empty(), gap < 1e-7) << gap;
    for (const TrimmedSurface& face : found->faces()) check_loops(face);
  }
}

TEST(Recognise, EndsThatNearlyMeetOnASideOfTheChartAreTold) {
  const auto codes = [](const std::vector<TrimLine>& lines) {
    const auto found = recognise(square(10), lines);
    EXPECT_TRUE(found.ok());
    std::vector<std::string> told;
    if (!found) return told;
    for (const Finding& each : found->findings()) told.push_back(each.code);
    return told;
  };
  const auto line = [](Point a, Point b) { return TrimLine{{{straight(a, b, "l")}, ChartLine::Kind::Constraint}}; };
  const std::vector<std::string> apart{"ends_apart"};
  EXPECT_EQ(codes({line({0, 5}, {5, 5}), line({5, 5}, {0, 5 + 2e-6})}), apart);
  EXPECT_EQ(codes({line({10, 10 - 2e-6}, {5, 5})}), apart);
  EXPECT_TRUE(codes({line({0, 5}, {5, 5}), line({5, 5}, {0, 5})}).empty());
  EXPECT_TRUE(codes({line({0, 5}, {5, 5}), line({5, 5}, {0, 5 + 2e-3})}).empty());
  // Drawn along the side: nothing is open.
  EXPECT_TRUE(codes({line({0, 5}, {5, 5}), line({5, 5}, {0, 5 + 2e-6}), line({0, 5}, {0, 5 + 2e-6})}).empty());
}

TEST(Recognise, WhatDoesNotCloseEnclosesNothingOrLeavesTheChartIsRefusedWithThePlace) {
  const TrimLine open{{{straight({0.2, 0.2}, {0.8, 0.2}), straight({0.8, 0.2}, {0.8, 0.8})}}, true};
  const auto not_closed = recognise(square(), std::vector{open});
  ASSERT_FALSE(not_closed.ok());
  EXPECT_NE(not_closed.error().message.find("does not close"), std::string::npos);
  const TrimLine back{{{straight({0.2, 0.2}, {0.8, 0.2}), straight({0.8, 0.2}, {0.2, 0.2})}}, true};
  const auto nothing = recognise(square(), std::vector{back});
  ASSERT_FALSE(nothing.ok());
  EXPECT_EQ(nothing.error().code, base::ErrorCode::DegenerateCurve);
  EXPECT_TRUE(nothing.error().place.has_value());
  const auto out = recognise(square(), std::vector{circle({0.9, 0.5}, 0.3)});
  ASSERT_FALSE(out.ok());
  EXPECT_EQ(out.error().code, base::ErrorCode::OutsideDomain);
  EXPECT_NEAR(*out.error().place->u, 1.0, 1e-12);
}

TEST(Recognise, LinesFarBesideAClosedChartAreRefusedAtOnce) {
  const Surface pipe = *Surface::cylinder({}, 1.0, {{0, 0}, {2 * pi, 8}});
  for (const Point from : {Point{1e12, 1}, {1, 1e12}, {-1e300, 4}}) {
    const auto found = recognise(pipe, std::vector{TrimLine{{{straight({1, 1}, from)}}}});
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.error().code, base::ErrorCode::OutsideDomain);
    EXPECT_TRUE(found.error().place.has_value());
  }
}

TEST(Recognise, SharedCurvesThatCoincideAreTold) {
  ChartEdge one = straight({0, 1}, {4, 1}), other = straight({1, 1}, {3, 1});
  one.shared = 7, other.shared = 8;
  const auto found = recognise(square(4), std::vector{TrimLine{{{one}}}, TrimLine{{{other}}}});
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->findings().size(), 1U);
  EXPECT_EQ(found->findings()[0].code, "numbers_coincide");
  EXPECT_NEAR(*found->findings()[0].place.x, 1.0, 1e-12);
}

TEST(Recognise, LinesThatRunAsOneWithoutCoincidingAreRefusedWithThePlace) {
  // A line and a cubic that leaves it with the third power: one to 1e-7 over a hundredth of the chart.
  const Curve cubic = *Curve::bezier({{0, 0.499, 0}, {1.0 / 3, 0.504, 0}, {2.0 / 3, 0.496, 0}, {1, 0.501, 0}});
  const auto crossing =
      recognise(square(), std::vector{TrimLine{{{straight({0, 0.5}, {1, 0.5})}}}, TrimLine{{{{cubic}}}}});
  ASSERT_TRUE(crossing.ok()) << crossing.error().message;  // three crossings: four slivers
  EXPECT_GE(crossing->faces().size(), 4U);
  const Curve flat = *Curve::bezier({{0, 0.499, 0}, {1.0 / 3, 0.5, 0}, {2.0 / 3, 0.5, 0}, {1, 0.501, 0}});
  const Curve flatter = *Curve::bezier({{0, 0.4, 0}, {0.25, 0.5, 0}, {0.5, 0.5, 0}, {0.75, 0.5, 0}, {1, 0.4, 0}});
  for (const Curve& curve : {flat, flatter}) {
    const auto found =
        recognise(square(), std::vector{TrimLine{{{straight({0, 0.5}, {1, 0.5})}}}, TrimLine{{{{curve}}}}});
    if (found.ok()) {
      // Told apart after all: then the areas must be right.
      double sum = 0.0;
      for (const TrimmedSurface& face : found->faces()) sum += chart_area(face);
      EXPECT_NEAR(sum, 1.0, 1e-6);
      EXPECT_GE(found->faces().size(), 3U);
      continue;
    }
    EXPECT_EQ(found.error().code, base::ErrorCode::CannotMesh);
    EXPECT_TRUE(found.error().place && found.error().place->u);
  }
}

TEST(Recognise, ALoopThatCrossesItselfHasTheFacesItBounds) {
  const Curve eight = *Curve::polyline({{0.2, 0.2, 0}, {0.8, 0.8, 0}, {0.8, 0.2, 0}, {0.2, 0.8, 0}, {0.2, 0.2, 0}});
  const auto found = recognise(square(), std::vector{TrimLine{{{{eight, eight.low(), eight.high()}}}, true}});
  ASSERT_TRUE(found.ok()) << found.error().message;
  EXPECT_NEAR(chart_area(found->faces()[*found->pick({0.7, 0.5})]), 0.09, 1e-12);
  EXPECT_EQ(found->faces().size(), 3U);
}

TEST(Recognise, TheSpherePatchIsKeptWhereXPlusZIsAtMostThree) {
  const Surface patch = *Surface::sphere({}, 5.0, {{0, -pi / 3}, {pi, pi / 3}});
  const auto edges = plane_edges(patch, {3, 0, 0}, {1, 0, 1}, {.name = "cut"});
  ASSERT_TRUE(edges.ok()) << edges.error().message;
  std::vector<TrimLine> lines;
  for (const ChartEdge& edge : *edges) lines.push_back({{{edge}}});
  const auto found = recognise(patch, lines);
  ASSERT_TRUE(found.ok()) << found.error().message;
  const auto kept = found->pick({3.0, 0.0});
  ASSERT_TRUE(kept.ok()) << kept.error().message;
  const TrimmedSurface& face = found->faces()[*kept];
  check_loops(face);
  // Area in space 25 * int du dsin(v), by Green along the edges, against a fine grid of the chart.
  double sampled = 0.0;
  const int n = 1500;
  for (int j = 0; j < n; ++j) {
    const double v = -pi / 3 + 2 * pi / 3 * (j + 0.5) / n;
    // 5 cos u cos v + 5 sin v <= 3: u from the angle on.
    const double c = (3 - 5 * std::sin(v)) / (5 * std::cos(v));
    const double from = c >= 1 ? 0.0 : c <= -1 ? pi : std::acos(c);
    sampled += 25 * (pi - from) * std::cos(v) * (2 * pi / 3) / n;
  }
  double green = 0.0;
  for (const ChartLoop& loop : face.loops) {
    for (const ChartEdge& edge : loop.edges)
      green += integral(edge, [](Point p, geom::Vector way) { return -25 * std::sin(p.y) * way.x; });
  }
  EXPECT_NEAR(green, sampled, 2e-4 * sampled);
  int cut = 0;
  for (const ChartEdge& edge : face.loops[0].edges) {
    if (edge.name != "cut") continue;
    ++cut;
    EXPECT_TRUE(edge.shared.has_value());
    for (int i = 0; i <= 20; ++i) {
      const Point3 p = patch.at(edge.at(std::lerp(edge.from, edge.to, i / 20.0)));
      EXPECT_NEAR(p.x + p.z, 3.0, 1e-9);
    }
  }
  EXPECT_GE(cut, 1);
}

TEST(Recognise, AHoleAcrossTheSeamOfAClosedCylinderIsOneHole) {
  const Surface pipe = *Surface::cylinder({}, 1.0, {{0, 0}, {2 * pi, 8}});
  for (const double turns : {0.0, 1.0, -2.0}) {
    const auto found = recognise(pipe, std::vector{circle({2 * pi * turns, 4}, 1)});
    ASSERT_TRUE(found.ok()) << found.error().message;
    ASSERT_EQ(found->faces().size(), 2U) << turns;
    const TrimmedSurface& face = found->faces()[*found->pick({3, 1})];
    EXPECT_NEAR(chart_area(face), 16 * pi - pi, 1e-9);
    check_loops(face);
    check_seams(face);
    const TrimmedSurface& hole = found->faces()[*found->pick({2 * pi * 5 + 0.1, 4})];
    EXPECT_NEAR(chart_area(hole), pi, 1e-9);
    check_seams(hole);
  }
}

TEST(Recognise, ATorusCutByTwoRingsIsTwoPipes) {
  const Surface ring = *Surface::torus({}, 6, 2, {{0, 0}, {2 * pi, 2 * pi}});
  const std::vector<TrimLine> lines{{{{straight({1, 0}, {1, 2 * pi})}}}, {{{straight({4, 0}, {4, 2 * pi})}}}};
  const auto found = recognise(ring, lines);
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->faces().size(), 2U);
  EXPECT_EQ(*found->pick({0.1, 1}), *found->pick({6, 3}));
  for (const TrimmedSurface& face : found->faces()) check_loops(face), check_seams(face);
}

TEST(Recognise, PartsOfASharedCurveHaveOneNumberOnBothSurfaces) {
  const Surface wide = *Surface::cylinder({{0, 0, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 2.0, {{-1, 0}, {1, 8}});
  const Surface narrow = *Surface::cylinder({{-4, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, 1.0, {{0, 0}, {2 * pi, 8}});
  const auto common = common_edges(wide, narrow, {.number = 1});
  ASSERT_TRUE(common.ok());
  std::vector<TrimLine> on_wide, on_narrow;
  for (const CommonEdge& each : *common) {
    on_wide.push_back({{{each.first}}});
    on_narrow.push_back({{{each.second}}});
  }
  on_wide.push_back({{{straight({-1, 4.2}, {1, 4.2})}}});
  SharedNumbers numbers(100);
  const auto first = recognise(wide, on_wide, numbers);
  ASSERT_TRUE(first.ok()) << first.error().message;
  EXPECT_FALSE(first->cuts().empty());
  RecogniseOptions options;
  options.cuts = first->cuts();
  const auto second = recognise(narrow, on_narrow, numbers, options);
  ASSERT_TRUE(second.ok()) << second.error().message;
  std::map<SharedCurveId, std::vector<std::pair<Point3, Point3>>> ends;
  for (const auto& [surface, found] : {std::pair{&wide, &*first}, {&narrow, &*second}}) {
    for (const TrimmedSurface& face : found->faces()) {
      for (const ChartLoop& loop : face.loops) {
        for (const ChartEdge& edge : loop.edges) {
          if (!edge.shared) continue;
          const Point3 p = surface->at(edge.start()), q = surface->at(edge.end());
          ends[*edge.shared].push_back(edge.against ? std::pair{q, p} : std::pair{p, q});
        }
      }
    }
  }
  int of_both = 0;
  for (const auto& [number, found] : ends) {
    for (const auto& [p, q] : found) {
      EXPECT_LE(geom::distance(p, found[0].first), 1e-9) << number;
      EXPECT_LE(geom::distance(q, found[0].second), 1e-9) << number;
    }
    if (found.size() == 4) ++of_both;
  }
  EXPECT_GE(of_both, 2);
}

}  // namespace
}  // namespace dobra::surf::trim
