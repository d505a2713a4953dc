#pragma once
// Sharp points of a sheet, as the tip of a cone is one. Internal to remesh.h. Page: docs/algorithms/remesh.md.

#include <vector>

#include "shared/surf/param/sheet.h"

namespace dobra::surf::remesh {

/// One a point, radians: how much the angles of the triangles round it lack to a whole turn, on the border to a half
/// one; negative where they are more. Their sum over a region is the curvature that it has in all.
std::vector<double> angle_defects(const param::Sheet& sheet);

/// Points whose defect is at least so many degrees, with those inside within a size of them too: so the tip of a hill
/// is one, and a point that noise lifted out of a plane is none, as its neighbours lack what it has too much.
/// @param sizes  one a point, m
/// @return their numbers, the sharpest first; of equal ones that with the least number  @cost O(n) and a size round
/// each
std::vector<std::uint32_t> sharp_points(const param::Sheet& sheet, const std::vector<double>& sizes, double degrees);

}  // namespace dobra::surf::remesh
