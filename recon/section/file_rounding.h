#pragma once
// What files round.

#include "recon/section/section.h"

namespace recon::section {

/// m; an end of a line that is nearer than this to another line is meant to lie on it.
inline double rounding_of_files(const Section& section) { return 1e-6 * box_of(section).diagonal(); }

}  // namespace recon::section
