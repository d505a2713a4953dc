#pragma once
// Edges and corners of a convex solid rounded by planes that touch cylinders and spheres. Page:
// docs/algorithms/sweeps.md. Source: [mantyla1988solid] (local operators); the way is ours.

#include <string>

#include "shared/base/result.h"
#include "shared/solid/solid.h"

namespace dobra::solid::shape {

struct RoundOptions {
  double radius = 1.0;         ///< m, above 0.
  int segments = 8;            ///< Planes by which one face turns into its neighbour; 2 makes chamfers.
  std::string name = "round";  ///< Of the new faces.
};

/// What a ball of that radius reaches inside the solid, but for the planes, which lie outside the cylinders and
/// spheres: its volume falls to the true one as segments^-2. The faces stay where they are.
/// @error InvalidOption: empty, several shells, a notch (with its place), radius or segments out of range, or a radius
///        so large that a face disappears (with its name).
/// @cost  O(planes * corners of the solid) for segments^2 planes a corner
base::Result<Solid> round_convex(const Solid& solid, const RoundOptions& options);

}  // namespace dobra::solid::shape
