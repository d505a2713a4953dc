#pragma once
// Areas of graphs with narrow peaks, ridges and steps over a square of side 6, by integrals along one variable that are
// summed here with many places: nothing of the program is used.

#include <cmath>
#include <numbers>

namespace dobra::support {

/// Simpson's sum.
template <class Function>
double simpson(const Function& f, double from, double to, int parts) {
  const double h = (to - from) / (2 * parts);
  double sum = f(from) + f(to);
  for (int i = 1; i < 2 * parts; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(from + i * h);
  return sum * h / 3.0;
}

/// height exp(-sharp r^2), which is nought at the border: with t = sharp r^2 = s^2 the area above that of the plane is
/// pi / sharp times the integral of sqrt(1 + 4 sharp height^2 t exp(-2 t)) - 1.
inline double peak_area(double height, double sharp) {
  const double c = 4.0 * sharp * height * height;
  const auto more = [c](double s) {
    const double steep = c * s * s * std::exp(-2.0 * s * s);
    return 2.0 * s * steep / (std::sqrt(1.0 + steep) + 1.0);
  };
  return 36.0 + std::numbers::pi / sharp * simpson(more, 0.0, 8.0, 400'000);
}

/// exp(-sharp (x - slope y)^2) for a ridge that leaves by the lower and the upper side.
inline double ridge_area(double sharp, double slope) {
  const auto more = [&](double s) {
    const double by_s = 2.0 * sharp * s * std::exp(-sharp * s * s), steep = by_s * by_s * (1.0 + slope * slope);
    return steep / (std::sqrt(1.0 + steep) + 1.0);
  };
  return 36.0 + 6.0 * 2.0 * simpson(more, 0.0, 8.0 / std::sqrt(sharp), 400'000);
}

/// tanh(sharp x), along y the same.
inline double step_area(double sharp) {
  const auto more = [&](double x) {
    const double c = std::cosh(sharp * x), by_x = sharp / (c * c);
    return by_x * by_x / (std::sqrt(1.0 + by_x * by_x) + 1.0);
  };
  return 36.0 + 6.0 * 2.0 * simpson(more, 0.0, 40.0 / sharp, 400'000);
}

/// log(x) from x = low to high, for a width along y.
inline double logarithm_area(double low, double high, double width) {
  const auto length = [](double x) { return std::sqrt(1.0 + x * x) - std::asinh(1.0 / x); };
  return width * (length(high) - length(low));
}

}  // namespace dobra::support
