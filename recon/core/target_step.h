#pragma once
// The operation `target`.

#include "recon/model/model.h"
#include "recon/unfold/target.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Target geometry and target grid. @error CannotRestore without a grid.
base::Result<model::Model> run_target(const model::Model& model, const unfold::TargetParams& params,
                                      const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities: target.curves, .extended; columns.
dobra::scenario::Operation target_step();

}  // namespace recon::core
