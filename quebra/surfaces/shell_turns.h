#pragma once
// Rotations that a deck for CalculiX may hold. It expands shells to solids, where a rotation is a difference of
// displacements across the thickness: one about the normal is none, and two that say the same of a node make it too
// stiff (the pinched cylinder moved a fourth of what it should). Page: docs/user/surfaces.md. Source: [calculix-ccx].

#include <array>
#include <map>

#include "quebra/surfaces/shell.h"

namespace quebra::surfaces {

struct TurnOptions {
  double flat = 0.25;  ///< Sine of the angle between a normal and a plane, or a direction across it, taken for nought.
  double kink = 0.25;  ///< Sine of half the angle between normals at a node that make it a kink.
};

/// Which rotations about x, y and z to hold, for each node with one held. Of those held at zero, one about the normal
/// is left out; of two axes in whose plane the normal lies, the one nearer to the normal; of three, the nearest. At a
/// kink, and where a rotation is not zero, all stay.
/// @cost O(elements)
std::map<std::size_t, std::array<bool, 3>> turns_to_hold(const dobra::surf::mesh::SurfaceElements& elements,
                                                         const Shell& shell, const TurnOptions& options = {});

}  // namespace quebra::surfaces
