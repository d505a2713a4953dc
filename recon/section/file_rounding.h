#pragma once
// What files round.

#include <optional>
#include <string>

#include "recon/section/section.h"

namespace recon::section {

/// m; an end of a line that is nearer than this to another line is meant to lie on it.
inline double rounding_of_files(const Section& section) { return 1e-6 * box_of(section).diagonal(); }

/// The grid that the coordinates of a file lie on.
struct FileGrid {
  double step = 0.0;       ///< m, of x.
  double cell = 0.0;       ///< The diagonal of a cell, m.
  std::size_t points = 0;  ///< Of horizons, faults, topographies and the border.
  std::size_t odd = 0;     ///< Of these, how many do not lie on it.
  std::string odd_line;    ///< Where the first of them is: "horizon 'top'".
  geom::Point odd_place;
};

/// Of steps 10^-k, k from 0 to 9, in the file's own unit, in metres or in feet the greatest of which the coordinates of
/// horizons, faults, topographies and the border are multiples, but for the rounding of doubles, and for one point in
/// 50, no more than half of those of a line; none where coordinates were computed, as those of a rotated plane are. It
/// goes by all of them together, since few coordinates are round numbers by chance.
std::optional<FileGrid> grid_of_files(const Section& section);
/// Its step.
std::optional<double> last_decimal(const Section& section);

/// m; how far rounding alone may part an end of a line from the line that it ended on; 0 where there is no
/// grid_of_files.
///
/// To multiples of d rounding moves a point by d/2 in x and in z, so by at most d / sqrt 2. The end is one such point;
/// the line that it ended on goes through others, and no place between two points moves farther than they do. Together
/// that is sqrt 2 d, the diagonal of a cell of the grid that the coordinates lie on. Never more than 1e-4 of the
/// section's diagonal, the width of a pencil line across a sheet: coarser numbers say too little about what belongs
/// together.
double rounding_of_coordinates(const Section& section);

}  // namespace recon::section
