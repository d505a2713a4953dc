// Kinks, jumps, poles and steep places of formulas, and formulas that have none however much they wave.

#include "shared/surf/graph_flaws.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "shared/surf/surface.h"

namespace dobra::surf {
namespace {

const geom::Box square{{-1, -1}, {1, 1}};

GraphFlaws flaws_of(const std::string& formula, const geom::Box& chart = square) {
  const auto found = graph_flaws(formula, chart);
  EXPECT_TRUE(found.ok()) << (found ? "" : to_string(found.error()));
  return found ? *found : GraphFlaws{};
}
bool has(const GraphFlaws& found, GraphFlawKind kind) {
  return std::any_of(found.flaws.begin(), found.flaws.end(), [&](const auto& flaw) { return flaw.kind == kind; });
}

TEST(GraphFlaws, AJumpIsFoundWhereItIs) {
  const GraphFlaws found = flaws_of("x > 0.123 ? 1 : 0");
  ASSERT_TRUE(has(found, GraphFlawKind::Jump));
  for (const GraphFlaw& flaw : found.flaws) EXPECT_NEAR(flaw.at.x, 0.123, 1e-9);
  EXPECT_TRUE(has(flaws_of("x + y > 0.3 ? 1 : 0.9"), GraphFlawKind::Jump));
}

TEST(GraphFlaws, APoleIsFoundBetweenPlacesOfAnyGrid) {
  const GraphFlaws found = flaws_of("1 / (x - 0.0137)");
  ASSERT_FALSE(found.flaws.empty());
  EXPECT_TRUE(has(found, GraphFlawKind::Pole) || has(found, GraphFlawKind::NoValue));
  EXPECT_NEAR(found.flaws[0].at.x, 0.0137, 1e-6);
  EXPECT_FALSE(flaws_of("1 / ((x - 0.0137) * (x - 0.0137))").flaws.empty());
}

TEST(GraphFlaws, ASlopeOrABendWithoutBoundIsFound) {
  for (const char* const formula : {"sqrt(1 - x * x)", "abs(x) ^ (1 / 3)", "abs(x - 0.2) ^ 1.5", "sqrt(abs(y - 0.1))"})
    EXPECT_TRUE(has(flaws_of(formula), GraphFlawKind::Steep)) << formula;
}

TEST(GraphFlaws, AKinkAlongXOrYIsALine) {
  const GraphFlaws found = flaws_of("abs(x - 0.013) + 0.01 * abs(y + 0.2)");
  EXPECT_TRUE(found.flaws.empty());
  ASSERT_EQ(found.kinks_x.size(), 1U);
  ASSERT_EQ(found.kinks_y.size(), 1U);
  EXPECT_NEAR(found.kinks_x[0], 0.013, 1e-10);
  EXPECT_NEAR(found.kinks_y[0], -0.2, 1e-9);
}

/// Ramps between two kinks: their distance is known.
const std::vector<double> widths{1.0, 0.1, 0.03, 3e-3, 3e-4, 3e-6};

TEST(GraphFlaws, KinksAlongLinesAreFoundHoweverNearToEachOther) {
  const geom::Box ten{{0, 0}, {10, 10}};
  for (const double width : widths) {
    const std::string w = fmt::format("{}", width);
    for (const char* const name : {"x", "y"}) {
      const GraphFlaws found = flaws_of(fmt::format("min(1, max(0, ({} - 5) / {}))", name, w), ten);
      EXPECT_TRUE(found.flaws.empty()) << w;
      const std::vector<double>& kinks = *name == 'x' ? found.kinks_x : found.kinks_y;
      EXPECT_TRUE((*name == 'x' ? found.kinks_y : found.kinks_x).empty()) << w;
      ASSERT_EQ(kinks.size(), 2U) << w << ' ' << name;
      EXPECT_NEAR(kinks[0], 5.0, 4e-15) << w;
      EXPECT_NEAR(kinks[1], 5.0 + width, 4e-15) << w;
    }
    const GraphFlaws crossing = flaws_of(fmt::format("min(1, max(0, (x - 5) / {0})) * min({0}, abs(y - 3))", w), ten);
    EXPECT_TRUE(crossing.flaws.empty()) << w;
    EXPECT_EQ(crossing.kinks_x.size(), 2U) << w;
    EXPECT_EQ(crossing.kinks_y.size(), 3U) << w;
  }
}

TEST(GraphFlaws, AChoiceThatBendsNothingIsNoKink) {
  for (const char* const formula : {"abs(x)^3", "max(0, x - 0.2)^2", "x > 0.3 ? x : x", "min(x, x)", "abs(abs(x)^3)",
                                    "floor(x / 7) + x", "abs(x - x) + y"}) {
    const GraphFlaws found = flaws_of(formula, {{-1, -1}, {0.9, 1}});
    EXPECT_TRUE(found.kinks_x.empty() && found.kinks_y.empty()) << formula;
  }
}

TEST(GraphFlaws, ManyChoicesAlongALineAreAllFound) {
  const GraphFlaws found = flaws_of("abs(sin(300 * x)) + abs(x - floor(x) - 0.5)", {{0.01, 0}, {3.5, 1}});
  // Noughts of the sine, and whole numbers and a half; at whole ones both meet again and there is no jump.
  std::vector<double> wanted{0.5, 1.0, 1.5, 2.0, 2.5, 3.0};
  for (int i = 1; i * std::numbers::pi / 300.0 < 3.5; ++i) wanted.push_back(i * std::numbers::pi / 300.0);
  std::sort(wanted.begin(), wanted.end());
  ASSERT_EQ(found.kinks_x.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found.kinks_x[i], wanted[i], 1e-12);
}

TEST(GraphFlaws, AJumpBetweenThePlacesOfTheNetIsFound) {
  for (const char* const formula : {"x > 0.2 && x < 0.2000003 ? 1 : 0", "floor(1e6 * (x - 0.2)) == 0 ? y + 2 : 0"})
    EXPECT_TRUE(has(flaws_of(formula), GraphFlawKind::Jump)) << formula;
}

TEST(GraphFlaws, NarrowRampsThatRunElsewhereAreTold) {
  const geom::Box ten{{-5, -5}, {5, 5}};
  for (const double width : widths) {
    for (const char* const along : {"x - 0.3 * y - 0.7137", "sqrt(x^2 + y^2) - 2.137", "x^2 + y^2 - 3.37"}) {
      const GraphFlaws found = flaws_of(fmt::format("min(1, max(0, ({}) / {}))", along, width), ten);
      EXPECT_TRUE(has(found, GraphFlawKind::Kink)) << along << ' ' << width;
      EXPECT_TRUE(found.kinks_x.empty() && found.kinks_y.empty()) << along << ' ' << width;
    }
  }
}

TEST(GraphFlaws, AKinkThatRunsElsewhereIsTold) {
  for (const char* const formula : {"abs(x - y)", "hypot(x, y)", "abs(x * x + y * y - 0.3)", "max(x, y * y)"}) {
    const GraphFlaws found = flaws_of(formula);
    EXPECT_TRUE(has(found, GraphFlawKind::Kink)) << formula;
    EXPECT_TRUE(found.kinks_x.empty() && found.kinks_y.empty()) << formula;
  }
}

TEST(GraphFlaws, WhatIsSmoothHasNone) {
  for (const char* const formula :
       {"0", "1e-12 * x * y", "x * y", "sin(50 * x) * cos(40 * y)", "sin(1000 * x)", "exp(-2000 * (x * x + y * y))",
        "1 / (x * x + 1e-4)", "tanh(1000 * x)", "x ^ 3 - 3 * x * y ^ 2", "(x + 1e6) ^ 2 - 1e12", "abs(x) ^ 3"}) {
    const GraphFlaws found = flaws_of(formula);
    EXPECT_TRUE(found.flaws.empty()) << formula << ": kind " << static_cast<int>(found.flaws[0].kind) << " at "
                                     << found.flaws[0].at.x << ", " << found.flaws[0].at.y;
    EXPECT_TRUE(found.kinks_x.empty() && found.kinks_y.empty()) << formula;
  }
  EXPECT_TRUE(flaws_of("0 * x", {{1e8, -1}, {1e8 + 2, 1}}).flaws.empty());
  EXPECT_TRUE(flaws_of("sin(x)", {{1e8, -1}, {1e8 + 2, 1}}).flaws.empty());
}

TEST(GraphFlaws, AGraphHasKinksWhereItsFormulaHas) {
  const auto surface = Surface::graph("abs(x - 0.25) * (2 + y) + y * y", square);
  ASSERT_TRUE(surface.ok());
  ASSERT_EQ(surface->kinks().u.size(), 3U);
  EXPECT_NEAR(surface->kinks().u[1], 0.25, 1e-10);
  // Derivatives are those of the side, up to the kink.
  for (const double x : {-0.5, 0.2499, 0.2501, 0.8}) {
    const double side = x < 0.25 ? -1.0 : 1.0;
    const Jet jet = surface->jet({x, 0.3});
    EXPECT_NEAR(jet.u.z, side * 2.3, 1e-6) << x;
    EXPECT_NEAR(jet.uv.z, side, 1e-5) << x;
    EXPECT_NEAR(jet.uu.z, 0.0, 1e-3) << x;
    EXPECT_NEAR(jet.v.z, std::abs(x - 0.25) + 0.6, 1e-6) << x;
  }
  EXPECT_LT(surface->bend({{-1, -1}, {1, 1}}).uu, 1e-6);
}

}  // namespace
}  // namespace dobra::surf
