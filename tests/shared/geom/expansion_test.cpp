#include "shared/geom/expansion.h"

#include <gtest/gtest.h>

#include "shared/geom/product_sum.h"
#include "tests/shared/geom/exact.h"

namespace dobra::geom {
namespace {

using namespace testing;

template <std::size_t N>
Rational value(const Expansion<N>& e) {
  Rational sum = 0;
  for (std::size_t i = 0; i < e.size(); ++i) sum += Rational(e[i]);
  return sum;
}

/// Terms of an expansion grow and their bits do not overlap.
template <std::size_t N>
bool well_formed(const Expansion<N>& e) {
  for (std::size_t i = 0; i + 1 < e.size(); ++i) {
    // The least bit of the larger term must be above the whole of the smaller one.
    int power = 0;
    const double mantissa = std::frexp(std::abs(e[i + 1]), &power);
    const auto integer = static_cast<std::uint64_t>(std::ldexp(mantissa, 53));
    const double least_bit = std::ldexp(1.0, power - 53 + std::countr_zero(integer));
    if (e[i] == 0.0 || std::abs(e[i]) >= least_bit) return false;
  }
  return true;
}

Expansion<8> random_expansion(std::mt19937_64& random) {
  const auto a = difference(random_double(random, -40, 40), random_double(random, -40, 40));
  const auto b = difference(random_double(random, -40, 40), random_double(random, -40, 40));
  return a * b;
}

TEST(Expansion, SumsDifferencesAndProductsAreExactAndDoNotOverlap) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 1000; ++i) {
    const auto e = random_expansion(random);
    const auto f = random_expansion(random);
    ASSERT_EQ(value(e + f), value(e) + value(f));
    ASSERT_EQ(value(e - f), value(e) - value(f));
    ASSERT_EQ(value(e * f), value(e) * value(f));
    ASSERT_EQ(value(e * f[0]), value(e) * Rational(f[0]));
    ASSERT_TRUE(well_formed(e) && well_formed(e + f) && well_formed(e - f) && well_formed(e * f));
    ASSERT_EQ((e - f).sign(), sign_of(Rational(value(e) - value(f))));
    ASSERT_NEAR((e * f).estimate() / static_cast<double>(value(e * f)), 1.0, 1e-15);
  }
}

TEST(Expansion, TermsThatCancelLeaveNothing) {
  std::mt19937_64 random(12);
  const auto e = random_expansion(random);
  EXPECT_EQ((e - e).size(), 0U);
  EXPECT_EQ((e - e).sign(), Sign::Zero);
  EXPECT_EQ((e * (e - e)).size(), 0U);
  EXPECT_EQ(difference(3.0, 1.0).size(), 1U);  // exact differences cost one term
}

TEST(Expansion, QuotientIsTheNearestDouble) {
  std::mt19937_64 random(13);
  for (int i = 0; i < 1000; ++i) {
    const auto e = random_expansion(random);
    const auto f = random_expansion(random);
    const double quotient = rounded_quotient(e, f);
    const Rational exact_quotient = value(e) / value(f);
    const Rational error = abs(Rational(exact_quotient - Rational(quotient)));
    for (const int step : {-1, 1}) {
      const double other = moved_by_ulps(quotient, step);
      ASSERT_LE(error, abs(Rational(exact_quotient - Rational(other)))) << quotient;
    }
  }
}

TEST(Expansion, QuotientHalfwayBetweenDoublesGoesToTheEvenOne) {
  const auto halfway = [](double low) {  // low + half an ulp of 1, over 3
    return rounded_quotient(Expansion<2>(two_sum(low, 0x1p-53)) * 3.0, Expansion<1>(3.0));
  };
  EXPECT_EQ(halfway(1.0), 1.0);
  EXPECT_EQ(halfway(1.0 + 0x1p-52), 1.0 + 0x1p-51);
}

TEST(ProductSum, SignAgreesWithRationalsOverTheWholeRangeOfDoubles) {
  std::mt19937_64 random(14);
  for (int i = 0; i < 300; ++i) {
    ProductSum sum;
    Rational exact_sum = 0;
    for (int j = 0; j < 6; ++j) {
      const Point p = random_point(random, -1074, 1023);
      const Point q = random_point(random, -1074, 1023);
      sum.add(Sign::Negative, {p.x, p.y, q.x, q.y});
      exact_sum -= Rational(p.x) * Rational(p.y) * Rational(q.x) * Rational(q.y);
    }
    ASSERT_EQ(sum.sign(), sign_of(exact_sum));
  }
}

TEST(ProductSum, ExtremeProductsCancelToZero) {
  const double greatest = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  ProductSum sum;
  sum.add(Sign::Positive, {greatest, greatest, greatest, -greatest});
  sum.add(Sign::Positive, {least, least, least, least});
  EXPECT_EQ(sum.sign(), Sign::Negative);
  sum.add(Sign::Positive, {greatest, greatest, greatest, greatest});
  EXPECT_EQ(sum.sign(), Sign::Positive);
  sum.add(Sign::Negative, {least, least, -least, -least});
  EXPECT_EQ(sum.sign(), Sign::Zero);
}

}  // namespace
}  // namespace dobra::geom
