#pragma once
// What a model tells in numbers, tables, remarks and files.

#include <memory>
#include <string>
#include <vector>

#include "recon/core/model.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Quantities that expectations refer to:
///   horizon.NAME.length_before                     always
///   grid.curves, .rungs, .vanished, .deepest, .last_distance         after grid
///   target.curves, .extended; columns                               after target
///   horizon.NAME.* and top.* (the columns of the table line_length), shortening, shortening_percent, points,
///   points_outside, points_beyond_ends, points_not_reversible, tears, torn, greatest_change_percent, balanced (0 or 1)
///   after restore
std::vector<dobra::scenario::Quantity> quantities_of(const Model& model);

/// line_length, after restore.
std::vector<dobra::scenario::DataTable> tables_of(const Model& model);

std::vector<std::string> remarks_of(const Model& model);

/// source_grid.geojson, target_grid.geojson, restored.geojson, restored.csv: as far as the model has them.
std::vector<dobra::scenario::Output> outputs_of(const std::shared_ptr<const Model>& model);

}  // namespace recon::core
