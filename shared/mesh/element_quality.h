#pragma once
// How good elements of any kind are: quadrilaterals by a measure of their own, and how far the mapping of bent elements
// is from an even one. Page: docs/algorithms/quality.md. Source: [knupp2003algebraic] for the shape,
// [johnen2013curvilinear] for the bound of the Jacobian.

#include <array>
#include <cstddef>

#include "shared/mesh/element_mesh.h"

namespace dobra::mesh {

/// Least over the corners of 2 |e1 x e2| / (|e1|^2 + |e2|^2), e1 and e2 the sides there: 1 for a square, 2 r / (1 +
/// r^2) for a rectangle of sides 1 : r, 0 or less if a corner is flat or re-entrant (corners anticlockwise).
double quadrilateral_shape(geom::Point a, geom::Point b, geom::Point c, geom::Point d);

/// alpha of a triangle, quadrilateral_shape of a quadrilateral, by their corners.
double shape_of(const ElementMesh& mesh, ElementId element);

struct ElementQuality {
  std::size_t quadrilaterals = 0;
  double shape_mean = 1.0;  ///< Of the quadrilaterals; 1 without any.
  double shape_min = 1.0;
  std::size_t quarter_points = 0;  ///< Elements with quarter points (order2.h), which the figures below leave out.
  double jacobian_min = 1.0;  ///< Least scaled_jacobian_bound (order2.h): 1 where all elements are straight triangles.
  ElementId worst_jacobian;   ///< Its element; none if that is 1.
  /// Elements by scaled_jacobian_bound, bins of 0.05 from 0; inverted ones in the first.
  std::array<std::size_t, 20> jacobians{};
};

/// @cost O(n)
ElementQuality element_quality_of(const ElementMesh& mesh);

}  // namespace dobra::mesh
