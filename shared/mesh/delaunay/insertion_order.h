#pragma once
// The order in which points are inserted: rounds of random, growing size, each along a Hilbert curve. The curve keeps
// the walks short, the rounds keep the expected number of flips linear whatever the input. Source: [amenta2003brio].

#include <cstdint>
#include <span>
#include <vector>

#include "shared/geom/point.h"

namespace dobra::mesh::delaunay {

/// A permutation of 0 .. n-1; the same for the same points. @pre finite coordinates.  @cost O(n log n)
std::vector<std::uint32_t> insertion_order(std::span<const geom::Point> points);

}  // namespace dobra::mesh::delaunay
