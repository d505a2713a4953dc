#include "recon/cli/inversion_commands.h"

#include "recon/cli/inversion_json.h"
#include "recon/cli/one_step.h"
#include "recon/inversion/invert_params.h"
#include "recon/inversion/predict_params.h"

namespace recon::cli {

dobra::cli::Command invert_command() {
  return one_step_command("invert", "Find the kinematics of a fold from the shapes of its beds",
                          dobra::scenario::fields_of<inversion::InvertParams>(), inversion_json, inversion_table);
}

dobra::cli::Command predict_command() {
  return one_step_command("predict",
                          "Predict a fault from a rollover, a rollover over a fault, or the angles of a fold",
                          dobra::scenario::fields_of<inversion::PredictParams>(), prediction_json, prediction_table);
}

}  // namespace recon::cli
