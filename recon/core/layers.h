#pragma once
// The picture of a model: the deformed section with its grid and, beside it and to the same scale, the restored
// section.

#include "recon/core/model.h"
#include "shared/scene/layer.h"

namespace recon::core {

/// One panel before the step target, two from then on, arranged so that both are as large as can be on a sheet. Items
/// of horizon layers have the horizon's id. Drawn by the section's table of colours where it has one.
void draw(const Model& model, dobra::scene::Picture& picture);

}  // namespace recon::core
