#pragma once
// Whether anything can move without strain: the parts of a mesh that are rigid in themselves (elements joined by
// sides), their three rigid motions each, and what supports, springs, ties and shared corners say about those. Decided
// before the equations are factorised, so that a floating part is named instead of a failed pivot.
// Page: docs/algorithms/fem.md.

#include <vector>

#include "shared/base/result.h"
#include "shared/fem/constraints.h"

namespace dobra::fem {

/// @pre   check(mesh, problem); `constraints` are those of constraints_of.
/// @error NotSupported naming the part (region, place) and how it can move.
/// @cost  O(n + r p^2) for r constraints and p parts that hang together.
base::Result<void> check_supported(const mesh::ElementMesh& mesh, const Problem& problem,
                                   const std::vector<DofConstraint>& constraints);

}  // namespace dobra::fem
