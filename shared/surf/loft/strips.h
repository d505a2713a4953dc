#pragma once
// The strips of faults between the ends of horizons: with them a faulted horizon is one surface, and what lies between
// two is closed. Page: docs/algorithms/loft.md.

#include <array>
#include <vector>

#include "shared/surf/loft/patch.h"

namespace dobra::surf::loft {

/// Anticlockwise seen from above: it covers its map; clockwise: it covers it less.
using StripTriangle = std::array<geom::Point3, 3>;

struct Strips {
  std::vector<StripTriangle> upper, lower;  ///< What counts with which horizon.
  double unsure = 0.0;                      ///< By how much a volume may be off where a horizon ends alone, m3.
  std::vector<Finding> findings;
};

/// 1. Where a horizon has pieces on both sides of a fault, the fault between their ends belongs to the horizon.
/// 2. Where both have a piece on the same side alone, the fault between the ends of the two closes the block: what of
///    it looks upwards counts with the upper one, the rest with the lower.
/// 3. Other ends at faults are told ("volume_at_fault").
/// Between the ends the strip is laid on the fault where that is near.
/// @param surfaces  with the faults
/// @cost  O(rows of the patches times triangles of the faults beside them)
Strips strips_between(const NamedSurface& upper, const NamedSurface& lower, const std::vector<NamedSurface>& surfaces);

}  // namespace dobra::surf::loft
