#pragma once
// The operation `grid`.

#include "recon/model/model.h"
#include "recon/unfold/grid.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Source grid on the top of the current section: what is restored becomes an earlier stage, and the restored section
/// that of a new one. What was not restored yet is forgotten.
/// @error those of make_source_grid and section_after.
base::Result<model::Model> run_grid(const model::Model& model, const unfold::GridParams& params,
                                    const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities: grid.curves, .rungs, .vanished, .deepest, .last_distance.
dobra::scenario::Operation grid_step();

}  // namespace recon::core
