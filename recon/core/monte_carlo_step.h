#pragma once
// The operation `monte_carlo`.

#include "recon/model/model.h"
#include "recon/unfold/monte_carlo.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Error bars of the restoration. @error CannotRestore without one.
base::Result<model::Model> run_monte_carlo(const model::Model& model, const unfold::MonteCarloParams& params,
                                           const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities: error.QUANTITY.mean, .deviation, .low, .median, .high; error.failed, error.balanced_share.
dobra::scenario::Operation monte_carlo_step();

}  // namespace recon::core
