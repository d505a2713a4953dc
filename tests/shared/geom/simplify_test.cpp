#include "shared/geom/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace dobra::geom {
namespace {

Polyline circle(std::size_t count) {
  Polyline contour;
  contour.closed = true;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    contour.points.push_back({std::cos(angle), std::sin(angle)});
  }
  return contour;
}

TEST(Simplify, CollinearPointsGoAtToleranceZeroAndCornersStay) {
  const Polyline chain{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}}, false};
  EXPECT_EQ(*simplify(chain, {0.0}), (Polyline{{{0, 0}, {3, 0}, {3, 2}}, false}));
  const Polyline square{{{1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 0}}, true};
  EXPECT_EQ(*simplify(square, {0.0}), (Polyline{{{2, 0}, {2, 2}, {0, 2}, {0, 0}}, true}));
}

TEST(Simplify, BumpOfTheToleranceGoesAndAHigherOneStays) {
  const Polyline chain{{{0, 0}, {1, 0.5}, {2, 0}}, false};
  EXPECT_EQ(simplify(chain, {0.5})->points.size(), 2U);
  EXPECT_EQ(simplify(chain, {0.49})->points.size(), 3U);
}

TEST(Simplify, EveryDroppedPointStaysWithinTolerance) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> step(-1.0, 1.0);
  for (const bool closed : {false, true}) {
    Polyline walk;
    walk.closed = closed;
    Point p;
    for (int i = 0; i < 500; ++i) walk.points.push_back(p = p + Vector{0.5 + step(random), step(random)});
    const Polyline few = *simplify(walk, {0.8});
    EXPECT_LT(few.points.size(), walk.points.size());
    for (const Point q : walk.points) ASSERT_LE(distance(few, q), 0.8);
    if (!closed) {
      EXPECT_EQ(few.points.front(), walk.points.front());
      EXPECT_EQ(few.points.back(), walk.points.back());
    }
  }
}

TEST(Simplify, StartVertexOfAContourDoesNotMatter) {
  Polyline contour = circle(60);
  auto sorted = simplify(contour, {0.05})->points;
  EXPECT_LT(sorted.size(), 30U);
  std::sort(sorted.begin(), sorted.end());
  for (int i = 0; i < 60; ++i) {
    std::rotate(contour.points.begin(), contour.points.begin() + 1, contour.points.end());
    auto turned = simplify(contour, {0.05})->points;
    std::sort(turned.begin(), turned.end());
    ASSERT_EQ(turned, sorted);
  }
}

TEST(Simplify, ContourKeepsThreePointsAtAnyTolerance) { EXPECT_EQ(simplify(circle(60), {100.0})->points.size(), 3U); }

TEST(Simplify, BadInputIsAnError) {
  EXPECT_EQ(simplify(circle(9), {-1.0}).error().code, base::ErrorCode::InvalidOption);
  EXPECT_EQ(simplify({{{1, 1}}, false}, {1.0}).error().code, base::ErrorCode::DegenerateCurve);
}

}  // namespace
}  // namespace dobra::geom
