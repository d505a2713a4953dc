#pragma once
// Gaps between the polygons of a section that are too wide to be bridged: there the lower one gets no horizon.
// Page: docs/algorithms/units.md, "Horizons from units".

#include <string>
#include <vector>

#include "recon/section/section.h"

namespace recon::input {

/// One line for every two polygons with nothing between the lower side of the one and the upper side of the other but a
/// gap higher than the tolerance (m, upright), over more than half of the narrower one: names, width, heights, place.
/// @cost  O(n log n) for n edges that overlap little.
std::vector<std::string> wide_gaps(const section::Section& section, double tolerance);

}  // namespace recon::input
