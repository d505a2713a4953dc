#pragma once
// Findings with their places as JSON, where a run was refused too.

#include <nlohmann/json.hpp>
#include <vector>

#include "shared/base/finding.h"
#include "shared/scenario/units.h"

namespace dobra::cli {

/// [{"code", "message", "place"}]; a place is {"item", "file", "line", "point": [x, y, z], "uv": [u, v]} with the parts
/// that are known, or null.
nlohmann::ordered_json findings_json(const std::vector<base::Finding>& findings, const scenario::UnitSystem& units);
base::Finding finding_of(const base::Error& error);

}  // namespace dobra::cli
