#pragma once
// The operation `join`.

#include "recon/input/join.h"
#include "recon/model/model.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Pieces of horizons of the section as it is now, joined: the section that the next steps stand on.
base::Result<model::Model> run_join(const model::Model& model, const input::JoinParams& params,
                                    const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities join.joined, join.widest_gap; table joins.
dobra::scenario::Operation join_step();

}  // namespace recon::core
