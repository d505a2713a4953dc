#pragma once
// Names beside the ends of lines: each stays as near to its end as the others allow. Internal to scene.

#include <optional>
#include <vector>

#include "shared/scene/layer.h"

namespace dobra::scene {

/// Of a name that had to move: room for the line that leads from its end to it, points.
constexpr double leader_length = 12.0;

/// Where a name would like to stand: its middle beside an end, to the right or to the left of it. Page coordinates.
struct NamePlace {
  geom::Point end;
  Anchor side = Anchor::Right;  ///< Right or Left.
  double width = 0.0;
  double height = 0.0;
};

/// Boxes that overlap none of the others, the nearest to the ends in the sense of least squares, in the order of the
/// ends from top to bottom; farther off than half its height a name stands `leader_length` aside. A name that would
/// move more than `reach` is dropped: the most crowded one first, of equals the later one.
/// @param low, high  no box reaches beyond these heights; a name for which there is no room between them is dropped.
/// @cost O(n^3), n names, at worst; of more than 400 the later ones are dropped.
std::vector<std::optional<geom::Box>> places_of_names(const std::vector<NamePlace>& names, double reach, double low,
                                                      double high);

}  // namespace dobra::scene
