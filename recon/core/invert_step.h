#pragma once
// The operation `invert`.

#include "recon/inversion/invert.h"
#include "recon/model/model.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// What was found, with the section that it was found from.
struct FoundKinematics {
  section::Section section;
  inversion::Inversion inversion;
};

/// The kinematics of a fold of the section as it is now; the section stays.
/// @error those of inversion::invert().
base::Result<model::Model> run_invert(const model::Model& model, const inversion::InvertParams& params,
                                      const dobra::scenario::Context& context, const base::Progress& progress);

dobra::scenario::Operation invert_step();

}  // namespace recon::core
