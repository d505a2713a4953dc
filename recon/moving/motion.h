#pragma once
// The map of a method for one amount of slip. Page: docs/algorithms/move.md

#include <string>
#include <utility>
#include <vector>

#include "recon/kinematics/amount.h"
#include "recon/kinematics/block_map.h"
#include "recon/moving/move_params.h"

namespace recon::moving {

struct Motion {
  kinematics::BlockMap map;
  /// Along the fault, m, > 0 raises the hanging wall: where it was measured, on bend and propagation folds on the first
  /// segment of the fault.
  double slip = 0.0;
  std::vector<std::pair<std::string, double>> figures;  ///< What the method found; degrees, m.
  std::vector<std::string> remarks;
};

/// @param path  as it is for the slip: its last point is what S > 0 goes towards.
/// @param arc   where on the path the amount is measured, m.
/// @error CannotRestore: those of the methods, with the place.
base::Result<Motion> make_motion(const kinematics::FaultPath& path, const MoveParams& params, kinematics::Amount amount,
                                 double arc);

/// Whether the method moves a tip, so that it needs no block that faults part from the rest.
bool has_tip(MoveMethod method);

}  // namespace recon::moving
