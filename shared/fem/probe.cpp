#include "shared/fem/probe.h"

#include <cmath>

#include "shared/geom/box.h"

namespace dobra::fem {
namespace {

using geom::Point;
using geom::Vector;

/// Reference coordinates may lie this far outside: points on sides belong to the elements; at a tip with quarter points
/// it is a distance of 1e-12 sides.
constexpr double on_side = 1e-6;

bool inside(ElementType type, double xi, double eta) {
  if (mesh::corner_count(type) == 3) return xi >= -on_side && eta >= -on_side && xi + eta <= 1.0 + on_side;
  return std::abs(xi) <= 1.0 + on_side && std::abs(eta) <= 1.0 + on_side;
}

std::optional<Shape> find_in(const ElementGeometry& element, Point at) {
  const double hit = 1e-13 * geom::box_of(element.points()).diagonal();
  double xi = mesh::corner_count(element.type) == 3 ? 1.0 / 3.0 : 0.0;
  double eta = xi;
  // A few steps; at a crack tip with quarter points, where the map stands still, each halves the distance.
  for (int step = 0; step < 60; ++step) {
    const Shape shape = shape_at(element.type, xi, eta);
    Vector off = at - Point{};
    Vector by_xi, by_eta;
    for (std::size_t a = 0; a < element.count; ++a) {
      const Vector p = element.coordinates[a] - Point{};
      off = off - shape.n[a] * p;
      by_xi = by_xi + shape.d_xi[a] * p;
      by_eta = by_eta + shape.d_eta[a] * p;
    }
    if (length(off) <= hit) return inside(element.type, xi, eta) ? std::optional(shape) : std::nullopt;
    const double determinant = cross(by_xi, by_eta);
    if (determinant == 0.0) return std::nullopt;
    const double d_xi = cross(off, by_eta) / determinant;
    const double d_eta = cross(by_xi, off) / determinant;
    xi += d_xi;
    eta += d_eta;
    if (!(std::abs(xi) < 10.0 && std::abs(eta) < 10.0)) return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::vector<geom::Box> element_boxes(const mesh::ElementMesh& mesh) {
  std::vector<geom::Box> boxes;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const ElementGeometry element = geometry_of(mesh, e);
    const geom::Box box = geom::box_of(element.points());
    boxes.push_back(box.grown((mesh::is_quadratic(element.type) ? 0.25 : 1e-6) * box.diagonal()));
  }
  return boxes;
}

std::optional<Located> locate(const mesh::ElementMesh& mesh, std::span<const geom::Box> boxes, Point at) {
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (!boxes[e].contains(at)) continue;
    if (const auto shape = find_in(geometry_of(mesh, e), at)) return Located{e, *shape};
  }
  return std::nullopt;
}

}  // namespace dobra::fem
