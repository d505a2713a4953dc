#pragma once
// How far a hanging wall goes, in the measure that is known. > 0 goes towards the fault's higher end, the path's last
// point. Page: docs/algorithms/rigid_and_shear.md

#include "recon/kinematics/fault_path.h"
#include "shared/base/result.h"

namespace recon::kinematics {

enum class Measure {
  Slip,   ///< Along the fault, m.
  Heave,  ///< Horizontal, m.
  Throw,  ///< Vertical, m.
};

struct Amount {
  Measure as = Measure::Slip;
  double value = 0.0;  ///< m
};

/// Arc length of the point of the path that is this amount away from the one at `arc`, along the path. Its ends go on
/// straight.
/// @error CannotRestore with the place where the path turns back in the measure, or never goes so far in it.
/// @cost  O(n)
base::Result<double> arc_after(const FaultPath& path, double arc, Amount amount);

}  // namespace recon::kinematics
