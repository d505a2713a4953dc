#pragma once
// An oracle for subdivisions that shares no code with the operators that make them: links, labels, counts, Euler's
// relation, and the geometry, all by brute force from the read-only side.

#include <string>
#include <vector>

#include "shared/topo/subdivision.h"

namespace dobra::topo {

/// All that is wrong, one line each; nothing if the subdivision is sound.
/// @cost O(n^2) at worst (edges are swept in x).
std::vector<std::string> violations(const Subdivision& subdivision);

}  // namespace dobra::topo
