#pragma once
// The signs of rocks over coloured areas, as strokes in page coordinates: one size on every page, whatever the scale.
// Their lattice stands on the page, so that signs run on from area to area.

#include <vector>

#include "shared/geom/segment.h"
#include "shared/scene/layer.h"

namespace dobra::scene {

constexpr Color pattern_ink{26, 26, 31, 140};

/// Points; a dot is as long as it is wide.
double pattern_width(Pattern pattern);

/// The strokes of all signs that may be seen in a box of the page; some reach beyond it.
/// @cost O(area of the box).
std::vector<geom::Segment> pattern_strokes(Pattern pattern, const geom::Box& box);

/// The parts of strokes inside closed contours under the even-odd rule. For the eye only: plain floating point.
/// @cost O(strokes times the edges that share a band of a few points' height with them).
std::vector<geom::Segment> parts_inside(const std::vector<geom::Segment>& strokes,
                                        const std::vector<geom::Polyline>& contours);

}  // namespace dobra::scene
