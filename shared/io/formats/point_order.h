#pragma once
// The order of unordered points of one curve. Internal to io: repair.h is what callers use.
// Page: docs/algorithms/repair.md. Source: [figueiredo1994].

#include <cstddef>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point.h"

namespace dobra::io::formats {

struct PointOrderFound {
  std::vector<std::size_t> order;  ///< Numbers of the points along the curve, equal ones once; its left end first.
  std::size_t inserted = 0;        ///< Points beside the longest path of the tree, put in where they lengthen it least.
};

/// The longest path of the Euclidean minimum spanning tree of the points: the curve itself where neighbours along it
/// are nearer than anything across. @error BadFormat with the place where more than a tenth of the points stand beside
/// it.
/// @cost O(n log n), and O(n) for each point beside the path.
base::Result<PointOrderFound> order_along_curve(const std::vector<geom::Point>& points);

}  // namespace dobra::io::formats
