#pragma once
// Inclined shear over a fault: the hanging wall moves across the direction of shear and slides along it, so that it
// stays on the fault. With q, w across and along the direction and the fault as w = W(q):
//   q' = q + h cos a      w' = w + W(q') - W(q)
// It is the shear of maps/shear_map.h from the fault onto itself. Page: docs/algorithms/rigid_and_shear.md

#include "recon/kinematics/amount.h"
#include "recon/maps/section_map.h"
#include "shared/base/angle.h"

namespace recon::kinematics {

/// @param angle  of the direction of shear from the vertical, + leaning to +x, in (-90, 90) degrees.
/// @param h      m, > 0 to +x; the heave only where the fault is level, or at angle 0.
/// @error CannotRestore where the fault runs along the direction or folds back in it, with the place and the angles at
///        which it does not.
base::Result<maps::SectionMap> shear_over(const FaultPath& path, base::Angle angle, double h);

/// The h that takes the point of the path at `arc` by this much along the fault: exact.
/// @error those of arc_after().
base::Result<double> shear_heave(const FaultPath& path, base::Angle angle, double arc, Amount amount);

}  // namespace recon::kinematics
