#pragma once
// Pairs of triangles into quadrilaterals, the best pairs first, then as many as alternating paths find; what finds no
// partner stays a triangle. Sides of any side set and borders of regions stay. Page: docs/algorithms/recombine.md.
// Source: [remacle2012blossom] for the measure.

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "shared/mesh/element_mesh.h"

namespace dobra::mesh {

struct RecombineOptions {
  double least_quality = 0.3;  ///< Of a quadrilateral that is made; 0 to 1.
};

/// eta = max(0, 1 - 2/pi * greatest |90 degrees - angle|): 1 for a rectangle, 0 from an angle of 0 or 180 degrees on.
double quad_quality(geom::Point a, geom::Point b, geom::Point c, geom::Point d);

/// How good the quadrilateral is that two triangles (elements of the mesh) make, by its corners; none if they must
/// stay.
using PairQuality =
    std::function<std::optional<double>(ElementId first, ElementId second, const std::array<NodeId, 4>& corners)>;

struct Recombined {
  ElementMesh mesh;
  std::vector<std::array<ElementId, 2>> made_of;  ///< One an element: what it was; two triangles of a quadrilateral.
};

/// The same with shapes judged by `quality`, for points that are not of a plane.
Recombined recombine(const ElementMesh& mesh, const RecombineOptions& options, const PairQuality& quality);

/// @pre  check(mesh), first order.  @cost O(n log n), and at most 1000 steps for each triangle that the best pairs
/// leave.
ElementMesh recombine(const ElementMesh& mesh, const RecombineOptions& options = {});

}  // namespace dobra::mesh
