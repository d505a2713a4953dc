#include "shared/geom/drawn_curve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dobra::geom {
namespace {

Polyline drawn_as(DrawnAs as, const DrawnCurve& curve, double degrees = 2.0) {
  const auto made = drawn(curve, as, {.max_angle = base::Angle::from_degrees(degrees)});
  EXPECT_TRUE(made) << to_string(made.error());
  return made ? *made : Polyline{};
}

TEST(DrawnCurve, TheQuarterCircleOfARationalBezierLiesOnTheCircle) {
  const Polyline arc = drawn_as(DrawnAs::RationalBezier, {{{1, 0}, {1, 1}, {0, 1}}, {}, {1.0, std::sqrt(0.5), 1.0}});
  for (const Point p : arc.points) EXPECT_NEAR(length(p - Point{}), 1.0, 1e-14);
  EXPECT_EQ(arc.points.front(), (Point{1, 0}));
  EXPECT_EQ(arc.points.back(), (Point{0, 1}));
  EXPECT_GE(arc.points.size(), 46u);  // 90 degrees by 2
}

TEST(DrawnCurve, ASplineAndAHermiteCurvePassThroughTheirPoints) {
  const std::vector<Point> points{{0, 0}, {3, 2}, {7, -1}, {10, 0}};
  const Polyline spline = drawn_as(DrawnAs::Spline, {points});
  const Polyline hermite = drawn_as(DrawnAs::Hermite, {points, {{3, 2}, {3, 0}, {3, -1}, {3, 1}}});
  for (const Point p : points) {
    EXPECT_LT(distance(spline, p), 2e-3);
    EXPECT_LT(distance(hermite, p), 2e-3);
  }
  EXPECT_FALSE(spline.closed);
  EXPECT_EQ(spline.points.back(), points.back());
}

TEST(DrawnCurve, ASplineWhoseLastPointRepeatsTheFirstIsClosed) {
  std::vector<Point> ring;
  for (int i = 0; i <= 8; ++i) {
    const double angle = 2.0 * 3.14159265358979323846 * (i % 8) / 8.0;
    ring.push_back({std::cos(angle), std::sin(angle)});
  }
  const Polyline closed = drawn_as(DrawnAs::Spline, {ring});
  EXPECT_TRUE(closed.closed);
  EXPECT_NEAR(signed_area(closed), 3.14159265, 0.02);
}

TEST(DrawnCurve, BeziersAndBSplinesStayWithinTheirPolygon) {
  const std::vector<Point> polygon{{0, 0}, {1, 4}, {5, 4}, {6, 0}};
  for (const DrawnAs as : {DrawnAs::Bezier, DrawnAs::BSpline}) {
    for (const Point p : drawn_as(as, {polygon}).points) {
      EXPECT_GE(p.y, 0.0);
      EXPECT_LE(p.y, 4.0);
    }
  }
}

TEST(DrawnCurve, AFinerAngleGivesMorePointsAndNoPieceIsLongerThanAsked) {
  const DrawnCurve curve{{{0, 0}, {3, 2}, {7, -1}, {10, 0}}};
  EXPECT_GT(drawn_as(DrawnAs::Spline, curve, 1.0).points.size(), drawn_as(DrawnAs::Spline, curve, 10.0).points.size());
  const auto fine = drawn(curve, DrawnAs::Spline, {.max_length = 0.25});
  ASSERT_TRUE(fine);
  for (std::size_t i = 0; i < fine->segment_count(); ++i) EXPECT_LE(fine->segment(i).length(), 0.25 * (1 + 1e-9));
}

TEST(DrawnCurve, WhatAKindDoesNotHaveOrLacksIsRefused) {
  const std::vector<Point> points{{0, 0}, {1, 1}, {2, 0}};
  const auto code = [&](DrawnAs as, const DrawnCurve& curve) {
    const auto made = drawn(curve, as);
    return made ? base::ErrorCode::Cancelled : made.error().code;
  };
  EXPECT_EQ(code(DrawnAs::Hermite, {points}), base::ErrorCode::InvalidOption);
  EXPECT_EQ(code(DrawnAs::RationalBezier, {points, {}, {1, 1}}), base::ErrorCode::InvalidOption);
  EXPECT_EQ(code(DrawnAs::RationalBezier, {points, {}, {1, -1, 1}}), base::ErrorCode::InvalidOption);
  EXPECT_EQ(code(DrawnAs::Line, {points, {}, {1, 1, 1}}), base::ErrorCode::InvalidOption);
  EXPECT_EQ(code(DrawnAs::BSpline, {points}), base::ErrorCode::DegenerateCurve);
  EXPECT_EQ(code(DrawnAs::Spline, {{{0, 0}}}), base::ErrorCode::DegenerateCurve);
}

}  // namespace
}  // namespace dobra::geom
