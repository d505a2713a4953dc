#pragma once
// Faces that are not plane: how far they are off, what that means for the volume, and an order of their corners that
// does not depend on how they are given. Page: docs/algorithms/polygon_mesh.md.

#include <optional>
#include <span>
#include <vector>

#include "shared/solid/mesh_solid.h"

namespace dobra::solid {

/// Of one face.
struct Warp {
  double distance = 0.0;  ///< Of the farthest corner from the mean plane, m.
  geom::Point3 at;        ///< That corner.
  double volume = 0.0;    ///< Between two ways to cut it into triangles, at most, m3.
};

/// None if no corner is farther from the mean plane than `flat`.
/// @cost O(n^3) for n corners; O(n) beyond 32, where the volume is area times height.
std::optional<Warp> warp_of(std::span<const geom::Point3> loop, double flat);
void add_warp(std::optional<WarpedFaces>& all, std::uint32_t face, const Warp& warp);

double diagonal_of(std::span<const geom::Point3> points);

/// The outer loop, the first, begins with the corner whose neighbours are nearest to each other, the least of several,
/// and goes on to the lesser of them. So a face is cut the same way whichever corner it begins with, and by both solids
/// that have it in common.
/// @return all loops were turned over.
bool begin_alike(const Space& space, std::vector<std::vector<PointId>>& loops);

}  // namespace dobra::solid
