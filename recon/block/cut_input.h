#pragma once
// What a scenario's [input] says of blocks: along_strike and cut. Page: docs/user/blocks.md

#include "recon/input/input.h"
#include "shared/scenario/document.h"

namespace recon::block {

/// The section that `wanted.cut` cuts out of the block that the one that was read stands for; with a remark for each
/// finding.
/// @error BadValue: no length along strike, not four numbers; BadSection: the plane misses the block. Those of
///        extrude() and cut().
base::Result<input::ReadSection> cut_through(input::ReadSection read, const input::SectionInput& wanted);

/// The lines, polygons, points and names of a section, as the [input] of a scenario in metres that gives it again.
dobra::scenario::Table input_table(const section::Section& section);

}  // namespace recon::block
