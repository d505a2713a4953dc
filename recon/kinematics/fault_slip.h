#pragma once
// Flexural slip in the hanging wall: its beds slide over each other along the parallels of the fault, as they do in
// unfolding (docs/algorithms/flexural_slip.md). Points move as in fault-parallel flow; a horizon can be laid out with
// its own length on top of that (maps::ColumnMap::lay). Page: docs/algorithms/fault_flow.md

#include "recon/kinematics/fault_path.h"
#include "recon/maps/map.h"

namespace recon::kinematics {

/// @param slip  m, along the path.
/// @return the map of the columns of the path, the hanging wall on their right-hand side (depth > 0); its pin lies
/// where
///         the fault goes on straight behind the moving block.
/// @error CannotRestore where the fault turns back on itself, with the place.
base::Result<maps::ColumnMap> flexural_slip(const FaultPath& path, double slip);

}  // namespace recon::kinematics
