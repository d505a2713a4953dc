#pragma once
// The polygon between two lines.

#include <utility>

#include "shared/geom/polyline.h"

namespace dobra::geom {

/// Between two lines that run the same way: along the first, back along the second, anticlockwise.
inline Polyline contour_between(const Polyline& upper, const Polyline& lower) {
  Polyline contour = upper;
  contour.points.insert(contour.points.end(), lower.points.rbegin(), lower.points.rend());
  contour.closed = true;
  contour = without_repeated_points(std::move(contour));
  return signed_area(contour) < 0.0 ? reversed(std::move(contour)) : contour;
}

}  // namespace dobra::geom
