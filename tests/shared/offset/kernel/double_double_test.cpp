#include "shared/offset/kernel/double_double.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "shared/offset/kernel/high.h"

namespace dobra::offset {
namespace {

// The bounds of the engine's decisions (resolution<Real>) suppose this; x86 and Arm servers have it in long double.
static_assert(std::numeric_limits<Real>::digits >= 64);
static_assert(std::numeric_limits<DoubleDouble>::digits >= 64);
#if defined(__x86_64__) && !defined(DOBRA_DOUBLE_DOUBLE)
static_assert(std::numeric_limits<long double>::digits == 64 && std::is_same_v<Real, long double>);
#endif

constexpr double bound = 0x1p-100;

High exact(DoubleDouble x) { return High(x.high()) + x.low(); }

/// Of all bits and of very different sizes; some exact doubles and whole numbers among them.
std::vector<DoubleDouble> numbers(unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-60, 60);
  std::vector<DoubleDouble> all{0.0, 1.0, -1.0, 3.0, 0x1p-60, 1e18};
  for (int k = 0; k < 200; ++k) {
    const double high = std::ldexp(mantissa(random), exponent(random));
    all.emplace_back(high, k % 5 == 0 ? 0 : high * 0x1p-54 * mantissa(random));
  }
  return all;
}

/// In parts of the exact result; 0 and the exact result are near nothing else.
double error_of(DoubleDouble found, const High& truth) {
  const High off = abs(High(exact(found) - truth));
  return truth == 0 ? (off == 0 ? 0 : 1) : static_cast<double>(High(off / abs(truth)));
}

void expect_sound(DoubleDouble x) {
  EXPECT_EQ(x.high() + x.low(), x.high()) << "the lower part overlaps the upper one";
}

TEST(DoubleDouble, SumsProductsQuotientsAndRootsKeepTheirBound) {
  const std::vector<DoubleDouble> left = numbers(1);
  const std::vector<DoubleDouble> right = numbers(2);
  for (const DoubleDouble a : left) {
    for (const DoubleDouble b : right) {
      EXPECT_LE(error_of(a + b, exact(a) + exact(b)), bound) << a.high() << " + " << b.high();
      EXPECT_LE(error_of(a - b, exact(a) - exact(b)), bound) << a.high() << " - " << b.high();
      EXPECT_LE(error_of(a * b, exact(a) * exact(b)), bound) << a.high() << " * " << b.high();
      expect_sound(a + b);
      expect_sound(a * b);
      if (exact(b) == 0) continue;
      EXPECT_LE(error_of(a / b, exact(a) / exact(b)), bound) << a.high() << " / " << b.high();
      expect_sound(a / b);
    }
    EXPECT_LE(error_of(root(abs(a)), root(High(abs(exact(a))))), bound) << a.high();
  }
}

TEST(DoubleDouble, WhatNearlyCancelsKeepsItsDigits) {
  for (int k = 1; k < 52; ++k) {
    const DoubleDouble a(1.0, 0x1p-54);
    const DoubleDouble b(1.0 + std::ldexp(1.0, -k), -0x1p-56);
    EXPECT_LE(error_of(a - b, exact(a) - exact(b)), bound) << k;
    EXPECT_LE(error_of(a * b - a, exact(a) * exact(b) - exact(a)), bound * std::ldexp(4.0, k)) << k;
  }
}

TEST(DoubleDouble, OrderIsThatOfTheNumbers) {
  const std::vector<DoubleDouble> all = numbers(3);
  for (const DoubleDouble a : all) {
    for (const DoubleDouble b : all) {
      EXPECT_EQ(a < b, exact(a) < exact(b));
      EXPECT_EQ(a <= b, exact(a) <= exact(b));
      EXPECT_EQ(a == b, exact(a) == exact(b));
    }
    EXPECT_TRUE(a < DoubleDouble(a.high(), a.low() + std::abs(a.high()) * 0x1p-100) || a == 0.0);
  }
}

TEST(DoubleDouble, TheLowerPartIsSeenByAComparisonWithADouble) {
  EXPECT_TRUE(DoubleDouble(1.0, 0x1p-80) > 1.0);
  EXPECT_TRUE(DoubleDouble(1.0, -0x1p-80) < 1.0);
  EXPECT_FALSE(DoubleDouble(1.0, 0x1p-80) == 1.0);
}

TEST(DoubleDouble, ChangesIntoHighAndBackWithoutALoss) {
  for (const DoubleDouble a : numbers(4)) {
    EXPECT_EQ(as<High>(a), exact(a));
    EXPECT_TRUE(as<DoubleDouble>(as<High>(a)) == a);
  }
  const High third = High(1) / 3;
  EXPECT_LE(error_of(as<DoubleDouble>(third), third), bound);
}

TEST(DoubleDouble, WhatLeavesTheRangeIsInfinite) {
  const DoubleDouble large(1e200);
  EXPECT_TRUE(std::isinf(static_cast<double>(large * large)));
  EXPECT_TRUE(std::isinf(static_cast<double>(std::numeric_limits<DoubleDouble>::infinity() + 1.0)));
}

}  // namespace
}  // namespace dobra::offset
