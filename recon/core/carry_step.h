#pragma once
// The operation `carry`.

#include "recon/model/carry.h"
#include "recon/model/model.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Points, lines and polygons from one state of the chain to another. @error CannotRestore without a restoration.
base::Result<model::Model> run_carry(const model::Model& model, const model::CarryParams& params,
                                     const dobra::scenario::Context& context, const base::Progress& progress);

dobra::scenario::Operation carry_step();

}  // namespace recon::core
