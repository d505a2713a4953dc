#include "shared/mesh/element_quality.h"

#include <algorithm>

#include "shared/mesh/order2.h"
#include "shared/mesh/quality.h"

namespace dobra::mesh {

using geom::Point;

double quadrilateral_shape(Point a, Point b, Point c, Point d) {
  const std::array<Point, 4> corner{a, b, c, d};
  double least = 1.0;
  for (std::size_t i = 0; i < 4; ++i) {
    const geom::Vector ahead = corner[(i + 1) % 4] - corner[i];
    const geom::Vector back = corner[(i + 3) % 4] - corner[i];
    const double sides = length_squared(ahead) + length_squared(back);
    least = std::min(least, sides == 0.0 ? 0.0 : 2.0 * cross(ahead, back) / sides);
  }
  return least;
}

double shape_of(const ElementMesh& mesh, ElementId element) {
  const auto nodes = mesh.nodes_of(element);
  const auto at = [&](std::size_t i) { return mesh.point(nodes[i]); };
  return corner_count(mesh.types[element.index()]) == 4 ? quadrilateral_shape(at(0), at(1), at(2), at(3))
                                                        : alpha(at(0), at(1), at(2));
}

ElementQuality element_quality_of(const ElementMesh& mesh) {
  ElementQuality quality;
  double sum = 0.0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const ElementId element(e);
    if (corner_count(mesh.types[e]) == 4) {
      const double shape = shape_of(mesh, element);
      ++quality.quadrilaterals;
      sum += shape;
      quality.shape_min = std::min(quality.shape_min, shape);
    }
    if (is_quarter_point(mesh, element)) {
      ++quality.quarter_points;
      continue;
    }
    const double jacobian = mesh.types[e] == ElementType::T3 ? 1.0 : scaled_jacobian_bound(mesh, element);
    // Rounding of straight elements is no distortion.
    if (jacobian < quality.jacobian_min && jacobian < 1.0 - 1e-12) {
      quality.jacobian_min = jacobian;
      quality.worst_jacobian = element;
    }
    constexpr double bins = 20.0;
    ++quality.jacobians[static_cast<std::size_t>(std::clamp((jacobian + 1e-12) * bins, 0.0, bins - 1.0))];
  }
  if (quality.quadrilaterals > 0) quality.shape_mean = sum / static_cast<double>(quality.quadrilaterals);
  return quality;
}

}  // namespace dobra::mesh
