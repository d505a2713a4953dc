#pragma once
// Ends that rounding has parted from the line they end on. Page: docs/algorithms/units.md

#include "recon/section/section.h"

namespace recon::section {

/// Moves ends of horizons and faults that lie within `reach` of a fault, of another horizon, of a topography or of the
/// border, but not on it, onto it. That line gets a vertex there. What a map has carried along a fault so ends on it to
/// the last bit.
/// @param reach  m, of the size of rounding.
/// @cost  O(ends x lines + points of the lines near an end)
void rejoin_ends(Section& section, double reach);

}  // namespace recon::section
