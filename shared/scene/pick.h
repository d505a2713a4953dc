#pragma once
// What is under the cursor.

#include <optional>
#include <string>

#include "shared/scene/layer.h"

namespace dobra::scene {

struct Pick {
  std::string layer;     ///< Key of the layer.
  std::uint32_t id = 0;  ///< Identity of the item in it: its `ids` entry or index; of a mesh, that of the triangle.
  friend auto operator<=>(const Pick&, const Pick&) = default;
};

/// What becomes of a line that was picked: others in its place, or none.
struct LineEdit {
  Pick pick;
  std::vector<geom::Polyline> becomes;
};

/// The item nearest to `at` in the topmost visible layer that has one there: lines and markers within `tolerance`,
/// filled regions and meshes that contain it (unfilled regions by their outline). Labels are not picked.
/// @param at         m, world coordinates.
/// @param tolerance  m, along x; along y it is divided by the panel's vertical exaggeration, so that it is a circle on
/// the page.
/// @cost  O(points and triangles of the visible layers).
std::optional<Pick> pick(const Panel& panel, geom::Point at, double tolerance);

/// Lines and markers that make the items of a pick stand out; empty where the panel has none. Of a mesh the triangle.
/// @cost O(items of the layer)
std::vector<Layer> highlight(const Panel& panel, const Pick& pick);

/// The edges of some triangles that bound them all: those that an odd number of them have. @cost O(n log n)
std::vector<std::array<std::uint32_t, 2>> rim_of(std::vector<std::array<std::uint32_t, 3>> triangles);

}  // namespace dobra::scene
