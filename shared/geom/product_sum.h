#pragma once
// Exact sign of a sum of products of up to four doubles of any finite size, by a fixed-point number wide enough for all
// of them. Slow (about a microsecond); used only where expansions could overflow or underflow. Source:
// [kulisch2013accumulator].

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "shared/geom/predicates.h"

namespace dobra::geom {

class ProductSum {
 public:
  /// Adds sign * the product of the factors.  @pre 1 to 4 finite factors; fewer than 2^30 calls.
  void add(Sign sign, std::initializer_list<double> factors) {
    std::array<std::uint64_t, 8> digits{1};  // base 2^32
    int exponent = 0;
    for (const double factor : factors) {
      if (factor == 0.0) return;
      int power = 0;
      const double mantissa = std::frexp(std::abs(factor), &power);
      if (factor < 0.0) sign = -sign;
      multiply(digits, static_cast<std::uint64_t>(std::ldexp(mantissa, mantissa_bits)));
      exponent += power - mantissa_bits;
    }
    const auto position = static_cast<std::size_t>(exponent - least_exponent);
    multiply(digits, std::uint64_t{1} << (position % 32));
    for (std::size_t i = 0; i < digits.size(); ++i) {
      limbs_[position / 32 + i] += static_cast<int>(sign) * static_cast<std::int64_t>(digits[i]);
    }
  }

  [[nodiscard]] Sign sign() const {
    std::int64_t carry = 0;
    bool any = false;
    for (const std::int64_t limb : limbs_) {
      const std::int64_t value = limb + carry;
      any = any || (value & digit_mask) != 0;
      carry = value >> 32;  // rounds down, so that what stays is a digit in [0, 2^32)
    }
    if (carry < 0) return Sign::Negative;
    return any || carry > 0 ? Sign::Positive : Sign::Zero;
  }

 private:
  static constexpr int mantissa_bits = 53;
  static constexpr int least_exponent = -4 * 1126;  // of four subnormal factors, each a 53-bit integer times 2^-1126
  static constexpr std::int64_t digit_mask = 0xffffffff;

  /// digits *= factor, for factor < 2^53 (in two halves, so that no step overflows 64 bits).
  static void multiply(std::array<std::uint64_t, 8>& digits, std::uint64_t factor) {
    const std::uint64_t low = factor & 0xffffffffU;
    const std::uint64_t high = factor >> 32;
    std::uint64_t carry = 0;
    std::uint64_t below = 0;
    for (std::uint64_t& digit : digits) {
      const std::uint64_t own = digit;
      const std::uint64_t low_part = own * low;
      const std::uint64_t high_part = below * high;
      const std::uint64_t sum = (low_part & 0xffffffffU) + (high_part & 0xffffffffU) + (carry & 0xffffffffU);
      carry = (low_part >> 32) + (high_part >> 32) + (carry >> 32) + (sum >> 32);
      digit = sum & 0xffffffffU;
      below = own;
    }
  }

  std::array<std::int64_t, (4 * (1126 + 1024)) / 32 + 9> limbs_{};
};

}  // namespace dobra::geom
