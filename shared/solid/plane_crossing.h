#pragma once
// Where edges meet a plane, by sums of two doubles, where these are enough to know the nearest doubles. Source:
// [dekker1971arithmetic], [joldes2017doubleword].

#include <optional>

#include "shared/geom/point3.h"
#include "shared/solid/space.h"

namespace dobra::solid {

struct CrossingInDoubles {
  geom::Point3 at;       ///< The nearest doubles.
  bool rounded = false;  ///< For sure they are not the place itself.
  friend bool operator==(const CrossingInDoubles&, const CrossingInDoubles&) = default;
};

/// Where the segment from p to q meets the plane; none where only exact numbers can tell. The same for q, p.
/// @pre p and q lie strictly on different sides.
std::optional<CrossingInDoubles> crossing_in_doubles(const Plane& plane, geom::Point3 p, geom::Point3 q);

/// Whether a point is off the plane for sure.
bool apart_in_doubles(const Plane& plane, geom::Point3 p);

}  // namespace dobra::solid
