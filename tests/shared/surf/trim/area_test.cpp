#include "shared/surf/trim/area.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ctime>
#include <memory>
#include <numbers>

#include "tests/shared/surf/surface_shapes.h"

namespace dobra::surf::trim {
namespace {

using geom::Point;
using test::pi;

ChartEdge straight_edge(Point a, Point b) { return {*Curve::line({a.x, a.y, 0.0}, {b.x, b.y, 0.0})}; }
ChartLoop polygon_loop(const std::vector<Point>& corners) {
  ChartLoop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
    loop.edges.push_back(straight_edge(corners[i], corners[(i + 1) % corners.size()]));
  return loop;
}
ChartLoop circle_loop(Point centre, double radius, bool hole) {
  ChartEdge edge{*Curve::conic(Curve::Conic::Ellipse, {centre.x, centre.y, 0.0}, {radius, 0.0, 0.0}, {0.0, radius, 0.0},
                               0.0, 2.0 * pi)};
  edge.from = hole ? 2.0 * pi : 0.0;
  edge.to = hole ? 0.0 : 2.0 * pi;
  return {{edge}};
}
ChartLoop whole_chart(const Surface& surface) {
  const geom::Box& box = surface.chart();
  return polygon_loop({box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}});
}

TEST(TrimmedArea, OfAPolygonIsThatOfTheShoelace) {
  const std::vector<Point> corners{{0.1, 0.2}, {0.9, 0.1}, {0.6, 0.5}, {0.95, 0.9}, {0.2, 0.8}};
  double shoelace = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i], b = corners[(i + 1) % corners.size()];
    shoelace += 0.5 * (a.x * b.y - a.y * b.x);
  }
  const Surface plane = *Surface::plane(test::tilted(), {{0, 0}, {1, 1}});
  const Measured area_of_it = area({plane, {polygon_loop(corners)}});
  EXPECT_NEAR(area_of_it.value, shoelace, 1e-13);
  EXPECT_LE(std::abs(area_of_it.value - shoelace), area_of_it.error + 1e-15);
}

TEST(TrimmedArea, OfWholeChartsIsThatOfTheSurface) {
  for (const test::Named& kind : test::all_kinds()) {
    const Measured whole = surf::area(kind.surface, 1e-9);
    const Measured by_loop = area({kind.surface, {whole_chart(kind.surface)}}, 1e-7);
    EXPECT_NEAR(by_loop.value, whole.value, 1e-6 * whole.value) << kind.name;
    EXPECT_NEAR(by_loop.value, whole.value, 2.0 * (by_loop.error + whole.error) + 1e-12 * whole.value) << kind.name;
  }
}

/// A graph of 400 x 400 cubic pieces, cut by a slanting side, against the sum over a grid of the slopes of the formula.
TEST(TrimmedArea, OfHundredsOfPiecesBothWaysTakesNoMinutes) {
  constexpr std::size_t count = 403;
  constexpr double step = 1.0 / 400.0;
  std::vector<double> knots;
  for (std::size_t i = 0; i < count + 4; ++i) knots.push_back((static_cast<double>(i) - 3.0) * step);
  // Uniform B-splines keep x and y, and take cos(k x) times (2 + cos(k step)) / 3.
  const double wave = 40.0, shrunk = std::pow((2.0 + std::cos(wave * step)) / 3.0, 2);
  const auto at = [&](std::size_t i) { return (static_cast<double>(i) - 1.0) * step; };
  std::vector<geom::Point3> points;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j)
      points.push_back({at(i), at(j), 0.02 / shrunk * std::cos(wave * at(i)) * std::cos(wave * at(j))});
  }
  const auto surface = Surface::nurbs(3, knots, 3, knots, points);
  ASSERT_TRUE(surface);
  const std::clock_t began = std::clock();
  const Measured made = area({*surface, {polygon_loop({{0, 0}, {0.7, 0}, {1, 1}, {0, 1}})}});
  const double took = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  double sum = 0.0;
  constexpr int places = 2000;
  for (int j = 0; j < places; ++j) {
    const double y = (j + 0.5) / places, width = 0.7 + 0.3 * y;
    for (int i = 0; i < places; ++i) {
      const double x = width * (i + 0.5) / places;
      const double zx = 0.02 * wave * std::sin(wave * x) * std::cos(wave * y);
      const double zy = 0.02 * wave * std::cos(wave * x) * std::sin(wave * y);
      sum += std::sqrt(1.0 + zx * zx + zy * zy) * width / places / places;
    }
  }
  EXPECT_NEAR(made.value, sum, 1e-5 * sum);
  EXPECT_LT(took, 10.0);  // s of the processor; it was minutes
}

TEST(TrimmedArea, HolesTakeTheirsOff) {
  const Surface cylinder = *Surface::cylinder(test::tilted(), 2.5, {{0, 0}, {2, 2}});
  const Measured made = area({cylinder,
                              {polygon_loop({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), circle_loop({0.6, 0.6}, 0.4, true),
                               circle_loop({1.45, 1.4}, 0.5, true)}});
  EXPECT_NEAR(made.value, 2.5 * (4.0 - pi * (0.16 + 0.25)), 1e-7);
}

TEST(TrimmedArea, OfALoopTheOtherWayIsNegative) {
  const Surface plane = *Surface::plane({}, {{-1, -1}, {1, 1}});
  EXPECT_NEAR(area({plane, {circle_loop({0, 0}, 0.5, true)}}).value, -0.25 * pi, 1e-8);
}

/// A triangle on a sphere whose sides in the chart are two meridians and a straight line to the pole's side: by the
/// integral of sin of the latitude.
TEST(TrimmedArea, ReachesPoles) {
  const Surface sphere = *Surface::sphere({}, 3.0, {{0, 0}, {1, 0.5 * pi}});
  const Measured made = area({sphere, {polygon_loop({{0, 0}, {1, 0.3}, {1, 0.5 * pi}, {0, 0.5 * pi}})}});
  // Between the line v = 0.3 u and the pole: 9 times the sum of 1 - sin(0.3 u) over u.
  EXPECT_NEAR(made.value, 9.0 * (1.0 - (1.0 - std::cos(0.3)) / 0.3), 1e-7);
}

/// A strip a millionth as wide as long: the tolerance is of what the box has.
TEST(TrimmedArea, OfThinStripsEnds) {
  const Surface sphere = *Surface::sphere({}, 1.0, {{0, -1}, {2, 1}});
  const Measured made = area({sphere, {polygon_loop({{0, 0.2}, {2, 0.6}, {2, 0.600001}, {0, 0.200001}})}});
  EXPECT_NEAR(made.value, 1e-6 * (std::sin(0.6) - std::sin(0.2)) / 0.2, 1e-11);
}

/// Kinks of the surface cross the loop: an extruded polyline, straightened.
/// Stretches along u twice as much beyond a place that is no break of it: no halving finds the place exactly.
struct SteppedShape : Surface::Shape {
  static constexpr double step = 0.3137;
  mutable std::size_t asked = 0;
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    asked += uv.size();
    for (std::size_t i = 0; i < uv.size(); ++i)
      jets[i] = {{uv[i].x, uv[i].y, 0.0}, {uv[i].x > step ? 2.0 : 1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {}, {}, {}};
  }
  [[nodiscard]] Bend bend(const geom::Box&) const override { return {}; }
};

TEST(TrimmedArea, WhatHalvingTheLoopsDoesNotLowerIsToldAndLeft) {
  const auto shape = std::make_shared<const SteppedShape>();
  const Surface surface = *Surface::of(shape, {{0, 0}, {1, 1}});
  const std::size_t before = shape->asked;
  const Measured whole = area({surface, {whole_chart(surface)}});
  EXPECT_LE(shape->asked - before, 40'000U);
  EXPECT_GT(whole.error, 1e-8 * whole.value);
  EXPECT_NEAR(whole.value, 2.0 - SteppedShape::step, 2.0 * whole.error);
}

TEST(TrimmedArea, KinksOfTheSurfaceAreSeen) {
  const Curve zigzag = *Curve::nurbs(1, {0, 0, 0.4, 0.7, 1, 1}, {{0, 0, 0}, {1, 0, 1}, {2, 0, 0}, {3, 0, 3}});
  const Surface roof = *Surface::extruded(zigzag, {0, 1, 0});
  const Measured made = area({roof, {polygon_loop({{0.1, 0.1}, {0.9, 0.2}, {0.8, 0.9}, {0.2, 0.8}})}}, 1e-10);
  // By strips of u: the speed of the profile times the height of the polygon there.
  double sum = 0.0;
  constexpr int parts = 700'000;
  for (int i = 0; i < parts; ++i) {
    const double u = 0.1 + 0.8 * (i + 0.5) / parts;
    const double speed = u < 0.4 ? std::sqrt(2.0) / 0.4 : u < 0.7 ? std::sqrt(2.0) / 0.3 : std::sqrt(10.0) / 0.3;
    const double low = 0.1 + 0.1 * (u - 0.1) / 0.8;
    const double high = u < 0.2   ? 0.1 + 0.7 * (u - 0.1) / 0.1
                        : u < 0.8 ? 0.8 + 0.1 * (u - 0.2) / 0.6
                                  : 0.9 - 0.7 * (u - 0.8) / 0.1;
    sum += speed * (high - low) * 0.8 / parts;
  }
  EXPECT_NEAR(made.value, sum, 1e-5 * sum);
  EXPECT_LE(made.error, 1e-9 * sum);
}

}  // namespace
}  // namespace dobra::surf::trim
