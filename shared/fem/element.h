#pragma once
// Isoparametric plane elements T3, T6, Q4, Q8: shape functions, integration rules, and the map from the reference
// element. Reference triangle: (0,0), (1,0), (0,1); reference square: [-1,1]^2; nodes as element_mesh.h numbers them.
// A T6 whose mid-sides at one corner stand at a quarter of the sides has the sqrt(r) field of a crack tip at that
// corner [barsoum1976]. Page: docs/algorithms/fem.md. Source: [zienkiewicz2000fem], [dunavant1985] for the triangle
// rules.

#include <array>
#include <cstdint>
#include <span>

#include "shared/geom/point.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::fem {

using mesh::ElementType;

inline constexpr std::size_t most_nodes = 8;

struct IntegrationPoint {
  double xi = 0.0;
  double eta = 0.0;
  double weight = 0.0;  ///< The weights of a rule add up to the area of the reference element.
};

/// Values and reference derivatives of the shape functions at one point.
struct Shape {
  std::array<double, most_nodes> n{};
  std::array<double, most_nodes> d_xi{};
  std::array<double, most_nodes> d_eta{};
};
Shape shape_at(ElementType type, double xi, double eta);

/// Reference coordinates of node i.
std::array<double, 2> reference_node(ElementType type, std::size_t i);

/// What a rule is for.
enum class Rule : std::uint8_t {
  Straight,  ///< Stiffness of an element with straight sides and mid-sides in their middle: exact with the fewest
             ///< points.
  Curved,    ///< Stiffness of any other element, and everything integrated over one: degree 5.
  Sample,    ///< Where stresses are most accurate: centroid (T3, Q4), three points (T6), 2 x 2 (Q8).
};
std::span<const IntegrationPoint> integration_points(ElementType type, Rule rule);
/// The shape functions at those points, computed once.
std::span<const Shape> shapes_at(ElementType type, Rule rule);

/// Shape functions and their derivatives in x and y at one point of one element.
struct Mapped {
  std::array<double, most_nodes> n{};
  std::array<double, most_nodes> d_x{};  ///< 1/m
  std::array<double, most_nodes> d_y{};  ///< 1/m
  double determinant = 0.0;              ///< Of the Jacobian, m2 a unit of reference area; > 0 in a valid element.
  geom::Point at;
};
/// @param corners  coordinates of the element's nodes, all of them.
Mapped map(std::span<const geom::Point> nodes, const Shape& shape);

/// One element of a mesh with its coordinates gathered.
struct ElementGeometry {
  ElementType type = ElementType::T3;
  std::array<geom::Point, most_nodes> coordinates;
  std::array<std::size_t, most_nodes> nodes{};  ///< Positions in the mesh.
  std::size_t count = 0;
  [[nodiscard]] std::span<const geom::Point> points() const { return std::span(coordinates).first(count); }
};
ElementGeometry geometry_of(const mesh::ElementMesh& mesh, std::size_t element);
/// Straight if every mid-side node stands, to rounding, in the middle of its side, and a quadrilateral is a
/// parallelogram.
Rule stiffness_rule(const ElementGeometry& element);

/// Gauss points on a side, parameter s in [-1, 1] from its first to its last corner; five: degree 9.
std::span<const IntegrationPoint> side_points();
/// Shape functions of the 2 or 3 nodes of a side in the order corner, corner, middle; `d_xi` is the derivative in s.
Shape side_shape(ElementType type, double s);

}  // namespace dobra::fem
