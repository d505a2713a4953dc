#include "shared/operations/offset_step.h"

#include "recon/core/model.h"
#include "recon/core/report.h"
#include "recon/core/steps.h"

namespace recon::core {

namespace {

/// Of the section in hand.
std::vector<dobra::io::Feature> lines_of(const Model& model) { return restored_features(model.section); }

std::size_t state_of(const Model& model) { return model.earlier.size(); }

}  // namespace

dobra::scenario::Operation offset_step() { return dobra::operations::offset_operation<Model, lines_of, state_of>(); }

}  // namespace recon::core
