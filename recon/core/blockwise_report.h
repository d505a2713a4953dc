#pragma once
// What a restoration block by block tells of itself: numbers, tables and its picture.

#include "recon/core/report.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Quantities: horizon.NAME.*, unit.NAME.* (the columns of their tables), block.NAME.shift, fault.NAME.gap_area,
/// overlap_area, dip_restored, shortening, width_before, width_after, shortening, shortening_percent,
/// shortening_by_folding, greatest_change_percent, greatest_area_change_percent, inconsistency_percent,
/// greatest_opening_percent, balanced (0 or 1; not judged: none). Nothing of other models, as of all below.
void add_blockwise_quantities(const Model& model, std::vector<dobra::scenario::Quantity>& quantities);
/// line_length, units, restored_blocks; of a jigsaw restored_faults.
void add_blockwise_tables(const Model& model, std::vector<dobra::scenario::DataTable>& tables);

/// Both states to one scale, blocks in colours.
void draw_blockwise(const Model& model, dobra::scene::Picture& picture);

}  // namespace recon::core
