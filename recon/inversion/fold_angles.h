#pragma once
// Angles of fault-related folds from the dips of their limbs, where beds keep their thickness and were level.
// Page: docs/algorithms/rollover.md. Source: [suppe1983], [suppe1990].

#include <optional>
#include <vector>

#include "recon/kinematics/fault_bend_angles.h"
#include "recon/kinematics/propagation_fold.h"

namespace recon::inversion {

/// Dips from the horizontal, > 0; a forelimb above 90 degrees is overturned.
struct LimbDips {
  std::optional<base::Angle> backlimb, forelimb;
};

/// The backlimb lies parallel to the ramp, theta; the forelimb dips 180 degrees - 2 gamma.
/// From one dip, with the fault going on along the beds behind the ramp (phi = theta): of a backlimb two folds, the
/// open one first, which are one at 30 degrees; of a forelimb one. From both dips the bend phi, and one fold.
/// @error BadValue: no dip, or one out of its range; CannotRestore: no fold has it. Without a place.
base::Result<std::vector<kinematics::BendFold>> bend_folds_of(const LimbDips& dips);

struct PropagationFold {
  kinematics::PropagationAngles angles;
  /// Of two dips: the forelimb that goes with the backlimb less the one that is given.
  std::optional<base::Angle> misfit;
};
/// The backlimb lies parallel to the ramp; tan gamma* = 3 tan(theta / 2), and the forelimb dips 180 degrees - 2 gamma*.
/// @error as above.
base::Result<PropagationFold> propagation_fold_of(const LimbDips& dips);

}  // namespace recon::inversion
