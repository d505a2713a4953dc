#pragma once
// The rock of one cell between faults, from the pieces of its beds. Page: docs/algorithms/blocks.md

#include <string>
#include <vector>

#include "recon/section/section.h"

namespace recon::faults {

/// A part of a horizon within a cell.
struct BedStretch {
  std::string bed;      ///< The horizon's whole.
  geom::Polyline line;  ///< From left to right along the bed.
};

/// A cell between faults.
struct Cell {
  std::vector<geom::Polyline> contours;  ///< Anticlockwise.
  geom::Polyline frame;                  ///< What of the contours lies on it is no fault. Anticlockwise.
  std::vector<BedStretch> stretches;
  double tolerance = 0.0;  ///< How near to a fault ends of beds lie on it, m.
};

/// A straight line that the beds do not give.
struct Closing {
  std::string bed;
  geom::Segment line;
};

struct CellRock {
  std::vector<geom::Polyline> rings;  ///< Within the cell.
  std::vector<Closing> closings;      ///< The longest first.
};

/// Between the beds of the cell.  @error those of topo::region.
base::Result<CellRock> rock_of(const Cell& cell);

}  // namespace recon::faults
