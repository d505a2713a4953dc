#include "shared/geom/bezier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "shared/geom/discretise.h"
#include "shared/geom/predicates.h"

namespace dobra::geom {
namespace {

void expect_close(Point p, Point q, double tolerance = 1e-14) {
  EXPECT_NEAR(p.x, q.x, tolerance);
  EXPECT_NEAR(p.y, q.y, tolerance);
}
void expect_close(Vector p, Vector q, double tolerance = 1e-14) {
  expect_close(Point{p.x, p.y}, Point{q.x, q.y}, tolerance);
}

Bezier example() { return *Bezier::make({{0, 0}, {1, 2}, {3, 3}, {4, 0}}); }

TEST(Bezier, CRV_d_PointsSplitAndLengthOfTheExample) {
  const Bezier curve = example();
  expect_close(curve.point(0.5), {2, 1.875});
  expect_close(curve.point(0.25), {0.90625, 1.265625});
  const auto [left, right] = curve.split(0.5);
  const std::vector<Point> expected{{0, 0}, {0.5, 1}, {1.25, 1.75}, {2, 1.875}};
  for (std::size_t i = 0; i < 4; ++i) expect_close(left.vertices()[i], expected[i]);
  expect_close(right.point(0.0), {2, 1.875});
  expect_close(right.point(1.0), {4, 0});
  EXPECT_NEAR(curve.length(0, 1), 5.829927, 5e-7);
  EXPECT_NEAR(left.length(0, 1) + right.length(0, 1), curve.length(0, 1), 1e-12);
  EXPECT_NEAR(curve.length(0.2, 0.7), -curve.length(0.7, 0.2), 1e-12);
}

TEST(Bezier, CRV_d_BothPartsFollowTheWholeAtAnyDegree) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (std::size_t degree = 1; degree <= 7; ++degree) {
    std::vector<Point> vertices(degree + 1);
    for (Point& p : vertices) p = {normal(random), normal(random)};
    const Bezier curve = *Bezier::make(vertices);
    const auto [before, after] = curve.split(0.3);
    for (const double t : {0.0, 0.4, 1.0}) {
      expect_close(before.point(t), curve.point(0.3 * t), 1e-13);
      expect_close(after.point(t), curve.point(0.3 + 0.7 * t), 1e-13);
      expect_close(0.7 * curve.tangent(0.3 + 0.7 * t), after.tangent(t), 1e-12);
    }
  }
}

TEST(RationalBezier, CRV_f_QuarterOfTheUnitCircleWithBothWeightings) {
  const double w = std::sqrt(0.5);
  for (const auto& [weights, middle] :
       {std::pair{std::vector<double>{1, 1, 2}, Point{0.6, 0.8}}, {{1, w, 1}, Point{w, w}}}) {
    const RationalBezier curve = *RationalBezier::make({{1, 0}, {1, 1}, {0, 1}}, weights);
    for (int i = 0; i <= 50; ++i) {
      const Point p = curve.point(i / 50.0);
      EXPECT_NEAR(std::hypot(p.x, p.y), 1.0, 1e-12);
      EXPECT_NEAR(dot(curve.tangent(i / 50.0), p - Point{}), 0.0, 1e-12);
    }
    expect_close(curve.point(0.5), middle, 1e-15);
    EXPECT_NEAR(curve.length(0, 1), std::numbers::pi / 2, 1e-12);
    const auto [before, after] = curve.split(0.3);
    expect_close(before.point(0.5), curve.point(0.15), 1e-15);
    expect_close(after.point(0.5), curve.point(0.65), 1e-15);
  }
}

TEST(HermiteCubic, CRV_g_ConversionThereAndBackChangesNothing) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vector{normal(random), normal(random)}; };
  for (int i = 0; i < 100; ++i) {
    const HermiteCubic cubic{Point{} + vector(), Point{} + vector(), vector(), vector()};
    const HermiteCubic back = hermite_of(bezier_of(cubic));
    expect_close(back.from, cubic.from, 1e-12);
    expect_close(back.to, cubic.to, 1e-12);
    expect_close(back.from_tangent, cubic.from_tangent, 1e-12);
    expect_close(back.to_tangent, cubic.to_tangent, 1e-12);
    expect_close(bezier_of(cubic).tangent(0), cubic.from_tangent, 1e-12);
    expect_close(bezier_of(cubic).tangent(1), cubic.to_tangent, 1e-12);
  }
}

TEST(Bezier, CRV_g_CurvesJoinedByEquation49HaveOneDerivative) {
  const Bezier first = example();
  for (const std::size_t degree : {1U, 2U, 3U, 5U}) {
    std::vector<Point> vertices(degree + 1, Point{7, -2});
    vertices[0] = first.vertices().back();
    vertices[1] = smooth_continuation(first, degree);
    expect_close(Bezier::make(vertices)->tangent(0), first.tangent(1), 1e-14);
  }
}

TEST(Bezier, CRV_h_MovesWithItsVerticesAndStaysInTheirHull) {
  const Bezier curve = example();
  const double a = 0.7;
  const auto moved = [&](Point p) {
    return Point{p.x * std::cos(a) - p.y * std::sin(a) + 3, p.x * std::sin(a) + p.y * std::cos(a) - 5};
  };
  std::vector<Point> vertices;
  for (const Point p : curve.vertices()) vertices.push_back(moved(p));
  const Bezier other = *Bezier::make(vertices);
  for (int i = 0; i <= 20; ++i) {
    const Point p = curve.point(i / 20.0);
    expect_close(other.point(i / 20.0), moved(p), 1e-14);
    for (std::size_t k = 0; k < 4; ++k) {  // the example's vertices are their own hull, clockwise
      EXPECT_NE(orient2d(curve.vertices()[k], curve.vertices()[(k + 1) % 4], p), Sign::Positive);
    }
  }
}

TEST(Bezier, IsDiscretisedLikeAnyCurve) {
  const Bezier curve = example();
  const auto points = discretise(functions_of(curve), {.max_length = 0.05});
  ASSERT_TRUE(points.ok());
  EXPECT_NEAR(length(points->polyline()), curve.length(0, 1), 1e-3);
}

TEST(Bezier, BadInputIsRefused) {
  EXPECT_EQ(Bezier::make({{0, 0}}).error().code, base::ErrorCode::DegenerateCurve);
  EXPECT_EQ(Bezier::make({{0, 0}, {NAN, 0}}).error().code, base::ErrorCode::NotFinite);
  EXPECT_EQ(RationalBezier::make({{0, 0}, {1, 0}}, {1}).error().code, base::ErrorCode::InvalidOption);
  EXPECT_EQ(RationalBezier::make({{0, 0}, {1, 0}}, {1, 0}).error().code, base::ErrorCode::InvalidOption);
}

}  // namespace
}  // namespace dobra::geom
