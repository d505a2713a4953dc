#pragma once
// The operation `predict`.

#include "recon/inversion/predict.h"
#include "recon/model/model.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// What was predicted, with the section that it was predicted from.
struct FoundPrediction {
  section::Section section;
  inversion::Predicted predicted;
};

/// From the section as it is now; the section stays.  @error those of inversion::predict().
base::Result<model::Model> run_predict(const model::Model& model, const inversion::PredictParams& params,
                                       const dobra::scenario::Context& context, const base::Progress& progress);

dobra::scenario::Operation predict_step();

}  // namespace recon::core
