#pragma once
// The operation `area_balance`.

#include "recon/balance/area_balance.h"
#include "recon/model/model.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Shortening from the area of a polygon with errors.
base::Result<model::Model> run_area_balance(const model::Model& model, const balance::AreaBalanceParams& params,
                                            const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities: area, initial_width, width, area_shortening, area_shortening_percent and their _error, _most.
dobra::scenario::Operation area_balance_step();

}  // namespace recon::core
