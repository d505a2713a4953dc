#pragma once
// The horizons of a section cut by its faults. Page: docs/algorithms/loft.md.

#include <string>
#include <vector>

#include "shared/surf/loft/sections.h"

namespace dobra::surf::loft {

/// A piece of a line between faults.
struct LinePiece {
  geom::Polyline line;
  std::string first_fault, last_fault;  ///< At which its ends lie; empty: none.
};

/// The lines of a name, parted where they cross faults of other names; an end nearer to a fault than `at_fault`, m,
/// lies at it. Where a fault has that name itself, its lines are parted likewise by the other faults.
/// @cost  O(vertices of the lines times those of the faults)
std::vector<LinePiece> pieces_of(const Section& section, const std::string& name, double at_fault);

}  // namespace dobra::surf::loft
