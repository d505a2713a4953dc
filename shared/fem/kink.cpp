#include "shared/fem/kink.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace dobra::fem {
namespace {

constexpr double pi = std::numbers::pi;

/// The first t from 0 to 90 degrees where f has a hill: a scan, then golden section to 1e-10. Not the highest: in plane
/// stress the energy density of pure opening is least at 90 degrees, but its minimum ahead of the tip is meant.
double first_hill(const std::function<double(double)>& f) {
  constexpr int steps = 360;
  constexpr double end = 0.5 * pi;
  int best = 0;
  while (best < steps && f(end * (best + 1) / steps) > f(end * best / steps)) ++best;
  double low = end * std::max(best - 1, 0) / steps;
  double high = end * std::min(best + 1, steps) / steps;
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  while (high - low > 1e-10) {
    const double a = high - ratio * (high - low);
    const double b = low + ratio * (high - low);
    (f(a) < f(b) ? low : high) = f(a) < f(b) ? a : b;
  }
  return 0.5 * (low + high);
}

double sigma_theta_angle(double one, double two) {
  if (two == 0.0) return 0.0;
  // 2 atan of the root of K_I sin t + K_II (3 cos t - 1) = 0 that K_II drives away from; written without cancellation.
  const double magnitude = std::hypot(one, std::sqrt(8.0) * two);
  return 2.0 * std::atan(one >= 0.0 ? -2.0 * two / (one + magnitude) : (one - magnitude) / (4.0 * two));
}

/// 16 pi mu S at a positive angle against a positive K_II (the kink is on the other side of x).
double energy_density(double t, double one, double two, double kappa) {
  const double c = std::cos(t);
  const double s = -std::sin(t);
  return (1 + c) * (kappa - c) * one * one + 2.0 * s * (2 * c - kappa + 1) * one * two +
         ((kappa + 1) * (1 - c) + (1 + c) * (3 * c - 1)) * two * two;
}

/// E' G at a positive angle against a positive K_II.
double energy_release(double t, double one, double two) {
  const double c = std::cos(t);
  const double s = std::sin(t);
  const double first = 1.0 / (3.0 + c * c);
  return 4.0 * first * first * std::pow((1 - t / pi) / (1 + t / pi), t / pi) *
         ((1 + 3 * c * c) * one * one + 8 * s * c * one * two + (9 - 5 * c * c) * two * two);
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
      const double t = two == 0.0 ? 0.0 : first_hill([&](double a) { return -energy_density(a, k.one, two, kappa); });
      return {base::Angle::from_radians(side * t),
              std::sqrt(energy_density(t, k.one, two, kappa) / (2.0 * (kappa - 1.0)))};
    }
    case KinkCriterion::GTheta: {
      const double t = two == 0.0 ? 0.0 : first_hill([&](double a) { return energy_release(a, k.one, two); });
      return {base::Angle::from_radians(side * t), std::sqrt(energy_release(t, k.one, two))};
    }
  }
  return {};
}

}  // namespace dobra::fem
