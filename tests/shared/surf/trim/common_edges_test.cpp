// Common curves of surfaces as edges in both charts: against closed forms, across seams, through poles.

#include "shared/surf/trim/common_edges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/shared/surf/surface_shapes.h"

namespace dobra::surf::trim {
namespace {

using geom::Point;
using geom::Point3;
using geom::Vector3;
using namespace surf::test;

Point3 in_space(const Surface& surface, const Curve& curve, double t) {
  const Point3 p = curve.at(t);
  return surface.at({p.x, p.y});
}

/// How far both surfaces and the curve in space are apart at most, of the size, at places that are no points of a
/// chain; derivatives against differences.
double apart(const Surface& a, const Surface& b, const CommonEdge& edge) {
  constexpr int places = 149;
  const double size = std::min(a.size(), b.size()), last = edge.first.to;
  double worst = 0.0;
  for (int i = 0; i <= places; ++i) {
    const double t = last * i / places;
    const Point3 p = in_space(a, edge.first.curve, t), q = in_space(b, edge.second.curve, t), r = edge.in_space.at(t);
    worst = std::max({worst, geom::distance(p, q) / size, geom::distance(p, r) / size});
  }
  return worst;
}

void check_derivatives(const Curve& curve, const std::string& name) {
  const double range = curve.high() - curve.low(), h = 1e-4 * range;
  for (int i = 1; i < 60; ++i) {
    const double t = curve.low() + range * i / 60.0;
    const Curve::Jet jet = curve.jet(t), before = curve.jet(t - h), after = curve.jet(t + h);
    const Vector3 first = (after.at - before.at) / (2.0 * h), second = (after.first - before.first) / (2.0 * h);
    EXPECT_LE(geom::length(first - jet.first), 1e-5 * (1.0 + geom::length(jet.first))) << name << " at " << t;
    EXPECT_LE(geom::length(second - jet.second), 1e-3 * (1.0 + geom::length(jet.second))) << name << " at " << t;
  }
}

TEST(CommonEdges, OfPipesLieOnBothBetweenThePointsOfTheChainToo) {
  const Surface wide = *Surface::cylinder({{0, 0, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 2.0, {{0, 0}, {2 * pi, 8}});
  const Surface narrow = *Surface::cylinder({{-4, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, 1.0, {{0, 0}, {2 * pi, 8}});
  const auto edges = common_edges(wide, narrow, {.name = "joint", .number = 5});
  ASSERT_TRUE(edges.ok()) << edges.error().message;
  ASSERT_GE(edges->size(), 2U);
  double total = 0.0;
  SharedCurveId number = 5;
  for (const CommonEdge& edge : *edges) {
    EXPECT_LE(apart(wide, narrow, edge), 1e-12);
    EXPECT_EQ(edge.first.shared, number);
    EXPECT_EQ(edge.second.shared, number++);
    EXPECT_EQ(edge.first.name, "joint");
    for (int i = 0; i <= 200; ++i) {
      const Point3 p = edge.in_space.at(edge.first.to * i / 200.0);
      EXPECT_NEAR(std::hypot(p.x, p.y), 2.0, 1e-12);
      EXPECT_NEAR(std::hypot(p.y, p.z), 1.0, 1e-12);
    }
    check_derivatives(edge.first.curve, "first");
    check_derivatives(edge.second.curve, "second");
    check_derivatives(edge.in_space, "in space");
    total += edge.in_space.length(0.0, edge.first.to);
  }
  // y = sin a, z = cos a, x = +-sqrt(4 - sin^2 a): the length by the trapezium rule, which converges at once here.
  double length = 0.0;
  for (int i = 0; i < 4096; ++i) {
    const double a = 2 * pi * i / 4096, s = std::sin(a), c = std::cos(a), x = std::sqrt(4 - s * s);
    length += std::hypot(1.0, s * c / x) * 2 * pi / 4096;
  }
  EXPECT_NEAR(total, 2 * length, 1e-8);
}

TEST(CommonEdges, OfASphereAndAPlaneAreCutAtTheSeamAndEndThereExactly) {
  const Surface ball = *Surface::sphere({}, 5.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  const auto edges = plane_edges(ball, {0, 0, 1}, {0.2, 0.1, 1.0});
  ASSERT_TRUE(edges.ok()) << edges.error().message;
  ASSERT_EQ(edges->size(), 1U);
  const Point from = edges->front().start(), to = edges->front().end();
  EXPECT_EQ(std::min(from.x, to.x), 0.0);
  EXPECT_EQ(std::max(from.x, to.x), 2 * pi);
  EXPECT_NEAR(from.y, to.y, 1e-14);
  const auto side = plane_edges(ball, {4, 0, 0}, {1, 0.1, 0.3});  // round the place where the seam is
  ASSERT_TRUE(side.ok()) << side.error().message;
  ASSERT_EQ(side->size(), 2U);
  const Vector3 n = geom::normalised(Vector3{1, 0.1, 0.3});
  for (const ChartEdge& edge : *side) {
    EXPECT_TRUE(edge.start().x == 0.0 || edge.start().x == 2 * pi);
    EXPECT_EQ(edge.end().x, edge.start().x);
    for (int i = 0; i <= 100; ++i)
      EXPECT_NEAR(dot(in_space(ball, edge.curve, edge.to * i / 100.0) - Point3{4, 0, 0}, n), 0.0, 1e-12);
  }
}

TEST(CommonEdges, ThroughThePolesEndInThem) {
  const Surface ball = *Surface::sphere({}, 2.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  const auto edges = plane_edges(ball, {0, 0, 0}, {1, 0.3, 0});
  ASSERT_TRUE(edges.ok()) << edges.error().message;
  ASSERT_EQ(edges->size(), 2U);
  for (const ChartEdge& edge : *edges) {
    EXPECT_EQ(std::abs(edge.start().y), 0.5 * pi);
    EXPECT_EQ(std::abs(edge.end().y), 0.5 * pi);
    for (int i = 1; i < 100; ++i) {
      const Point p = edge.at(edge.to * i / 100.0);
      EXPECT_NEAR(std::cos(p.x) + 0.3 * std::sin(p.x), 0.0, 1e-9) << p.y;
    }
  }
}

TEST(CommonEdges, AlongTheSeamStayOnItExactly) {
  const Surface ball = *Surface::sphere({}, 2.0, {{0, -1.2}, {2 * pi, 1.2}});
  const auto edges = plane_edges(ball, {0, 0, 0}, {0, 1, 0});
  ASSERT_TRUE(edges.ok()) << edges.error().message;
  int on_seam = 0;
  for (const ChartEdge& edge : *edges) {
    if (edge.at(0.5 * edge.to).x > 1 && edge.at(0.5 * edge.to).x < 6) continue;
    ++on_seam;
    for (int i = 0; i <= 50; ++i) {
      const double u = edge.at(edge.to * i / 50.0).x;
      EXPECT_TRUE(u == 0.0 || u == 2 * pi) << u;
    }
  }
  EXPECT_GE(on_seam, 1);
}

TEST(CommonEdges, HaveCornersOnlyAtTheirEnds) {
  const Surface roof = *Surface::nurbs(1, {0, 0, 1, 2, 2}, 1, {0, 0, 1, 1},
                                       {{0, 0, 0}, {0, 8, 0}, {5, 0, 3}, {5, 8, 3}, {10, 0, 0}, {10, 8, 0}});
  const auto edges = plane_edges(roof, {0, 3, 0}, {0.1, 1, 0});
  ASSERT_TRUE(edges.ok()) << edges.error().message;
  ASSERT_EQ(edges->size(), 2U);
  for (const ChartEdge& edge : *edges) check_derivatives(edge.curve, "roof");
}

TEST(CommonEdges, OfManyPairsAreOnBothToATenthOfABillionth) {
  Chance chance{std::mt19937(11)};
  int pieces = 0;
  const std::vector<Named> all = all_kinds();
  for (int round = 0; round < 24; ++round) {
    const Surface& a = all[chance.random() % all.size()].surface;
    const Point3 middle = a.at(chance.of(a.chart()));
    const Vector3 z = geom::normalised(Vector3{chance(-1, 1), chance(-1, 1), chance(0.2, 1)});
    const Vector3 x = geom::normalised(cross(Vector3{chance(-1, 1), 1, 0.3}, z));
    const double r = a.size() * chance(0.1, 0.4);
    const Frame frame{middle + r * x, x, cross(z, x), z};
    const Surface b = round % 2 ? *Surface::cylinder(frame, r, {{0, -r}, {2 * pi, r}})
                                : *Surface::torus(frame, r, 0.4 * r, {{0, 0}, {2 * pi, 2 * pi}});
    const auto edges = common_edges(a, b);
    ASSERT_TRUE(edges.ok()) << round << edges.error().message;
    for (const CommonEdge& edge : *edges) {
      EXPECT_LE(apart(a, b, edge), 1e-10) << round;
      ++pieces;
    }
  }
  EXPECT_GT(pieces, 24);
}

// A plane through the pole of a ball, with the normal (a cos m, a sin m, c): at the angle q from the pole the longitude
// u has cos(u - m) = c / a tan(q / 2). With m of a right angle the curve comes to the pole along the seam.
TEST(CommonEdges, ThroughAPoleAreSmoothUpToIt) {
  const double r = 5.0;
  const Surface ball = *Surface::sphere({}, r, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  for (const double pole : {1.0, -1.0}) {
    for (int k = 0; k < 12; ++k) {
      const double m = k * pi / 6;
      for (const double steep : {1.0, 0.3}) {
        const Vector3 normal{std::cos(m), std::sin(m), pole * steep};
        const std::string what = std::to_string(k) + " by " + std::to_string(pole * steep);
        const auto edges = plane_edges(ball, {0, 0, pole * r}, normal);
        ASSERT_TRUE(edges.ok()) << what << edges.error().message;
        double length = 0.0;
        int in_pole = 0;
        for (const ChartEdge& edge : *edges) {
          EXPECT_LE(edge.curve.bend(edge.from, edge.to), 50.0) << what;
          length += edge.to - edge.from;
          in_pole += ball.in_pole(edge.start()) ? 1 : 0;
          in_pole += ball.in_pole(edge.end()) ? 1 : 0;
          for (const bool from_end : {false, true}) {
            for (const double by : {0.0, 1e-9, 1e-7, 1e-5, 1e-3, 0.01, 0.03, 0.3}) {
              const double t = std::lerp(edge.from, edge.to, from_end ? 1.0 - by : by);
              const Point uv = edge.at(t);
              const double q = 0.5 * pi - pole * uv.y;
              EXPECT_NEAR(std::cos(uv.x - m), steep * std::tan(0.5 * q), 1e-7) << what << " at " << t;
              const Curve::Jet jet = edge.curve.jet(t);
              EXPECT_LE(std::abs(jet.second.x) + std::abs(jet.second.y), 50.0) << what << " at " << t;
            }
          }
        }
        EXPECT_EQ(in_pole, 2) << what;
        const double round = 2 * pi * r / std::sqrt(1.0 + steep * steep);
        EXPECT_NEAR(length, round, 1e-3 * round) << what;  // by the chords of the chain
      }
    }
  }
}

TEST(CommonEdges, OfPipesThatTouchWhereTheyCrossAreOnBothOrRefused) {
  const Surface one = *Surface::cylinder({{0, 0, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 2.0, {{0, 0}, {2 * pi, 8}});
  const Surface other = *Surface::cylinder({{-4, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, 2.0, {{0, 0}, {2 * pi, 8}});
  const auto edges = common_edges(one, other);
  if (!edges.ok()) {
    ASSERT_TRUE(edges.error().place.has_value());
    EXPECT_TRUE(edges.error().place->z.has_value());
    return;
  }
  for (const CommonEdge& edge : *edges) EXPECT_LE(apart(one, other, edge), 1e-10);
}

TEST(ChartCurves, AnEllipseHasItsPointsAndASplinePassesItsOwn) {
  const Curve ellipse = *Curve::ellipse({0.5, 0.5, 0}, {0.3, 0, 0}, {0, 0.2, 0}, 0, 2 * pi);
  for (int i = 0; i <= 40; ++i) {
    const Point3 p = ellipse.at(2 * pi * i / 40.0);
    EXPECT_NEAR(std::pow((p.x - 0.5) / 0.3, 2) + std::pow((p.y - 0.5) / 0.2, 2), 1.0, 1e-14);
    EXPECT_LE(geom::length(ellipse.jet(0.15 * i).second), ellipse.bend(0, 1) * (1 + 1e-12));
  }
  EXPECT_FALSE(Curve::ellipse({}, {1, 0, 0}, {2, 0, 0}, 0, 1).ok());
  const std::vector<Point3> points{{0, 0, 0}, {1, 0.5, 0}, {2, 0, 0}, {2.5, -1, 0}, {4, 0, 0}};
  const Curve spline = *Curve::through(points);
  double t = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) t += geom::distance(points[i - 1], points[i]);
    EXPECT_LE(geom::distance(spline.at(t), points[i]), 1e-14);
    if (i == 0 || i + 1 == points.size()) continue;
    const Curve::Jet left = spline.jet(std::nextafter(t, 0.0)), right = spline.jet(t);
    EXPECT_LE(geom::length(left.first - right.first), 1e-12);
    EXPECT_LE(geom::length(left.second - right.second), 1e-12);
  }
  // A cubic is given back by its points, whatever their spacing, where the parameter is the length of chords: on a
  // line.
  const Curve line = *Curve::through({{0, 0, 0}, {0.1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  for (const double at : {0.05, 1.0, 2.7}) EXPECT_NEAR(line.at(at).x, at, 1e-14);
}

TEST(ChartCurves, AClosedSplineIsSmoothAllRound) {
  std::vector<Point3> points;
  for (int i = 0; i < 24; ++i) points.push_back({std::cos(pi * i / 12), std::sin(pi * i / 12), 0});
  points.push_back(points.front());
  const Curve ring = *Curve::through(points);
  const Curve::Jet first = ring.jet(ring.low()), last = ring.jet(ring.high());
  EXPECT_LE(geom::length(first.first - last.first), 1e-12);
  EXPECT_LE(geom::length(first.second - last.second), 1e-11);
  for (int i = 0; i < 100; ++i) {
    const Point3 p = ring.at(ring.high() * i / 100);
    EXPECT_NEAR(std::hypot(p.x, p.y), 1.0, 2e-5);
  }
}

TEST(ChartCurves, OfPointsInOnePlaceAreRefusedWithTheirNumber) {
  const auto twice = Curve::through({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}});
  ASSERT_FALSE(twice.ok());
  EXPECT_NE(twice.error().message.find("2 and 3"), std::string::npos);
  EXPECT_FALSE(Curve::polyline({{0, 0, 0}}).ok());
}

}  // namespace
}  // namespace dobra::surf::trim
