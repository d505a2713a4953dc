#pragma once
// What `quebra mesh --json` says of surfaces: findings with their places, where a run was refused too.

#include <nlohmann/json.hpp>
#include <vector>

#include "quebra/model/model.h"
#include "shared/base/error.h"

namespace quebra::cli {

/// [{"code", "message", "place"}]; a place is {"item", "file", "line", "point": [x, y, z], "uv": [u, v]} with the parts
/// that are known, or null.
nlohmann::ordered_json findings_json(const std::vector<dobra::surf::mesh::Finding>& findings,
                                     const dobra::scenario::UnitSystem& units);
dobra::surf::mesh::Finding finding_of(const dobra::base::Error& error);

}  // namespace quebra::cli
