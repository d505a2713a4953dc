#pragma once
// A surface as one mesh of triangles, as files have it: each node once, none without a triangle, no triangle without a
// height, and patches that share the line of a section share its nodes. Page: docs/algorithms/loft.md.

#include <array>
#include <cstdint>
#include <vector>

#include "shared/surf/loft/patch.h"

namespace dobra::surf::loft {

struct JoinedMesh {
  std::vector<geom::Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< In the order of the patches and their lattices.
};

/// The lattices of all patches. Neighbours on a lattice that are nearer than 1e-6 of `size` are one node; where lines
/// of sections run they stay where they are. A node that one of two patches has on their common line parts the
/// triangles of the other, which keep their place. Pieces that faults part keep borders of their own.
/// @param size  of all that the surfaces came from, m
/// @cost  O(n log n + nodes of borders with one x)
JoinedMesh joined(const NamedSurface& surface, double size);

}  // namespace dobra::surf::loft
