#pragma once
// The rings of a sketch: boundary curves that follow each other, end to end, back to their start.

#include <vector>

#include "quebra/domain/domain.h"

namespace quebra::repair {

/// Boundary curves that follow each other back to their start.
struct Ring {
  std::vector<domain::Domain::Side> sides;
  dobra::geom::Polyline outline;  ///< Traced, through the places where its curves are cut.
};

/// The rings of all boundary curves, in the order of their first curves; a curve that is on none bounds nothing.
/// @cost O(n log n) for n curves
std::vector<Ring> find_rings(const std::vector<sketch::Curve>& curves);

/// Of the area in a contour; its first point where it has none.
dobra::geom::Point centroid(const dobra::geom::Polyline& contour);

}  // namespace quebra::repair
