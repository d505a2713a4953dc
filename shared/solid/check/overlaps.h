#pragma once
// Which of several solids that should stand side by side have volume in common. Page: docs/algorithms/boolean.md.

#include <cstddef>
#include <span>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point3.h"
#include "shared/solid/solid.h"

namespace dobra::solid::check {

struct Overlap {
  std::size_t first = 0, second = 0;  ///< Their places in the list.
  double volume = 0.0;                ///< m3.
  geom::Point3 at;                    ///< In it: the middle, or where that is outside, a corner.
};

/// Pairs, but for those that have less than 1e-12 of the smaller one in common, which rounding leaves where solids side
/// by side were turned.
/// @cost that of combine() for each pair whose boxes overlap; where combine() of all of them says that no two have
/// volume
///       in common, there is no need to ask
base::Result<std::vector<Overlap>> overlaps(std::span<const Solid> solids);

}  // namespace dobra::solid::check
