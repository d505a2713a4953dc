#pragma once
// Polygons of exact points cut into triangles: holes are bridged, then ears are clipped. Exact.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "shared/solid/soup.h"

namespace dobra::solid {

/// Whether no two edges of the loop meet except neighbours in their corner.  @cost O(n log n + pairs near each other)
bool is_simple(const Space& space, Projection onto, std::span<const PointId> loop);

/// Twice the area is positive: the loop runs anticlockwise in the projection.  @pre it is simple and not all in a line
bool runs_left(const Space& space, Projection onto, std::span<const PointId> loop);

/// Whether the loops bound a face: simple, the first around all others, which lie beside each other. They may touch in
/// corners.  @cost O(n log n + pairs near each other + n loops)
bool bound_a_face(const Space& space, Projection onto, std::span<const std::vector<PointId>> loops);

/// Whether two edges of the facet meet, and not in their ends: a corner lies within an edge, or edges cover each other.
bool meets_itself(const Soup& soup, const Facet& facet);

/// Rounded, a place where edges meet so that the loops bound no face; none if no edges do.
std::optional<geom::Point3> where_edges_meet(const Space& space, Projection onto,
                                             std::span<const std::vector<PointId>> loops);

/// @param loops  first the outer one, anticlockwise in the projection, then holes, clockwise; they may touch in
/// corners.
/// @return       triangles of corners, all corners used; none if the loops are not such a polygon.
/// @cost         O(n^2) at worst.
std::optional<std::vector<std::array<PointId, 3>>> triangulate(const Space& space, Projection onto,
                                                               std::span<const std::vector<PointId>> loops);

/// The loops of a facet: the outer one first.
std::vector<std::vector<PointId>> sorted_loops(const Soup& soup, const Facet& facet, Projection onto);

}  // namespace dobra::solid
