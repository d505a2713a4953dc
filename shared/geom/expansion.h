#pragma once
// Exact arithmetic on sums of doubles. An expansion is a sum of doubles of increasing magnitude whose bits do not
// overlap; sums, differences and products of expansions are expansions again, without any rounding. Zero terms are
// dropped, so that the cost follows the bits that are really there.
//
// Exact while no term overflows or underflows: see in_expansion_range(). Source: [shewchuk1997predicates], sections 2.3
// to 2.5 (linear expansion sum, scale expansion): they ask of their operands only that terms do not overlap, which
// every function here also delivers.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "shared/geom/predicates.h"

namespace dobra::geom {

/// high + low, exactly; high is the sum (product) rounded to nearest.
struct TwoTerms {
  double high;
  double low;
};

/// a + b.
inline TwoTerms two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  return {sum, (a - (sum - b_part)) + (b - b_part)};
}

/// a + b.  @pre |a| >= |b| or a == 0.
inline TwoTerms fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a * b.
inline TwoTerms two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// True if expansions of polynomials up to degree 4 in values like this one neither overflow nor underflow.
inline bool in_expansion_range(double value) {
  const double size = std::abs(value);
  return size == 0.0 || (size >= 0x1p-200 && size <= 0x1p200);
}

/// An expansion of at most `Capacity` terms.
template <std::size_t Capacity>
class Expansion {
 public:
  Expansion() = default;  // zero; the array stays uninitialised on purpose, only size_ terms are ever read
  explicit Expansion(double value) { append(value); }
  explicit Expansion(TwoTerms terms) {
    append(terms.low);
    append(terms.high);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double operator[](std::size_t i) const { return terms_[i]; }
  /// The next larger term; zeros are left out.  @pre does not overlap the terms before it.
  void append(double term) {
    if (term != 0.0) terms_[size_++] = term;
  }
  [[nodiscard]] Sign sign() const { return size_ == 0 ? Sign::Zero : sign_of(terms_[size_ - 1]); }
  /// The value with a relative error of a few units in the last place.
  [[nodiscard]] double estimate() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < size_; ++i) sum += terms_[i];
    return sum;
  }
  void clear() { size_ = 0; }
  [[nodiscard]] Expansion operator-() const {
    Expansion negated;
    for (std::size_t i = 0; i < size_; ++i) negated.append(-terms_[i]);
    return negated;
  }

 private:
  std::array<double, Capacity> terms_;
  std::size_t size_ = 0;
};

/// a - b.
inline Expansion<2> difference(double a, double b) { return Expansion<2>(two_sum(a, -b)); }

/// Linear expansion sum: O(m + n).
template <std::size_t M, std::size_t N>
Expansion<M + N> operator+(const Expansion<M>& e, const Expansion<N>& f) {
  Expansion<M + N> sum;
  std::size_t i = 0;
  std::size_t j = 0;
  const auto next_by_magnitude = [&] {
    if (j == f.size() || (i < e.size() && std::abs(e[i]) < std::abs(f[j]))) return e[i++];
    return f[j++];
  };
  const std::size_t count = e.size() + f.size();
  if (count == 0) return sum;
  if (count == 1) {
    sum.append(next_by_magnitude());
    return sum;
  }
  const double smallest = next_by_magnitude();
  TwoTerms total = fast_two_sum(next_by_magnitude(), smallest);
  for (std::size_t k = 2; k < count; ++k) {
    const TwoTerms carried = fast_two_sum(next_by_magnitude(), total.low);
    sum.append(carried.low);
    total = two_sum(total.high, carried.high);
  }
  sum.append(total.low);
  sum.append(total.high);
  return sum;
}

template <std::size_t M, std::size_t N>
Expansion<M + N> operator-(const Expansion<M>& e, const Expansion<N>& f) {
  return e + (-f);
}

/// Scale expansion: O(n).
template <std::size_t N>
Expansion<2 * N> operator*(const Expansion<N>& e, double factor) {
  Expansion<2 * N> scaled;
  if (e.size() == 0 || factor == 0.0) return scaled;
  TwoTerms product = two_product(e[0], factor);
  scaled.append(product.low);
  double carry = product.high;
  for (std::size_t i = 1; i < e.size(); ++i) {
    product = two_product(e[i], factor);
    const TwoTerms low = two_sum(carry, product.low);
    scaled.append(low.low);
    const TwoTerms high = fast_two_sum(product.high, low.high);
    scaled.append(high.low);
    carry = high.high;
  }
  scaled.append(carry);
  return scaled;
}

/// O(m n^2) for n terms of f, so put the shorter operand second.
template <std::size_t M, std::size_t N>
Expansion<2 * M * N> operator*(const Expansion<M>& e, const Expansion<N>& f) {
  Expansion<2 * M * N> product;
  for (std::size_t j = 0; j < f.size(); ++j) {
    const auto sum = product + e * f[j];
    product.clear();
    for (std::size_t k = 0; k < sum.size(); ++k) product.append(sum[k]);
  }
  return product;
}

/// numerator / denominator rounded once to the nearest double, ties to even.
/// @pre denominator is not zero; the quotient is neither huge nor subnormal.
template <std::size_t M, std::size_t N>
double rounded_quotient(const Expansion<M>& numerator, const Expansion<N>& denominator) {
  if (numerator.sign() == Sign::Zero) return 0.0;
  double quotient = numerator.estimate() / denominator.estimate();
  quotient += (numerator - denominator * quotient).estimate() / denominator.estimate();
  // The correction above leaves at most the wrong one of two neighbours; the midpoint between them decides.
  const auto remainder = numerator - denominator * quotient;
  const Sign direction = remainder.sign() * denominator.sign();
  if (direction == Sign::Zero) return quotient;
  const double infinity = std::numeric_limits<double>::infinity();
  const double neighbour = std::nextafter(quotient, direction == Sign::Positive ? infinity : -infinity);
  const double half_gap = 0.5 * (neighbour - quotient);
  const Sign beyond = (remainder - denominator * half_gap).sign() * denominator.sign() * direction;
  const bool quotient_is_even = (std::bit_cast<std::uint64_t>(quotient) & 1U) == 0;
  return beyond == Sign::Negative || (beyond == Sign::Zero && quotient_is_even) ? quotient : neighbour;
}

}  // namespace dobra::geom
