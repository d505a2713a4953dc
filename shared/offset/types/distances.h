#pragma once
// The distances of a family of offset curves: D_1 = d0, D_k = f D_{k-1} + d0, each measured from the base.
// Successive gaps grow by the factor. Page: docs/algorithms/offset.md. Source: [carvalho2005offset].

#include <cstddef>
#include <vector>

#include "shared/base/result.h"

namespace dobra::offset {
inline namespace types {

struct DistanceRule {
  std::size_t count = 1;  ///< Number of curves, 1 to 100 000.
  double initial = 1.0;   ///< Distance of the first curve from the base, m; above 0.
  double factor = 1.0;    ///< On the accumulated distance; above 0. 1 gives equal gaps.
};

/// `count` distances, m, ascending.
/// @error InvalidOption: which of the three is wrong and what it may be; also if a distance is no longer finite or the
///        curves no longer move apart.
base::Result<std::vector<double>> distances(const DistanceRule& rule);

}  // namespace types
}  // namespace dobra::offset
