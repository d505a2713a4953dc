#pragma once
// The picture of a model: the deformed section with its grid and, beside it to the same scale, the restored one
// (requirement REC-6).

#include "recon/core/model.h"
#include "shared/scene/layer.h"

namespace recon::core {

/// One panel before the step target, two from then on: side by side, a section that is long and low one above the
/// other. Items of horizon layers have the horizon's id.
dobra::scene::Picture picture_of(const Model& model);

/// The colour of a horizon, the same in every panel; eight are told apart, then they repeat.
dobra::scene::Color horizon_color(HorizonId id);

}  // namespace recon::core
