#pragma once
// What files round.

#include <optional>

#include "recon/section/section.h"

namespace recon::section {

/// m; an end of a line that is nearer than this to another line is meant to lie on it.
inline double rounding_of_files(const Section& section) { return 1e-6 * box_of(section).diagonal(); }

/// 10^-k m for the smallest k from 0 to 9 of which all coordinates of horizons, faults, topographies and the border are
/// multiples, but for the rounding of doubles; none where coordinates were computed, as those in feet or of a rotated
/// plane are. It goes by all of them together, since few coordinates are round numbers by chance.
std::optional<double> last_decimal(const Section& section);

/// m; how far rounding alone may part an end of a line from the line that it ended on; 0 where there is no
/// last_decimal.
///
/// To multiples of d rounding moves a point by d/2 in x and in z, so by at most d / sqrt 2. The end is one such point;
/// the line that it ended on goes through others, and no place between two points moves farther than they do. Together
/// that is sqrt 2 d, the diagonal of a cell of the grid that the coordinates lie on. Never more than 1e-4 of the
/// section's diagonal, the width of a pencil line across a sheet: coarser numbers say too little about what belongs
/// together.
double rounding_of_coordinates(const Section& section);

}  // namespace recon::section
