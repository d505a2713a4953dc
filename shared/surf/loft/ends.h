#pragma once
// Horizons between the sections are led to the faults that their pieces end at. Page: docs/algorithms/loft.md.

#include <optional>
#include <vector>

#include "shared/surf/loft/patch.h"

namespace dobra::surf::loft {

/// Moves the borders of the patches that end at faults along their last pieces until they lie on the faults: on the
/// lines of the sections by nothing, between them by what the border misses there, less what the lines themselves miss.
/// The rest of a patch goes along by the part of its length. A border that would go farther than `most`, m, or meets no
/// fault, stays, with a finding.
/// @param lines_v  of each patch: v of its lines
/// @cost  O(rows of the patches times triangles of the faults)
void lead_to_faults(NamedSurface& horizon, const std::vector<std::vector<double>>& lines_v,
                    const std::vector<NamedSurface>& faults, double most, std::vector<Finding>& findings);

/// From a point along a direction of length 1 to the nearest place on a surface's lattice, m; within `most` either way.
/// @cost  O(triangles)
std::optional<double> meeting_along(const NamedSurface& surface, geom::Point3 from, geom::Vector3 way, double most);

}  // namespace dobra::surf::loft
