#pragma once
// Ends that rounding has parted from the line they end on, and ends beyond a fault. Page: docs/algorithms/units.md

#include <optional>
#include <string>

#include "recon/section/section.h"

namespace recon::section {

/// Moves ends of horizons and faults that lie within `reach` of a fault, of another horizon, of a topography or of the
/// border, but not on it, onto it, with whatever has a vertex at the end. That line gets a vertex there. What a map has
/// carried along a fault so ends on it to the last bit.
/// @param reach  m, of the size of rounding.
/// @cost  O(ends x lines + points of the lines near an end)
void rejoin_ends(Section& section, double reach);

/// Where horizons end within `reach` of the end of a fault that lies within it of another fault: all of them get one
/// vertex there. Else nothing changes.
void join_at_branches(Section& section, double reach);

/// What of a horizon lies beyond the fault that it crosses last before an end of it.
struct Overshoot {
  const Horizon* horizon = nullptr;
  const SectionLine* fault = nullptr;
  double length = 0.0;  ///< m
};
/// Unless that is `longest` or more.
std::optional<Overshoot> overshoot_of(const Section& section, const Horizon& horizon, LineEnd end, double longest);
/// Without the place.
std::string words_of(const Overshoot& overshoot);

/// m; a short number above a length, for a tolerance that takes it in.
double tolerance_above(double length);

}  // namespace recon::section
