#pragma once
// What commands that print figures say: the figures, and findings with their places, where a run was refused too.

#include <nlohmann/json.hpp>
#include <vector>

#include "shared/base/error.h"
#include "shared/base/finding.h"
#include "shared/base/result.h"
#include "shared/cli/session.h"
#include "shared/scenario/units.h"

namespace dobra::cli {

/// [{"code", "message", "place"}]; a place is {"item", "file", "line", "point": [x, y, z], "uv": [u, v]} with the parts
/// that are known, or null.
nlohmann::ordered_json findings_json(const std::vector<base::Finding>& findings, const scenario::UnitSystem& units);
base::Finding finding_of(const base::Error& error);

base::Result<void> print_json(const nlohmann::ordered_json& json);
/// With --json, what was refused as the only finding; not where the user stopped the work.
base::Result<void> tell_refusal(Session& session, const base::Error& error);
/// With --json all of it, else its numbers and texts as a table and the findings as notes.
base::Result<void> tell(Session& session, const nlohmann::ordered_json& json,
                        const std::vector<base::Finding>& findings);

}  // namespace dobra::cli
