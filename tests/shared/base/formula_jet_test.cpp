// Derivatives of formulas against differences of base::Formula, and bounds against values at many places.

#include "shared/base/formula_jet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "shared/base/formula.h"

namespace dobra::base {
namespace {

const std::array<std::string, 2> x_and_y{"x", "y"};

/// Every operation, smooth over 0.2 .. 0.7 x 0.2 .. 0.7.
const std::vector<std::string> smooth_formulas{"3",
                                               "x",
                                               "-y",
                                               "x + y - 2 * x / y",
                                               "x^2 + y^3 - x^-2",
                                               "x^1.7 + y^-0.3",
                                               "x^y",
                                               "2^-x^2",
                                               "-x^2",
                                               "+x*-y",
                                               "2^x^y",
                                               "-2^2*x",
                                               "sin(3 * x) * cos(4 * y)",
                                               "tan(x * y)",
                                               "asin(x) + acos(y)",
                                               "atan(5 * x - y)",
                                               "sinh(x) * cosh(y - 0.5)",
                                               "tanh(10 * (x - y))",
                                               "exp(-20 * ((x - 0.4)^2 + y^2))",
                                               "log(x) + log10(x + y)",
                                               "sqrt(x + y)",
                                               "cbrt(x - 2)",
                                               "abs(x - 3) + sign(y)",
                                               "floor(x) + x",
                                               "atan2(y, x) + atan2(-y, x - 1)",
                                               "hypot(x, y)",
                                               "pow(x, 3) * pow(y, x)",
                                               "min(x, 7 * y) + max(x, y + 5)",
                                               "x < y + 1 ? x * y : 7",
                                               "(x > 2) * 4 + (x != y + 9) * x",
                                               "x > 2 || y < 3 && x >= 0.1 ? x^2 : y",
                                               "x == 5 ? 1 : y <= 2 ? x : y",
                                               "pi * x + e * y + 1.5e-2 + .5 + 2.",
                                               "x ^ 0",
                                               "1 / (x * x + 1e-2)",
                                               "(x + 1) ^ 3 * (y - 1) ^ 5 / (1 + x)^2"};

TEST(FormulaJet, DerivativesAreThoseOfTheFormula) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> in(0.2, 0.7);
  constexpr double h = 1e-4;
  for (const std::string& text : smooth_formulas) {
    const auto jet = FormulaJet::make(text, x_and_y);
    ASSERT_TRUE(jet.ok()) << text;
    const auto f = *Formula::make(text, x_and_y);
    const auto at = [&](double x, double y) { return f.at(std::array{x, y}); };
    for (int i = 0; i < 20; ++i) {
      const double x = in(random), y = in(random);
      const PlaneJet<double> z = jet->at(x, y);
      const double size = 1.0 + std::abs(z.xx) + std::abs(z.yy);
      EXPECT_NEAR(z.value, at(x, y), 1e-13 * size) << text;
      EXPECT_NEAR(z.x, (at(x + h, y) - at(x - h, y)) / (2 * h), 1e-4 * size) << text;
      EXPECT_NEAR(z.y, (at(x, y + h) - at(x, y - h)) / (2 * h), 1e-4 * size) << text;
      EXPECT_NEAR(z.xx, (at(x + h, y) - 2 * at(x, y) + at(x - h, y)) / (h * h), 1e-4 * size) << text;
      EXPECT_NEAR(z.yy, (at(x, y + h) - 2 * at(x, y) + at(x, y - h)) / (h * h), 1e-4 * size) << text;
      EXPECT_NEAR(z.xy, (at(x + h, y + h) - at(x - h, y + h) - at(x + h, y - h) + at(x - h, y - h)) / (4 * h * h),
                  1e-4 * size)
          << text;
    }
  }
}

TEST(FormulaJet, BoundsHoldAtEveryPlaceAndComeNearInSmallBoxes) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> in(-1.3, 1.3), side(0.0, 1.0);
  for (const std::string& text : smooth_formulas) {
    const FormulaJet jet = *FormulaJet::make(text, x_and_y);
    for (int i = 0; i < 200; ++i) {
      const double x = in(random), y = in(random), w = std::pow(side(random), 4), h = std::pow(side(random), 4);
      const FormulaJet::Bounds bounds = jet.over({x, x + w}, {y, y + h});
      for (int k = 0; k <= 16; ++k) {
        const PlaneJet<double> z = jet.at(x + w * (k % 4 + side(random)) / 5.0, y + h * (k / 4 + side(random)) / 6.0);
        const auto holds = [&](Range range, double at, const char* what) {
          if (!std::isfinite(at) || !std::isfinite(z.value)) return;
          const double hair = 1e-9 * (1.0 + std::abs(at));
          EXPECT_TRUE(range.low - hair <= at && at <= range.high + hair)
              << text << ' ' << what << ": " << at << " not in " << range.low << " .. " << range.high << " over " << x
              << ", " << y << " by " << w << ", " << h;
        };
        holds(bounds.of.value, z.value, "value");
        holds(bounds.of.x, z.x, "x"), holds(bounds.of.y, z.y, "y");
        holds(bounds.of.xx, z.xx, "xx"), holds(bounds.of.xy, z.xy, "xy"), holds(bounds.of.yy, z.yy, "yy");
      }
    }
    const FormulaJet::Bounds small = jet.over({0.4, 0.4 + 1e-6}, {0.3, 0.3 + 1e-6});
    const PlaneJet<double> z = jet.at(0.4, 0.3);
    EXPECT_FALSE(small.kink) << text;
    EXPECT_NEAR(small.of.xx.high - small.of.xx.low, 0.0, 1e-2 * (1.0 + std::abs(z.xx))) << text;
    EXPECT_NEAR(small.of.yy.high - small.of.yy.low, 0.0, 1e-2 * (1.0 + std::abs(z.yy))) << text;
  }
}

TEST(FormulaJet, TheGrammarIsThatOfTheFormula) {
  for (const char* const text : {"2^-x^2",
                                 "-x^-y",
                                 "2 ^ -x * y",
                                 "-x*y",
                                 "x/-y/2",
                                 "x - y - 2",
                                 "- x + y",
                                 "x < y < 3",
                                 "x == y == 0",
                                 "x < y == 1",
                                 "x > 2 < 1",
                                 "2 - 3 < 1 - 1",
                                 "1.5e-2 + .5 + 2. + 1.e3 + 1E5 + 1e+2",
                                 "1 || 0 && 0",
                                 "0 ? 1 : 0 ? 2 : 5",
                                 "1 ? 0 ? 7 : 8 : 9",
                                 "2*x ? 3 : 4",
                                 "x ? 3 : 4 + 1",
                                 "(x)",
                                 "2^x^y",
                                 "x^y*2",
                                 "x*y^2",
                                 "x >= y || y >= x",
                                 "sign(x - y) - floor(7 * y)",
                                 "atan2(-y, -x)",
                                 "min(x, y) < x"}) {
    const auto f = Formula::make(text, x_and_y);
    const auto jet = FormulaJet::make(text, x_and_y);
    ASSERT_TRUE(f.ok() && jet.ok()) << text;
    for (const auto& at : {std::array{0.3, 0.6}, std::array{0.9, -0.2}, std::array{-0.4, -0.7}}) {
      const double wanted = f->at(at), value = jet->at(at[0], at[1]).value;
      EXPECT_TRUE(wanted == value || (std::isnan(wanted) && std::isnan(value)) ||
                  std::abs(wanted - value) <= 1e-14 * std::abs(wanted))
          << text << ": " << value << " for " << wanted;
    }
  }
}

TEST(FormulaJet, AKinkOrAJumpInTheBoxIsTold) {
  for (const char* const text : {"abs(x)", "max(x, y)", "x > 0 ? 1 : 0", "sign(y)", "floor(x + 0.5)", "(x > y) * 3"}) {
    const FormulaJet jet = *FormulaJet::make(text, x_and_y);
    EXPECT_TRUE(jet.over({-0.1, 0.6}, {-0.1, 0.6}).kink) << text;
    EXPECT_FALSE(jet.over({0.1, 0.2}, {0.05, 0.09}).kink) << text;
  }
}

TEST(FormulaJet, APoleHasNoBounds) {
  for (const char* const text : {"1 / x", "log(x^2 + y^2)", "sqrt(x)", "cbrt(y)", "tan(2 * x)", "x^-2", "abs(x)^1.5"}) {
    const FormulaJet jet = *FormulaJet::make(text, x_and_y);
    const PlaneJet<Range> over = jet.over({-0.1, 1.0}, {-0.1, 1.0}).of;
    EXPECT_FALSE(std::isfinite(over.xx.size() + over.yy.size())) << text;
  }
}

TEST(FormulaJet, WhatIsNoFormulaIsRefused) {
  for (const char* const text :
       {"", "x +", "(x", "x)", "sin x", "sin(x, y)", "min(x)", "z", "1 2", "x ? y", "x,y", "1..2"})
    EXPECT_FALSE(FormulaJet::make(text, x_and_y).ok()) << text;
}

TEST(FormulaJet, ChoicesChangeOverWhereTheyDo) {
  const auto changes = [](const std::string& text) {
    return FormulaJet::make(text, x_and_y)->changes({-3.0, 7.0}, {-3.0, 7.0});
  };
  const FormulaJet::Changes ramp = changes("min(1, max(0, (x - 5) / 0.003)) + abs(y + 1) * max(y, 3)");
  ASSERT_EQ(ramp.x.size(), 2U);
  ASSERT_EQ(ramp.y.size(), 2U);
  const auto holds = [](Range range, double at) {
    return range.low - 2e-15 <= at && at <= range.high + 2e-15 && range.high - range.low < 1e-14;
  };
  EXPECT_TRUE(holds(ramp.x[0], 5.0));
  EXPECT_TRUE(holds(ramp.x[1], 5.003));
  EXPECT_TRUE(holds(ramp.y[0], -1.0));
  EXPECT_TRUE(holds(ramp.y[1], 3.0));
  for (const char* const none : {"x * y", "abs(x * y)", "abs(x - 9)", "max(x, 8 - y)", "hypot(x, y)"}) {
    EXPECT_TRUE(changes(none).x.empty()) << none;
    EXPECT_TRUE(changes(none).y.empty()) << none;
  }
  EXPECT_EQ(changes("floor(x)").x.size(), 10U);  // from -2 to 7: at -3 nothing is before
  EXPECT_EQ(changes("(x > 1 && x <= 2) * (y == 4)").x.size(), 2U);
}

}  // namespace
}  // namespace dobra::base
