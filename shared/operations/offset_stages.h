#pragma once
// The construction of offset curves on the planar subdivision (shared/offset/stepper/stepper.h), stopped after some
// steps: for a look at the work. Curve after curve, distance after distance, one raw edge a step. Page:
// docs/algorithms/offset.md

#include "shared/operations/offset_families.h"

namespace dobra::operations {

/// Where the construction stands that is at work.
struct OffsetStage {
  std::size_t steps = 0;                     ///< Of all curves.
  std::string curve = {};                    ///< The base,
  double distance = 0.0;                     ///< and the distance.
  std::size_t regions = 0;                   ///< That the last step closed.
  geom::Polyline base_segment = {};          ///< Of the last step,
  geom::Polyline raw_edge = {};              ///< the edge that it inserted,
  std::vector<geom::Polyline> deleted = {};  ///< and what it deleted.
  std::vector<geom::Polyline> so_far = {};
};

struct StagedOffsets {
  std::vector<OffsetFamily> families;  ///< The curves that are done.
  std::optional<OffsetStage> stage;    ///< None where all are.
};

/// The first `plan.stop_after` steps.
/// @pre the plan is for one side, without areas. @error as offset_families
base::Result<StagedOffsets> offset_stages(const OffsetCaller& caller, const std::string& file, const OffsetInput& input,
                                          const OffsetPlan& plan);

}  // namespace dobra::operations
