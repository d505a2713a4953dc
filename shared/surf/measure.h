#pragma once
// Lengths, areas and curvatures on a surface. Page: docs/algorithms/surfaces.md. Source: [docarmo1976].

#include <optional>

#include "shared/surf/surface.h"

namespace dobra::surf {

/// The first fundamental form: a step (du, dv) of the chart is E du^2 + 2 F du dv + G dv^2 m^2 long.
struct Metric {
  double e = 0.0, f = 0.0, g = 0.0;
  [[nodiscard]] double length(geom::Vector step) const {
    return std::sqrt(std::max(0.0, e * step.x * step.x + 2.0 * f * step.x * step.y + g * step.y * step.y));
  }
  /// Area in space of a unit of the chart's.
  [[nodiscard]] double area() const { return std::sqrt(std::max(0.0, e * g - f * f)); }
};
inline Metric metric(const Jet& jet) { return {dot(jet.u, jet.u), dot(jet.u, jet.v), dot(jet.v, jet.v)}; }

/// The unit normal; nothing where Su and Sv are parallel, or one of them is nought beside the other (a pole).
std::optional<geom::Vector3> normal(const Jet& jet);

/// The same, and on a side that is one point (the pole of a sphere, the apex of a cone) what it comes to along the line
/// of the chart that ends there.
std::optional<geom::Vector3> normal(const Surface& surface, geom::Point uv);

/// Curvatures, 1/m, positive where the surface bends to the side of its normal.
struct Curvature {
  double least = 0.0, greatest = 0.0;
  [[nodiscard]] double mean() const { return 0.5 * (least + greatest); }
  [[nodiscard]] double gaussian() const { return least * greatest; }
};
/// Nothing where there is no normal.
std::optional<Curvature> curvature(const Jet& jet);

/// A number found by quadrature, and what may be wrong with it at most.
struct Measured {
  double value = 0.0;
  double error = 0.0;
};

/// Area of a part of the chart, m2. Gauss's rule with 8 x 8 points between the breaks, in cells that show how the
/// surface bends (details.h); these are quartered until the sum of their errors is within the tolerance, or 20 times.
/// @param tolerance  part of the area. Not a number where the surface has no value (a formula undefined between the
/// places at which Surface::graph looked).
Measured area(const Surface& surface, const geom::Box& part, double tolerance = 1e-10);
inline Measured area(const Surface& surface, double tolerance = 1e-10) {
  return area(surface, surface.chart(), tolerance);
}

/// Length in space of the straight line of the chart between two of its points, m, to 1e-12 of itself where it is
/// smooth.
double length(const Surface& surface, geom::Point from, geom::Point to);

}  // namespace dobra::surf
