#pragma once
// Where a crack turns under K_I and K_II: three criteria. Angles are from the crack's own direction, anticlockwise; a
// positive K_II turns it clockwise. Page: docs/algorithms/crack.md. Source: [erdogan1963], [sih1974], [hussain1974].

#include <cstdint>

#include "shared/base/angle.h"
#include "shared/fem/material.h"

namespace dobra::fem::fracture {

/// Stress intensity factors, Pa sqrt(m).
struct Intensity {
  double one = 0.0;  ///< K_I, positive opens.
  double two = 0.0;  ///< K_II, positive slides the left lip (of travel) ahead.
};

enum class KinkCriterion : std::uint8_t {
  SigmaTheta,  ///< Greatest hoop stress.
  STheta,      ///< Least density of strain energy.
  GTheta,      ///< Greatest energy release of a small kink (Hussain, Pu, Underwood).
};

struct Kink {
  base::Angle angle;
  double equivalent = 0.0;  ///< The K_I that is as severe, Pa sqrt(m).
};

/// @pre the intensity is not zero. Only kinks up to 90 degrees are looked at.
Kink kink_of(KinkCriterion criterion, const Intensity& k, const Material& material);

}  // namespace dobra::fem::fracture
