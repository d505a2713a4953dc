#pragma once
// What the sub-command `move` prints.

#include <string>

#include "recon/cli/ledger_json.h"

namespace recon::cli {

/// {"method", "fault", "direction", "slip", "blocks", "misfit": [{"horizon", "along", "gap", "overlap"}], "gap_area",
/// "overlap_area", "figures", "tip", "remarks"} and, with geometry, "moved" (what moved, by piece) and "pieces" (of the
/// whole section).  @pre the stage in hand is moved
std::string move_json(const model::Model& model, Geometry geometry);
std::string move_table(const model::Model& model);

}  // namespace recon::cli
