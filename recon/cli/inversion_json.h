#pragma once
// Kinematics from beds, and predictions, as JSON and as tables to read.

#include <string>

#include "recon/model/model.h"

namespace recon::cli {

/// {"method", "values": [{"name", "unit", "best", "fixed", "low", "high", "limits", "at_limit"}], "confidence",
/// "misfit", "misfit_before", "misfit_region", "points", "independent_points", "beds": [{"name", "points",
/// "misfit_before", "misfit", "dip_restored", "correlation", "correlation_length"}], "map": {"values", "at", "misfit",
/// "region"}, "remarks"}; null where no limit is known.
/// @pre the model has been inverted.
std::string inversion_json(const model::Model& model);
std::string inversion_table(const model::Model& model);

/// {"what", "solutions": [{figure: value}], "lines": [{"kind", "points"}], "remarks"}
/// @pre the model has a prediction.
std::string prediction_json(const model::Model& model);
std::string prediction_table(const model::Model& model);

}  // namespace recon::cli
