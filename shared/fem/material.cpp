#include "shared/fem/material.h"

#include <fmt/format.h>

#include <cmath>

#include "shared/base/text.h"
#include "shared/fem/mixed.h"

namespace dobra::fem {

base::Result<void> check(const Material& material, const std::string& name) {
  const auto wrong = [&](const std::string& message) {
    return base::Error{base::ErrorCode::InvalidOption, message, base::Place{.item = name}};
  };
  const auto& [young, poisson, thickness, state] = material;
  if (!(young > 0.0) || !std::isfinite(young))
    return wrong(fmt::format("Young's modulus is {}; it must be positive", base::number_text(young)));
  if (!(thickness > 0.0) || !std::isfinite(thickness))
    return wrong(fmt::format("the thickness is {}; it must be positive", base::number_text(thickness)));
  if (state == PlaneState::Strain && !(poisson > -1.0 && poisson <= most_poisson))
    return wrong(fmt::format(
        "Poisson's ratio is {}; plane strain needs -1 < nu <= {} (an incompressible material cannot be analysed "
        "by displacements)",
        base::number_text(poisson), most_poisson));
  if (state == PlaneState::Stress && !(poisson > -1.0 && poisson <= 0.5))
    return wrong(fmt::format("Poisson's ratio is {}; it must be above -1 and at most 0.5", base::number_text(poisson)));
  return {};
}

Elasticity elasticity(const Material& material) {
  const double e = material.young;
  const double nu = material.poisson;
  const double shear = shear_modulus(material);
  if (material.state == PlaneState::Stress) return {e / (1.0 - nu * nu), nu * e / (1.0 - nu * nu), shear};
  const double factor = e / ((1.0 + nu) * (1.0 - 2.0 * nu));
  return {factor * (1.0 - nu), factor * nu, shear};
}

Voigt stress_of(const Elasticity& d, const Voigt& strain) {
  return {d.xx * strain[0] + d.xy * strain[1], d.xy * strain[0] + d.xx * strain[1], d.shear * strain[2]};
}

Voigt strain_of(const Elasticity& d, const Voigt& stress) {
  // xx + xy and xx - xy are the eigenvalues of the normal block; their difference is 2 mu, without cancellation.
  const double mean = 0.5 * (stress[0] + stress[1]) / (d.xx + d.xy);
  const double half = 0.5 * (stress[0] - stress[1]) / (2.0 * d.shear);
  return {mean + half, mean - half, stress[2] / d.shear};
}

double energy_product(const Elasticity& d, const Voigt& a, const Voigt& b) {
  const Voigt strain = strain_of(d, b);
  return a[0] * strain[0] + a[1] * strain[1] + a[2] * strain[2];
}

double shear_modulus(const Material& material) { return material.young / (2.0 * (1.0 + material.poisson)); }

double kolosov(const Material& material) {
  const double nu = material.poisson;
  return material.state == PlaneState::Strain ? 3.0 - 4.0 * nu : (3.0 - nu) / (1.0 + nu);
}

double effective_modulus(const Material& material) {
  const double nu = material.poisson;
  return material.state == PlaneState::Strain ? material.young / (1.0 - nu * nu) : material.young;
}

Principal principal(const Voigt& stress) {
  const double mean = 0.5 * (stress[0] + stress[1]);
  const double half = 0.5 * (stress[0] - stress[1]);
  const double radius = std::hypot(half, stress[2]);
  return {mean + radius, mean - radius, radius > 0.0 ? 0.5 * std::atan2(stress[2], half) : 0.0};
}

double von_mises(const Voigt& stress, const Material& material) {
  const auto [x, y, xy] = stress;
  const double z = material.state == PlaneState::Strain ? material.poisson * (x + y) : 0.0;
  return std::sqrt(0.5 * ((x - y) * (x - y) + (y - z) * (y - z) + (z - x) * (z - x)) + 3.0 * xy * xy);
}

}  // namespace dobra::fem
