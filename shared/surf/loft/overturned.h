#pragma once
// Horizons that end on an overturned limb lie over themselves beyond their ends on the map: there a column of the map
// says nothing of what is between two of them. Page: docs/algorithms/loft.md.

#include <optional>

#include "shared/surf/loft/patch.h"

namespace dobra::surf::loft {

/// An end beyond which the surface goes on over or under itself, as of the inverted limb of a recumbent fold.
/// @cost O(points of the lattices)
std::optional<geom::Point3> overturned_end(const NamedSurface& surface);

/// Of the body that two surfaces close with straight sides from border to border, m3. Nothing where a patch is no loft,
/// or where patches do not begin and end at the same sections and lie beside each other, corner by corner.
/// @pre The surfaces do not cross.
/// @cost O(points of the lattices)
std::optional<double> closed_volume(const NamedSurface& upper, const NamedSurface& lower);

}  // namespace dobra::surf::loft
