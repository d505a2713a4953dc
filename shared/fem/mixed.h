#pragma once
// Elements of second order in plane strain of a nearly incompressible material (nu > 0.45). Plain ones lock there:
// their dilatation has more freedom than their displacements can follow. Here the dilatation is projected, element by
// element, on linear functions of the place, and a bubble inside (zero on the sides) gives the displacements what they
// lack; both are eliminated in the element, so that the equations keep their size and stay definite.
// Page: docs/algorithms/fem.md. Source: [crouzeix1973] (T6; Q8 alike), [zienkiewicz2000fem] (mixed forms, static
// condensation).

#include <array>
#include <cstdint>
#include <span>

#include "shared/fem/element.h"
#include "shared/fem/material.h"

namespace dobra::fem {

/// Poisson's ratio in plane strain above which elements of second order are mixed, and those of first refused.
inline constexpr double mixed_above = 0.45;
/// The same above which those of first order have a remark.
inline constexpr double stiff_above = 0.4;

/// The greatest in plane strain: nearer to 0.5 the equations are singular to rounding.
inline constexpr double most_poisson = 0.4999999;

/// Plane strain above `mixed_above`.
bool nearly_incompressible(const Material& material);

/// Coordinates of the reference element at a mapped point, and their derivatives in x and y.
struct Reference {
  double xi = 0.0, eta = 0.0;
  double xi_x = 0.0, xi_y = 0.0, eta_x = 0.0, eta_y = 0.0;  ///< 1/m
};
Reference reference_at(const ElementGeometry& element, const Mapped& mapped);

/// The matrices of one mixed element, the bubble last among its nodes. Displacement 2 a + axis is that of node a.
class MixedElement {
 public:
  static constexpr std::size_t most = 2 * (most_nodes + 1);
  using Row = std::array<double, most>;

  /// @pre second order, nearly_incompressible(material), determinants > 0 at the integration points
  MixedElement(const ElementGeometry& element, const Material& material);

  /// Stiffness of the element's own nodes, the bubble eliminated, N/m.
  [[nodiscard]] double stiffness(std::size_t i, std::size_t j) const;
  /// The bubble's displacements that go with those of the nodes, m.
  [[nodiscard]] geom::Vector bubble(std::span<const geom::Vector> own) const;
  /// Coefficients of 1, x and y in the projected dilatation.
  [[nodiscard]] std::array<double, 3> dilatation(std::span<const geom::Vector> own, geom::Vector bubble) const;
  [[nodiscard]] double dilatation_at(const std::array<double, 3>& coefficients, geom::Point p) const;

 private:
  [[nodiscard]] std::array<double, 3> basis(geom::Point p) const;
  void eliminate_bubble();

  std::size_t dofs_;  ///< Of the nodes, without the bubble.
  geom::Point centre_;
  double scale_ = 1.0;
  std::array<Row, most> k_{};        ///< N/m
  std::array<Row, 3> dilatation_{};  ///< Coefficients of the projected dilatation by displacement.
  std::array<Row, 2> bubble_{};      ///< Displacements of the bubble by those of the nodes.
};

/// The bubble's derivatives in x and y, 1/m.
geom::Vector bubble_slope(ElementType type, const Reference& at);

}  // namespace dobra::fem
