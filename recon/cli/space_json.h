#pragma once
// Surfaces and cut sections as `recon surface` and `recon cut` print them.

#include <nlohmann/json.hpp>
#include <string>

#include "recon/model/model.h"

namespace recon::cli {

nlohmann::ordered_json surfaces_json(const model::Model& model);
std::string surfaces_table(const model::Model& model);
nlohmann::ordered_json cut_json(const model::Model& model);
std::string cut_table(const model::Model& model);

}  // namespace recon::cli
