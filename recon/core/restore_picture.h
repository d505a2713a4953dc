#pragma once
// The picture of a restored section, with its ledger.

#include "recon/model/model.h"
#include "shared/scene/layer.h"

namespace recon::core {

/// The section before and after, each with its grid, to the same scale and arranged so that both are as large as can be
/// on a sheet; the balance ledger as tables, what the method keeps and the verdict as notes. Nothing where the model is
/// not restored.
void draw_restored(const model::Model& model, dobra::scene::Picture& picture);

}  // namespace recon::core
