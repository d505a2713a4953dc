// Loops as files bring them, and surfaces that fold.

#include "shared/surf/trim/mend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shared/surf/trim/chart_curves.h"
#include "tests/shared/surf/surface_shapes.h"
#include "tests/shared/surf/trim/chart_checks.h"

namespace dobra::surf::trim {
namespace {

using geom::Point;
using namespace surf::test;

ChartLoop ring(const std::vector<Point>& points, geom::Vector by = {}) {
  ChartLoop loop;
  for (std::size_t i = 0; i < points.size(); ++i)
    loop.edges.push_back(straight(points[i] + by, points[(i + 1) % points.size()] + by));
  return loop;
}
ChartLoop turned(ChartLoop loop) {
  std::reverse(loop.edges.begin(), loop.edges.end());
  for (ChartEdge& edge : loop.edges) std::swap(edge.from, edge.to);
  return loop;
}
ChartLoop round(Point middle, double radius) { return {circle(middle, radius).line.edges}; }
int told(const Mended& mended, const std::string& code) {
  return static_cast<int>(
      std::count_if(mended.findings.begin(), mended.findings.end(), [&](const Finding& f) { return f.code == code; }));
}
const std::vector<Point> corners{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
Surface four_by_four() { return *Surface::plane({}, {{0, 0}, {4, 4}}); }

TEST(Mend, LoopsTurnedAnyWayMeanTheSameFace) {
  for (int turns = 0; turns < 8; ++turns) {
    TrimmedSurface face{four_by_four(), {}};
    const ChartLoop outer = ring(corners), hole = round({2, 2}, 1), island = ring({{1.8, 1.8}, {2.2, 1.8}, {2, 2.3}});
    face.loops = {turns & 1 ? turned(outer) : outer, turns & 2 ? hole : turned(hole),
                  turns & 4 ? turned(island) : island};
    SharedNumbers numbers;
    const auto found = mended(face, numbers);
    ASSERT_TRUE(found.ok()) << turns << found.error().message;
    EXPECT_NEAR(chart_area(found->face), 16 - pi + 0.1, 1e-10) << turns;
    ASSERT_EQ(found->face.loops.size(), 3U);
    EXPECT_EQ(told(*found, "loop_turned"), (turns & 1) + (turns >> 1 & 1) + (turns >> 2 & 1)) << turns;
    check_loops(found->face);
  }
}

TEST(Mend, LoopsAPeriodOffOrOverTheSeam) {
  const Surface pipe = *Surface::cylinder({}, 1.0, {{0, 0}, {2 * pi, 8}});
  for (const double off : {0.0, 2 * pi, -2 * pi, -4 * pi}) {
    TrimmedSurface face{pipe, {ring({{1, 1}, {3, 1}, {3, 5}, {1, 5}}, {off, 0})}};
    SharedNumbers numbers;
    const auto found = mended(face, numbers);
    ASSERT_TRUE(found.ok()) << off << found.error().message;
    EXPECT_NEAR(chart_area(found->face), 8.0, 1e-11);
    EXPECT_TRUE(found->findings.empty());
    check_loops(found->face);
    // A patch across the seam: its inside lies there, in two parts.
    face.loops = {ring({{-1, 1}, {1, 1}, {1, 5}, {-1, 5}}, {off, 0})};
    const auto over = mended(face, numbers);
    ASSERT_TRUE(over.ok()) << over.error().message;
    EXPECT_NEAR(chart_area(over->face), 8.0, 1e-11);
    EXPECT_EQ(over->face.loops.size(), 2U);
    check_seams(over->face);
    // The pipe from end to end with a hole over the seam, both seams among its edges.
    face.loops = {ring({{0, 0}, {2 * pi, 0}, {2 * pi, 8}, {0, 8}}), turned(round({off, 4}, 1))};
    const auto pierced = mended(face, numbers);
    ASSERT_TRUE(pierced.ok()) << pierced.error().message;
    EXPECT_NEAR(chart_area(pierced->face), 16 * pi - pi, 1e-9);
    check_loops(pierced->face);
    check_seams(pierced->face);
  }
}

TEST(Mend, RingsRoundAPipeBoundThePartBetweenThem) {
  const Surface pipe = *Surface::cylinder({}, 1.0, {{0, 0}, {2 * pi, 8}});
  const ChartLoop low{{straight({0, 2}, {2 * pi, 2})}}, high{{straight({2 * pi, 5}, {0, 5})}};
  for (const auto& loops : {std::vector{low, high}, std::vector{turned(low), high}}) {
    SharedNumbers numbers;
    const auto found = mended({pipe, loops}, numbers);
    ASSERT_TRUE(found.ok()) << found.error().message;
    EXPECT_NEAR(chart_area(found->face), 6 * pi, 1e-9);
    check_seams(found->face);
  }
}

TEST(Mend, WhatASphereKeepsFollowsFromTheTurnOfItsLoop) {
  const Surface ball = *Surface::sphere({}, 1.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  SharedNumbers numbers;
  const auto small = mended({ball, {round({3, 0}, 0.5)}}, numbers);
  ASSERT_TRUE(small.ok()) << small.error().message;
  EXPECT_NEAR(chart_area(small->face), 0.25 * pi, 1e-9);
  const auto rest = mended({ball, {turned(round({3, 0}, 0.5))}}, numbers);
  ASSERT_TRUE(rest.ok()) << rest.error().message;
  EXPECT_NEAR(chart_area(rest->face), 2 * pi * pi - 0.25 * pi, 1e-9);
  EXPECT_TRUE(rest->findings.empty());
  const auto all = mended({ball, {}}, numbers);
  ASSERT_TRUE(all.ok());
  EXPECT_EQ(told(*all, "no_loops"), 1);
  EXPECT_NEAR(chart_area(all->face), 2 * pi * pi, 1e-9);
}

TEST(Mend, GapsAreClosedAndASlitIsALineInside) {
  for (const double gap : {1e-7, 1e-5, 1e-3}) {
    TrimmedSurface face{four_by_four(), {ring(corners)}};
    ChartLoop hole;
    hole.edges = {straight({1, 1}, {1, 3}), straight({1 + gap, 3}, {3, 3}), straight({3, 3 - gap}, {3, 1}),
                  straight({3, 1 + gap}, {1, 1 + gap})};
    face.loops.push_back(hole);
    SharedNumbers numbers;
    const auto found = mended(face, numbers);
    ASSERT_TRUE(found.ok()) << found.error().message;
    EXPECT_NEAR(chart_area(found->face), 12.0, 10 * gap);
    EXPECT_EQ(told(*found, "gap_closed"), gap > 4e-7 ? 4 : 0) << gap;
    check_loops(found->face);
  }
  TrimmedSurface slit{four_by_four(), {ring({{0, 0}, {2, 0}, {2, 2}, {2, 0}, {4, 0}, {4, 4}, {0, 4}})}};
  SharedNumbers numbers;
  const auto found = mended(slit, numbers);
  ASSERT_TRUE(found.ok()) << found.error().message;
  EXPECT_NEAR(chart_area(found->face), 16.0, 1e-12);
  ASSERT_EQ(found->face.lines.size(), 1U);
}

TEST(Mend, LoopsALittleBeyondTheChartArePulledIn) {
  for (const double off : {1e-9, 1e-6, 1e-3}) {
    SharedNumbers numbers;
    const auto found =
        mended({four_by_four(), {ring({{-off, -off}, {4 + off, -off}, {4 + off, 4}, {0, 4 + off}})}}, numbers);
    ASSERT_TRUE(found.ok()) << off << found.error().message;
    EXPECT_NEAR(chart_area(found->face), 16.0, 4 * off);
    EXPECT_EQ(told(*found, "pulled_in") > 0, off > 1e-7) << off;
    check_loops(found->face);
  }
}

TEST(Mend, LoopsThatCrossAreRefusedAndThoseThatTouchAreNot) {
  SharedNumbers numbers;
  const auto eight = mended({four_by_four(), {ring({{1, 1}, {3, 3}, {3, 1}, {1, 3}})}}, numbers);
  ASSERT_FALSE(eight.ok());
  EXPECT_EQ(eight.error().code, base::ErrorCode::SelfIntersection);
  EXPECT_NEAR(*eight.error().place->u, 2.0, 1e-9);
  EXPECT_NEAR(*eight.error().place->y, 2.0, 1e-9);
  const auto holes = mended({four_by_four(), {ring(corners), round({1.5, 2}, 1), round({2.5, 2}, 1)}}, numbers);
  ASSERT_FALSE(holes.ok());
  EXPECT_EQ(holes.error().code, base::ErrorCode::SelfIntersection);
  const auto touching = mended({four_by_four(), {ring(corners), round({1, 2}, 1), round({3, 2}, 1)}}, numbers);
  ASSERT_TRUE(touching.ok()) << touching.error().message;
  EXPECT_NEAR(chart_area(touching->face), 16 - 2 * pi, 1e-9);
}

TEST(FindFold, ACoonsPatchThatFoldsIsToldAndOthersAreNot) {
  for (const Named& each : all_kinds()) {
    SharedNumbers numbers;
    EXPECT_FALSE(find_fold(mended({each.surface, {}}, numbers)->face).has_value()) << each.name;
  }
  const auto line = [](double x0, double y0, double x1, double y1) { return *Curve::line({x0, y0, 0}, {x1, y1, 0}); };
  // The left border bulges over the right one.
  const Curve bulge = *Curve::bezier({{0, 0, 0}, {4, 0.3, 0}, {4, 0.7, 0}, {0, 1, 0}});
  const Surface folded = *Surface::coons(line(0, 0, 1, 0), line(0, 1, 1, 1), bulge, line(1, 0, 1, 1));
  SharedNumbers numbers;
  const auto fold = find_fold(mended({folded, {}}, numbers)->face);
  ASSERT_TRUE(fold.has_value());
  EXPECT_EQ(fold->code, base::ErrorCode::DegenerateCurve);
  ASSERT_TRUE(fold->place && fold->place->u && fold->place->z);
  const Jet jet = folded.jet({*fold->place->u, *fold->place->v});
  EXPECT_LE(geom::length(cross(jet.u, jet.v)), 1e-6);
  // What folds lies in the middle; without it the rest is sound.
  EXPECT_FALSE(find_fold(mended({folded, {ring({{0, 0}, {1, 0}, {1, 0.05}, {0, 0.05}})}}, numbers)->face).has_value());
  // A sharp ridge is no fold.
  const Surface ridge = *Surface::nurbs(1, {0, 0, 1, 2, 2}, 1, {0, 0, 1, 1},
                                        {{0, 0, 0}, {0, 8, 0}, {1, 0, 9}, {1, 8, 9}, {2, 0, 0}, {2, 8, 0}});
  EXPECT_FALSE(find_fold(mended({ridge, {}}, numbers)->face).has_value());
}

}  // namespace
}  // namespace dobra::surf::trim
