#pragma once
// Numbers for the decisions that Real leaves in doubt. 256 bits hold every product of coordinates' differences, and D
// carries a perturbation of 2^-100: far below what input and output can say, far above the error. So all coincidences
// that depend on D fall as if D were a little greater (offset.h), and what is still equal here is equal for every D:
// parts of the base that coincide.

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "shared/offset/kernel/numbers.h"

namespace dobra::offset {
inline namespace kernel {

using High =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<256, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;

/// By Newton's method from 64 bits, several times as fast as the library's, which finds bit after bit.
template <>
inline High root<High>(const High& x) {
  if (!(x > 0)) return 0;
  const int half = ilogb(x) / 2;
  const High scaled = ldexp(x, -2 * half);
  High inverse = 1 / std::sqrt(static_cast<long double>(scaled));
  for (int k = 0; k < 2; ++k) inverse = ldexp(High(inverse * (3 - scaled * inverse * inverse)), -1);  // 126, 250 bits
  const High found = scaled * inverse;
  return ldexp(High(found + ldexp(High((scaled - found * found) * inverse), -1)), half);
}

/// What one rounding and its company may do, of the greatest coordinate.
template <class T>
inline constexpr double resolution = 0;
template <>
inline constexpr double resolution<Real> = 0x1p-60;
template <>
inline constexpr double resolution<High> = 0x1p-245;

/// The distance with its perturbation, where it can be told.
template <class T>
T distance_as(double d) {
  return d;
}
template <>
inline High distance_as<High>(double d) {
  return High(d) + ldexp(High(d), -100);
}

template <class T, class S>
T as(const S& x) {
  if constexpr (std::is_same_v<S, DoubleDouble> && std::is_same_v<T, High>) {
    return High(x.high()) + x.low();
  } else if constexpr (std::is_same_v<S, High> && std::is_same_v<T, DoubleDouble>) {
    const auto high = static_cast<double>(x);
    return {high, static_cast<double>(High(x - high))};
  } else {
    return static_cast<T>(x);
  }
}
template <class T, class S>
VecOf<T> as(const VecOf<S>& a) {
  return {as<T>(a.x), as<T>(a.y)};
}

}  // namespace kernel
}  // namespace dobra::offset
