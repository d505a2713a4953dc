#include "shared/base/short_number.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace dobra::base {

namespace {

constexpr int digits = 10;
constexpr double roundings = 4.0;  ///< Of the last binary place.

}  // namespace

double without_rounding(double value) {
  if (!std::isfinite(value)) return value;
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1);
  double nearest = value;
  std::from_chars(text.data(), end.ptr, nearest);
  const double noise = roundings * std::numeric_limits<double>::epsilon() * std::abs(value);
  return std::abs(nearest - value) <= noise ? nearest : value;
}

}  // namespace dobra::base
