#pragma once
// The proportions by which an advancing front decides. Page: docs/algorithms/advancing_front.md.

namespace dobra::mesh::front {

namespace rules {

inline constexpr double least_gap = 0.65;
inline constexpr double corner_cosine = 0.2;   ///< Corners up to 78 degrees are closed.
inline constexpr double least_alpha = 0.72;    ///< Of a triangle that closes a corner.
inline constexpr double widest_corner = -0.5;  ///< Corners up to 120 degrees, where there is no room for a node.
inline constexpr double least_joint = 0.6;     ///< Least alpha of a triangle there.
inline constexpr double most_radius =
    0.72;  ///< Its circumradius over the size: below least_spacing, so that no node gets inside.
inline constexpr double empty_radius = 0.62;  ///< A smaller circle has no room for a node that keeps its distance.
inline constexpr double most_growth = 1.2;    ///< From a side to the node over it; steeper places are left to the gaps.
inline constexpr double most_shrink = 1.28;
inline constexpr double right_corner = 0.2;   ///< Cosine of corners of the border that are halved, at most.
inline constexpr double even_corner = 1.4;    ///< And how much longer one of their sides may be.
inline constexpr double shortest_seed = 0.6;  ///< Length of a first side over the size.
inline constexpr double longest_seed = 1.4;

}  // namespace rules

}  // namespace dobra::mesh::front
