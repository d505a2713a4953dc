#pragma once
// A bend of a fault that beds of constant thickness pass. Page: docs/algorithms/fault_bend_fold.md.
// Source: [suppe1983].

#include "shared/base/angle.h"
#include "shared/base/result.h"

namespace recon {
namespace base = dobra::base;
}

namespace recon::kinematics {

struct BendFold {
  base::Angle theta;  ///< Cutoff: from the segment before the bend to the beds, > 0 if the fault climbs through them.
  base::Angle phi;    ///< How much flatter the fault is behind the bend; negative: steeper.
  base::Angle gamma;  ///< From the beds before the bend to the axial plane.
  base::Angle beta;   ///< Cutoff behind the bend.
  double slip_ratio = 1.0;  ///< Slip behind the bend a metre of slip before it.
};

/// What follows from the three angles that make a bend: beta = theta - phi + 180 degrees - 2 gamma, R.
BendFold bend_with(base::Angle theta, base::Angle phi, base::Angle gamma);

/// cot(gamma - theta + phi) = cot(gamma - theta) - 2 cot(gamma), the root with the greater gamma: the fold is open.
/// @param theta  in [0, 90) degrees; 0: beds along the segment before the bend.
/// @error CannotRestore: no gamma; the message says the greatest phi at this theta. Without a place.
base::Result<BendFold> bend_fold(base::Angle theta, base::Angle phi);

/// From a ramp to a flat, theta = phi:  tan gamma = (1 + sqrt(1 - 3 tan^2 theta)) / tan theta.
/// @error CannotRestore: theta is no more than 0, or more than 30 degrees. Without a place.
base::Result<BendFold> step_up(base::Angle theta);

}  // namespace recon::kinematics
