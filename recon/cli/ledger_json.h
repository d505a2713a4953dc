#pragma once
// What the sub-commands print: the ledger of a restoration and the balance of a section, as JSON and as tables.

#include <string>

#include "recon/model/model.h"

namespace recon::cli {

enum class Geometry { Leave, Include };

/// {"method", "percent", "ledger": [...], "verdict", "tolerance_percent", "remarks", ...} and, with geometry,
/// "restored". An entry of a horizon has the area of the layer below it (null for the lowest); polygons are entries of
/// their own.
std::string restoration_json(const model::Model& model, Geometry geometry);
std::string restoration_table(const model::Model& model);

/// {"ledger": [...], "fit", "verdict"} and "area_balance" where there is one.
std::string balance_json(const model::Model& model);
std::string balance_table(const model::Model& model);

}  // namespace recon::cli
