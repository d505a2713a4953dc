// Curves that two surfaces share: closed forms, touchings, and random pairs against dense samples of signs.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>

#include "shared/surf/intersect.h"
#include "tests/shared/surf/surface_shapes.h"

namespace dobra::surf {
namespace {

using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;
using namespace test;

double length_of(const SharedCurve& curve) {
  double sum = 0.0;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    sum += geom::distance(curve.points[i - 1].at, curve.points[i].at);
  return sum;
}

bool on_border(const Surface& surface, Point uv) {
  const Box& chart = surface.chart();
  return uv.x == chart.low.x || uv.x == chart.high.x || uv.y == chart.low.y || uv.y == chart.high.y;
}

/// Every point is on both, and every curve is closed or ends on a border. How far apart the surfaces are at most, of
/// the size.
double check(const SharedSet& set, const Surface& a, const Surface& b, const std::string& name) {
  const double size = std::min(a.size(), b.size());
  double worst = 0.0;
  for (const SharedCurve& curve : set.curves) {
    EXPECT_GE(curve.points.size(), 2U) << name;
    for (const SharedPoint& p : curve.points) {
      worst =
          std::max({worst, geom::distance(a.at(p.first), p.at) / size, geom::distance(b.at(p.second), p.at) / size});
      EXPECT_TRUE(a.chart().contains(p.first) && b.chart().contains(p.second)) << name;
    }
    for (std::size_t i = 1; i < curve.points.size(); ++i)
      EXPECT_LE(geom::distance(curve.points[i - 1].at, curve.points[i].at), 0.03 * size) << name;
    const SharedPoint &first = curve.points.front(), &last = curve.points.back();
    if (curve.closed) {
      EXPECT_LE(geom::distance(first.at, last.at), 1e-9 * size) << name;
    } else {
      for (const SharedPoint* end : {&first, &last})
        EXPECT_TRUE(on_border(a, end->first) || on_border(b, end->second))
            << name << " ends inside at " << end->first << end->second;
    }
  }
  return worst;
}

TEST(IntersectSurfaces, APlaneCutsASphereInItsCircleAcrossTheSeam) {
  const Frame frame = tilted();
  const Surface ball = *Surface::sphere(frame, 5.0, {{0, -0.5 * pi}, {2 * pi, 0.5 * pi}});
  for (const double away : {0.0, 1.0, -4.0, 4.999}) {
    for (const Vector3 normal : {Vector3{1, 2, 3}, Vector3{-1, 0.2, 0}, frame.z}) {
      const Vector3 n = geom::normalised(normal);
      const auto cut = intersect_plane(ball, frame.origin + away * n, normal);
      ASSERT_TRUE(cut.ok()) << cut.error().message;
      ASSERT_EQ(cut->curves.size(), 1U) << away;
      EXPECT_TRUE(cut->curves[0].closed) << away;
      EXPECT_TRUE(cut->contacts.empty());
      EXPECT_NEAR(length_of(cut->curves[0]), 2 * pi * std::sqrt(25 - away * away),
                  0.01 * 2 * pi * std::sqrt(25 - away * away));
      for (const SharedPoint& p : cut->curves[0].points) {
        EXPECT_NEAR(dot(p.at - frame.origin, n), away, 1e-11);
        EXPECT_LE(geom::distance(ball.at(p.first), p.at), 1e-12);
      }
    }
  }
  EXPECT_TRUE(intersect_plane(ball, frame.origin + 5.001 * frame.x, frame.x)->curves.empty());
  const auto touch = intersect_plane(ball, frame.origin + 5.0 * geom::normalised(frame.x + frame.z), frame.x + frame.z);
  ASSERT_TRUE(touch.ok());
  EXPECT_TRUE(touch->curves.empty());
  ASSERT_EQ(touch->contacts.size(), 1U);
  EXPECT_EQ(touch->contacts[0].kind, SharedContact::Kind::Touch);
}

TEST(IntersectSurfaces, SmallLoopsNearATouchAreFound) {
  const Surface bumps = *Surface::graph("sin(x) * cos(y)", {{0, 0}, {12, 12}});
  int tops = 0;  // sin x cos y = 1 within the chart, by its places
  for (int i = 0; i < 8; ++i) {
    for (int k = -1; k < 8; ++k) {
      const double x = (i + 0.5) * pi, y = k * pi;
      const bool up = (i + k) % 2 == 0;
      if (x < 12 && y > 0.1 && y < 12 && up) ++tops;
    }
  }
  for (const double below : {1e-1, 1e-3, 1e-5}) {
    const auto cut = intersect_plane(bumps, {0, 0, 1.0 - below}, {0, 0, 1});
    ASSERT_TRUE(cut.ok()) << cut.error().message;
    int loops = 0;
    for (const SharedCurve& curve : cut->curves) loops += curve.closed ? 1 : 0;
    EXPECT_EQ(loops, tops) << below;
    check(*cut, bumps, *Surface::plane({{0, 0, 1.0 - below}, {1, 0, 0}, {0, 1, 0}, {}}, {{-99, -99}, {99, 99}}),
          "bumps");
  }
}

TEST(IntersectSurfaces, PipesThatCross) {
  const Frame along{{0, 0, -4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, across{{-4, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  const Surface wide = *Surface::cylinder(along, 2.0, {{0, 0}, {2 * pi, 8}});
  const Surface narrow = *Surface::cylinder(across, 1.0, {{0, 0}, {2 * pi, 8}}),
                equal = *Surface::cylinder(across, 2.0, {{0, 0}, {2 * pi, 8}});
  const auto two = intersect_surfaces(wide, narrow);
  ASSERT_TRUE(two.ok()) << two.error().message;
  EXPECT_EQ(two->curves.size(), 2U);
  for (const SharedCurve& curve : two->curves) {
    EXPECT_TRUE(curve.closed);
    for (const SharedPoint& p : curve.points) {
      EXPECT_NEAR(std::hypot(p.at.x, p.at.y), 2.0, 1e-12);
      EXPECT_NEAR(std::hypot(p.at.y, p.at.z), 1.0, 1e-12);
    }
  }
  const auto crossing = intersect_surfaces(wide, equal);  // two ellipses, through each other twice
  ASSERT_TRUE(crossing.ok()) << crossing.error().message;
  int at = 0;
  for (const SharedContact& contact : crossing->contacts) {
    EXPECT_EQ(contact.kind, SharedContact::Kind::Crossing);
    EXPECT_NEAR(std::abs(contact.point.at.y), 2.0, 1e-9);
    ++at;
  }
  EXPECT_GE(at, 2);
  double total = 0.0;
  for (const SharedCurve& curve : crossing->curves) {
    total += length_of(curve);
    for (const SharedPoint& p : curve.points) EXPECT_NEAR(std::abs(p.at.x), std::abs(p.at.z), 1e-6);
  }
  EXPECT_NEAR(total, 2 * 15.2807, 0.05);  // of the ellipse with axes 2 and 2 sqrt 2
}

TEST(IntersectSurfaces, CurvesThatEndWhereTheSurfacesTouchEndThereToTheDigits) {
  const Surface main = *Surface::cylinder({}, 2.0, {{0, -5}, {2 * pi, 5}});
  // Half of it, from the axis of the other on, its seam through a place where they touch.
  const Surface branch = *Surface::cylinder({{}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, 2.0, {{0, 0}, {2 * pi, 5}});
  const auto shared = intersect_surfaces(main, branch);
  ASSERT_TRUE(shared.ok()) << shared.error().message;
  std::size_t ends = 0;
  for (const SharedCurve& curve : shared->curves) {
    EXPECT_FALSE(curve.closed);
    for (const SharedPoint& p : {curve.points.front(), curve.points.back()}) {
      if (std::abs(p.at.y) < 1.99) continue;
      ++ends;
      EXPECT_LT(geom::distance(p.at, {0, std::copysign(2.0, p.at.y), 0}), 1e-14);
      EXPECT_EQ(p.second.y, 0.0);  // the border of the branch, exactly
    }
  }
  EXPECT_EQ(ends, 4U);
}

TEST(IntersectSurfaces, TouchingAlongALineIsToldAndCoincidingIsRefused) {
  const Surface pipe = *Surface::cylinder({}, 2.0, {{0, 0}, {pi, 5}});
  const auto along = intersect_plane(pipe, {0, 2, 0}, {0, 1, 0});
  ASSERT_TRUE(along.ok()) << along.error().message;
  ASSERT_FALSE(along->contacts.empty());
  for (const SharedContact& contact : along->contacts) {
    EXPECT_EQ(contact.kind, SharedContact::Kind::Along);
    EXPECT_NEAR(contact.point.at.x, 0.0, 1e-4);
  }
  EXPECT_TRUE(along->curves.empty());
  const Surface other = *Surface::cylinder({}, 2.0, {{1, 1}, {2, 9}});
  const auto same = intersect_surfaces(pipe, other);
  ASSERT_FALSE(same.ok());
  EXPECT_NE(same.error().message.find("share more than curves"), std::string::npos);
  EXPECT_FALSE(intersect_plane(pipe, {0, 0, 0}, {}).ok());
}

TEST(IntersectSurfaces, CornersOfASurfaceAreCornersOfTheCurve) {
  const Surface roof = *Surface::nurbs(1, {0, 0, 1, 2, 2}, 1, {0, 0, 1, 1},
                                       {{0, 0, 0}, {0, 8, 0}, {5, 0, 3}, {5, 8, 3}, {10, 0, 0}, {10, 8, 0}});
  const auto cut = intersect_plane(roof, {0, 3, 0}, {0.1, 1, 0});
  ASSERT_TRUE(cut.ok()) << cut.error().message;
  ASSERT_EQ(cut->curves.size(), 1U);
  EXPECT_FALSE(cut->curves[0].closed);
  double top = 0.0;
  for (const SharedPoint& p : cut->curves[0].points) top = std::max(top, p.at.z);
  EXPECT_NEAR(top, 3.0, 1e-12);
  const SharedPoint &first = cut->curves[0].points.front(), &last = cut->curves[0].points.back();
  EXPECT_EQ(std::min(first.first.x, last.first.x), 0.0);
  EXPECT_EQ(std::max(first.first.x, last.first.x), 2.0);
  EXPECT_NEAR(length_of(cut->curves[0]), 2.0 * std::sqrt(34.0 + 0.25), 1e-10);
}

/// A surface with a function that changes its sign across it, and where in its chart a point near it lies.
struct Told {
  Surface surface;
  std::function<double(Point3)> side;
  std::function<Point(Point3)> place;
};

Told any_surface(Chance& chance) {
  const Vector3 z = geom::normalised(Vector3{chance(-1, 1), chance(-1, 1), chance(0.2, 1)});
  const Vector3 x = geom::normalised(cross(Vector3{chance(-1, 1), 1, 0.3}, z));
  const Frame frame{{chance(-1, 1), chance(-1, 1), chance(-1, 1)}, x, cross(z, x), z};
  const auto local = [frame](Point3 p) {
    const Vector3 d = p - frame.origin;
    return Point3{dot(d, frame.x), dot(d, frame.y), dot(d, frame.z)};
  };
  const double from = chance(0, 2), turn = chance.random() % 3 == 0 ? 2 * pi : chance(1, 4.2);
  const auto angle = [from, turn](Point3 q) {
    double u = std::atan2(q.y, q.x);
    while (u < from - (turn < 5 ? 0.3 : 0.0)) u += 2 * pi;
    return u;
  };
  switch (chance.random() % 6) {
    case 0: {
      const double r = chance(0.6, 2.5);
      return {*Surface::sphere(frame, r, {{from, chance(-1.3, -0.2)}, {from + turn, chance(0.2, 1.3)}}),
              [=](Point3 p) { return geom::distance(p, frame.origin) - r; },
              [=](Point3 p) {
                const Point3 q = local(p);
                return Point{angle(q), std::atan2(q.z, std::hypot(q.x, q.y))};
              }};
    }
    case 1: {
      const double r = chance(0.4, 2.0);
      return {*Surface::cylinder(frame, r, {{from, chance(-2.5, -0.5)}, {from + turn, chance(0.5, 2.5)}}),
              [=](Point3 p) {
                const Point3 q = local(p);
                return std::hypot(q.x, q.y) - r;
              },
              [=](Point3 p) {
                const Point3 q = local(p);
                return Point{angle(q), q.z};
              }};
    }
    case 2: {
      const double r = chance(1.0, 2.0), a = chance(-0.4, 0.4);
      return {*Surface::cone(frame, r, a, {{from, -1.5}, {from + turn, 1.5}}),
              [=](Point3 p) {
                const Point3 q = local(p);
                return std::hypot(q.x, q.y) - r - q.z * std::tan(a);
              },
              [=](Point3 p) {
                const Point3 q = local(p);
                return Point{angle(q), q.z / std::cos(a)};
              }};
    }
    case 3: {
      const double major = chance(1.0, 2.0), minor = chance(0.3, 0.9), v0 = chance(-3, 0), v1 = v0 + chance(2, 6);
      return {*Surface::torus(frame, major, minor, {{from, v0}, {from + turn, v1}}),
              [=](Point3 p) {
                const Point3 q = local(p);
                return std::hypot(std::hypot(q.x, q.y) - major, q.z) - minor;
              },
              [=](Point3 p) {
                const Point3 q = local(p);
                double v = std::atan2(q.z, std::hypot(q.x, q.y) - major);
                while (v < v0) v += 2 * pi;
                return Point{angle(q), v};
              }};
    }
    case 4: {
      return {*Surface::plane(frame, {{chance(-2.5, -0.5), chance(-2.5, -0.5)}, {chance(0.5, 2.5), chance(0.5, 2.5)}}),
              [=](Point3 p) { return local(p).z; },
              [=](Point3 p) {
                const Point3 q = local(p);
                return Point{q.x, q.y};
              }};
    }
    default: {
      // A rational patch over a grid in the frame's plane: x and y are linear in u and v, whatever the weights of
      // columns, if all weights are one; heights are any.
      const double bumps = chance(0.5, 3.0);
      const std::vector<double> knots{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
      std::vector<Point3> net;
      for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
          const auto greville = [&](std::size_t k) { return (knots[k + 1] + knots[k + 2] + knots[k + 3]) / 3.0 - 1.5; };
          net.push_back(frame.origin + 1.3 * greville(i) * frame.x + 1.3 * greville(j) * frame.y +
                        bumps * chance(-1, 1) * frame.z);
        }
      }
      const Surface patch = *Surface::nurbs(3, knots, 3, knots, net);
      const auto place = [=](Point3 p) {
        const Point3 q = local(p);
        return Point{q.x / 1.3 + 1.5, q.y / 1.3 + 1.5};
      };
      return {patch, [=](Point3 p) { return local(p).z - local(patch.at(place(p))).z; }, place};
    }
  }
}

TEST(IntersectSurfaces, RandomPairsHaveEveryCurveThatDenseSamplesSee) {
  const char* const asked = std::getenv("DOBRA_RANDOM_CASES");
  const int cases = asked ? std::atoi(asked) : 200;
  int curves = 0, loops = 0, crossings = 0;
  double worst = 0.0;
  for (int seed = 0; seed < cases; ++seed) {
    Chance chance{std::mt19937(static_cast<unsigned>(seed + 1))};
    const Told a = any_surface(chance), b = any_surface(chance);
    const std::string name = "seed " + std::to_string(seed);
    const auto set = intersect_surfaces(a.surface, b.surface);
    ASSERT_TRUE(set.ok()) << name << set.error().message;
    worst = std::max(worst, check(*set, a.surface, b.surface, name));
    curves += static_cast<int>(set->curves.size());
    for (const SharedCurve& curve : set->curves) loops += curve.closed ? 1 : 0;
    const double size = std::min(a.surface.size(), b.surface.size());
    // Signs of b's side over a's chart.
    const Box& chart = a.surface.chart();
    constexpr int n = 60;
    const auto uv = [&](double i, double j) {
      return Point{std::lerp(chart.low.x, chart.high.x, i / n), std::lerp(chart.low.y, chart.high.y, j / n)};
    };
    int missed = 0;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        for (const auto& [di, dj] : {std::pair{1, 0}, std::pair{0, 1}}) {
          if (i + di > n || j + dj > n) continue;
          double low = 0.0, high = 1.0;
          const auto side = [&](double t) { return b.side(a.surface.at(uv(i + t * di, j + t * dj))); };
          const bool up = side(0.0) < 0.0;
          if ((side(1.0) < 0.0) == up) continue;
          for (int k = 0; k < 40; ++k) (((side(0.5 * (low + high)) < 0.0) == up) ? low : high) = 0.5 * (low + high);
          const Point3 at = a.surface.at(uv(i + low * di, j + low * dj));
          const Point there = b.place(at);
          if (!b.surface.chart().contains(there) || geom::distance(b.surface.at(there), at) > 1e-8 * size) continue;
          ++crossings;
          double nearest = 1e300;
          for (const SharedCurve& curve : set->curves) {
            for (std::size_t k = 1; k < curve.points.size(); ++k) {
              const Point3 p = curve.points[k - 1].at;
              const Vector3 chord = curve.points[k].at - p;
              const double square = dot(chord, chord),
                           part = square > 0 ? std::clamp(dot(at - p, chord) / square, 0.0, 1.0) : 0.0;
              nearest = std::min(nearest, geom::distance(at, p + part * chord));
            }
          }
          if (nearest > 2e-3 * size) ++missed;
        }
      }
    }
    EXPECT_EQ(missed, 0) << name;
  }
  RecordProperty("curves", curves);
  EXPECT_LE(worst, 1e-12);
  EXPECT_GT(curves, cases / 2);
  EXPECT_GT(loops, cases / 200);
  EXPECT_GT(crossings, 20 * cases);
  if (asked)
    printf("%d curves, %d of them closed, %d places checked, surfaces apart %.2g of the size\n", curves, loops,
           crossings, worst);
}

}  // namespace
}  // namespace dobra::surf
