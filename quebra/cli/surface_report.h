#pragma once
// What commands on surfaces and solids say: figures, and findings with their places, where a run was refused too.

#include <nlohmann/json.hpp>
#include <vector>

#include "quebra/model/model.h"
#include "shared/base/error.h"
#include "shared/cli/session.h"

namespace quebra::cli {

/// [{"code", "message", "place"}]; a place is {"item", "file", "line", "point": [x, y, z], "uv": [u, v]} with the parts
/// that are known, or null.
nlohmann::ordered_json findings_json(const std::vector<dobra::surf::mesh::Finding>& findings,
                                     const dobra::scenario::UnitSystem& units);
dobra::surf::mesh::Finding finding_of(const dobra::base::Error& error);

dobra::base::Result<void> print_json(const nlohmann::ordered_json& json);
/// With --json, what was refused as the only finding; not where the user stopped the work.
dobra::base::Result<void> tell_refusal(dobra::cli::Session& session, const dobra::base::Error& error);
/// With --json all of it, else its numbers and texts as a table and the findings as notes.
dobra::base::Result<void> tell(dobra::cli::Session& session, const nlohmann::ordered_json& json,
                               const std::vector<dobra::surf::mesh::Finding>& findings);

}  // namespace quebra::cli
