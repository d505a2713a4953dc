#pragma once
// Linear elastic, isotropic materials of plane problems. Stresses and strains are {xx, yy, xy} with the engineering
// shear strain (gamma = 2 epsilon_xy); stresses Pa, positive in tension. Source: [zienkiewicz2000fem].

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "shared/base/result.h"

namespace dobra::fem {

enum class PlaneState : std::uint8_t { Stress, Strain };

/// {xx, yy, xy}
using Voigt = std::array<double, 3>;

struct Material {
  double young = 0.0;      ///< E, Pa, > 0.
  double poisson = 0.0;    ///< nu, above -1; below 0.5 in plane strain, at most 0.5 in plane stress.
  double thickness = 1.0;  ///< m, > 0.
  PlaneState state = PlaneState::Stress;
  friend bool operator==(const Material&, const Material&) = default;
};

/// By the region tags of a mesh.
using Materials = std::map<std::int32_t, Material>;

/// @error InvalidOption with `name` as its item: what is wrong with the material.
base::Result<void> check(const Material& material, const std::string& name);

/// The elasticity matrix of an isotropic plane material: stress = {xx e_x + xy e_y, xy e_x + xx e_y, shear g}.
struct Elasticity {
  double xx = 0.0;     ///< Pa
  double xy = 0.0;     ///< Pa
  double shear = 0.0;  ///< Pa: mu
};
Elasticity elasticity(const Material& material);

Voigt stress_of(const Elasticity& elasticity, const Voigt& strain);
/// The inverse of stress_of.
Voigt strain_of(const Elasticity& elasticity, const Voigt& stress);
/// sigma : D^-1 : sigma, twice the density of energy, J/m3.
double energy_product(const Elasticity& elasticity, const Voigt& a, const Voigt& b);

/// mu = E / (2 (1 + nu)), Pa.
double shear_modulus(const Material& material);
/// Kolosov's constant: 3 - 4 nu (strain), (3 - nu) / (1 + nu) (stress).
double kolosov(const Material& material);
/// E' of K^2 = G E': E / (1 - nu^2) (strain), E (stress), Pa.
double effective_modulus(const Material& material);

struct Principal {
  double greatest = 0.0;  ///< Pa
  double least = 0.0;     ///< Pa
  double angle = 0.0;     ///< Of the greatest, radians anticlockwise from x, in (-pi/2, pi/2].
};
Principal principal(const Voigt& stress);
/// Von Mises, with sigma_z = nu (sigma_x + sigma_y) in plane strain, Pa.
double von_mises(const Voigt& stress, const Material& material);

}  // namespace dobra::fem
