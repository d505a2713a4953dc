#pragma once
// Formulas that a user writes as text, such as "3 * (1 - x^2) + sin(pi * y)": read once, evaluated at many places.
// Numbers, the names given, pi and e; + - * / ^ (to the right, before the sign: -x^2 = -(x^2)), < <= > >= (1 or 0),
// a ? b : c, brackets; sin cos tan asin acos atan sinh cosh tanh exp log log10 sqrt cbrt abs sign floor, atan2 hypot pow
// min max of two. Angles are radians.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shared/base/result.h"

namespace dobra::base {

class Formula {
 public:
  /// @param names  what stands for the values of `at`, in their order.
  /// @error BadValue with the column (from 1) of what cannot be read; a name that is not known comes with a suggestion.
  static Result<Formula> make(const std::string& text, std::span<const std::string> names);

  /// The value where the names have these values; not finite where the formula is not defined.
  /// @cost O(length of the text), no allocation
  [[nodiscard]] double at(std::span<const double> values) const;

  struct Step {
    enum class Kind : std::uint8_t { Number, Name, One, Two, SkipUnless, Skip } kind = Kind::Number;
    double number = 0.0;
    std::size_t target = 0;  ///< Of a name its position, of a function its number, of a skip the step to go on with.
  };

 private:
  std::vector<Step> steps_;  ///< In postfix order.
};

}  // namespace dobra::base
