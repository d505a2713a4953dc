#pragma once
// Where edges meet a plane, by sums of two doubles, where these are enough to know the nearest doubles. Source:
// [dekker1971arithmetic].

#include <optional>

#include "shared/geom/point3.h"
#include "shared/solid/section.h"

namespace dobra::solid {

/// The nearest doubles of the place where the segment from p to q meets the plane; none where only exact numbers can
/// tell. The same for q, p.
/// @pre p and q lie strictly on different sides.
std::optional<geom::Point3> crossing_in_doubles(const CutPlane& plane, geom::Point3 p, geom::Point3 q);

}  // namespace dobra::solid
