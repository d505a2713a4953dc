#pragma once
// Surfaces and cut sections as `recon surface` and `recon cut` print them.

#include <string>

#include "recon/model/model.h"
#include "shared/base/error.h"

namespace recon::cli {

std::string surfaces_json(const model::Model& model);
std::string surfaces_table(const model::Model& model);
std::string cut_json(const model::Model& model);
std::string cut_table(const model::Model& model);
/// A refusal as findings: no surfaces, and the error with its place.
std::string refusal_json(const base::Error& error);

}  // namespace recon::cli
