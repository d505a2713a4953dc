#include "recon/block/strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace recon::block {
namespace {

using geom::Point;
using geom::Polyline;

constexpr double nowhere = std::numeric_limits<double>::infinity();

double area_of(const std::vector<Polyline>& loops) {
  double area = 0.0;
  for (const Polyline& loop : loops) area += geom::signed_area(loop);
  return area;
}

/// The area between two uprights by the integral of -y dx over the sides: uprights have no part in it.
double area_between(const Polyline& loop, double from, double to) {
  double area = 0.0;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Point a = loop.points[i];
    const Point b = loop.points[(i + 1) % loop.points.size()];
    if (a.x == b.x) continue;
    const auto y = [&](double x) { return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x); };
    const double x0 = std::clamp(a.x, from, to);
    const double x1 = std::clamp(b.x, from, to);
    area -= 0.5 * (y(x0) + y(x1)) * (x1 - x0);
  }
  return area;
}

TEST(Strip, LinesThatOnlyTouchABoundOrLieOutsideGiveNothing) {
  EXPECT_TRUE(within({{{-5, 0}, {0, 3}, {-5, 6}}, false}, {0.0, 10.0}).empty());
  EXPECT_TRUE(within({{{11, 0}, {12, 0}}, false}, {0.0, 10.0}).empty());
  EXPECT_TRUE(within({{{-5, 0}, {-1, 0}}, false}, {0.0, nowhere}).empty());
  EXPECT_TRUE(loops_within({{{{-5, 0}, {0, 0}, {0, 6}, {-5, 6}}, true}}, {0.0, 10.0}).empty());
  EXPECT_TRUE(loops_within({{{{-5, 0}, {0, 3}, {-5, 6}}, true}}, {0.0, 10.0}).empty());
  EXPECT_TRUE(loops_within({}, {0.0, 10.0}).empty());
}

TEST(Strip, ALineThatComesBackIsInPiecesWithItsOwnPoints) {
  const Polyline line{{{-2, 0}, {2, 0}, {4, 1}, {12, 5}, {12, 6}, {9, 6}, {10, 7}, {9, 8}, {-1, 8}}, false};
  const std::vector<Polyline> pieces = within(line, {0.0, 10.0});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].points, (std::vector<Point>{{0, 0}, {2, 0}, {4, 1}, {10, 4}}));
  EXPECT_EQ(pieces[1].points, (std::vector<Point>{{10, 6}, {9, 6}, {10, 7}, {9, 8}, {0, 8}}));
}

TEST(Strip, ALineOnABoundAndALineWithinStayAsTheyAre) {
  const Polyline upright{{{10, 0}, {10, 4}}, false};
  EXPECT_EQ(within(upright, {0.0, 10.0}), std::vector<Polyline>{upright});
  EXPECT_EQ(within(upright, {10.0, 20.0}), std::vector<Polyline>{upright});
  const Polyline loop{{{0, 0}, {10, 0}, {10, 4}, {0, 4}}, true};
  EXPECT_EQ(loops_within({loop}, {0.0, 10.0}), std::vector<Polyline>{loop});
  EXPECT_EQ(loops_within({loop}, {}), std::vector<Polyline>{loop});
}

TEST(Strip, BothWaysAlongASideMeetABoundInOnePlace) {
  const Point a{-1.0 / 3.0, 0.1};
  const Point b{2.0 / 7.0, 1.3};
  const auto there = within({{a, b}, false}, {0.1, nowhere});
  const auto back = within({{b, a}, false}, {0.1, nowhere});
  EXPECT_EQ(there[0].points.front(), back[0].points.back());
  EXPECT_EQ(there[0].points.front().x, 0.1);
}

TEST(Strip, ACombFallsIntoItsTeethAndAHoleOpens) {
  // Three teeth that point to the right, and the back of the comb at the left.
  const Polyline comb{{{0, 0}, {9, 0}, {9, 1}, {3, 1}, {3, 2}, {9, 2}, {9, 3}, {3, 3}, {3, 4}, {9, 4}, {9, 5}, {0, 5}},
                      true};
  const auto teeth = loops_within({comb}, {5.0, nowhere});
  ASSERT_EQ(teeth.size(), 3U);
  for (const Polyline& tooth : teeth) EXPECT_EQ(geom::signed_area(tooth), 4.0);
  const auto back = loops_within({comb}, {-nowhere, 5.0});
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(geom::signed_area(back[0]), 21.0);
  const Polyline outer{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, true};
  const Polyline hole{{{4, 4}, {4, 6}, {6, 6}, {6, 4}}, true};
  const auto open = loops_within({outer, hole}, {5.0, nowhere});
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(geom::signed_area(open[0]), 48.0);
  const auto whole = loops_within({outer, hole}, {2.0, nowhere});
  ASSERT_EQ(whole.size(), 2U);
  EXPECT_EQ(area_of(whole), 76.0);
  const auto parted = loops_within({outer, hole}, {4.5, 5.5});  // only above and below the hole
  ASSERT_EQ(parted.size(), 2U);
  EXPECT_EQ(area_of(parted), 8.0);
}

TEST(Strip, RandomStarsKeepTheirAreaBetweenTheBounds) {
  std::mt19937 random(11);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  for (int i = 0; i < 300; ++i) {
    Polyline star{{}, true};
    const int corners = 3 + i % 40;
    for (int k = 0; k < corners; ++k) {
      const double angle = 6.283185307179586 * k / corners;
      const double reach = draw(0.5, 10.0);
      star.points.push_back({reach * std::cos(angle), reach * std::sin(angle)});
      if (i % 3 == 0)
        star.points.back() = {std::round(star.points.back().x), star.points.back().y};  // corners on bounds
    }
    const double from = std::round(draw(-8.0, 3.0));
    const double to = from + std::round(draw(1.0, 5.0));
    const std::vector<Polyline> loops = loops_within({star}, {from, to});
    EXPECT_NEAR(area_of(loops), area_between(star, from, to), 1e-10) << i;
    for (const Polyline& loop : loops) {
      EXPECT_GT(geom::signed_area(loop), 0.0) << i;
      for (const Point p : loop.points) EXPECT_TRUE(p.x >= from && p.x <= to) << i;
    }
  }
}

}  // namespace
}  // namespace recon::block
