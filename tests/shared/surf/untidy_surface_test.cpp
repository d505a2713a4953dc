// What surfaces come with: poles, seams, skewed and stretched charts, knots that stand too often, weights near nought.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numbers>
#include <random>
#include <thread>

#include "shared/surf/measure.h"
#include "shared/surf/surface.h"

namespace dobra::surf {
namespace {

using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;
constexpr double full_turn = 2.0 * std::numbers::pi;

std::string message_of(const auto& result) { return result.ok() ? std::string("fine") : result.error().message; }

/// The functions of a spline by their definition, in more digits.
long double function_of(const std::vector<double>& knots, std::size_t i, std::size_t degree, long double t) {
  if (degree == 0) return knots[i] <= t && t < knots[i + 1] ? 1.0L : 0.0L;
  long double sum = 0.0L;
  if (knots[i + degree] > knots[i])
    sum += (t - knots[i]) / (static_cast<long double>(knots[i + degree]) - knots[i]) *
           function_of(knots, i, degree - 1, t);
  if (knots[i + degree + 1] > knots[i + 1])
    sum += (knots[i + degree + 1] - t) / (static_cast<long double>(knots[i + degree + 1]) - knots[i + 1]) *
           function_of(knots, i + 1, degree - 1, t);
  return sum;
}

TEST(SplineBasis, IsItsDefinitionWithItsDerivativesOnAnyKnots) {
  std::mt19937 random(21);
  int judged = 0;
  for (int tries = 0; tries < 800; ++tries) {
    const std::size_t degree = 1 + random() % 5;
    std::vector<double> knots;
    double at = -3.0;
    for (std::size_t i = 0; i < 2 * (degree + 1) + random() % 8; ++i) {
      knots.push_back(at);
      if (random() % 2 == 0) at += random() % 4 == 0 ? 1e-3 : 1.0 + static_cast<double>(random() % 100) / 25.0;
    }
    const base::Result<SplineBasis> basis = SplineBasis::make(degree, knots, "knots");
    if (!basis) continue;
    const std::vector<double> breaks = basis->breaks();
    for (std::size_t piece = 1; piece < breaks.size(); ++piece) {
      const long double a = breaks[piece - 1], b = breaks[piece], t = a + 0.4L * (b - a), h = 0.1L * (b - a);
      const SplineBasis::Values values = basis->at(static_cast<double>(t));
      for (std::size_t j = 0; j <= degree; ++j) {
        const auto f = [&](int k) {
          return function_of(knots, values.first + j, degree, static_cast<long double>(static_cast<double>(t)) + k * h);
        };
        // Differences of five and more places are exact for these degrees.
        const long double first = (8.0L * (f(1) - f(-1)) - (f(2) - f(-2))) / 12.0L;
        const long double second = (-f(-2) + 16.0L * f(-1) - 30.0L * f(0) + 16.0L * f(1) - f(2)) / 12.0L;
        if (degree <= 4) {
          EXPECT_NEAR(values.of[0][j], static_cast<double>(f(0)), 1e-14);
          EXPECT_NEAR(values.of[1][j] * static_cast<double>(h), static_cast<double>(first), 1e-13);
          EXPECT_NEAR(values.of[2][j] * static_cast<double>(h * h), static_cast<double>(second), 1e-12);
          ++judged;
        } else {
          EXPECT_NEAR(values.of[0][j], static_cast<double>(f(0)), 1e-14);
        }
      }
    }
  }
  EXPECT_GT(judged, 2000);
}

/// A projective change of the parameter leaves the curve and spreads the weights: 1, 1e-3, 1e-6.
TEST(Untidy, WeightsNearNoughtAreTheSameCircle) {
  const double c = std::sqrt(0.5);
  for (const double spread : {1.0, 1e-1, 1e-3}) {
    const Curve arc = *Curve::bezier({{2, 0, 0}, {2, 0, 2}, {0, 0, 2}}, {1.0, spread * c, spread * spread});
    EXPECT_NEAR(arc.length(0, 1), 0.5 * std::numbers::pi * 2.0, 1e-11) << spread;
    const Surface tube = *Surface::extruded(arc, {0, 5, 0});
    const Surface ball = *Surface::revolved(arc, {}, {0, 0, 1}, 0, full_turn);
    EXPECT_NEAR(area(tube).value, 5.0 * std::numbers::pi, 1e-9) << spread;
    EXPECT_NEAR(area(ball).value, 2.0 * std::numbers::pi * 4.0, 1e-8) << spread;
    for (const double t : {0.0, 1e-4, 0.02, 0.5, 0.97, 1.0}) {
      EXPECT_NEAR(geom::length(arc.at(t) - Point3{}), 2.0, 1e-14);
      const Curvature bent = *curvature(tube.jet({t, 0.3}));
      EXPECT_NEAR(std::max(std::abs(bent.least), std::abs(bent.greatest)), 0.5, 1e-9) << spread << " " << t;
      EXPECT_NEAR(bent.gaussian(), 0.0, 1e-9);
    }
  }
}

TEST(Untidy, StretchedAndSkewedChartsAreTheSameSurface) {
  const auto sphere_part = [](double stretch_u, double stretch_v) {
    const double w = std::sqrt(0.5);
    const std::vector<Point3> net{{3, 0, 0}, {3, 0, 3}, {0, 0, 3}, {3, 3, 0}, {3, 3, 3},
                                  {0, 0, 3}, {0, 3, 0}, {0, 3, 3}, {0, 0, 3}};
    const double u = stretch_u, v = stretch_v;
    return *Surface::nurbs(2, {0, 0, 0, u, u, u}, 2, {0, 0, 0, v, v, v}, net, {1, w, 1, w, 0.5, w, 1, w, 1});
  };
  for (const auto& [u, v] : {std::pair{1.0, 1.0}, std::pair{1000.0, 1.0}, std::pair{1e-3, 1e3}, std::pair{1e9, 1.0}}) {
    const Surface part = sphere_part(u, v);
    EXPECT_NEAR(area(part).value, 4.5 * std::numbers::pi, 1e-8) << u;
    EXPECT_TRUE(part.collapsed(Side::Top));
    for (const double s : {0.1, 0.5, 0.9}) {
      for (const double t : {0.1, 0.5, 0.9}) {
        const Jet jet = part.jet({s * u, t * v});
        const std::optional<Vector3> n = normal(jet);
        ASSERT_TRUE(n) << u << " " << v;
        EXPECT_NEAR(dot(*n, jet.at - Point3{}), 3.0, 1e-13);
        EXPECT_NEAR(curvature(jet)->mean(), -1.0 / 3.0, 1e-11);
        EXPECT_NEAR(curvature(jet)->gaussian(), 1.0 / 9.0, 1e-11);
      }
    }
  }
  // A chart whose lines meet at a thousandth of a radian: a cylinder of which v also runs round.
  const double lean = 1e-3;
  const Surface skew = *Surface::plane({{}, {1, 0, 0}, {1, lean, 0}, {}}, {{0, 0}, {2, 3}});
  EXPECT_NEAR(area(skew).value, 6.0 * lean, 1e-12);
  EXPECT_NEAR(length(skew, {0, 0}, {-1, 1}), lean, 1e-18);
  EXPECT_EQ(normal(skew.jet({0, 0}))->z, 1.0);
}

TEST(Untidy, PolesAndApexHaveFiniteJetsAndALimitOfTheNormal) {
  const Surface ball = *Surface::sphere({}, 2.0, {{0, -0.25 * full_turn}, {full_turn, 0.25 * full_turn}});
  const Surface cone = *Surface::cone({}, 0.0, 0.4, {{0, 0}, {full_turn, 3.0}});
  const Surface other = *Surface::cone({}, 0.0, 0.4, {{0, -3}, {full_turn, 0.0}});
  for (const double u : {0.0, 1.0, 3.0, full_turn}) {
    for (const double v : {ball.chart().low.y, ball.chart().high.y}) {
      const Jet jet = ball.jet({u, v});
      for (const Vector3 each : {jet.u, jet.v, jet.uu, jet.uv, jet.vv}) EXPECT_TRUE(geom::is_finite(each));
      EXPECT_FALSE(normal(jet));
      EXPECT_FALSE(curvature(jet));
      const std::optional<Vector3> limit = normal(ball, {u, v});
      ASSERT_TRUE(limit);
      EXPECT_LE(geom::length(*limit - Vector3{0, 0, v > 0 ? 1.0 : -1.0}), 1e-15);
    }
    // The normal of a cone is the same along each of its lines, up to the apex.
    EXPECT_LE(geom::length(*normal(cone, {u, 0.0}) - *normal(cone, {u, 1.0})), 1e-14);
    EXPECT_LE(geom::length(*normal(other, {u, 0.0}) - *normal(other, {u, -1.0})), 1e-14);
  }
  // An octant whose pole is a side of control points.
  const Surface turned = *Surface::revolved(*Curve::bezier({{2, 0, 0}, {2, 0, 2}, {0, 0, 2}}, {1, std::sqrt(0.5), 1}),
                                            {}, {0, 0, 1}, 0.0, 1.0);
  EXPECT_TRUE(turned.collapsed(Side::Top));
  EXPECT_NEAR(normal(turned, {0.3, 1.0})->z, 1.0, 1e-14);
}

TEST(Untidy, AKnotTooOftenIsATearUnlessBothSidesMeet) {
  const std::vector<double> knots{0, 0, 0, 1, 1, 1, 2, 2, 2};
  const std::vector<Point3> joined{{0, 0, 0}, {1, 0, 2}, {2, 0, 0}, {2, 0, 0}, {3, 0, -2}, {4, 0, 0}};
  std::vector<Point3> torn = joined;
  torn[3].z = 0.25;
  const auto has = [](const std::string& text, const char* words) {
    EXPECT_NE(text.find(words), std::string::npos) << text;
  };
  has(message_of(Curve::nurbs(2, knots, torn)),
      "torn at 1, where knot 4 stands 3 times: control points 3 and 4 are 0.25 m apart");
  ASSERT_TRUE(Curve::nurbs(2, knots, joined).ok());
  const auto patch = [&](const std::vector<Point3>& row, bool along_u) {
    std::vector<Point3> net;
    for (std::size_t i = 0; i < (along_u ? row.size() : 2); ++i) {
      for (std::size_t j = 0; j < (along_u ? 2 : row.size()); ++j)
        net.push_back(row[along_u ? i : j] + Vector3{0, 3.0 * static_cast<double>(along_u ? j : i), 0});
    }
    return along_u ? Surface::nurbs(2, knots, 1, {0, 0, 1, 1}, net) : Surface::nurbs(1, {0, 0, 1, 1}, 2, knots, net);
  };
  has(message_of(patch(torn, true)), "torn at u = 1");
  has(message_of(patch(torn, false)), "torn at v = 1");
  const double length = 2.0 * Curve::bezier({{0, 0, 0}, {1, 0, 2}, {2, 0, 0}})->length(0, 1);
  for (const bool along_u : {true, false}) EXPECT_NEAR(area(*patch(joined, along_u)).value, 3.0 * length, 1e-9);
}

TEST(Untidy, BothSidesOfACornerAreSeen) {
  const Curve bent =
      *Curve::nurbs(2, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1, 0, 0.5}, {1, 0, 1}});
  const Surface strip = *Surface::extruded(bent, {0, 2, 0});
  EXPECT_EQ(strip.breaks().u, (std::vector<double>{0, 1, 2}));
  const Vector3 left = *normal(strip.jet({std::nextafter(1.0, 0.0), 0.5})), right = *normal(strip.jet({1.0, 0.5}));
  EXPECT_NEAR(dot(left, right), 0.0, 1e-15);
  EXPECT_NEAR(area(strip).value, 4.0, 1e-12);
}

TEST(Untidy, AGridWithRepeatedPoints) {
  std::vector<Point3> cap;  // the first column is one point, one row has a point twice
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 5; ++j) {
      const double angle = 0.25 * i, r = 0.5 * j;
      cap.push_back({r * std::cos(angle), r * std::sin(angle), 0.1 * r * r});
    }
  }
  cap[2 * 5 + 3] = cap[2 * 5 + 2];
  const Surface fan = *Surface::through(cap, 6, 5);
  EXPECT_TRUE(fan.collapsed(Side::Bottom));
  for (const Side side : {Side::Left, Side::Right, Side::Top}) EXPECT_FALSE(fan.collapsed(side));
  EXPECT_TRUE(std::isfinite(area(fan, 1e-6).value));
  for (int i = 0; i < 6; ++i) {  // a row between two columns: all on the surface's border
    EXPECT_LE(geom::distance(fan.at({0, 0}), cap[static_cast<std::size_t>(5 * i)]), 1e-13);
  }
  EXPECT_LE(geom::distance(fan.at({0, 1}), cap[4]), 1e-13);
  EXPECT_LE(geom::distance(fan.at({1, 1}), cap.back()), 1e-13);
  std::vector<Point3> twice = cap;
  for (std::size_t j = 0; j < 5; ++j) twice[3 * 5 + j] = twice[2 * 5 + j];
  EXPECT_EQ(message_of(Surface::through(twice, 6, 5)), "points 3 and 4 are the same in every row of the grid");
}

TEST(Untidy, GraphsThatWaveOftenHaveTheirDerivatives) {
  for (const auto& [waves, within] : {std::pair{1.0, 2e-9}, std::pair{10.0, 1e-8}, std::pair{50.0, 5e-8}}) {
    const double k = full_turn * waves / 10.0;
    const std::string number = std::to_string(k);
    const double rounded = std::stod(number);
    const Surface graph = *Surface::graph("sin(" + number + " * x) * cos(" + number + " * y)", {{0, 0}, {10, 10}});
    double first = 0.0, second = 0.0;
    for (int i = 0; i < 400; ++i) {
      const Point at{10.0 * std::fmod(0.618034 * i, 1.0), 10.0 * (i + 0.5) / 400.0};
      const double sx = std::sin(rounded * at.x), cx = std::cos(rounded * at.x), sy = std::sin(rounded * at.y),
                   cy = std::cos(rounded * at.y);
      const Jet jet = graph.jet(at);
      first = std::max({first, std::abs(jet.u.z - rounded * cx * cy), std::abs(jet.v.z + rounded * sx * sy)});
      second = std::max({second, std::abs(jet.uu.z + rounded * rounded * sx * cy),
                         std::abs(jet.vv.z + rounded * rounded * sx * cy),
                         std::abs(jet.uv.z + rounded * rounded * cx * sy)});
    }
    EXPECT_LE(first, within * rounded) << waves;
    EXPECT_LE(second, within * rounded * rounded) << waves;
  }
}

TEST(Untidy, ManyAtOnceAndFromManyThreadsAreTheSame) {
  const Surface graph = *Surface::graph("sin(x) * exp(y / 5)", {{0, 0}, {6, 4}});
  std::vector<Point> uv;
  for (int i = 0; i < 200; ++i) uv.push_back({0.03 * i, 4.0 * std::fmod(0.618034 * i, 1.0)});
  std::vector<Jet> expected;
  for (const Point at : uv) expected.push_back(graph.jet(at));
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&] {
      std::vector<Jet> all(uv.size());
      graph.jets(uv, all);
      for (std::size_t i = 0; i < uv.size(); ++i) {
        if (!(all[i].at == expected[i].at && all[i].uv == expected[i].uv && all[i].vv == expected[i].vv)) ++wrong;
      }
    });
  }
  for (std::thread& each : threads) each.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace dobra::surf
