#pragma once
// How many vertices, edges and faces the units of a block have together.

#include <span>

#include "recon/block/block.h"

namespace recon::block {

/// What two units share counts once. Exactly coplanar neighbours with one name between the same units are one face,
/// edges in a line between the same faces one edge.
/// @cost O(n log n)
BlockCounts count(std::span<const BlockUnit> units);

}  // namespace recon::block
