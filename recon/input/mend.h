#pragma once
// Repairs that need the whole section: ends of horizons at faults, edges that polygons share, slivers. The one
// mechanism is io::formats::repair; here is only the way there and back.

#include "recon/input/input.h"

namespace recon::input {

/// Mends what the input asks for, and where it says nothing of ends at faults, joins those ends to faults, horizons,
/// topographies and the border that the rounding of the coordinates has parted from them (rounding_of_coordinates);
/// what was done is added to the remarks.
/// @error those of io::formats::repair; BadSection: a polygon that crosses itself once its vertices are moved.
base::Result<void> mend(const SectionInput& input, ReadSection& read);

}  // namespace recon::input
