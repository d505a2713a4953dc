#pragma once
// The surface of today and what lay above it: horizons are cut where they meet the topography, what is above is kept as
// eroded and not restored. Page: docs/algorithms/units.md

#include "recon/input/input.h"

namespace recon::input {

/// Cuts the horizons of a section at its topographies. A horizon that dives and comes up again falls into several, "A",
/// "A (2)", ...; what lies above becomes a line of kind Eroded, with a remark that tells its length.
/// @error BadSection: a topography that crosses itself, with the place; nothing is left below it.
base::Result<void> cut_at_topography(ReadSection& read);

/// The section with the topography of that name as a horizon, for a grid that stands on it; as it is if there is none.
/// @error those of faces_of.
base::Result<section::Section> with_topography_as_horizon(section::Section section, const std::string& name);

}  // namespace recon::input
