#pragma once
// Everything that a user can do to a section, listed once: the window, the command line, scenarios and tests call these
// entries.

#include "recon/core/grid.h"
#include "recon/core/model.h"
#include "recon/core/restore.h"
#include "recon/core/target.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Source grid on the top of the current section: what is restored becomes an earlier stage, and the restored section
/// that of a new one. What was not restored yet is forgotten.
/// @error those of make_source_grid and section_after.
base::Result<Model> run_grid(const Model& model, const GridParams& params, const dobra::scenario::Context& context,
                             const base::Progress& progress);
/// Target geometry and target grid. @error CannotRestore without a grid.
base::Result<Model> run_target(const Model& model, const TargetParams& params, const dobra::scenario::Context& context,
                               const base::Progress& progress);
/// Restored section and line-length table. @error CannotRestore without grid and target.
base::Result<Model> run_restore(const Model& model, const RestoreParams& params,
                                const dobra::scenario::Context& context, const base::Progress& progress);

/// Points, lines and polygons from one state of the chain to another. @error CannotRestore without a restoration.
base::Result<Model> run_carry(const Model& model, const CarryParams& params, const dobra::scenario::Context& context,
                              const base::Progress& progress);

/// Excess areas, bed lengths and the detachment of the section as it was read.
base::Result<Model> run_balance(const Model& model, const BalanceParams& params,
                                const dobra::scenario::Context& context, const base::Progress& progress);
/// Shortening from the area of a polygon with errors.
base::Result<Model> run_area_balance(const Model& model, const AreaBalanceParams& params,
                                     const dobra::scenario::Context& context, const base::Progress& progress);
/// Error bars of the restoration. @error CannotRestore without one.
base::Result<Model> run_monte_carlo(const Model& model, const MonteCarloParams& params,
                                    const dobra::scenario::Context& context, const base::Progress& progress);

/// RECON, as the shared machinery sees it. Quantities that expectations refer to:
///   horizon.NAME.length_before, section.area, section.units_area (their sum), section.misfits   always
///   grid.curves, .rungs, .vanished, .deepest, .last_distance         after grid
///   target.curves, .extended; columns                               after target
///   horizon.NAME.* and top.* (the columns of the table line_length), shortening, shortening_percent, points,
///   points_outside, points_beyond_ends, points_not_reversible, tears, torn, greatest_change_percent,
///   greatest_area_change_percent, inconsistency_percent, lean_left, lean_right, balanced (0 or 1; not judged: none),
///   unit.NAME.* (the columns of the table units), of pieces too     after restore
///   error.QUANTITY.mean, .deviation, .low, .median, .high; error.failed, error.balanced_share   after monte_carlo
///   bed.NAME.* (the columns of the table area_depth), displacement, detachment; of three levels or more
///   displacement_error, detachment_error, r_squared                 after balance
///   stages (earlier ones), since_input.horizon.NAME.change_percent, since_input.unit.NAME.change_percent,
///   since_input.balanced                                            from the second stage on
///   area, initial_width, width, area_shortening, area_shortening_percent and their _error, _most   after area_balance
const dobra::scenario::Program& program();

}  // namespace recon::core
