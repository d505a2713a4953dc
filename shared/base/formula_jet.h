#pragma once
// Derivatives of formulas of two names: exactly at a place, and bounds of them over a rectangle by interval arithmetic
// [moore2009]. The formula is read a second time, by the grammar of base::Formula. Bounds are proven but for rounding.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "shared/base/result.h"

namespace dobra::base {

struct Range {
  double low = 0.0, high = 0.0;
  [[nodiscard]] double size() const { return low > -high ? high : -low; }  ///< No member is farther from nought.
};

/// A value with its first and second derivatives by x and y.
template <class Number>
struct PlaneJet {
  Number value{}, x{}, y{}, xx{}, xy{}, yy{};
};

class FormulaJet {
 public:
  /// @param names  of x and y.
  /// @error BadValue where the text is no formula; base::Formula says better why.
  static Result<FormulaJet> make(const std::string& text, const std::array<std::string, 2>& names);

  /// Not finite where the formula or one of its derivatives is not.
  [[nodiscard]] PlaneJet<double> at(double x, double y) const;
  /// Bounds over a rectangle; infinite where there are none. At a kink or a jump (abs, min, a choice) those of both
  /// sides count, and that there may be one is told.
  struct Bounds {
    PlaneJet<Range> of;
    bool kink = false;
  };
  [[nodiscard]] Bounds over(Range x, Range y) const;

  /// Where a choice of the formula (abs, sign, floor, min, max, a comparison) that looks at x alone, or at y alone,
  /// changes over, found by halving ranges over which it is not decided until numbers end: each place lies in one of
  /// these ranges, which ascend and are apart.
  struct Changes {
    std::vector<Range> x, y;
  };
  /// @cost some fifty bounds a place. A choice that stays undecided over more than 4096 parts is left out.
  [[nodiscard]] Changes changes(Range x, Range y) const;

  struct Step {
    std::uint8_t operation = 0;
    double number = 0.0;
  };

 private:
  std::vector<Step> steps_;  ///< In the order of a stack machine.
  std::size_t depth_ = 0;    ///< Of its stack.
};

}  // namespace dobra::base
