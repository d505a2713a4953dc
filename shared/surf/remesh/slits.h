#pragma once
// Borders that almost meet: the mesh is open there though it looks closed, as where the points of neighbours differ by
// rounding, or where a point lies on the side of a neighbour that does not know it (a T-joint).

#include <optional>
#include <vector>

#include "shared/base/finding.h"
#include "shared/surf/param/sheet.h"

namespace dobra::surf::remesh {

/// "slit", with the first place: points of borders that lie on other sides of borders, up to a millionth of the extent
/// and a hundredth of these sides. Copies of one point, in which parts meet, are none.
/// @cost O(n log n) for n sides of borders
std::optional<base::Finding> slits_of(const std::vector<param::SheetMade>& sheets);

}  // namespace dobra::surf::remesh
