// Curves and surfaces made of others: moved, over another range, offset, with other ends.
#include <gtest/gtest.h>

#include <cmath>

#include "shared/surf/measure.h"
#include "tests/shared/surf/surface_shapes.h"

namespace dobra::surf {
namespace {

using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;
using test::pi;

/// Derivatives against differences of the points, and second ones against differences of the first.
void expect_own_derivatives(const Curve& curve, double t, const std::string& name, double close = 1e-6) {
  const double h = 1e-5 * (curve.high() - curve.low());
  const Curve::Jet at = curve.jet(t), before = curve.jet(t - h), after = curve.jet(t + h);
  const Vector3 first = (after.at - before.at) / (2.0 * h), second = (after.first - before.first) / (2.0 * h);
  EXPECT_LE(geom::length(first - at.first), close * geom::length(at.first)) << name << " at " << t;
  EXPECT_LE(geom::length(second - at.second), 1e-5 * (geom::length(at.second) + geom::length(at.first)))
      << name << " at " << t;
  EXPECT_LE(geom::length(at.second), curve.bend(curve.low(), curve.high()) * (1.0 + 1e-6)) << name << " at " << t;
}

std::vector<std::pair<std::string, Curve>> derived_curves() {
  const Curve wave =
      *Curve::nurbs(3, {0, 0, 0, 0, 0.5, 1, 1, 1, 1}, {{0, 0, 0}, {1, 2, 0}, {2, -1, 1}, {3, 1, 0}, {4, 0, 0}});
  const Curve ellipse = *Curve::conic(Curve::Conic::Ellipse, {1, 2, 3}, {2, 0, 0}, {0, 1, 1}, 0.3, 5.0);
  return {{"line", *Curve::line({1, 2, 3}, Vector3{1, -1, 2}, -3, 4)},
          {"ellipse", ellipse},
          {"hyperbola", *Curve::conic(Curve::Conic::Hyperbola, {1, 2, 0}, {2, 0, 0}, {0, 1, 0}, -1.5, 1.0)},
          {"parabola", *Curve::conic(Curve::Conic::Parabola, {1, 2, 0}, {0.5, 0, 0}, {0, 1, 0}, -2, 1)},
          {"moved", wave.moved({0, 2, 0}, {-2, 0, 0}, {0, 0, -2}, {5, 6, 7})},
          {"offset in space", *wave.offset(0.3, {0, 0.2, 1})},
          {"offset of an ellipse", *ellipse.offset(-0.2, {1, 0, 0})},
          {"with other ends", wave.reaching(0.1, {-1, 0, 0}, 0.9, {5, 5, 5})}};
}

TEST(DerivedCurve, DerivativesAreThoseOfThePoints) {
  test::Chance chance{std::mt19937(5)};
  for (const auto& [name, curve] : derived_curves()) {
    for (int i = 0; i < 20; ++i) {
      const double t = chance(curve.low() + 1e-3, curve.high() - 1e-3);
      if (std::abs(t - 0.5) > 1e-3) expect_own_derivatives(curve, t, name);
    }
  }
}

TEST(DerivedCurve, ConicsFulfilTheirEquations) {
  for (const double t : {-1.2, -0.3, 0.0, 0.8, 7.0}) {
    const Point3 e = Curve::conic(Curve::Conic::Ellipse, {}, {3, 0, 0}, {0, 2, 0}, -2, 8)->at(t);
    EXPECT_NEAR(e.x * e.x / 9 + e.y * e.y / 4, 1.0, 1e-14);
    const Point3 p = Curve::conic(Curve::Conic::Parabola, {}, {0.25 / 2, 0, 0}, {0, 1, 0}, -2, 8)->at(t);
    EXPECT_NEAR(p.y * p.y, 8.0 * p.x, 1e-13);  // y^2 = 4 f x with f = 2
    if (t > 2.0) continue;
    const Point3 h = Curve::conic(Curve::Conic::Hyperbola, {}, {3, 0, 0}, {0, 2, 0}, -2, 8)->at(t);
    EXPECT_NEAR(h.x * h.x / 9 - h.y * h.y / 4, 1.0, 1e-13);
  }
}

TEST(DerivedCurve, AnOffsetCircleIsACircleToTheRight) {
  const Curve circle = *Curve::conic(Curve::Conic::Ellipse, {1, 1, 0}, {2, 0, 0}, {0, 2, 0}, 0, 2 * pi);
  const Curve offset = *circle.offset(0.5, {0, 0, 1});  // anticlockwise: the right is outside
  for (const double t : {0.0, 1.0, 3.0, 2 * pi}) EXPECT_NEAR(distance(offset.at(t), {1, 1, 0}), 2.5, 1e-14);
}

TEST(DerivedCurve, ClosedOnesGoRoundAndOpenOnesGoOn) {
  const double w = std::sqrt(0.5);
  const Curve circle = *Curve::nurbs(
      2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
      {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {1, 0, 0}},
      {1, w, 1, w, 1, w, 1, w, 1});
  const Curve later = *circle.over(3.25, 6.5);
  EXPECT_EQ(later.breaks(), (std::vector<double>{3.25, 4, 5, 6, 6.5}));
  for (const double t : {3.25, 3.9, 4.0, 4.3, 6.5})
    EXPECT_LT(distance(later.at(t), circle.at(std::fmod(t, 4.0))), 1e-14) << t;
  EXPECT_LT(geom::length(circle.over(2, 4)->jet(4).first - circle.jet(4).first), 1e-14);
  const Curve open = *Curve::bezier({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}});
  EXPECT_LT(distance(open.over(-0.5, 1.5)->at(1.5), {3, -1.5, 0}), 1e-14);  // x = 2 t, y = 2 t (1 - t)
}

TEST(DerivedCurve, EndsAreReachedExactlyAndBothWays) {
  const Curve wave = *Curve::bezier({{0, 0, 0}, {1, 2, 0}, {3, 0, 0}});
  const Curve made = wave.reaching(0.2, {0.41, 0.63, 0.0}, 0.7, {0.1, 0.2, 0.3});
  EXPECT_EQ(made.at(0.2), (Point3{0.41, 0.63, 0.0}));
  EXPECT_EQ(made.at(0.7), (Point3{0.1, 0.2, 0.3}));
  EXPECT_EQ(made.low(), 0.2);
}

TEST(DerivedCurve, WhatLeavesTheBoxRunsAlongItsBorder) {
  const Curve held = Curve::line({-1, 0.5, 0}, Vector3{1, 0.1, 0}, 0, 3)->held({0, 0}, {1, 0.6});
  EXPECT_EQ(held.at(0.5), (Point3{0.0, 0.55, 0.0}));
  EXPECT_EQ(held.jet(0.5).first, (Vector3{0.0, 0.1, 0.0}));
  EXPECT_EQ(held.at(2.5), (Point3{1.0, 0.6, 0.0}));
}

TEST(DerivedCurve, WhatCannotBeIsRefused) {
  EXPECT_FALSE(Curve::line({0, 0, 0}, Vector3{}, 0, 1).ok());
  EXPECT_FALSE(Curve::line({0, 0, 0}, Vector3{1, 0, 0}, 1, 1).ok());
  EXPECT_FALSE(Curve::conic(Curve::Conic::Ellipse, {}, {1, 0, 0}, {2, 0, 0}, 0, 1).ok());
  const Curve along_z = *Curve::line({0, 0, 0}, Vector3{0, 0, 1}, 0, 1);
  EXPECT_FALSE(along_z.offset(1.0, {0, 0, 1}).ok());
  EXPECT_FALSE(along_z.over(0.0, std::nan("")).ok());
}

void expect_own_derivatives(const Surface& surface, Point uv, const std::string& name, double close) {
  const double hu = 1e-5 * surface.chart().width(), hv = 1e-5 * surface.chart().height();
  const Jet at = surface.jet(uv);
  const Jet left = surface.jet({uv.x - hu, uv.y}), right = surface.jet({uv.x + hu, uv.y});
  const Jet below = surface.jet({uv.x, uv.y - hv}), above = surface.jet({uv.x, uv.y + hv});
  const auto near = [&](Vector3 said, Vector3 by, double size, const char* what) {
    EXPECT_LE(geom::length(said - by), close * (geom::length(by) + size)) << name << ' ' << what;
  };
  near(at.u, (right.at - left.at) / (2 * hu), 0.0, "u");
  near(at.v, (above.at - below.at) / (2 * hv), 0.0, "v");
  near(at.uu, (right.u - left.u) / (2 * hu), geom::length(at.u) / surface.chart().width(), "uu");
  near(at.uv, (above.u - below.u) / (2 * hv), geom::length(at.u) / surface.chart().height(), "uv");
  near(at.vv, (above.v - below.v) / (2 * hv), geom::length(at.v) / surface.chart().height(), "vv");
  const Bend bend = surface.bend(surface.chart());
  EXPECT_LE(geom::length(at.uu), bend.uu * (1 + 1e-6) + 1e-9) << name;
  EXPECT_LE(geom::length(at.uv), bend.uv * (1 + 1e-6) + 1e-9) << name;
  EXPECT_LE(geom::length(at.vv), bend.vv * (1 + 1e-6) + 1e-9) << name;
}

Surface wavy_patch() {
  std::vector<Point3> points;
  std::mt19937 random(11);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 5; ++j)
      points.push_back({1.0 * i, 1.0 * j, 0.4 * (static_cast<double>(random() % 1000) / 500.0 - 1.0)});
  }
  return *Surface::nurbs(3, {0, 0, 0, 0, 0.4, 0.7, 1, 1, 1, 1}, 3, {0, 0, 0, 0, 0.5, 1, 1, 1, 1}, points);
}

TEST(DerivedSurface, DerivativesAreThoseOfThePoints) {
  const Frame mirror{{1, 2, 3}, {0, -2, 0}, {-2, 0, 0}, {0, 0, 2}};
  test::Chance chance{std::mt19937(7)};
  const std::vector<std::pair<std::string, Surface>> kinds{
      {"mirrored", *wavy_patch().moved(mirror)},
      {"window", *wavy_patch().over({{0.2, 0.1}, {0.9, 0.6}})},
      {"offset", *wavy_patch().offset(0.1)},
      {"offset of a torus", *Surface::torus(test::tilted(), 3, 1, {{0, 0}, {2, 2}})->offset(0.5)},
      {"extruded over a range", *Surface::extruded(test::cubic(2, -3, true, 1), {0, 1, 2}, -3, 5)}};
  for (const auto& [name, surface] : kinds) {
    for (int i = 0; i < 20; ++i) {
      Point uv = chance.of(surface.chart());
      for (const double at : surface.breaks().u)
        uv.x += std::abs(uv.x - at) < 1e-3 ? 3e-3 * (uv.x > 0.5 ? -1 : 1) : 0.0;
      for (const double at : surface.breaks().v)
        uv.y += std::abs(uv.y - at) < 1e-3 ? 3e-3 * (uv.y > 0.5 ? -1 : 1) : 0.0;
      expect_own_derivatives(surface, uv, name, 1e-6);
    }
  }
}

TEST(DerivedSurface, AnOffsetSphereIsASphereUpToItsPoles) {
  const Surface sphere = *Surface::sphere(test::tilted(), 2.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  for (const double by : {0.7, -1.5}) {
    const Surface made = *sphere.offset(by), wanted = *Surface::sphere(test::tilted(), 2.0 + by, sphere.chart());
    EXPECT_TRUE(made.collapsed(Side::Bottom));
    EXPECT_TRUE(made.collapsed(Side::Top));
    EXPECT_TRUE(made.closed_u());
    for (const Point uv : {Point{0.1, 0.2}, Point{3.0, -1.2}, Point{2.0, 0.5 * pi}, Point{0.0, -0.5 * pi}}) {
      const Jet a = made.jet(uv), b = wanted.jet(uv);
      EXPECT_LT(distance(a.at, b.at), 1e-12) << uv;
      EXPECT_LT(geom::length(a.u - b.u) + geom::length(a.v - b.v), 1e-5) << uv;
      if (std::abs(uv.y) < 1.5) {
        EXPECT_LT(geom::length(a.u - b.u) + geom::length(a.v - b.v), 1e-12) << uv;
        EXPECT_LT(geom::length(a.uu - b.uu) + geom::length(a.uv - b.uv) + geom::length(a.vv - b.vv), 1e-7) << uv;
      }
    }
    EXPECT_NEAR(area(made).value, area(wanted).value, 1e-8);
  }
}

TEST(DerivedSurface, OffsetsBeyondARadiusOfCurvatureAreRefusedWithTheirPlace) {
  const Surface cylinder = *Surface::cylinder({}, 0.5, {{0, 0}, {1, 1}});
  EXPECT_TRUE(cylinder.offset(10.0).ok());  // outwards
  EXPECT_TRUE(cylinder.offset(-0.49).ok());
  const auto refused = cylinder.offset(-0.5);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, base::ErrorCode::DegenerateCurve);
  EXPECT_TRUE(refused.error().place && refused.error().place->u && refused.error().place->x);
}

TEST(DerivedSurface, WindowsGoRoundAClosedPatch) {
  const Curve circle = *Curve::nurbs(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                                     {{1, 0, 0},
                                      {1, std::sqrt(3.0), 0},
                                      {-0.5, 0.5 * std::sqrt(3.0), 0},
                                      {-2, 0, 0},
                                      {-0.5, -0.5 * std::sqrt(3.0), 0},
                                      {1, -std::sqrt(3.0), 0},
                                      {1, 0, 0}},
                                     {1, 0.5, 1, 0.5, 1, 0.5, 1});
  const Surface tube = *Surface::extruded(circle, {0, 0, 2});
  const Surface later = *tube.over({{2.5, 0.0}, {5.5, 1.0}}, Surface::Beyond::GoesRound);
  EXPECT_TRUE(later.closed_u());
  EXPECT_EQ(later.breaks().u, (std::vector<double>{2.5, 3, 4, 5, 5.5}));
  EXPECT_LT(distance(later.at({4.5, 0.3}), tube.at({1.5, 0.3})), 1e-14);
  EXPECT_LE(tube.bend({{0.1, 0}, {0.9, 1}}).uu, later.bend({{2.9, 0}, {3.9, 1}}).uu * (1 + 1e-12));
}

TEST(DerivedSurface, AMirrorTurnsTheNormalAgainstItsImage) {
  const Surface patch = wavy_patch();
  const Surface mirrored = *patch.moved({{}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Vector3 n = *normal(patch.jet({0.3, 0.4})), m = *normal(mirrored.jet({0.3, 0.4}));
  EXPECT_LT(geom::length(m - Vector3{n.x, -n.y, -n.z}), 1e-14);  // the image is (-x, y, z)
  EXPECT_FALSE(patch.moved({{}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}).ok());
}

}  // namespace
}  // namespace dobra::surf
