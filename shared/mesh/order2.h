#pragma once
// Elements of second order: T3 and Q4 become T6 and Q8 with mid-side nodes, on the true curve where a side lies on one.
// The mapping of an element is invertible if its Jacobian determinant is positive everywhere; that is judged by the
// determinant's Bernstein coefficients, which bound it from below (never from samples). A side whose curve would
// invert an element is made straight again.
// Page: docs/algorithms/order2.md. Source: [johnen2013curvilinear].

#include <functional>
#include <map>
#include <string>

#include "shared/mesh/element_mesh.h"

namespace dobra::mesh {

/// The point half-way between two neighbouring nodes of a curve, on the curve.
using MiddleOfCurve = std::function<geom::Point(geom::Point from, geom::Point to)>;

struct SecondOrder {
  ElementMesh mesh;
  std::size_t curved = 0;                 ///< Sides whose mid-side node lies on a curve, off the chord.
  std::vector<ElementSide> straightened;  ///< Sides whose curve would have inverted an element.
};

/// Mid-side nodes come after the nodes there are, in the order of the elements and their sides; the lips of a crack get
/// one each. Sets stay as they are.
/// @param curves  by the name of a side set.
/// @pre    first order, check(mesh)
/// @cost   O(n log n)
SecondOrder to_second_order(ElementMesh mesh, const std::map<std::string, MiddleOfCurve>& curves = {});

/// Least value of the Jacobian determinant over the element, over its value for the straight-sided element (its mean):
/// 1 for straight-sided triangles. A lower bound, exact for T3 and T6 where the least is at a corner.  @cost O(1)
double scaled_jacobian_bound(const ElementMesh& mesh, ElementId element);

/// Whether both sides at a corner of an element of second order have their mid-side node at a quarter from it: the
/// Jacobian is then 0 there, on purpose, and the bound its rounding.
bool is_quarter_point(const ElementMesh& mesh, ElementId element);

}  // namespace dobra::mesh
