// Areas and bounds of graphs whose formula rises over a place narrower than any net, against integrals along one
// variable.

#include "tests/support/narrow_peaks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "shared/surf/details.h"
#include "shared/surf/graph_flaws.h"
#include "shared/surf/measure.h"
#include "shared/surf/trim/area.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::narrow_peaks_test {
namespace {

const geom::Box six{{-3, -3}, {3, 3}};

/// The whole chart, with its border as a loop.
trim::TrimmedSurface framed(const Surface& surface) {
  const geom::Box& box = surface.chart();
  const std::array corners{box.low, geom::Point{box.high.x, box.low.y}, box.high, geom::Point{box.low.x, box.high.y}};
  trim::ChartLoop loop;
  for (std::size_t i = 0; i < 4; ++i) {
    const geom::Point a = corners[i], b = corners[(i + 1) % 4];
    loop.edges.push_back({*Curve::line({a.x, a.y, 0.0}, {b.x, b.y, 0.0})});
  }
  return {surface, {loop}};
}

struct Case {
  const char* formula;
  double area;
};
std::vector<Case> cases() {
  return {{"0.01 * exp(-10000 * (x^2 + y^2))", support::peak_area(0.01, 1e4)},
          {"exp(-3000 * (x^2 + y^2))", support::peak_area(1.0, 3e3)},
          {"exp(-10000 * ((x - 0.137)^2 + (y + 0.211)^2))", support::peak_area(1.0, 1e4)},
          {"0.01 * exp(-1e8 * ((x - 0.137)^2 + (y + 0.211)^2))", support::peak_area(0.01, 1e8)},
          {"exp(-1e4 * (x - 0.3 * y)^2)", support::ridge_area(1e4, 0.3)},
          {"exp(-1e4 * (y - 0.3 * x)^2)", support::ridge_area(1e4, 0.3)},
          {"tanh(1000 * x)", support::step_area(1e3)},
          {"tanh(1000 * y)", support::step_area(1e3)}};
}

TEST(NarrowPeaks, TheClosedFormIsTheOneThatWasFoundElsewhere) {
  EXPECT_NEAR(support::peak_area(0.01, 1e4), 36.0001417, 5e-8);
}

TEST(NarrowPeaks, AreasByQuadratureSeeThem) {
  for (const Case& each : cases()) {
    const Surface graph = *Surface::graph(each.formula, six);
    EXPECT_NEAR(area(graph, 1e-6).value, each.area, 1e-6 * each.area) << each.formula;
  }
}

TEST(NarrowPeaks, AreasOfTrimmedFacesSeeThem) {
  std::vector<Case> all = cases();
  all.erase(all.begin() + 5);  // a ridge takes seconds; one is enough
  for (const Case& each : all) {
    trim::TrimmedSurface face = framed(*Surface::graph(each.formula, six));
    // A corner where the graph is flat is cut off.
    trim::ChartLoop& loop = face.loops[0];
    loop.edges[1] = {*Curve::line({3, -3, 0}, {3, 2, 0})};
    loop.edges[2] = {*Curve::line({2, 3, 0}, {-3, 3, 0})};
    loop.edges.insert(loop.edges.begin() + 2, {*Curve::line({3, 2, 0}, {2, 3, 0})});
    EXPECT_NEAR(trim::area(face).value, each.area - 0.5, 2e-6 * each.area) << each.formula;
  }
}

/// A ramp from 0 to 1 over a width: what it adds to the plane, by its length, is length (sqrt(1 + width^2) - width).
const std::vector<double> ramps{1.0, 0.1, 0.03, 3e-3, 3e-4, 3e-6};

TEST(NarrowPeaks, RampsBetweenKinksHaveTheirArea) {
  for (const double width : ramps) {
    const double wanted = 36.0 + 6.0 * (std::hypot(1.0, width) - width);
    for (const char* const name : {"x", "y"}) {
      const Surface graph = *Surface::graph(fmt::format("min(1, max(0, ({} - 1) / {}))", name, width), six);
      EXPECT_NEAR(area(graph, 1e-9).value, wanted, 1e-8 * wanted) << name << ' ' << width;
      EXPECT_NEAR(trim::area(framed(graph)).value, wanted, 1e-8 * wanted) << name << ' ' << width;
    }
  }
}

TEST(NarrowPeaks, ALogarithmRoundItsPoleHasItsArea) {
  // Radial integrals over an eighth of the square, r = exp(t).
  const auto area_to = [](double radius) {
    return support::simpson(
        [](double t) {
          const double r = std::exp(t), slope = 2.0 * r / (r * r + 1e-8);
          return r * r * std::sqrt(1.0 + slope * slope);
        },
        std::log(1e-10), std::log(radius), 2000);
  };
  const double wanted = 8.0 * support::simpson([&](double angle) { return area_to(3.0 / std::cos(angle)); }, 0.0,
                                               0.25 * std::numbers::pi, 50);
  const Surface graph = *Surface::graph("log(x^2 + y^2 + 1e-8)", six);
  EXPECT_NEAR(area(graph, 1e-8).value, wanted, 1e-6 * wanted);
  EXPECT_NEAR(trim::area(framed(graph)).value, wanted, 1e-6 * wanted);
}

/// Sixty waves ask for more places than are looked at with the tolerance of smooth faces.
TEST(NarrowPeaks, AreasOfManyWavesAreRight) {
  constexpr int n = 1200;
  double sum = 0.0;
  for (int i = 0; i < n * n; ++i) {
    const double x = 6.0 * (i / n + 0.5) / n - 3.0, y = 6.0 * (i % n + 0.5) / n - 3.0;
    const double by_x = 3.0 * std::cos(10 * x) * std::cos(8 * y), by_y = 2.4 * std::sin(10 * x) * std::sin(8 * y);
    sum += std::sqrt(1.0 + by_x * by_x + by_y * by_y) * 36.0 / (n * n);
  }
  const Surface graph = *Surface::graph("0.3 * sin(10 * x) * cos(8 * y)", six);
  EXPECT_NEAR(trim::area(framed(graph)).value, sum, 1e-5 * sum);
  EXPECT_NEAR(area(graph, 1e-7).value, sum, 1e-5 * sum);
}

TEST(NarrowPeaks, ALogarithmNearItsPole) {
  for (const double low : {1e-2, 1e-3, 1e-4}) {
    const Surface graph = *Surface::graph("log(x)", {{low, -3}, {3, 3}});
    const double wanted = support::logarithm_area(low, 3.0, 6.0);
    EXPECT_NEAR(area(graph, 1e-9).value, wanted, 1e-7 * wanted) << low;
    EXPECT_NEAR(trim::area(framed(graph)).value, wanted, 1e-7 * wanted) << low;
  }
}

TEST(NarrowPeaks, DetailsLieWhereThePeakIs) {
  const Surface graph = *Surface::graph("exp(-10000 * ((x - 0.137)^2 + (y + 0.211)^2))", six);
  EXPECT_FALSE(graph.seen(six));
  const Details details = details_of(graph, six);
  EXPECT_TRUE(details.unseen.empty());
  ASSERT_FALSE(details.parts.empty());
  double finest = 6.0;
  for (const geom::Box& part : details.parts) {
    EXPECT_LT(geom::distance(part.centre(), {0.137, -0.211}), 0.5);
    finest = std::min(finest, part.width());
  }
  EXPECT_LT(finest, 0.02);
}

TEST(NarrowPeaks, PlainGraphsHaveNoDetails) {
  for (const char* const formula : {"0", "x * y", "(x^2 - y^2) / 10", "4 * exp(-(x^2 + y^2) / 8)", "sin(x) * cos(y)",
                                    "x^3 - 3 * x * y^2", "sqrt(1 + x^2 + y^2)", "1 / (4 + x * y / 3)", "abs(x) + y"}) {
    const Details details = details_of(*Surface::graph(formula, six), six);
    EXPECT_TRUE(details.parts.empty()) << formula << ' ' << details.parts.size();
    EXPECT_TRUE(details.unseen.empty()) << formula;
  }
}

TEST(NarrowPeaks, LengthsSeeThem) {
  const Surface graph = *Surface::graph("0.01 * exp(-1e6 * (x - 0.7331)^2)", six);
  const auto slope = [](double s) {
    const double by_s = 2e4 * s * std::exp(-1e6 * s * s);
    return by_s * by_s / (std::sqrt(1.0 + by_s * by_s) + 1.0);
  };
  const double wanted = 6.0 + 2.0 * support::simpson(slope, 0.0, 8e-3, 400'000);
  EXPECT_NEAR(length(graph, {-3, 1}, {3, 1}), wanted, 1e-9);
}

bool has_flaw(const std::string& formula, GraphFlawKind kind, geom::Point near) {
  const GraphFlaws found = *graph_flaws(formula, six);
  return std::any_of(found.flaws.begin(), found.flaws.end(),
                     [&](const GraphFlaw& flaw) { return flaw.kind == kind && geom::distance(flaw.at, near) < 0.02; });
}

TEST(NarrowPeaks, FlawsBetweenTheLinesAreFound) {
  const geom::Point at{0.137, -0.211};
  EXPECT_TRUE(has_flaw("hypot(x - 0.137, y + 0.211) < 0.01 ? 1 : 0", GraphFlawKind::Jump, at));
  EXPECT_TRUE(has_flaw("max(0, 1 - 200 * hypot(x - 0.137, y + 0.211))", GraphFlawKind::Kink, at));
  EXPECT_TRUE(has_flaw("abs(x - y) < 0.001 && abs(x - 0.5) < 0.01 ? 0.3 : 0", GraphFlawKind::Jump, {0.5, 0.5}));
  const GraphFlaws pole = *graph_flaws("1e-6 / ((x - 0.137)^2 + (y + 0.211)^2)", six);
  ASSERT_FALSE(pole.flaws.empty());
  EXPECT_NEAR(geom::distance(pole.flaws[0].at, at), 0.0, 1e-3);
}

TEST(NarrowPeaks, SmoothOnesAreNoFlaws) {
  for (const Case& each : cases()) EXPECT_TRUE(graph_flaws(each.formula, six)->flaws.empty()) << each.formula;
  for (const char* const formula : {"abs(x)^3", "abs(x * y)^3", "sqrt(x^4 + y^4 + 1e-3)", "(x^2 + y^2)^2.5",
                                    "exp(-1 / (1e-300 + x^2))", "x > -9 ? x * y : 7", "min(x, 9) + max(y, -9)"}) {
    const GraphFlaws found = *graph_flaws(formula, six);
    EXPECT_TRUE(found.flaws.empty()) << formula << ": kind " << static_cast<int>(found.flaws[0].kind) << " at "
                                     << found.flaws[0].at.x << ", " << found.flaws[0].at.y;
  }
}

}  // namespace
}  // namespace dobra::surf::narrow_peaks_test
