#pragma once
// The operation `carry`.

#include "recon/core/carry.h"
#include "recon/core/model.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Points, lines and polygons from one state of the chain to another. @error CannotRestore without a restoration.
base::Result<Model> run_carry(const Model& model, const CarryParams& params, const dobra::scenario::Context& context,
                              const base::Progress& progress);

dobra::scenario::Operation carry_step();

}  // namespace recon::core
