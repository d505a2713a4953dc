#pragma once
// Exact numbers m * 2^e with whole m of any length: sums, differences and products of doubles without rounding. What
// the filters of space.h leave open is decided with them. Page: docs/algorithms/boolean.md.

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

#include "shared/geom/predicates.h"

namespace dobra::solid {

class Dyadic {
 public:
  /// Numbers of up to 512 bits need no memory of their own.
  using Whole = boost::multiprecision::number<
      boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                             boost::multiprecision::unchecked,
                                             std::allocator<boost::multiprecision::limb_type>>,
      boost::multiprecision::et_off>;

  Dyadic() = default;
  /// @pre value is finite.
  explicit Dyadic(double value) {
    if (value == 0.0) return;
    int power = 0;
    auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &power), 53));
    const int zeros = __builtin_ctzll(static_cast<std::uint64_t>(mantissa));
    mantissa /= std::int64_t{1} << zeros;
    whole_ = mantissa;
    exponent_ = power - 53 + zeros;
  }

  [[nodiscard]] geom::Sign sign() const { return static_cast<geom::Sign>(whole_.sign()); }
  [[nodiscard]] bool zero() const { return whole_.is_zero(); }
  [[nodiscard]] const Whole& whole() const { return whole_; }
  [[nodiscard]] int exponent() const { return exponent_; }

  friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
    Dyadic product;
    product.whole_ = a.whole_ * b.whole_;
    product.exponent_ = a.exponent_ + b.exponent_;
    return product;
  }
  friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
    if (a.zero()) return b;
    if (b.zero()) return a;
    const Dyadic& fine = a.exponent_ <= b.exponent_ ? a : b;
    const Dyadic& coarse = a.exponent_ <= b.exponent_ ? b : a;
    Dyadic sum = fine;
    if (fine.exponent_ == coarse.exponent_) {
      sum.whole_ += coarse.whole_;
    } else {
      sum.whole_ += coarse.whole_ << static_cast<unsigned>(coarse.exponent_ - fine.exponent_);
    }
    return sum;
  }
  Dyadic operator-() const {
    Dyadic negated = *this;
    negated.whole_ = -negated.whole_;
    return negated;
  }
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + (-b); }
  Dyadic& operator+=(const Dyadic& other) { return *this = *this + other; }

 private:
  Whole whole_ = 0;
  int exponent_ = 0;
};

/// numerator / denominator rounded once, to the nearest double, ties to even.  @pre denominator is not zero; the
/// quotient is neither huge nor subnormal.
inline double rounded_quotient(const Dyadic& numerator, const Dyadic& denominator) {
  using boost::multiprecision::msb;
  if (numerator.zero()) return 0.0;
  Dyadic::Whole top = abs(numerator.whole());
  Dyadic::Whole bottom = abs(denominator.whole());
  // 62 to 63 bits of the quotient; whatever is left over goes into the last of them, far below the half of a unit.
  const int shift = 62 - (static_cast<int>(msb(top)) - static_cast<int>(msb(bottom)));
  if (shift > 0) top <<= static_cast<unsigned>(shift);
  if (shift < 0) bottom <<= static_cast<unsigned>(-shift);
  Dyadic::Whole quotient;
  Dyadic::Whole rest;
  divide_qr(top, bottom, quotient, rest);
  auto bits = static_cast<std::int64_t>(quotient);
  if (!rest.is_zero()) bits |= 1;
  const double size = std::ldexp(static_cast<double>(bits), numerator.exponent() - denominator.exponent() - shift);
  return numerator.sign() == denominator.sign() ? size : -size;
}
inline double rounded(const Dyadic& value) { return rounded_quotient(value, Dyadic(1.0)); }

/// A vector of space, exact.
using Dyadic3 = std::array<Dyadic, 3>;

inline Dyadic dot(const Dyadic3& a, const Dyadic3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Dyadic3 cross(const Dyadic3& a, const Dyadic3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Dyadic3 operator-(const Dyadic3& a, const Dyadic3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Dyadic3 operator+(const Dyadic3& a, const Dyadic3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Dyadic3 operator*(const Dyadic3& a, const Dyadic& f) { return {a[0] * f, a[1] * f, a[2] * f}; }

}  // namespace dobra::solid
