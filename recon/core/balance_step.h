#pragma once
// The operation `balance`.

#include "recon/balance/area_depth.h"
#include "recon/model/model.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Excess areas, bed lengths and the detachment of the section as it was read.
base::Result<model::Model> run_balance(const model::Model& model, const balance::BalanceParams& params,
                                       const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities: bed.NAME.* (the columns of the table area_depth), layer.NAME.isogon_index, bed_inconsistency_percent,
/// displacement, detachment; of three levels or more displacement_error, detachment_error, r_squared.
dobra::scenario::Operation balance_step();

}  // namespace recon::core
