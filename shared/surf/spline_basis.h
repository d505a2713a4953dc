#pragma once
// The B-spline functions of a knot vector, with their derivatives. Page: docs/algorithms/surfaces.md.
// Source: [piegl1997].

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "shared/base/result.h"

namespace dobra::surf {

/// Knots that do not decrease, degree + 1 times the first and the last or not (a spline on the range between).
class SplineBasis {
 public:
  static constexpr std::size_t highest_degree = 15;

  /// @param called  what the messages call the knots: "knots_u".
  /// @error InvalidOption: a degree outside 1 .. 15, fewer than 2 (degree + 1) knots, knots that decrease or stand more
  ///        than degree + 1 times, an empty range; NotFinite. Each names the knot, counted from 1.
  static base::Result<SplineBasis> make(std::size_t degree, std::vector<double> knots, const std::string& called);

  [[nodiscard]] std::size_t degree() const { return degree_; }
  /// How many functions, and so control points, there are.
  [[nodiscard]] std::size_t count() const { return knots_.size() - degree_ - 1; }
  [[nodiscard]] std::span<const double> knots() const { return knots_; }
  [[nodiscard]] double low() const { return knots_[degree_]; }
  [[nodiscard]] double high() const { return knots_[count()]; }
  /// The knots inside the range, each once, with both ends: between two of them all derivatives are continuous.
  [[nodiscard]] std::vector<double> breaks() const;

  /// Where a knot inside stands degree + 1 times a spline may jump, from the control value i - 1 to i: these i.
  [[nodiscard]] std::vector<std::size_t> jumps() const;

  /// The parts of a range that lie between two knots each; a range outside 0 is of the end piece.
  [[nodiscard]] std::vector<std::pair<double, double>> pieces(double from, double to) const;
  /// Bezier's control values over a range between two knots, of control value `first` on: value i is the sum of
  /// [i][j] times control value first + j.
  struct ToBezier {
    std::size_t first = 0;
    std::array<std::array<double, highest_degree + 1>, highest_degree + 1> of{};
  };
  /// @pre from < to, of one element of pieces().  @cost O(degree^4)
  [[nodiscard]] ToBezier bezier(double from, double to) const;

  /// The functions that are not zero at a parameter, from number `first` on, with two derivatives.
  struct Values {
    std::size_t first = 0;
    std::array<std::array<double, highest_degree + 1>, 3> of{};  ///< [derivative][function - first]
  };
  /// From the right at a knot inside (from the left: of the double before it), from the left at the last. Beyond the
  /// range the end pieces go on.
  /// @cost O(degree^2 + log knots)
  [[nodiscard]] Values at(double t) const;

  /// The same for a degree that is known, without room for more.
  template <std::size_t degree>
  struct Few {
    std::size_t first = 0;
    std::array<std::array<double, degree + 1>, 3> of;  // NOLINT: all of it is written
  };
  /// @pre 2 <= degree = degree()
  template <std::size_t degree>
  [[nodiscard]] Few<degree> few(double t) const {
    const std::size_t span = span_of(t);
    const double* const knots = &knots_[span - degree];
    // Functions of degree j are sums of parts of those of degree j - 1; derivatives are differences of these parts.
    std::array<double, degree + 1> value;  // NOLINT: so below
    std::array<double, degree> part, first, below;
    value[0] = 1.0;
    for (std::size_t j = 1; j <= degree; ++j) {
      double saved = 0.0;
      for (std::size_t r = 0; r < j; ++r) {
        const double low = knots[degree + 1 + r - j], high = knots[degree + 1 + r];
        part[r] = value[r] / (high - low);
        value[r] = saved + (high - t) * part[r];
        saved = (t - low) * part[r];
      }
      value[j] = saved;
      if (j + 1 != degree) continue;
      for (std::size_t r = 0; r < degree; ++r)
        below[r] = static_cast<double>(j) * ((r > 0 ? part[r - 1] : 0.0) - (r < j ? part[r] : 0.0));
    }
    for (std::size_t r = 0; r < degree; ++r) first[r] = below[r] / (knots[degree + 1 + r] - knots[r + 1]);
    Few<degree> few;
    few.first = span - degree;
    few.of[0] = value;
    for (std::size_t r = 0; r <= degree; ++r) {
      few.of[1][r] = static_cast<double>(degree) * ((r > 0 ? part[r - 1] : 0.0) - (r < degree ? part[r] : 0.0));
      few.of[2][r] = static_cast<double>(degree) * ((r > 0 ? first[r - 1] : 0.0) - (r < degree ? first[r] : 0.0));
    }
    return few;
  }

 private:
  SplineBasis(std::size_t degree, std::vector<double> knots) : degree_(degree), knots_(std::move(knots)) {}
  /// The knot at which the piece that holds a parameter begins.
  [[nodiscard]] std::size_t span_of(double t) const;
  std::size_t degree_;
  std::vector<double> knots_;
};

}  // namespace dobra::surf
