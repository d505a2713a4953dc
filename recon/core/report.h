#pragma once
// What a model tells in numbers, tables, remarks and files.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recon/core/model.h"
#include "shared/io/feature.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Quantities that expectations refer to:
///   horizon.NAME.length_before, section.area, section.units_area (their sum), section.misfits   always
///   grid.curves, .rungs, .vanished, .deepest, .last_distance         after grid
///   target.curves, .extended; columns                               after target
///   horizon.NAME.* and top.* (the columns of the table line_length), shortening, shortening_percent, points,
///   points_outside, points_beyond_ends, points_not_reversible, tears, torn, greatest_change_percent,
///   greatest_area_change_percent, inconsistency_percent, lean_left, lean_right, balanced (0 or 1),
///   unit.NAME.* (the columns of the table units), of pieces too     after restore
///   error.QUANTITY.mean, .deviation, .low, .median, .high; error.failed, error.balanced_share   after monte_carlo
///   bed.NAME.* (the columns of the table area_depth), displacement, detachment; of three levels or more
///   displacement_error, detachment_error, r_squared                 after balance
///   stages (earlier ones), since_input.horizon.NAME.change_percent, since_input.unit.NAME.change_percent
///                                                                   of the second stage on
///   area, initial_width, width, area_shortening, area_shortening_percent and their _error, _most   after area_balance
std::vector<dobra::scenario::Quantity> quantities_of(const Model& model);

/// line_length, horizons_in_pieces (their sums), units, strain after restore; error_bars after monte_carlo; area_depth
/// after balance; carried after carry; stages from the second stage on.
std::vector<dobra::scenario::DataTable> tables_of(const Model& model);

std::vector<std::string> remarks_of(const Model& model);

/// The rows of the ledger, one a unit: polygons that are pieces of one are summed.  @pre the model is restored.
std::vector<UnitRow> unit_rows(const Model& model);

/// The names, values and units of a row, in the order of its table's columns; nothing where there is no value.
struct RowCell {
  const char* name;
  const char* unit;
  std::optional<double> value;
};
std::vector<RowCell> cells_of(const UnitRow& row);
std::vector<RowCell> cells_of(const BedBalance& row);
std::vector<RowCell> cells_of(const LineLength& row);
std::vector<RowCell> cells_of(const AreaDepthFit& fit);

/// All lines, polygons and points of a section with their names, kinds and ids, but for those of no length.
std::vector<dobra::io::Feature> restored_features(const Section& section);

/// source_grid.geojson, target_grid.geojson, restored.geojson, restored.csv, carried.geojson: as far as the model has them.
std::vector<dobra::scenario::Output> outputs_of(const std::shared_ptr<const Model>& model);

}  // namespace recon::core
