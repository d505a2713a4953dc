#pragma once
// Disjoint patches of triangles and their polynomials. Internal to recovered.h.

#include <array>
#include <vector>

#include "shared/surf/param/recovered.h"

namespace dobra::surf::param {

/// a0 + a1 x + a2 y + a3 x^2 + a4 x y + a5 y^2, x and y from a place of the chart.
using Quadratic = std::array<geom::Vector3, 6>;
/// The same polynomial about a place further by `step`.
Quadratic shifted(const Quadratic& a, geom::Vector step);

struct Patches {
  PatchReport report;
  std::vector<geom::Point> centres;    ///< One a patch.
  std::vector<Quadratic> polynomials;  ///< About the centre.
};
/// Stars of vertices inside that have no triangle in common, from the lowest number on; what is left joins the smallest
/// patch beside it. Patches of too few points join another.
Patches patches_of(const DiscreteChart& chart, const RecoverOptions& options);

}  // namespace dobra::surf::param
