#pragma once
// Numbers of 106 bits as unevaluated sums of two doubles, for compilers whose long double is a double (real.h). Sums,
// products, quotients and roots are wrong by less than 2^-100 of the result, where neither it nor the squares of what
// it is made of leave the range of doubles. Source: [joldes2017doubleword].

#include <cmath>
#include <concepts>
#include <limits>

namespace dobra::offset {
inline namespace kernel {

class DoubleDouble {
 public:
  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double x) : high_(x) {}  // NOLINT: a double is one
  template <std::floating_point F>
  explicit constexpr DoubleDouble(F x)
      : high_(static_cast<double>(x)), low_(static_cast<double>(x - static_cast<F>(high_))) {}
  /// @pre |low| is at most half a unit in the last place of high
  constexpr DoubleDouble(double high, double low) : high_(high), low_(low) {}
  [[nodiscard]] constexpr double high() const { return high_; }
  [[nodiscard]] constexpr double low() const { return low_; }
  template <std::floating_point F>
  explicit constexpr operator F() const {
    return static_cast<F>(high_) + static_cast<F>(low_);
  }

  friend DoubleDouble operator-(DoubleDouble a) { return {-a.high_, -a.low_}; }
  friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble high = sum(a.high_, b.high_);
    const DoubleDouble low = sum(a.low_, b.low_);
    const DoubleDouble first = quick_sum(high.high_, high.low_ + low.high_);
    return quick_sum(first.high_, low.low_ + first.low_);
  }
  friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }
  friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const double high = a.high_ * b.high_;
    const double error = std::fma(a.high_, b.high_, -high);
    const double low = std::fma(a.low_, b.high_, std::fma(a.high_, b.low_, a.low_ * b.low_));
    return quick_sum(high, error + low);
  }
  friend DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double first = a.high_ / b.high_;
    if (!std::isfinite(first)) return first;
    const DoubleDouble rest = a - b * first;
    const double second = rest.high_ / b.high_;
    const double third = (rest - b * second).high_ / b.high_;
    return quick_sum(first, second) + third;
  }
  DoubleDouble& operator+=(DoubleDouble b) { return *this = *this + b; }
  DoubleDouble& operator-=(DoubleDouble b) { return *this = *this - b; }
  DoubleDouble& operator*=(DoubleDouble b) { return *this = *this * b; }
  friend DoubleDouble abs(DoubleDouble a) { return a.high_ < 0 || (a.high_ == 0 && a.low_ < 0) ? -a : a; }
  /// By one step of Newton's from the root in doubles.
  friend DoubleDouble sqrt(DoubleDouble a) {
    if (!(a.high_ > 0)) return std::sqrt(a.high_);
    const double first = std::sqrt(a.high_);
    const double square = first * first;
    const DoubleDouble rest = a - DoubleDouble(square, std::fma(first, first, -square));
    return quick_sum(first, rest.high_ / (2 * first));
  }

  friend constexpr bool operator==(DoubleDouble a, DoubleDouble b) { return a.high_ == b.high_ && a.low_ == b.low_; }
  friend constexpr bool operator<(DoubleDouble a, DoubleDouble b) {
    return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
  }
  friend constexpr bool operator>(DoubleDouble a, DoubleDouble b) { return b < a; }
  friend constexpr bool operator<=(DoubleDouble a, DoubleDouble b) { return a < b || a == b; }
  friend constexpr bool operator>=(DoubleDouble a, DoubleDouble b) { return b <= a; }

 private:
  /// Exactly a + b.
  static DoubleDouble sum(double a, double b) {
    const double high = a + b;
    const double other = high - a;
    return {high, (a - (high - other)) + (b - other)};
  }
  /// The same where |a| >= |b| or a is 0. What leaves the range of doubles has no lower half.
  static DoubleDouble quick_sum(double a, double b) {
    if (!std::isfinite(a)) return a;
    const double high = a + b;
    const double low = b - (high - a);
    return {high, std::isfinite(high) ? low : 0};
  }
  double high_ = 0;
  double low_ = 0;
};

}  // namespace kernel
}  // namespace dobra::offset

template <>
class std::numeric_limits<dobra::offset::DoubleDouble> : public std::numeric_limits<double> {
 public:
  static constexpr int digits = 106;
  static constexpr dobra::offset::DoubleDouble infinity() { return std::numeric_limits<double>::infinity(); }
};
