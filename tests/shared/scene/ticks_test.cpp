#include "shared/scene/ticks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace dobra::scene {
namespace {

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> all;
  for (const Tick& tick : ticks) all.push_back(tick.label);
  return all;
}

TEST(Ticks, StepsAreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_THAT(labels(nice_ticks(0.0, 10.0, 6)), testing::ElementsAre("0", "2", "4", "6", "8", "10"));
  EXPECT_THAT(labels(nice_ticks(0.0, 1000.0, 3)), testing::ElementsAre("0", "500", "1000"));
}

TEST(Ticks, DecimalsAreThoseOfTheStep) {
  EXPECT_THAT(labels(nice_ticks(0.0, 1.0, 5)), testing::ElementsAre("0.0", "0.5", "1.0"));
  EXPECT_THAT(labels(nice_ticks(0.1, 0.3, 5)), testing::ElementsAre("0.10", "0.15", "0.20", "0.25", "0.30"));
}

TEST(Ticks, NegativeNumbersHaveATrueMinusAndZeroHasNone) {
  EXPECT_THAT(labels(nice_ticks(-1.0, 1.0, 3)), testing::ElementsAre("\u22121", "0", "1"));
  EXPECT_EQ(tick_label(-0.0, 1), "0.0");
  EXPECT_EQ(tick_label(-0.04, 1), "0.0");
}

TEST(Ticks, ARangeWithoutWidthHasOneTickAndInfinityNone) {
  EXPECT_EQ(nice_ticks(3.0, 3.0, 5).size(), 1U);
  EXPECT_EQ(nice_ticks(1e9, 1e9 + 1e-7, 5).size(), 1U);
  EXPECT_TRUE(nice_ticks(0.0, std::numeric_limits<double>::infinity(), 5).empty());
}

TEST(Ticks, NiceBelowIsTheLargestStepNotAbove) {
  EXPECT_DOUBLE_EQ(nice_below(99.0), 50.0);
  EXPECT_DOUBLE_EQ(nice_below(100.0), 100.0);
  EXPECT_DOUBLE_EQ(nice_below(4.9), 2.0);
  EXPECT_DOUBLE_EQ(nice_below(0.0107), 0.01);
  EXPECT_DOUBLE_EQ(nice_below(0.5), 0.5);
}

TEST(Ticks, OfLogarithmsNameTheNumbersThemselves) {
  const auto room = [](const std::string& text) { return 6.0 * static_cast<double>(text.size()); };
  const auto over = [&](double low, double high, double length) {
    return labels(logarithmic_ticks_that_fit(low, high, length, 8.0, 20.0, room));
  };
  EXPECT_THAT(over(-0.5, 1.1, 300.0), testing::ElementsAre("0.5", "1", "2", "5", "10"));
  EXPECT_THAT(over(2.0, 5.0, 150.0), testing::ElementsAre("100", "1000", "10000", "100000"));
  EXPECT_THAT(over(0.0, 6.0, 70.0), testing::ElementsAre("1", "1000", "1e+06"));
  EXPECT_FALSE(over(3.1, 3.2, 300.0).empty());  // no such number within
}

TEST(Ticks, LabelsThatFitKeepTheirGap) {
  const auto room = [](const std::string& text) { return 6.0 * static_cast<double>(text.size()); };
  for (const double length : {20.0, 60.0, 150.0, 700.0}) {
    const std::vector<Tick> ticks = ticks_that_fit(7456000.0, 7457000.0, length, 8.0, 30.0, room);
    ASSERT_FALSE(ticks.empty());
    for (std::size_t i = 1; i < ticks.size(); ++i) {
      const double apart = (ticks[i].value - ticks[i - 1].value) / 1000.0 * length;
      EXPECT_GE(apart, 8.0 + 0.5 * (room(ticks[i].label) + room(ticks[i - 1].label)));
    }
  }
}

RC_GTEST_PROP(Ticks, AreEquallySpacedInTheRangeAndNotTooMany,
              (int mantissa, int exponent, unsigned width, unsigned count)) {
  const double unit = std::pow(10.0, std::abs(exponent) % 9 - 5);
  const double low = (mantissa % 1000) * unit;
  const double high = low + (1 + width % 2000) * unit;
  const std::size_t most = 1 + count % 30;
  const std::vector<Tick> ticks = nice_ticks(low, high, most);
  RC_ASSERT(!ticks.empty());
  RC_ASSERT(ticks.size() <= most);
  const double slack = 1e-8 * (high - low);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    RC_ASSERT(ticks[i].value >= low - slack);
    RC_ASSERT(ticks[i].value <= high + slack);
    if (i > 1) {
      const double first = ticks[1].value - ticks[0].value;
      RC_ASSERT(std::abs(ticks[i].value - ticks[i - 1].value - first) <= slack);
    }
    if (i > 0) RC_ASSERT(ticks[i].label != ticks[i - 1].label);
  }
}

}  // namespace
}  // namespace dobra::scene
