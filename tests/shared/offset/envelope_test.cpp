#include "shared/offset/envelope.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "shared/offset/arcs.h"
#include "shared/offset/sections.h"
#include "tests/support/offset_oracle.h"

namespace dobra::offset {
namespace {

using geom::Point;
using geom::Polyline;

/// A random graph over an axis of any direction: noise, short steps, or small integers, which give exact coincidences.
Polyline random_graph(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> real(0.0, 1.0);
  Polyline graph;
  const std::size_t count = 3 + random() % 40;
  double x = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (seed % 3 == 2) {
      graph.points.push_back({static_cast<double>(i), static_cast<double>(random() % 5)});
    } else {
      x += seed % 3 == 0 ? 0.3 : 0.01 + std::pow(real(random), 3);
      graph.points.push_back({x, normal(random)});
    }
  }
  if (seed % 2 == 1) {
    const double a = 2 * std::numbers::pi * real(random);
    for (Point& p : graph.points) p = {p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a)};
  }
  return graph;
}

TEST(Envelope, OnlyCurvesThatNeverTurnBackAreMonotone) {
  const auto direction = [](const Polyline& curve) { return monotone_direction(prepare(curve, Side::RightOfTravel).value()); };
  EXPECT_TRUE(direction({{{0, 0}, {1, 5}, {2, -5}}, false}));
  EXPECT_TRUE(direction({{{0, 0}, {0, 1}, {-3, 1.5}, {1, 2}}, false}));
  EXPECT_FALSE(direction({{{0, 0}, {1, 0}, {0, 0}}, false}));
  EXPECT_FALSE(direction({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, false}));
  EXPECT_FALSE(direction({{{0, 0}, {1, 0}, {0, 1}, {-1, -1}, {2, -1}}, false}));
  EXPECT_FALSE(direction({{{0, 0}, {4, 0}, {2, 3}}, true}));
}

TEST(Envelope, AgreesWithTheSectionsOnRandomGraphs) {
  OffsetOptions options;
  options.join = Join::Round;
  std::size_t judged = 0;
  for (std::uint32_t seed = 0; seed < 600; ++seed) {
    const Polyline graph = random_graph(seed);
    const double d = 0.05 + 2.0 * static_cast<double>(seed % 97) / 97.0 * static_cast<double>(seed % 13) / 13.0;
    const BaseCurve base = prepare(graph, Side::RightOfTravel).value();
    const auto forward = monotone_direction(base);
    ASSERT_TRUE(forward) << seed;
    const OffsetPiece fast = monotone_offset(base, *forward, d, options);
    const Clearance clearance(base, options);
    double longest = 0.0;
    Polyline other;
    for (const OffsetPiece& piece : Trimmer(base, clearance, Outline::Sides::Both, d, options).run()) {
      if (length(piece, graph) > longest) other = chords(piece, graph, 1e-4).polyline;
      longest = std::max(longest, length(piece, graph));
    }
    ASSERT_EQ(fast.points.empty(), other.points.empty()) << seed;
    if (other.points.empty()) continue;
    ++judged;
    const Polyline drawn = chords(fast, graph, 1e-4).polyline;
    EXPECT_NEAR(length(fast, graph), longest, 1e-9 * (1 + longest)) << seed;
    for (const Point p : other.points) EXPECT_LE(geom::distance(drawn, p), 2e-4 * d + 1e-9) << seed;
    EXPECT_GE(support::least_distance(drawn, graph), d * (1 - 1.001e-4)) << seed;
    EXPECT_EQ(support::crossings(drawn), 0U) << seed;
  }
  EXPECT_GT(judged, 500U);
}

}  // namespace
}  // namespace dobra::offset
