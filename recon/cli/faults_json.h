#pragma once
// What the sub-command `faults` prints.

#include <string>

#include "recon/model/model.h"

namespace recon::cli {

/// {"tolerance", "faults": [{"name", "order"?, "hanging_wall", "sense", "ends", "cutoffs": [{"horizon", "hanging_wall",
/// "footwall", "separation", "throw", "heave", "gap", "overlap", "distance", "mark"?}]}], "blocks": [{"name", "area",
/// "faults", "part_of"?}], "remarks"}. A missing wall, and what it leaves unmeasured, is null.
std::string faults_json(const model::Model& model);
std::string faults_table(const model::Model& model);

}  // namespace recon::cli
