#pragma once
// The operation `restore`.

#include "recon/jigsaw/restore_params.h"
#include "recon/model/model.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Restored section and balance ledger. @error CannotRestore without grid and target.
base::Result<model::Model> run_restore(const model::Model& model, const unfold::RestoreParams& params,
                                       const dobra::scenario::Context& context, const base::Progress& progress);

/// The same, or block by block, which needs neither grid nor target and is a stage of its own.
base::Result<model::Model> run_restore_step(const model::Model& model, const jigsaw::RestoreStepParams& params,
                                            const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities: horizon.NAME.* and top.* (the columns of the table line_length), shortening, shortening_percent, points,
/// points_outside, points_beyond_ends, points_not_reversible, tears, torn, greatest_change_percent,
/// greatest_area_change_percent, inconsistency_percent, lean_left, lean_right, balanced (0 or 1; not judged: none),
/// unit.NAME.* (the columns of the table units), of pieces too.
/// Block by block: horizon.NAME.*, unit.NAME.*, block.NAME.shift, greatest_change_percent and so on, balanced; of a
/// jigsaw also fault.NAME.gap_area, overlap_area, dip_restored and shortening, width_before, width_after, shortening,
/// shortening_percent, shortening_by_folding, greatest_opening_percent.
dobra::scenario::Operation restore_step();

}  // namespace recon::core
