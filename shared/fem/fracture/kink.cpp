#include "shared/fem/fracture/kink.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace dobra::fem::fracture {
namespace {

using std::numbers::pi;

/// The slope of f, to rounding: an imaginary step takes no difference.
template <class F>
double slope(const F& f, double t) {
  constexpr double step = 1e-30;
  return f(std::complex<double>(t, step)).imag() / step;
}

/// The first t from 0 to 90 degrees where f has a hill: a scan, then bisection of its slope (values alone would tell
/// the place of a flat extreme to half of the digits). Not the highest: in plane stress the energy density of pure
/// opening is least at 90 degrees, but its minimum ahead of the tip is meant.
template <class F>
double first_hill(const F& f) {
  constexpr int steps = 360;
  constexpr double end = 0.5 * pi;
  int best = 0;
  const auto value = [&](int i) { return f(std::complex<double>(end * i / steps)).real(); };
  while (best < steps && value(best + 1) > value(best)) ++best;
  double low = end * std::max(best - 1, 0) / steps;
  double high = end * std::min(best + 1, steps) / steps;
  for (double middle = 0.5 * (low + high); low < middle && middle < high; middle = 0.5 * (low + high)) {
    (slope(f, middle) > 0.0 ? low : high) = middle;
  }
  return low;
}

double sigma_theta_angle(double one, double two) {
  if (two == 0.0) return 0.0;
  // 2 atan of the root of K_I sin t + K_II (3 cos t - 1) = 0 that K_II drives away from; written without cancellation.
  const double magnitude = std::hypot(one, std::sqrt(8.0) * two);
  return 2.0 * std::atan(one >= 0.0 ? -2.0 * two / (one + magnitude) : (one - magnitude) / (4.0 * two));
}

/// 16 pi mu S at a positive angle against a positive K_II (the kink is on the other side of x).
template <class T>
T energy_density(T t, double one, double two, double kappa) {
  const T c = std::cos(t);
  const T s = -std::sin(t);
  return (1.0 + c) * (kappa - c) * one * one + 2.0 * s * (2.0 * c - kappa + 1.0) * one * two +
         ((kappa + 1.0) * (1.0 - c) + (1.0 + c) * (3.0 * c - 1.0)) * two * two;
}

/// E' G at a positive angle against a positive K_II.
template <class T>
T energy_release(T t, double one, double two) {
  const T c = std::cos(t);
  const T s = std::sin(t);
  const T first = 1.0 / (3.0 + c * c);
  return 4.0 * first * first * std::exp(t / pi * std::log((1.0 - t / pi) / (1.0 + t / pi))) *
         ((1.0 + 3.0 * c * c) * one * one + 8.0 * s * c * one * two + (9.0 - 5.0 * c * c) * two * two);
}

}  // namespace

Kink kink_of(KinkCriterion criterion, const Intensity& k, const Material& material) {
  const double two = std::abs(k.two);
  const double side = k.two > 0.0 ? -1.0 : 1.0;
  const double kappa = kolosov(material);
  switch (criterion) {
    case KinkCriterion::SigmaTheta: {
      const double t = sigma_theta_angle(k.one, k.two);
      const double h = std::cos(0.5 * t);
      return {base::Angle::from_radians(t), h * (k.one * h * h - 1.5 * k.two * std::sin(t))};
    }
    case KinkCriterion::STheta: {
      const double t =
          two == 0.0 ? 0.0 : first_hill([&](std::complex<double> a) { return -energy_density(a, k.one, two, kappa); });
      return {base::Angle::from_radians(side * t),
              std::sqrt(energy_density(t, k.one, two, kappa) / (2.0 * (kappa - 1.0)))};
    }
    case KinkCriterion::GTheta: {
      const double t =
          two == 0.0 ? 0.0 : first_hill([&](std::complex<double> a) { return energy_release(a, k.one, two); });
      return {base::Angle::from_radians(side * t), std::sqrt(energy_release(t, k.one, two))};
    }
  }
  return {};
}

}  // namespace dobra::fem::fracture
