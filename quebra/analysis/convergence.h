#pragma once
// How the error falls from cycle to cycle of the adaptive loop, as a curve. Page: docs/algorithms/estimate.md

#include "quebra/model/model.h"
#include "shared/scene/layer.h"

namespace quebra::analysis {

/// Estimated error against unknowns, logarithms of both to one scale, so that slopes are true: N^(-p/2), the best that
/// elements of order p can do, stands beside it. All analyses of the model count, in their order.
/// @pre the model has an analysis whose error is above 0
dobra::scene::Picture convergence_picture(const model::Model& model);

}  // namespace quebra::analysis
