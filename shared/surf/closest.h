#pragma once
// The point of a surface that is nearest to a point in space. Page: docs/algorithms/surface_search.md.

#include "shared/surf/surface.h"

namespace dobra::surf {

/// Where a perpendicular stands.
struct Foot {
  geom::Point uv;
  geom::Point3 at;
  double distance = 0.0;  ///< m.
};

/// The nearest place downhill from a known neighbour: no place around it is nearer, by more than 1e-12 of the
/// surface's size, and it is never farther than the neighbour. Walks across seams, poles and corners; stays on the
/// sheet that the neighbour is on, however near another one comes.
/// @param near  taken to the chart where it lies beside it.
Foot closest(const Surface& surface, geom::Point3 point, geom::Point near);

/// The nearest place of all, by halving the chart: no place is nearer by more than 1e-9 of the surface's size.
Foot closest_of_all(const Surface& surface, geom::Point3 point);

}  // namespace dobra::surf
