#pragma once
// Formulas that a user writes as text, such as "3 * (1 - x^2) + sin(pi * y)": read once, evaluated at many places.
// Numbers, the names given, pi and e; + - * / ^ (before the sign: -x^2 = -(x^2)), < <= > >= == != && ||, a ? b : c,
// brackets; sin cos tan asin acos atan sinh cosh tanh exp log log10 sqrt cbrt abs sign floor, atan2 hypot pow min max
// of two. Angles are radians. Read and evaluated by muParser.

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"

namespace dobra::base {

/// What the user wrote, where the formula is a part of it.
struct FormulaPlace {
  std::string called = "formula";
  std::string whole;      ///< Empty: the formula is all.
  std::size_t begin = 0;  ///< Of the formula in it, bytes.
};

/// Which character of UTF-8 text, from 1, begins at or holds byte `at`, from 0.
std::size_t character_number(std::string_view text, std::size_t at);

class Formula {
 public:
  /// @param names  what stands for the values of `at`, in their order.
  /// @error BadValue with the column (character from 1) of what cannot be read; a name that is not known comes with a
  /// suggestion, or
  ///        with those there are.
  static Result<Formula> make(const std::string& text, std::span<const std::string> names,
                              const FormulaPlace& within = {});

  /// The value where the names have these values; not finite where the formula is not defined. Any number of threads
  /// may ask at once.
  /// @cost O(length of the text)
  [[nodiscard]] double at(std::span<const double> values) const;

 private:
  class Evaluators;
  std::shared_ptr<Evaluators> evaluators_;
};

}  // namespace dobra::base
