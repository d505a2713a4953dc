#pragma once
// Fault-bend folds of flats and ramps: at every bend slip changes so that beds keep their thickness. What passes a bend
// changes as rock from farther back arrives there, so that the map is a chain of flows, one a stage.
// Page: docs/algorithms/fault_bend_fold.md. Source: [suppe1983].

#include <optional>

#include "recon/kinematics/fault_bend_angles.h"
#include "recon/kinematics/flow_map.h"

namespace recon::kinematics {

/// How a bend is passed between two slips of the first segment.
struct BendStage {
  geom::Point at;  ///< The bend.
  BendFold fold;
  double from = 0.0, to = 0.0;  ///< Slip of the first segment, m.
};

/// @param bedding   direction of the undeformed beds, anticlockwise from +x; nothing: along the first segment.
/// @param from, to  slip of the first segment that the fault has had at the two states, m, >= 0; to < from restores.
/// @return stages by bend, then by slip.
/// @error CannotRestore with the bend: those of bend_fold(), and slip < 0.
base::Result<std::vector<BendStage>> bend_stages(const FaultPath& path, std::optional<base::Angle> bedding, double from,
                                                 double to);

/// The map from one state to the other.  @error those above and of FlowDomains::make().
base::Result<FlowMap> fault_bend_fold(const FaultPath& path, std::optional<base::Angle> bedding, double from,
                                      double to);

}  // namespace recon::kinematics
