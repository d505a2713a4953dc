// Charts without poles: the surface is the same, its derivatives agree with differences through the pole, and the area
// in space of what is meant is that of closed forms.

#include "shared/surf/trim/open.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "shared/surf/measure.h"
#include "shared/surf/trim/chart_curves.h"
#include "shared/surf/trim/mend.h"
#include "tests/shared/surf/surface_shapes.h"
#include "tests/shared/surf/trim/chart_checks.h"

namespace dobra::surf::trim {
namespace {

using geom::Point;
using geom::Point3;
using geom::Vector3;
using namespace surf::test;

/// Area in space: the area of the metric along many lines of the chart, between the loops.
double area_in_space(const TrimmedSurface& face, int n = 400) {
  geom::Box box;
  for (const ChartLoop& loop : face.loops) {
    for (const ChartEdge& edge : loop.edges) {
      for (int i = 0; i <= 40; ++i) box.add(edge.at(std::lerp(edge.from, edge.to, i / 40.0)));
    }
  }
  double sum = 0.0;
  std::vector<std::vector<Point>> rings;
  for (const ChartLoop& loop : face.loops) {
    rings.emplace_back();
    for (const ChartEdge& edge : loop.edges) {
      for (int i = 0; i < 400; ++i) rings.back().push_back(edge.at(std::lerp(edge.from, edge.to, i / 400.0)));
    }
  }
  for (int k = 0; k < n; ++k) {
    const double v = std::lerp(box.low.y, box.high.y, (k + 0.5) / n), height = box.height() / n;
    std::vector<double> at;
    for (const auto& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point p = ring[i], q = ring[(i + 1) % ring.size()];
        if ((p.y <= v) != (q.y <= v)) at.push_back(p.x + (v - p.y) / (q.y - p.y) * (q.x - p.x));
      }
    }
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      const int parts = 1 + static_cast<int>((at[i + 1] - at[i]) / box.width() * n);
      for (int j = 0; j < parts; ++j) {
        const double u = std::lerp(at[i], at[i + 1], (j + 0.5) / parts);
        sum += metric(face.surface.jet({u, v})).area() * height * (at[i + 1] - at[i]) / parts;
      }
    }
  }
  return sum;
}

void check_derivatives(const Surface& surface, Point p, double h, double tolerance) {
  const Jet jet = surface.jet(p);
  const Vector3 u = (surface.at({p.x + h, p.y}) - surface.at({p.x - h, p.y})) / (2 * h);
  const Vector3 v = (surface.at({p.x, p.y + h}) - surface.at({p.x, p.y - h})) / (2 * h);
  EXPECT_LE(geom::length(jet.u - u), tolerance) << p;
  EXPECT_LE(geom::length(jet.v - v), tolerance) << p;
  const auto second = [&](geom::Vector a, geom::Vector b) {
    const auto at = [&](double s, double t) { return surface.at(p + s * h * a + t * h * b); };
    return ((at(1, 1) - at(1, -1)) - (at(-1, 1) - at(-1, -1))) / (4 * h * h);
  };
  EXPECT_LE(geom::length(jet.uv - second({1, 0}, {0, 1})), 10 * tolerance) << p;
  EXPECT_LE(geom::length(jet.uu - second({1, 0}, {1, 0})), 10 * tolerance) << p;
  EXPECT_LE(geom::length(jet.vv - second({0, 1}, {0, 1})), 10 * tolerance) << p;
}

TEST(PolarChart, OfASphereIsSmoothThroughThePoleAndTurnsAsBefore) {
  const Surface ball = *Surface::sphere(tilted(), 5.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  for (const Side side : {Side::Bottom, Side::Top}) {
    const auto polar = polar_chart(ball, side, 0.5);
    ASSERT_TRUE(polar.ok());
    EXPECT_NEAR(polar->angle, 2 * pi, 1e-12);
    EXPECT_NEAR(polar->radius, 2.5 * pi, 1e-9);
    for (const Point p : {Point{0, 0}, {1e-7, -2e-7}, {1e-3, 1e-3}, {1, 2}, {-3, 0.5}, {-2, -1e-9}})
      check_derivatives(polar->surface, p, 2e-3, 2e-6);
    for (const Point p : {Point{1, 2}, {-2, 1}, {0.1, -3}}) {
      EXPECT_LE(geom::distance(polar->surface.at(p), ball.at(polar->back(p))), 1e-12);
      EXPECT_LE(geom::distance(polar->forward(polar->back(p)), p), 1e-12);
      const Vector3 now = *normal(polar->surface.jet(p)), before = *normal(ball.jet(polar->back(p)));
      EXPECT_NEAR(dot(now, before), 1.0, 1e-9);
    }
    EXPECT_FALSE(polar->surface.closed_u() || polar->surface.closed_v());
    for (const Side each : {Side::Left, Side::Right, Side::Bottom, Side::Top})
      EXPECT_FALSE(polar->surface.collapsed(each));
  }
}

TEST(PolarChart, OfAPartOfATurnIsASectorOfTheTrueAngle) {
  const Surface patch = *Surface::sphere({}, 2.0, {{0.3, 0}, {1.5, 0.5 * pi}});
  const auto polar = polar_chart(patch, Side::Top);
  ASSERT_TRUE(polar.ok());
  EXPECT_NEAR(polar->angle, 1.2, 1e-9);
  const Surface cone = *Surface::cone({}, 0.0, 0.5, {{0, 0}, {2.0, 3}});
  const auto apex = polar_chart(cone, Side::Bottom);
  ASSERT_TRUE(apex.ok());
  EXPECT_NEAR(apex->angle, 2.0 * std::sin(0.5), 1e-4);
  // A sector of a cone rolled out: lengths and angles are those of the plane.
  for (const Point p : {Point{1, 0.1}, {2, -0.3}, {0.5, 0}}) {
    const Metric m = metric(apex->surface.jet(p));
    EXPECT_NEAR(m.e, 1.0, 1e-4);
    EXPECT_NEAR(m.g, 1.0, 1e-4);
    EXPECT_NEAR(m.f, 0.0, 1e-4);
  }
}

TEST(PolarChart, MapsCurvesWithTheirDerivatives) {
  const Surface ball = *Surface::sphere({}, 2.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  const PolarChart polar = *polar_chart(ball, Side::Top, 0.5);
  const Curve before = *Curve::ellipse({3, 0.8, 0}, {1, 0.2, 0}, {0, 0.4, 0}, 0, 2 * pi), after = polar.mapped(before);
  for (int i = 1; i < 30; ++i) {
    const double t = 0.2 * i, h = 1e-4;
    const Point3 p = after.at(t), q = before.at(t);
    EXPECT_LE(geom::distance(polar.surface.at({p.x, p.y}), ball.at({q.x, q.y})), 1e-12);
    const Curve::Jet jet = after.jet(t), low = after.jet(t - h), high = after.jet(t + h);
    EXPECT_LE(geom::length(jet.first - (high.at - low.at) / (2 * h)), 1e-6);
    EXPECT_LE(geom::length(jet.second - (high.first - low.first) / (2 * h)), 1e-6);
    EXPECT_LE(geom::length(jet.second), after.bend(0, 2 * pi));
  }
}

TEST(Open, AFullSphereIsTwoDisksWithOneBorder) {
  const Surface ball = *Surface::sphere({}, 5.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  const auto whole = recognise(ball, {});
  ASSERT_TRUE(whole.ok());
  ASSERT_EQ(whole->faces().size(), 1U);
  SharedNumbers numbers(50);
  const auto halves = open(whole->faces()[0], numbers);
  ASSERT_TRUE(halves.ok()) << halves.error().message;
  ASSERT_EQ(halves->size(), 2U);
  double area = 0.0;
  for (const Opened& half : *halves) {
    EXPECT_TRUE(half.polar);
    ASSERT_EQ(half.face.loops.size(), 1U);
    ASSERT_EQ(half.face.loops[0].edges.size(), 1U);
    EXPECT_GT(loop_area(half.face.loops[0]), 0.0);
    EXPECT_EQ(half.face.loops[0].edges[0].name, artificial_border);
    check_loops(half.face);
    area += area_in_space(half.face);
  }
  EXPECT_NEAR(area, 4 * pi * 25, 0.3);
  const ChartEdge &a = (*halves)[0].face.loops[0].edges[0], &b = (*halves)[1].face.loops[0].edges[0];
  ASSERT_TRUE(a.shared.has_value());
  EXPECT_EQ(a.shared, b.shared);
  EXPECT_NE(a.against, b.against);
  for (int i = 0; i <= 20; ++i) {
    const Point3 p = (*halves)[0].face.surface.at(a.at(std::lerp(a.from, a.to, i / 20.0)));
    const Point3 q = (*halves)[1].face.surface.at(b.at(std::lerp(b.to, b.from, i / 20.0)));
    EXPECT_LE(geom::distance(p, q), 1e-12);
  }
}

TEST(Open, ASphereWhoseLoopIsItsSeamOnly) {
  const Surface ball = *Surface::sphere({}, 2.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  for (const double off : {0.0, 2 * pi}) {  // as files have it: up and down the seam, a period off
    const double low = off, high = off + 2 * pi;
    const ChartLoop seam{{straight({high, -0.5 * pi}, {high, 0.5 * pi}), straight({low, 0.5 * pi}, {low, -0.5 * pi})}};
    SharedNumbers numbers;
    const auto whole = mended({ball, {seam}}, numbers);
    ASSERT_TRUE(whole.ok()) << whole.error().message;
    const auto halves = open(whole->face, numbers);
    ASSERT_TRUE(halves.ok()) << halves.error().message;
    ASSERT_EQ(halves->size(), 2U);
    EXPECT_NEAR(area_in_space((*halves)[0].face) + area_in_space((*halves)[1].face), 16 * pi, 0.1);
    for (const Opened& half : *halves) {
      for (const ChartEdge& edge : half.face.loops.at(0).edges) EXPECT_EQ(edge.name, artificial_border);
    }
  }
}

TEST(Open, AHoleCloseToThePoleAndItsWavyRimAreWhereTheyWere) {
  const Surface ball = *Surface::sphere({}, 3.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  std::vector<Point3> wave;
  for (int i = 0; i <= 60; ++i) wave.push_back({2 * pi * i / 60.0, 0.3 + 0.1 * std::cos(7 * 2 * pi * i / 60.0), 0});
  const Curve rim = *Curve::through(wave);
  const auto found = recognise(
      ball,
      std::vector{TrimLine{{{{.curve = rim, .from = rim.low(), .to = rim.high()}}}, true}, circle({1, 1.2}, 0.3)});
  ASSERT_TRUE(found.ok()) << found.error().message;
  SharedNumbers numbers;
  const auto cap = open(found->faces()[*found->pick({4, 1})], numbers);
  ASSERT_TRUE(cap.ok()) << cap.error().message;
  ASSERT_EQ(cap->size(), 1U);
  ASSERT_EQ(cap->front().face.loops.size(), 2U);
  for (const ChartLoop& loop : cap->front().face.loops) {
    for (const ChartEdge& edge : loop.edges) {
      for (int i = 0; i <= 300; ++i) {
        const Point p = edge.at(std::lerp(edge.from, edge.to, i / 300.0)), back = cap->front().back(p);
        EXPECT_LE(geom::distance(cap->front().face.surface.at(p), ball.at(back)), 1e-12);
        const bool of_rim = std::abs(back.y - 0.3 - 0.1 * std::cos(7 * back.x)) < 1e-3;
        const bool of_hole = std::abs(std::hypot(back.x - 1, back.y - 1.2) - 0.3) < 1e-9;
        EXPECT_TRUE(of_rim || of_hole) << back;
      }
    }
  }
}

TEST(Open, AMeshHasANodeAtATipAndNeedsNoneAtASmoothPole) {
  SharedNumbers numbers;
  const auto points_of = [&](const Surface& surface) {
    const auto whole = recognise(surface, {});
    const auto opened = open(whole->faces().front(), numbers);
    std::size_t count = 0;
    for (const Opened& each : *opened) {
      for (const ChartPoint& point : each.face.points) {
        EXPECT_LE(geom::distance(each.face.surface.at(point.at), {}), 1e-12);
        ++count;
      }
    }
    return count;
  };
  EXPECT_EQ(points_of(*Surface::cone({}, 0.0, 0.5, {{0, 0}, {2 * pi, 3}})), 1U);
  EXPECT_EQ(points_of(*Surface::sphere({}, 2.0, {{0, -0.5 * pi}, {2 * pi, 0.1}})), 0U);
}

TEST(Open, ALuneIsTwoSectors) {
  const Surface lune = *Surface::sphere({}, 3.0, {{0.2, -0.5 * pi}, {1.4, 0.5 * pi}});
  SharedNumbers numbers;
  const auto halves = open(recognise(lune, {})->faces()[0], numbers);
  ASSERT_TRUE(halves.ok()) << halves.error().message;
  ASSERT_EQ(halves->size(), 2U);
  double area = 0.0;
  for (const Opened& half : *halves) {
    ASSERT_EQ(half.face.loops.size(), 1U);
    EXPECT_EQ(half.face.loops[0].edges.size(), 3U);
    check_loops(half.face);
    int artificial = 0;
    for (const ChartEdge& edge : half.face.loops[0].edges) artificial += edge.name == artificial_border ? 1 : 0;
    EXPECT_EQ(artificial, 1);
    area += area_in_space(half.face);
  }
  EXPECT_NEAR(area, 1.2 * 2 * 9, 0.02);
}

/// The length in space of lines of a kind and a name inside the parts of a face.
double length_in_space(const std::vector<Opened>& parts, ChartLine::Kind kind, const std::string& name) {
  double sum = 0.0;
  for (const Opened& part : parts) {
    for (const ChartLine& line : part.face.lines) {
      if (line.kind != kind) continue;
      for (const ChartEdge& edge : line.edges) {
        if (edge.name != name) continue;
        constexpr int n = 2000;
        Point3 last = part.face.surface.at(edge.start());
        for (int i = 1; i <= n; ++i) {
          const Point3 next = part.face.surface.at(edge.at(std::lerp(edge.from, edge.to, 1.0 * i / n)));
          sum += geom::distance(last, next);
          last = next;
        }
      }
    }
  }
  return sum;
}

/// Latitudes between which the common borders of two halves of a ball lie.
std::pair<double, double> latitudes_of_the_cut(const std::vector<Opened>& halves) {
  double low = pi, high = -pi;
  for (const Opened& half : halves) {
    for (const ChartEdge& edge : half.face.loops.at(0).edges) {
      if (edge.name != artificial_border) continue;
      for (int i = 0; i <= 20; ++i) {
        const double at = half.back(edge.at(std::lerp(edge.from, edge.to, i / 20.0))).y;
        low = std::min(low, at), high = std::max(high, at);
      }
    }
  }
  return {low, high};
}

// The cut between the poles runs along no line: what lay on it would be taken as the cut.
TEST(Open, LinesAlongTheMiddleBetweenTwoPolesStay) {
  const double degree = pi / 180.0;
  const Surface ball = *Surface::sphere({}, 5.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  struct Drawn {
    double from, to;  ///< Longitudes.
    std::vector<double> latitudes;
  };
  std::vector<double> many;
  for (int i = -40; i <= 40; ++i) many.push_back(2.0 * i);
  std::vector<double> favourites;
  for (int i = -9; i <= 9; ++i) favourites.push_back(5.0 * i);
  const std::vector<Drawn> cases{{30, 70, {0}},        {30, 70, {1e-6}},       {30, 70, {-1e-4}}, {30, 70, {1}},
                                 {30, 70, {10}},       {30, 70, {-10}},        {0, 40, {0}},      {320, 360, {0}},
                                 {30, 70, {0, 5, -5}}, {30, 70, {0, 1e-3, 8}}, {10, 350, many},   {30, 70, favourites},
                                 {0, 360, {0}}};
  for (const Drawn& drawn : cases) {
    for (const ChartLine::Kind kind : {ChartLine::Kind::Crack, ChartLine::Kind::Constraint}) {
      std::vector<TrimLine> lines;
      double wanted = 0.0;
      for (const double at : drawn.latitudes) {
        lines.push_back({{{straight({drawn.from * degree, at * degree}, {drawn.to * degree, at * degree}, "k")}, kind},
                         false,
                         false});
        wanted += 5.0 * std::cos(at * degree) * (drawn.to - drawn.from) * degree;
      }
      const auto found = recognise(ball, lines);
      ASSERT_TRUE(found.ok()) << found.error().message;
      ASSERT_EQ(found->faces().size(), 1U);
      SharedNumbers numbers(50);
      const auto halves = open(found->faces()[0], numbers);
      const std::string what = testing::PrintToString(drawn.latitudes) + " from " + std::to_string(drawn.from);
      ASSERT_TRUE(halves.ok()) << what << halves.error().message;
      ASSERT_EQ(halves->size(), 2U) << what;
      EXPECT_NEAR(length_in_space(*halves, kind, "k"), wanted, 1e-5 * wanted) << what;
      double area = 0.0;
      for (const Opened& half : *halves) {
        check_loops(half.face);
        area += area_in_space(half.face);
      }
      EXPECT_NEAR(area, 4 * pi * 25, 0.5) << what;
      const auto [low, high] = latitudes_of_the_cut(*halves);
      EXPECT_NEAR(low, high, 1e-9) << what;
      double nearest = pi;
      for (const double at : drawn.latitudes) nearest = std::min(nearest, std::abs(low - at * degree));
      EXPECT_GT(nearest, 0.99 * degree) << what;
      // Where nothing is near it stays in the middle.
      if (drawn.latitudes.size() == 1 && std::abs(drawn.latitudes[0]) >= 10) {
        EXPECT_NEAR(low, 0.0, 1e-12) << what;
      }
    }
  }
}

// Slanting lines may leave no place where the cut meets none of them: it crosses them then.
TEST(Open, LinesThatSlantFromPoleToPoleAreCrossedByTheCut) {
  const Surface ball = *Surface::sphere({}, 5.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  std::vector<TrimLine> lines;
  double wanted = 0.0;
  constexpr int pieces = 12;
  for (int k = 0; k < pieces; ++k) {
    const Point a{0.3, std::lerp(-1.4, 1.4, 1.0 * k / pieces)}, b{5.9, a.y + 2.8 / pieces};
    lines.push_back({{{straight(a, b, "k")}, ChartLine::Kind::Crack}, false, false});
    constexpr int n = 4000;
    Point3 last = ball.at(a);
    for (int i = 1; i <= n; ++i) {
      const Point3 next = ball.at({std::lerp(a.x, b.x, 1.0 * i / n), std::lerp(a.y, b.y, 1.0 * i / n)});
      wanted += geom::distance(last, next);
      last = next;
    }
  }
  const auto found = recognise(ball, lines);
  ASSERT_TRUE(found.ok()) << found.error().message;
  SharedNumbers numbers(50);
  const auto halves = open(found->faces()[0], numbers);
  ASSERT_TRUE(halves.ok()) << halves.error().message;
  ASSERT_EQ(halves->size(), 2U);
  EXPECT_NEAR(length_in_space(*halves, ChartLine::Kind::Crack, "k"), wanted, 1e-5 * wanted);
}

TEST(Open, AConeWithItsApexIsADiskAndItsTipAPoint) {
  const Surface cone = *Surface::cone({}, 0.0, 0.4, {{0, 0}, {2 * pi, 5}});
  const std::vector<TrimLine> lines{circle({6.2, 3}, 1)};  // across the seam
  const auto found = recognise(cone, lines);
  ASSERT_TRUE(found.ok()) << found.error().message;
  const TrimmedSurface& face = found->faces()[*found->pick({3, 1})];
  SharedNumbers numbers;
  const auto opened = open(face, numbers);
  ASSERT_TRUE(opened.ok()) << opened.error().message;
  ASSERT_EQ(opened->size(), 1U);
  const TrimmedSurface& disk = opened->front().face;
  check_loops(disk);
  ASSERT_EQ(disk.loops.size(), 2U);
  EXPECT_GT(loop_area(disk.loops[0]), 0.0);
  EXPECT_LT(loop_area(disk.loops[1]), 0.0);
  for (const ChartLoop& loop : disk.loops) {
    for (const ChartEdge& edge : loop.edges) EXPECT_NE(edge.name, artificial_border);
  }
  EXPECT_EQ(geom::distance(disk.surface.at({0, 0}), {0, 0, 0}), 0.0);
  // The hole in space: its chart is (u, v) with r = v sin a.
  double hole = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double t = pi * (i + 0.5) / 2000, v = 3 - std::cos(t), half = std::sin(t);
    hole += 2 * half * v * std::sin(0.4) * std::sin(t) * pi / 2000;
  }
  EXPECT_NEAR(area_in_space(disk), pi * 25 * std::sin(0.4) - hole, 0.02);
}

TEST(Open, ALoopThroughThePole) {
  // An octant with its corner in the pole, as loops are read from files: no edge along the pole.
  const Surface ball = *Surface::sphere({}, 1.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  const TrimLine loop{{{straight({1, 0}, {2.5, 0}, "foot"), straight({2.5, 0}, {2.5, 0.5 * pi}, "east"),
                        straight({1, 0.5 * pi}, {1, 0}, "west")}},
                      true};
  const auto found = recognise(ball, std::vector{loop});
  ASSERT_TRUE(found.ok()) << found.error().message;
  ASSERT_EQ(found->faces().size(), 2U);
  SharedNumbers numbers;
  const auto sector = open(found->faces()[*found->pick({1.7, 0.5})], numbers);
  ASSERT_TRUE(sector.ok()) << sector.error().message;
  ASSERT_EQ(sector->size(), 1U);
  ASSERT_EQ(sector->front().face.loops.size(), 1U);
  EXPECT_EQ(sector->front().face.loops[0].edges.size(), 3U);
  EXPECT_NEAR(area_in_space(sector->front().face), 1.5, 0.005);
  // The rest touches both poles.
  const auto rest = open(found->faces()[*found->pick({4, 0.5})], numbers);
  ASSERT_TRUE(rest.ok()) << rest.error().message;
  ASSERT_EQ(rest->size(), 2U);
  double area = 0.0;
  for (const Opened& part : *rest) {
    check_loops(part.face);
    area += area_in_space(part.face);
  }
  EXPECT_NEAR(area, 4 * pi - 1.5, 0.03);
}

TEST(Open, ATorusAndACylinderKeepTheirChartsAndTheirSeamsAreArtificial) {
  SharedNumbers numbers;
  const Surface ring = *Surface::torus({}, 6, 2, {{0, 0}, {2 * pi, 2 * pi}});
  const auto torus = open(recognise(ring, {})->faces()[0], numbers);
  ASSERT_TRUE(torus.ok());
  ASSERT_EQ(torus->size(), 1U);
  EXPECT_FALSE(torus->front().polar);
  std::multiset<SharedCurveId> seen;
  for (const ChartEdge& edge : torus->front().face.loops[0].edges) {
    EXPECT_EQ(edge.name, artificial_border);
    seen.insert(*edge.shared);
  }
  EXPECT_EQ(seen.size(), 4U);
  for (const SharedCurveId each : seen) EXPECT_EQ(seen.count(each), 2U);
  const Surface pipe = *Surface::cylinder({}, 1.0, {{0, 0}, {2 * pi, 8}});
  const auto found = recognise(pipe, std::vector{circle({0, 4}, 1)});
  const auto opened = open(found->faces()[*found->pick({3, 1})], numbers);
  ASSERT_TRUE(opened.ok());
  int artificial = 0;
  for (const ChartEdge& edge : opened->front().face.loops[0].edges)
    artificial += edge.name == artificial_border ? 1 : 0;
  EXPECT_EQ(artificial, 4);
  EXPECT_EQ(opened->front().back({1, 2}), (Point{1, 2}));
}

TEST(Open, ACoonsCornerAndACollapsedBezierSideAreSectors) {
  // A triangle as a bilinear patch whose top is one point.
  const Surface flat = *Surface::nurbs(1, {0, 0, 1, 1}, 1, {0, 0, 1, 1}, {{0, 0, 0}, {1, 2, 0}, {2, 0, 0}, {1, 2, 0}});
  ASSERT_TRUE(flat.collapsed(Side::Top));
  SharedNumbers numbers;
  const auto opened = open(recognise(flat, {})->faces()[0], numbers);
  ASSERT_TRUE(opened.ok()) << opened.error().message;
  ASSERT_EQ(opened->size(), 1U);
  EXPECT_EQ(opened->front().face.loops[0].edges.size(), 3U);
  EXPECT_NEAR(area_in_space(opened->front().face), 2.0, 0.01);
  const Metric m = metric(opened->front().face.surface.jet({0.3, 0.0}));
  EXPECT_GT(m.area(), 0.3);
  EXPECT_LT(m.area(), 3.0);
}

TEST(Open, ChartLengthsAreThoseOfTheMiddleLines) {
  const geom::Vector lengths = chart_lengths(*Surface::plane({{}, {1, 0, 0}, {0, 1, 0}, {}}, {{0, 0}, {10, 5}}));
  EXPECT_NEAR(lengths.x, 10, 1e-12);
  EXPECT_NEAR(lengths.y, 5, 1e-12);
}

}  // namespace
}  // namespace dobra::surf::trim
