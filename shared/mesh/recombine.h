#pragma once
// Pairs of triangles into quadrilaterals, the best pairs first, then as many as alternating paths find; what finds no
// partner stays a triangle. Sides of any side set and borders of regions stay. Page: docs/algorithms/recombine.md.
// Source: [remacle2012blossom] for the measure.

#include "shared/mesh/element_mesh.h"

namespace dobra::mesh {

struct RecombineOptions {
  double least_quality = 0.3;  ///< Of a quadrilateral that is made; 0 to 1.
};

/// eta = max(0, 1 - 2/pi * greatest |90 degrees - angle|): 1 for a rectangle, 0 from an angle of 0 or 180 degrees on.
double quad_quality(geom::Point a, geom::Point b, geom::Point c, geom::Point d);

/// @pre  check(mesh), first order.  @cost O(n log n), and at most 1000 steps for each triangle that the best pairs
/// leave.
ElementMesh recombine(const ElementMesh& mesh, const RecombineOptions& options = {});

}  // namespace dobra::mesh
