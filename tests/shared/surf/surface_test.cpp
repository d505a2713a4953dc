// Surfaces against closed forms, against each other, and their derivatives against differences of their points.

#include "shared/surf/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "shared/surf/measure.h"
#include "tests/shared/surf/surface_shapes.h"

namespace dobra::surf {
namespace {

using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;
using namespace test;

TEST(Surface, DerivativesAreThoseOfThePoints) {
  std::mt19937 random(5);
  for (const auto& [name, surface] : all_kinds()) {
    const Box& chart = surface.chart();
    const double du = 1e-4 * chart.width(), dv = 1e-4 * chart.height();
    for (int tries = 0; tries < 200; ++tries) {
      const auto part = [&] { return 0.01 + 0.98 * static_cast<double>(random() % 10000) / 10000.0; };
      const Point at{chart.low.x + part() * chart.width(), chart.low.y + part() * chart.height()};
      bool near_break = false;  // a difference over it is of two pieces
      for (const double u : surface.breaks().u) near_break = near_break || std::abs(u - at.x) < 3.0 * du;
      for (const double v : surface.breaks().v) near_break = near_break || std::abs(v - at.y) < 3.0 * dv;
      if (near_break) continue;
      const Jet jet = surface.jet(at);
      const auto p = [&](double i, double j) { return surface.at({at.x + i * du, at.y + j * dv}); };
      // Differences of fourth order.
      const auto first = [&](const std::function<Point3(double)>& q, double h) {
        return (8.0 * (q(1) - q(-1)) - (q(2) - q(-2))) / (12.0 * h);
      };
      const auto second = [&](const std::function<Point3(double)>& q, double h) {
        return (16.0 * ((q(1) - q(0)) + (q(-1) - q(0))) - ((q(2) - q(0)) + (q(-2) - q(0)))) / (12.0 * h * h);
      };
      const double size = surface.size();
      const auto near = [&](Vector3 a, Vector3 b, double unit, double within, const char* what) {
        EXPECT_LE(geom::length(a - b) * unit, within * size) << name << " " << what << " at " << at;
      };
      near(jet.u, first([&](double i) { return p(i, 0); }, du), chart.width(), 1e-8, "u");
      near(jet.v, first([&](double j) { return p(0, j); }, dv), chart.height(), 1e-8, "v");
      near(jet.uu, second([&](double i) { return p(i, 0); }, du), chart.width() * chart.width(), 3e-5, "uu");
      near(jet.vv, second([&](double j) { return p(0, j); }, dv), chart.height() * chart.height(), 3e-5, "vv");
      const auto u_at = [&](double j) { return Point3{} + surface.jet({at.x, at.y + j * dv}).u; };
      near(jet.uv, first(u_at, dv), chart.width() * chart.height(), 1e-6, "uv");
      EXPECT_EQ(jet.at, p(0, 0)) << name;
    }
  }
}

/// surfaces.md gives these from another program.
TEST(Surface, AreasOfTheStandIns) {
  const Frame frame = tilted();
  EXPECT_NEAR(area(*Surface::cylinder(frame, 5.0, {{0, 0}, {0.5 * pi, 10.0}})).value, 78.539816, 5e-7);
  EXPECT_NEAR(area(*Surface::graph("(x^2 - y^2) / 10", {{-10, -10}, {10, 10}})).value, 744.625672, 5e-7);
  EXPECT_NEAR(area(*Surface::sphere(frame, 5.0, {{0, -pi / 3.0}, {pi, pi / 3.0}})).value, 136.034952, 5e-7);
  EXPECT_NEAR(area(*Surface::torus(frame, 6.0, 2.0, {{0, 0}, {1.5 * pi, 2.0 * pi}})).value, 355.305758, 5e-7);
  EXPECT_NEAR(area(*Surface::torus(frame, 6.0, 2.0, {{0, 0}, {1.5 * pi, pi}})).value, 177.652879, 5e-7);
  EXPECT_NEAR(area(*Surface::torus(frame, 6.0, 2.0, {{0, -0.5 * pi}, {1.5 * pi, 0.5 * pi}})).value, 215.351991, 5e-7);
  EXPECT_NEAR(area(*Surface::graph("4 * exp(-(x^2 + y^2) / 8)", {{-10, -10}, {10, 10}}), 1e-9).value, 420.999630, 5e-7);
  EXPECT_NEAR(area(*Surface::graph("1.5 * sin(x) * cos(y)", {{0, 0}, {10, 10}}), 1e-9).value, 144.457679, 5e-7);
  EXPECT_NEAR(area(coons_of_cubics()).value, 118.238826, 5e-7);
}

TEST(Surface, CoonsOfCubicsIsTheBicubicPatchOfTheirPolygons) {
  const Surface coons = coons_of_cubics();
  EXPECT_NEAR(coons.at({0.5, 0.5}).z, 2.25, 1e-14);
  // The control net is the Coons of the control polygons.
  const double bottom[] = {0, 4, 4, 0}, top[] = {0, -3, 5, 0}, left[] = {0, 3, -3, 0}, right[] = {0, -2, 4, 0};
  std::vector<Point3> net;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double u = i / 3.0, v = j / 3.0;
      net.push_back({10.0 * u, 10.0 * v, (1 - v) * bottom[i] + v * top[i] + (1 - u) * left[j] + u * right[j]});
    }
  }
  const Surface patch = *Surface::nurbs(3, {0, 0, 0, 0, 1, 1, 1, 1}, 3, {0, 0, 0, 0, 1, 1, 1, 1}, net);
  for (double u = 0.0; u <= 1.0; u += 0.125) {
    for (double v = 0.0; v <= 1.0; v += 0.125)
      EXPECT_LE(geom::distance(coons.at({u, v}), patch.at({u, v})), 1e-13) << u << " " << v;
  }
}

TEST(Surface, CurvaturesOfQuadricsAreExact) {
  const Frame frame = tilted();
  std::mt19937 random(8);
  for (int i = 0; i < 100; ++i) {
    const Point at{static_cast<double>(random() % 1000) / 700.0, static_cast<double>(random() % 1000) / 800.0};
    const auto of = [&](const Surface& surface) { return *curvature(surface.jet(at)); };
    const Curvature ball = of(*Surface::sphere(frame, 5.0, {{0, 0}, {1.5, 1.4}}));
    EXPECT_NEAR(ball.least, -0.2, 1e-14);  // away from the normal, which points outwards
    EXPECT_NEAR(ball.greatest, -0.2, 1e-14);
    const Curvature pipe = of(*Surface::cylinder(frame, 4.0, {{0, 0}, {1.5, 1.5}}));
    EXPECT_NEAR(pipe.least, -0.25, 1e-14);
    EXPECT_NEAR(pipe.greatest, 0.0, 1e-14);
    const Curvature ring = of(*Surface::torus(frame, 6.0, 2.0, {{0, 0}, {1.5, 1.5}}));
    EXPECT_NEAR(ring.gaussian(), std::cos(at.y) / (2.0 * (6.0 + 2.0 * std::cos(at.y))), 1e-13);
    EXPECT_NEAR(ring.mean(), -(6.0 + 4.0 * std::cos(at.y)) / (4.0 * (6.0 + 2.0 * std::cos(at.y))), 1e-13);
  }
}

/// A rational patch of degree 2 and the sphere itself, whatever the parameters.
TEST(Surface, RationalPatchesAreQuadricsExactly) {
  const double w = std::sqrt(0.5);
  // An octant of the sphere of radius 3, its pole a side.
  std::vector<Point3> net{{3, 0, 0}, {3, 0, 3}, {0, 0, 3}, {3, 3, 0}, {3, 3, 3},
                          {0, 0, 3}, {0, 3, 0}, {0, 3, 3}, {0, 0, 3}};
  const Surface octant =
      *Surface::nurbs(2, {0, 0, 0, 1, 1, 1}, 2, {0, 0, 0, 1, 1, 1}, net, {1, w, 1, w, 0.5, w, 1, w, 1});
  for (double u = 0.0; u <= 1.0; u += 1.0 / 16.0) {
    for (double v = 0.0; v <= 1.0; v += 1.0 / 16.0) EXPECT_NEAR(geom::length(octant.at({u, v}) - Point3{}), 3.0, 1e-14);
  }
  EXPECT_TRUE(octant.collapsed(Side::Top));
  EXPECT_FALSE(octant.collapsed(Side::Bottom) || octant.collapsed(Side::Left) || octant.collapsed(Side::Right));
  EXPECT_NEAR(area(octant).value, 4.5 * pi, 1e-8);
  EXPECT_FALSE(normal(octant.jet({0.3, 1.0})));  // none at a pole
  EXPECT_TRUE(normal(octant.jet({0.3, 0.999})));
}

TEST(Surface, PolesAndSeamsAreKnown) {
  const Surface ball = *Surface::sphere(tilted(), 2.0, {{0, -0.5 * pi}, {2.0 * pi, 0.5 * pi}});
  EXPECT_TRUE(ball.closed_u());
  EXPECT_FALSE(ball.closed_v());
  EXPECT_TRUE(ball.collapsed(Side::Bottom));
  EXPECT_TRUE(ball.collapsed(Side::Top));
  EXPECT_FALSE(ball.collapsed(Side::Left));
  EXPECT_NEAR(area(ball).value, 16.0 * pi, 1e-8);
  const Surface ring = *Surface::torus(tilted(), 3.0, 1.0, {{1, 2}, {1 + 2.0 * pi, 2 + 2.0 * pi}});
  EXPECT_TRUE(ring.closed_u());
  EXPECT_TRUE(ring.closed_v());
  EXPECT_NEAR(area(ring).value, 12.0 * pi * pi, 1e-8);
  const double apex = -2.0 / std::sin(0.4);
  const Surface cone = *Surface::cone(tilted(), 2.0, 0.4, {{0, apex}, {2.0 * pi, 0.0}});
  EXPECT_TRUE(cone.collapsed(Side::Bottom));
  EXPECT_NEAR(area(cone).value, pi * 2.0 * -apex, 1e-8);  // pi r times the slant
  // A hair before the apex nothing has collapsed.
  EXPECT_FALSE(Surface::cone(tilted(), 2.0, 0.4, {{0, apex + 1e-6}, {2.0 * pi, 0.0}})->collapsed(Side::Bottom));
  const Surface open = *Surface::cylinder(tilted(), 1.0, {{0, 0}, {2.0 * pi - 1e-6, 1}});
  EXPECT_FALSE(open.closed_u());
}

TEST(Surface, OtherKnotsForTheSameSurfaceChangeNothing) {
  // The parabola z = u^2 in degree 2 and raised to degree 3 with a knot put in.
  const Curve low = *Curve::bezier({{0, 0, 0}, {0.5, 0, 0}, {1, 0, 1}});
  const Curve high =
      *Curve::nurbs(3, {0, 0, 0, 0, 0.5, 1, 1, 1, 1},
                    {{0, 0, 0}, {1.0 / 6.0, 0, 0}, {0.5, 0, 1.0 / 6.0}, {5.0 / 6.0, 0, 2.0 / 3.0}, {1, 0, 1}});
  for (double t = 0.0; t <= 1.0; t += 1.0 / 32.0) EXPECT_LE(geom::distance(low.at(t), high.at(t)), 1e-15) << t;
  EXPECT_NEAR(low.length(0, 1), (2.0 * std::sqrt(5.0) + std::asinh(2.0)) / 4.0, 1e-13);
  EXPECT_NEAR(high.length(0, 1), low.length(0, 1), 1e-13);
}

TEST(Surface, ThroughAGridPassesEveryPoint) {
  std::vector<Point3> grid;
  std::mt19937 random(4);
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 31; ++j)
      grid.push_back(
          {i + static_cast<double>(random() % 100) / 500.0, 3.0 * j, static_cast<double>(random() % 100) / 20.0});
  }
  const Surface surface = *Surface::through(grid, 20, 31);
  // Points of the grid are met by the closest of a fine walk of the chart, refined by Newton's rule.
  for (const std::size_t k : {std::size_t{0}, std::size_t{30}, std::size_t{17 + 31 * 9}, grid.size() - 1}) {
    Point at{};
    double least = 1e300;
    for (int i = 0; i <= 200; ++i) {
      for (int j = 0; j <= 300; ++j) {
        const Point uv{i / 200.0, j / 300.0};
        const double away = geom::distance(surface.at(uv), grid[k]);
        if (away < least) least = away, at = uv;
      }
    }
    for (int i = 0; i < 20; ++i) {
      const Jet jet = surface.jet(at);
      const Metric m = metric(jet);
      const double a = dot(grid[k] - jet.at, jet.u), b = dot(grid[k] - jet.at, jet.v), d = m.e * m.g - m.f * m.f;
      at = {at.x + (m.g * a - m.f * b) / d, at.y + (m.e * b - m.f * a) / d};
      at = {std::clamp(at.x, 0.0, 1.0), std::clamp(at.y, 0.0, 1.0)};
    }
    EXPECT_LE(geom::distance(surface.at(at), grid[k]), 1e-9) << k;
  }
}

TEST(Surface, LengthsOfTheChart) {
  const Surface pipe = *Surface::cylinder(tilted(), 3.0, {{0, 0}, {2, 8}});
  EXPECT_NEAR(length(pipe, {0, 0}, {2, 8}), 10.0, 1e-11);  // a helix: 6 round, 8 along
  const Surface kinked =
      *Surface::extruded(*Curve::nurbs(1, {0, 0, 1, 2, 2}, {{0, 0, 0}, {3, 0, 4}, {3, 0, 10}}), {0, 1, 0});
  EXPECT_NEAR(length(kinked, {0, 0.5}, {2, 0.5}), 11.0, 1e-13);
  EXPECT_NEAR(area(kinked).value, 11.0, 1e-12);
}

TEST(Surface, WhatCannotBeIsSaidWithItsNumber) {
  const Frame frame = tilted();
  const Box chart{{0, 0}, {1, 1}};
  const auto said = [](const auto& result) { return result.ok() ? std::string("fine") : result.error().message; };
  const auto has = [](const std::string& text, const char* words) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
  };
  const double nan = std::nan("");
  has(said(Surface::cylinder(frame, -1.0, chart)), "the radius of the cylinder is -1; it must be above 0");
  has(said(Surface::cylinder(frame, nan, chart)), "not finite");
  has(said(Surface::cylinder(frame, 1.0, {{0, 0}, {7, 1}})), "a full turn");
  has(said(Surface::cylinder(frame, 1.0, {{1, 0}, {1, 1}})), "empty");
  has(said(Surface::cylinder(frame, 1.0, {{0, 0}, {nan, 1}})), "not finite");
  has(said(Surface::cylinder({{}, {1, 0, 0}, {0.6, 0.8, 0}, {0, 0, 1}}, 1.0, chart)), "right angles");
  has(said(Surface::cone(frame, 2.0, 0.4, {{0, -9}, {1, 0}})), "apex");
  has(said(Surface::sphere(frame, 2.0, {{0, -2}, {1, 0}})), "latitudes");
  has(said(Surface::torus(frame, 1.0, 2.0, chart)), "cross itself");
  has(said(Surface::plane({{}, {1, 0, 0}, {-2, 0, 0}, {}}, chart)), "parallel");
  has(said(Surface::extruded(quarter(1.0), {})), "no length");
  has(said(Surface::graph("sqrt(x - 0.5)", chart)), "no value at x = 0");
  has(said(Surface::graph("x +* y", chart)), "x +* y");
  has(said(Surface::coons(cubic(4, 4, true, 0), cubic(0, 0, true, 10), cubic(0, 0, false, 0.25),
                          cubic(0, 0, false, 10))),
      "a gap of 0.25 m where bottom and left begin");
  const std::vector<Point3> four{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}};
  const auto patch = [&](std::vector<double> knots, std::vector<double> weights = {}) {
    return Surface::nurbs(1, std::move(knots), 1, {0, 0, 1, 1}, four, std::move(weights));
  };
  EXPECT_TRUE(patch({0, 0, 1, 1}).ok());
  has(said(patch({0, 0, 1, 0.5})), "knots_u: knot 4 (0.5) is below the one before it (1)");
  has(said(patch({0, 0, 1})), "knots_u: 3 knots, but degree 1 needs 4");
  has(said(patch({0, 0, 0, 1})), "more than 2 times");
  has(said(patch({0, 1, 1, 1, 2})), "more than 2 times");
  has(said(patch({0, 0, nan, 1})), "knot 3 is not finite");
  has(said(patch({0, 0, 0.5, 1, 1})), "4 control points, but degree and knots ask for 6");
  has(said(patch({0, 0, 1, 1}, {1, 1, 0, 1})), "weight 3 is 0");
  has(said(patch({0, 0, 1, 1}, {1, 1})), "2 weights for 4");
  has(said(Surface::through(four, 1, 4)), "two by two");
  has(said(Surface::through(four, 3, 2)), "4 points for a grid of 3 x 2");
  has(said(Surface::through({{0, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 1, 0}}, 2, 2)), "one point each");
  has(said(Curve::arc({}, {1, 0, 0}, {0, 2, 0}, 0, 1)), "right angle");
  has(said(Curve::line({1, 2, 3}, {1, 2, 3})), "same point");
}

/// A basis of any degree and knots, some of them equal: the functions are a partition of one, and reproduce straight
/// lines from Greville's places.
TEST(SplineBasis, IsAPartitionOfOneAndHasLinearPrecision) {
  std::mt19937 random(12);
  for (int tries = 0; tries < 300; ++tries) {
    const std::size_t degree = 1 + random() % 6;
    std::vector<double> knots;
    double at = 0.0;
    for (std::size_t i = 0; i < 2 * (degree + 1) + random() % 6; ++i) {
      knots.push_back(at);
      if (random() % 3 != 0) at += 0.1 + static_cast<double>(random() % 100) / 50.0;
    }
    const base::Result<SplineBasis> basis = SplineBasis::make(degree, knots, "knots");
    if (!basis) continue;
    for (int i = 0; i <= 50; ++i) {
      const double t = basis->low() + (basis->high() - basis->low()) * i / 50.0;
      const SplineBasis::Values values = basis->at(t);
      double one = 0.0, line = 0.0, slope = 0.0, none = 0.0;
      for (std::size_t j = 0; j <= degree; ++j) {
        double greville = 0.0;
        for (std::size_t k = 1; k <= degree; ++k) greville += knots[values.first + j + k] / static_cast<double>(degree);
        one += values.of[0][j];
        none += values.of[1][j];
        line += values.of[0][j] * greville;
        slope += values.of[1][j] * greville;
      }
      EXPECT_NEAR(one, 1.0, 1e-13);
      EXPECT_NEAR(none, 0.0, 1e-10);
      EXPECT_NEAR(line, t, 1e-12 * std::max(1.0, at));
      EXPECT_NEAR(slope, 1.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace dobra::surf
