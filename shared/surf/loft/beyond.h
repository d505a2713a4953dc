#pragma once
// Lines side by side that are joined by place and do not end beside each other: beyond the end of the shorter one the
// surface runs together at that end, and nobody knows its heights. Page: docs/algorithms/loft.md.

#include <cstddef>
#include <vector>

#include "shared/geom/point.h"
#include "shared/geom/point3.h"

namespace dobra::surf::loft {

struct Beyond {
  /// By how much the surface would be higher or lower, m, if the longer line's shape went on along the sections, at the
  /// worst place; 0: ends are beside each other, or what goes on is straight.
  double off = 0.0;
  geom::Point3 at;  ///< There.
  std::size_t shorter = 0, longer = 0;
  double ahead = 0.0;  ///< How far the longer one goes on, m along the map.
  double area = 0.0;   ///< Of the map, beyond all the shorter ends, m2.
};

/// @param lines  side by side, each with its places along `way` ascending or descending, in the order of the sections
/// @param way    a unit vector of the map along the lines, out of the end that is looked at
/// @param high   the last points of the lines are that end, or else the first
/// @cost  O(n^2) in the points of a line that goes on
Beyond beyond_ends(const std::vector<std::vector<geom::Point3>>& lines, geom::Vector way, bool high);

}  // namespace dobra::surf::loft
