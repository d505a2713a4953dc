#include "shared/fem/error/exact_fields.h"

#include <cmath>

#include "shared/base/check.h"

namespace dobra::fem::error {
namespace {

using geom::Point;
using geom::Vector;
using std::numbers::pi;

/// {xx, yy, xy} of axes turned by -angle: from local to global components.
Voigt turned(const Voigt& s, double angle) {
  const double c = std::cos(angle);
  const double n = std::sin(angle);
  return {c * c * s[0] + n * n * s[1] - 2 * c * n * s[2], n * n * s[0] + c * c * s[1] + 2 * c * n * s[2],
          c * n * (s[0] - s[1]) + (c * c - n * n) * s[2]};
}

}  // namespace

Voigt kirsch_stress(Point at, double radius, double tension) {
  const double r2 = at.x * at.x + at.y * at.y;
  const double q = radius * radius / r2;
  const double c2 = (at.x * at.x - at.y * at.y) / r2;
  const double s2 = 2.0 * at.x * at.y / r2;
  const double c4 = c2 * c2 - s2 * s2;
  const double s4 = 2.0 * s2 * c2;
  return {tension * (1.0 - q * (1.5 * c2 + c4) + 1.5 * q * q * c4), tension * (-q * (0.5 * c2 - c4) - 1.5 * q * q * c4),
          tension * (-q * (0.5 * s2 + s4) + 1.5 * q * q * s4)};
}

double corner_exponent(base::Angle interior, CornerMode mode) {
  const double w = interior.radians();
  const double sign = mode == CornerMode::Opening ? 1.0 : -1.0;
  const auto f = [&](double l) { return std::sin(l * w) + sign * l * std::sin(w); };
  // lambda = 1, a rotation, is a root of the second equation that means nothing.
  double low = (mode == CornerMode::Opening ? 0.5 : 1.0) * pi / w;
  double high = std::min(1.0 - 1e-9, 1.5 * pi / w);
  if (f(low) * f(high) >= 0.0) return 1.0;
  for (int i = 0; i < 200 && high - low > 1e-16; ++i) {
    const double middle = 0.5 * (low + high);
    (f(low) * f(middle) <= 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

Voigt l_corner_stress(Point at, base::Angle bisector) {
  constexpr double l = 0.544483736782464;
  constexpr double q = 0.543075578836737;
  const double r = std::hypot(at.x, at.y);
  double t = std::atan2(at.y, at.x) - bisector.radians();
  t -= 2.0 * pi * std::round(t / (2.0 * pi));
  const double f = l * std::pow(r, l - 1.0);
  const double a = std::cos((l - 1.0) * t);
  const double b = (l - 1.0) * std::cos((l - 3.0) * t);
  const Voigt local{f * ((2.0 - q * (l + 1.0)) * a - b), f * ((2.0 + q * (l + 1.0)) * a + b),
                    f * ((l - 1.0) * std::sin((l - 3.0) * t) + q * (l + 1.0) * std::sin((l - 1.0) * t))};
  return turned(local, bisector.radians());
}

Vector tip_displacement(Point at, TipLoad mode, const Material& material) {
  const double r = std::hypot(at.x, at.y);
  const double t = std::atan2(at.y, at.x);
  const double kappa = kolosov(material);
  const double factor = std::sqrt(r / (2.0 * pi)) / (2.0 * shear_modulus(material));
  if (mode == TipLoad::Opening) return factor * (kappa - std::cos(t)) * Vector{std::cos(0.5 * t), std::sin(0.5 * t)};
  DOBRA_CHECK(mode == TipLoad::Sliding);
  return factor *
         Vector{std::sin(0.5 * t) * (kappa + 2.0 + std::cos(t)), -std::cos(0.5 * t) * (kappa - 2.0 + std::cos(t))};
}

TipField tip_field(Point at, TipLoad load, const Material& material) {
  const double r = std::hypot(at.x, at.y);
  const double t = std::atan2(at.y, at.x);
  const double c = std::cos(t);
  const double s = std::sin(t);
  const double kappa = kolosov(material);
  const double mu = shear_modulus(material);
  Vector by_r;      // derivative in r
  Vector by_theta;  // derivative in theta, divided by r
  if (load == TipLoad::Force) {
    const double factor = 1.0 / (8.0 * pi * mu * r);
    by_r = {-factor * (kappa + 1.0), 0.0};
    by_theta = {-factor * 2.0 * std::sin(2.0 * t), -factor * (kappa - 1.0 - 2.0 * std::cos(2.0 * t))};
  } else {
    by_r = 0.5 / r * tip_displacement(at, load, material);
    const double factor = std::sqrt(r / (2.0 * pi)) / (2.0 * mu * r);
    const double ch = std::cos(0.5 * t);
    const double sh = std::sin(0.5 * t);
    by_theta = load == TipLoad::Opening
                   ? factor * Vector{-0.5 * sh * (kappa - c) + ch * s, 0.5 * ch * (kappa - c) + sh * s}
                   : factor * Vector{0.5 * ch * (kappa + 2.0 + c) - sh * s, 0.5 * sh * (kappa - 2.0 + c) + ch * s};
  }
  TipField field;
  field.gradient = {c * by_r.x - s * by_theta.x, s * by_r.x + c * by_theta.x, c * by_r.y - s * by_theta.y,
                    s * by_r.y + c * by_theta.y};
  field.stress = stress_of(elasticity(material), strain_of(field.gradient));
  return field;
}

}  // namespace dobra::fem::error
