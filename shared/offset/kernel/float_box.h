#pragma once
// Boxes that prune: half the memory of doubles.

#include <algorithm>
#include <limits>

#include "shared/offset/kernel/numbers.h"

namespace dobra::offset {
inline namespace kernel {

/// Rounded outwards.
struct FloatBox {
  float low_x = std::numeric_limits<float>::infinity();
  float low_y = std::numeric_limits<float>::infinity();
  float high_x = -std::numeric_limits<float>::infinity();
  float high_y = -std::numeric_limits<float>::infinity();

  /// @param margin  added on all sides.
  FloatBox() = default;
  FloatBox(Flat low, Flat high, double margin)
      : low_x(below(low.x - margin)),
        low_y(below(low.y - margin)),
        high_x(above(high.x + margin)),
        high_y(above(high.y + margin)) {}
  void add(const FloatBox& other) {  // by value: no branch, which nothing could predict
    low_x = other.low_x < low_x ? other.low_x : low_x;
    low_y = other.low_y < low_y ? other.low_y : low_y;
    high_x = other.high_x > high_x ? other.high_x : high_x;
    high_y = other.high_y > high_y ? other.high_y : high_y;
  }
  [[nodiscard]] bool overlaps(const FloatBox& other) const {
    return (low_x <= other.high_x) & (other.low_x <= high_x) & (low_y <= other.high_y) & (other.low_y <= high_y);
  }
  [[nodiscard]] bool empty() const { return low_x > high_x; }
  [[nodiscard]] float size() const { return (high_x - low_x) + (high_y - low_y); }

 private:
  // One step of 2^-23 is at least the rounding of a float; the least normal number stands in for what is below it.
  static float below(double x) { return static_cast<float>(x - std::abs(x) * 1.2e-7 - 1e-37); }
  static float above(double x) { return static_cast<float>(x + std::abs(x) * 1.2e-7 + 1e-37); }
};

}  // namespace kernel
}  // namespace dobra::offset
