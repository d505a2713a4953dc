#pragma once
// What of lines and areas can be seen: a section of a million points has a few thousand on a screen. For the eye only.

#include <vector>

#include "shared/scene/layer.h"

namespace dobra::scene {

/// How closely, and where, something is looked at.
struct Sight {
  double detail = 0.0;  ///< World lengths: smaller things cannot be seen.
  geom::Box window{};   ///< What is outside is not seen.
};

/// Lines as they are seen: parts that do not come into the window left out, and points within `detail` of the line
/// that the others draw. @cost O(n log n) for usual lines.
std::vector<geom::Polyline> seen_lines(const std::vector<geom::Polyline>& lines, const Sight& sight);

/// A region that fills the same within the window, to `detail`. @cost O(n log n) for usual contours.
Region seen_region(const Region& region, const Sight& sight);

/// Points of all lines, contours or meshes of a layer: what drawing it costs.
std::size_t point_count(const Layer& layer);

/// Contents of layers that are equal to those of the same place in `before` become the same in memory, so that whoever
/// compares them later is quick. @cost O(size)
void share_with(Picture& picture, const Picture& before);

}  // namespace dobra::scene
