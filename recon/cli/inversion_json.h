#pragma once
// Kinematics from beds as JSON, and as a table to read.

#include <string>

#include "recon/core/model.h"

namespace recon::cli {

/// @pre the model has been inverted.
std::string inversion_json(const core::Model& model);
std::string inversion_table(const core::Model& model);

}  // namespace recon::cli
