#pragma once
// Areas, dips and volumes of surfaces in space. Page: docs/algorithms/loft.md.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "shared/base/angle.h"
#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/surf/loft/patch.h"

namespace dobra::surf::loft {

/// How a plane lies: dip below the horizontal, 0 to 90 degrees, and the way that it goes down, from north clockwise.
struct Dip {
  base::Angle dip;
  base::Angle azimuth;  ///< 0 where it is level.
};
/// Of triangles.
std::vector<Dip> dips(const std::vector<geom::Point3>& points,
                      const std::vector<std::array<std::uint32_t, 3>>& triangles);
/// Of the triangles of a patch.
std::vector<Dip> dips(const Patch& patch);

struct Measures {
  double area = 0.0;     ///< m2
  double plan = 0.0;     ///< Of what it covers on the map, overturned parts less, m2.
  base::Angle dip_mean;  ///< Weighted by area.
  double mean_z = 0.0;   ///< Weighted by area, m.
};
/// Gauss's rule in each cell of the lattice, 2 points along u and 5 along v: exact for plan areas of lofts.
Measures measures(const NamedSurface& surface);

/// What is between two surfaces.
struct Volume {
  double value = 0.0;   ///< Integral of the height of the upper above the lower, m3; where it is below, it counts less.
  double plan = 0.0;    ///< Over which, m2.
  bool exact = false;   ///< Both have one border on the map, and the value is that of the surfaces themselves.
  double below = 0.0;   ///< Where the upper surface lies below the lower one, what is between them, m3.
  double unsure = 0.0;  ///< By how much it may be off where a horizon ends alone at a fault, m3; findings tell more.
  std::vector<Finding> findings;
};
/// Over what both cover on the map, block by block up to the faults (strips.h). Where their borders are the same on the
/// map (to 1e-6 of the size) and no fault is beside them but vertical ones, the value is the integral over the
/// surfaces; else that of the pairs of triangles of both lattices that lie over each other, where an overturned one
/// counts less: a place of three sheets, as at thrusts, counts once.
/// Where they cross, a finding `cross` tells both parts and the deepest place.
/// Horizons that end on an overturned limb: the body that both close (overturned.h), told by `overturned_end`.
/// @param surfaces  with the faults that the horizons end at
/// @error Cancelled
/// @cost O(n log n + pairs), and that of strips_between()
base::Result<Volume> volume_between(const NamedSurface& upper, const NamedSurface& lower,
                                    const std::vector<NamedSurface>& surfaces = {},
                                    const base::Progress& progress = {});

}  // namespace dobra::surf::loft
