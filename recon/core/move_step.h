#pragma once
// The operation `move`.

#include "recon/model/model.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Blocks of the section as it is now moved along a fault: a stage of its own.
/// @error those of next_stage() and moving::move_block().
base::Result<model::Model> run_move(const model::Model& model, const moving::MoveParams& params,
                                    const dobra::scenario::Context& context, const base::Progress& progress);

dobra::scenario::Operation move_step();

}  // namespace recon::core
