#include "shared/geom/cubic_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shared/geom/discretise.h"

namespace dobra::geom {
namespace {

/// Points with y at x = 0, 1, 2, ...
std::vector<Point> graph(std::initializer_list<double> heights) {
  std::vector<Point> points;
  for (const double y : heights) points.push_back({static_cast<double>(points.size()), y});
  return points;
}

/// The point in the middle of a cubic, by the knots.
Point middle(const CubicPath& path, std::size_t i) {
  const auto k = path.knots();
  return path.point((0.5 * (k[i] + k[i + 1]) - k.front()) / (k.back() - k.front()));
}

TEST(CubicPath, CRV_a_NaturalSplineHasItsListedDerivatives) {
  const auto points = graph({0, 1, 0, 1, 0});
  const auto knots = uniform_knots(5, SplineEnds::Natural);
  const auto d = spline_derivatives(points, knots, SplineEnds::Natural);
  const double expected[] = {12.0 / 7, -3.0 / 7, 0, 3.0 / 7, -12.0 / 7};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(d[i].y, expected[i], 1e-14);
    EXPECT_NEAR(d[i].x, 1.0, 1e-14);  // x is the parameter itself
  }
  const CubicPath path = *cubic_spline(points, knots, SplineEnds::Natural);
  const double heights[] = {0.767857, 0.446429, 0.446429, 0.767857};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(middle(path, i).y, heights[i], 5e-7);
}

TEST(CubicPath, CRV_b_KnotsChangeTheDerivatives) {
  const auto points = graph({0, 1, 0, 1, 0, 1});
  const auto uniform = spline_derivatives(points, uniform_knots(6, SplineEnds::Natural), SplineEnds::Natural);
  EXPECT_NEAR(uniform[0].y, 1.727273, 5e-7);
  EXPECT_NEAR(uniform[1].y, -0.454545, 5e-7);
  EXPECT_NEAR(uniform[2].y, 0.090909, 5e-7);
  const auto spaced = spline_derivatives(points, std::vector<double>{0, 1, 2, 6, 7, 8}, SplineEnds::Natural);
  const double expected[] = {1.576087, -0.152174, -0.967391, -0.967391, -0.152174, 1.576087};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(spaced[i].y, expected[i], 5e-7);
}

TEST(CubicPath, CRV_c_ClosedSplineThroughFourPointsOfACircle) {
  const std::vector<Point> points{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  const auto knots = uniform_knots(4, SplineEnds::Closed);
  const auto d = spline_derivatives(points, knots, SplineEnds::Closed);
  const Vector expected[] = {{0, 1.5}, {-1.5, 0}, {0, -1.5}, {1.5, 0}};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(length(d[i] - expected[i]), 1e-14);
  const CubicPath path = *cubic_spline(points, knots, SplineEnds::Closed);
  EXPECT_LT(distance(middle(path, 0), {0.6875, 0.6875}), 1e-14);
  EXPECT_EQ(path.point(0.0), path.point(1.0));
  EXPECT_LT(length(path.tangent(0.0) - path.tangent(1.0)), 1e-13);
}

TEST(CubicPath, CRV_e_UniformBSplineOfTheExampleAndItsLocalControl) {
  const std::vector<Point> vertices{{0, 0}, {1, 2}, {3, 3}, {4, 0}};
  const CubicPath path = *uniform_b_spline(vertices);
  ASSERT_EQ(path.cubics().size(), 1U);
  EXPECT_LT(distance(path.point(0), {1 + 1.0 / 6, 11.0 / 6}), 1e-14);
  EXPECT_LT(distance(path.point(0.5), {2, 2.0 + 19.0 / 48}), 1e-14);
  EXPECT_LT(distance(path.point(1), {3 - 1.0 / 6, 14.0 / 6}), 1e-14);
  for (int i = 0; i <= 10; ++i) {  // equal vertices: the basis sums to 1
    EXPECT_LT(distance(uniform_b_spline(std::vector<Point>(4, {7, 5}))->point(i / 10.0), {7, 5}), 1e-14);
  }
  std::vector<Point> seven;
  for (int i = 0; i < 7; ++i) seven.push_back({static_cast<double>(i), std::sin(i)});
  const CubicPath before = *uniform_b_spline(seven);
  seven[0].y += 1.0;
  const CubicPath after = *uniform_b_spline(seven);
  ASSERT_EQ(before.cubics().size(), 4U);
  EXPECT_NE(after.point(0.1), before.point(0.1));
  for (int i = 0; i <= 30; ++i) EXPECT_EQ(after.point(0.25 + 0.75 * i / 30), before.point(0.25 + 0.75 * i / 30));
}

TEST(CubicPath, CRV_h_MovesWithItsPoints) {
  const auto points = graph({0, 3, 1, 1, 5, -2});
  const auto moved = [](Point p) {
    return Point{p.x * std::cos(0.7) - p.y * std::sin(0.7) + 3, p.x * std::sin(0.7) + p.y * std::cos(0.7) - 5};
  };
  std::vector<Point> others;
  for (const Point p : points) others.push_back(moved(p));
  for (const SplineEnds ends : {SplineEnds::Natural, SplineEnds::Closed}) {
    const CubicPath path = *cubic_spline(points, chord_length_knots(points, ends), ends);
    const CubicPath other = *cubic_spline(others, chord_length_knots(others, ends), ends);
    for (int i = 0; i <= 40; ++i) EXPECT_LT(distance(other.point(i / 40.0), moved(path.point(i / 40.0))), 1e-13);
  }
  const CubicPath near = *uniform_b_spline(points);
  const CubicPath other = *uniform_b_spline(others);
  for (int i = 0; i <= 40; ++i) EXPECT_LT(distance(other.point(i / 40.0), moved(near.point(i / 40.0))), 1e-13);
}

TEST(CubicPath, SplinesAreSmoothToTheSecondDerivativeWithAnyKnots) {
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  for (const SplineEnds ends : {SplineEnds::Natural, SplineEnds::Closed}) {
    std::vector<Point> points(200);
    for (Point& p : points) p = {normal(random), normal(random)};
    const auto knots = chord_length_knots(points, ends);
    const CubicPath path = *cubic_spline(points, knots, ends);
    const auto curvature = [&](const HermiteCubic& c, double h,
                               double u) {  // second derivative by the knots' parameter
      const Vector second = (6 - 12 * u) * (c.to - c.from) + (6 * u - 4) * c.from_tangent + (6 * u - 2) * c.to_tangent;
      return second / (h * h);
    };
    const auto cubics = path.cubics();
    double worst = 0;
    for (std::size_t i = 0; i + (ends == SplineEnds::Closed ? 0 : 1) < cubics.size(); ++i) {
      const std::size_t next = (i + 1) % cubics.size();
      const Vector a = curvature(cubics[i], knots[i + 1] - knots[i], 1);
      const Vector b = curvature(cubics[next], knots[next + 1] - knots[next], 0);
      worst = std::max(worst, length(a - b) / (1 + length(a)));
    }
    EXPECT_LT(worst, 1e-10);
    if (ends == SplineEnds::Natural) {
      EXPECT_LT(length(curvature(cubics[0], knots[1], 0)), 1e-9);
    }
  }
}

TEST(CubicPath, LengthAddsUpAndFollowsItsChords) {
  const auto points = graph({0, 3, 1, 1, 5, -2});
  const CubicPath path = *cubic_spline(points, chord_length_knots(points, SplineEnds::Natural), SplineEnds::Natural);
  EXPECT_NEAR(path.length(0, 0.37) + path.length(0.37, 1), path.length(0, 1), 1e-12);
  const auto drawn = discretise(functions_of(path), {.max_length = 0.01});
  ASSERT_TRUE(drawn.ok());
  EXPECT_NEAR(length(drawn->polyline()), path.length(0, 1), 1e-3);
}

TEST(CubicPath, BadInputIsRefused) {
  const auto points = graph({0, 1, 0});
  const auto spline = [&](std::vector<double> knots) { return cubic_spline(points, knots, SplineEnds::Natural); };
  EXPECT_EQ(spline({0, 1}).error().code, base::ErrorCode::InvalidOption);
  EXPECT_EQ(spline({0, 1, 1}).error().code, base::ErrorCode::InvalidOption);
  EXPECT_EQ(cubic_spline(graph({0}), std::vector<double>{0}, SplineEnds::Natural).error().code,
            base::ErrorCode::DegenerateCurve);
  EXPECT_EQ(uniform_b_spline(points).error().code, base::ErrorCode::DegenerateCurve);
}

}  // namespace
}  // namespace dobra::geom
