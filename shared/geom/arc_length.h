#pragma once
// Length of a curve from the size of its derivative.

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace dobra::geom {

/// Integral of speed(t) from t0 to t1 (negative if t1 < t0): Gauss's rule with 15 points, halving a range until both
/// halves agree with it to 1e-13 of the whole, 30 times at most (a cusp).  @cost some 45 evaluations of speed where it
/// is smooth.
template <class Speed>
double arc_length(const Speed& speed, double t0, double t1) {
  using Rule = boost::math::quadrature::gauss<double, 15>;
  const double first = Rule::integrate(speed, t0, t1);
  const double enough = 1e-13 * std::abs(first);
  const auto refine = [&](const auto& self, double a, double b, double coarse, int depth) -> double {
    const double middle = 0.5 * (a + b);
    const double left = Rule::integrate(speed, a, middle);
    const double right = Rule::integrate(speed, middle, b);
    if (depth == 0 || std::abs(left + right - coarse) <= enough) return left + right;
    return self(self, a, middle, left, depth - 1) + self(self, middle, b, right, depth - 1);
  };
  return t0 == t1 ? 0.0 : refine(refine, t0, t1, first, 30);
}

}  // namespace dobra::geom
