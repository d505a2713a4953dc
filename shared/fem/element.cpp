#include "shared/fem/element.h"

#include <cmath>
#include <limits>
#include <vector>

namespace dobra::fem {
namespace {

using Points = std::vector<IntegrationPoint>;

/// One orbit of a symmetric triangle rule: the three points with barycentric coordinates (1 - 2a, a, a).
void add_orbit(Points& points, double a, double weight) {
  const double b = 1.0 - 2.0 * a;
  points.push_back({a, a, weight});
  points.push_back({b, a, weight});
  points.push_back({a, b, weight});
}

/// Radon's rule of degree 5, in closed form.
Points triangle_seven() {
  const double root = std::sqrt(15.0);
  Points points{{1.0 / 3.0, 1.0 / 3.0, 9.0 / 80.0}};
  add_orbit(points, (6.0 - root) / 21.0, (155.0 - root) / 2400.0);
  add_orbit(points, (6.0 + root) / 21.0, (155.0 + root) / 2400.0);
  return points;
}

Points triangle_three() {
  Points points;
  add_orbit(points, 1.0 / 6.0, 1.0 / 6.0);
  return points;
}

Points square(const std::vector<std::array<double, 2>>& line) {
  Points points;
  for (const auto& [y, wy] : line) {
    for (const auto& [x, wx] : line) points.push_back({x, y, wx * wy});
  }
  return points;
}

Points make_points(ElementType type, Rule rule) {
  const double two = 1.0 / std::sqrt(3.0);
  const double three = std::sqrt(0.6);
  const std::vector<std::array<double, 2>> gauss_2{{-two, 1.0}, {two, 1.0}};
  const std::vector<std::array<double, 2>> gauss_3{{-three, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {three, 5.0 / 9.0}};
  switch (type) {
    case ElementType::T3:
      return rule == Rule::Curved ? triangle_seven() : Points{{1.0 / 3.0, 1.0 / 3.0, 0.5}};
    case ElementType::T6:
      return rule == Rule::Curved ? triangle_seven() : triangle_three();
    case ElementType::Q4:
      if (rule == Rule::Sample) return {{0.0, 0.0, 4.0}};
      return rule == Rule::Curved ? square(gauss_3) : square(gauss_2);
    case ElementType::Q8:
      return rule == Rule::Sample ? square(gauss_2) : square(gauss_3);
  }
  return {};
}

struct Table {
  Points points;
  std::vector<Shape> shapes;
};

const Table& table(ElementType type, Rule rule) {
  static const std::vector<Table> tables = [] {
    std::vector<Table> all;
    for (const ElementType t : {ElementType::T3, ElementType::T6, ElementType::Q4, ElementType::Q8}) {
      for (const Rule r : {Rule::Straight, Rule::Curved, Rule::Sample}) {
        Table one{make_points(t, r), {}};
        for (const auto& p : one.points) one.shapes.push_back(shape_at(t, p.xi, p.eta));
        all.push_back(std::move(one));
      }
    }
    return all;
  }();
  return tables[static_cast<std::size_t>(type) * 3 + static_cast<std::size_t>(rule)];
}

Shape triangle_quadratic(double x, double y) {
  const double z = 1.0 - x - y;
  return {{z * (2 * z - 1), x * (2 * x - 1), y * (2 * y - 1), 4 * x * z, 4 * x * y, 4 * y * z},
          {1 - 4 * z, 4 * x - 1, 0.0, 4 * (z - x), 4 * y, -4 * y},
          {1 - 4 * z, 0.0, 4 * y - 1, -4 * x, 4 * x, 4 * (z - y)}};
}

Shape square_bilinear(double x, double y) {
  return {{0.25 * (1 - x) * (1 - y), 0.25 * (1 + x) * (1 - y), 0.25 * (1 + x) * (1 + y), 0.25 * (1 - x) * (1 + y)},
          {-0.25 * (1 - y), 0.25 * (1 - y), 0.25 * (1 + y), -0.25 * (1 + y)},
          {-0.25 * (1 - x), -0.25 * (1 + x), 0.25 * (1 + x), 0.25 * (1 - x)}};
}

Shape square_serendipity(double x, double y) {
  constexpr std::array<std::array<double, 2>, 4> corner{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  Shape s;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [a, b] = corner[i];
    s.n[i] = 0.25 * (1 + a * x) * (1 + b * y) * (a * x + b * y - 1);
    s.d_xi[i] = 0.25 * a * (1 + b * y) * (2 * a * x + b * y);
    s.d_eta[i] = 0.25 * b * (1 + a * x) * (a * x + 2 * b * y);
  }
  for (const auto& [i, b] : {std::pair<std::size_t, double>{4, -1.0}, {6, 1.0}}) {  // on the sides eta = b
    s.n[i] = 0.5 * (1 - x * x) * (1 + b * y);
    s.d_xi[i] = -x * (1 + b * y);
    s.d_eta[i] = 0.5 * b * (1 - x * x);
  }
  for (const auto& [i, a] : {std::pair<std::size_t, double>{5, 1.0}, {7, -1.0}}) {  // on the sides xi = a
    s.n[i] = 0.5 * (1 - y * y) * (1 + a * x);
    s.d_xi[i] = 0.5 * a * (1 - y * y);
    s.d_eta[i] = -y * (1 + a * x);
  }
  return s;
}

}  // namespace

Shape shape_at(ElementType type, double xi, double eta) {
  switch (type) {
    case ElementType::T3:
      return {{1 - xi - eta, xi, eta}, {-1, 1, 0}, {-1, 0, 1}};
    case ElementType::T6:
      return triangle_quadratic(xi, eta);
    case ElementType::Q4:
      return square_bilinear(xi, eta);
    case ElementType::Q8:
      return square_serendipity(xi, eta);
  }
  return {};
}

std::array<double, 2> reference_node(ElementType type, std::size_t i) {
  constexpr std::array<std::array<double, 2>, 6> triangle{{{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};
  constexpr std::array<std::array<double, 2>, 8> square{
      {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
  return mesh::corner_count(type) == 3 ? triangle[i] : square[i];
}

std::span<const IntegrationPoint> integration_points(ElementType type, Rule rule) { return table(type, rule).points; }
std::span<const Shape> shapes_at(ElementType type, Rule rule) { return table(type, rule).shapes; }

Mapped map(std::span<const geom::Point> nodes, const Shape& shape) {
  double x_xi = 0.0, x_eta = 0.0, y_xi = 0.0, y_eta = 0.0;
  Mapped m;
  m.n = shape.n;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    x_xi += shape.d_xi[i] * nodes[i].x;
    x_eta += shape.d_eta[i] * nodes[i].x;
    y_xi += shape.d_xi[i] * nodes[i].y;
    y_eta += shape.d_eta[i] * nodes[i].y;
    m.at = m.at + shape.n[i] * geom::Vector{nodes[i].x, nodes[i].y};
  }
  m.determinant = x_xi * y_eta - x_eta * y_xi;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    m.d_x[i] = (y_eta * shape.d_xi[i] - y_xi * shape.d_eta[i]) / m.determinant;
    m.d_y[i] = (x_xi * shape.d_eta[i] - x_eta * shape.d_xi[i]) / m.determinant;
  }
  return m;
}

ElementGeometry geometry_of(const mesh::ElementMesh& mesh, std::size_t element) {
  ElementGeometry g;
  g.type = mesh.types[element];
  const auto nodes = mesh.nodes_of(mesh::ElementId(element));
  g.count = nodes.size();
  for (std::size_t i = 0; i < g.count; ++i) {
    g.nodes[i] = nodes[i].index();
    g.coordinates[i] = mesh.points[nodes[i].index()];
  }
  return g;
}

Rule stiffness_rule(const ElementGeometry& element) {
  if (element.type == ElementType::T3 || element.type == ElementType::Q4) return Rule::Straight;
  const std::size_t corners = mesh::corner_count(element.type);
  for (std::size_t i = 0; i < corners; ++i) {
    const geom::Point a = element.coordinates[i];
    const geom::Point b = element.coordinates[(i + 1) % corners];
    const geom::Vector off = element.coordinates[corners + i] - geom::midpoint(a, b);
    // 1e-12 of a side: the rounding of a mid-side computed from large coordinates is not a curve.
    if (length_squared(off) > 1e-24 * length_squared(b - a)) return Rule::Curved;
  }
  return Rule::Straight;
}

std::span<const IntegrationPoint> side_points() {
  static const std::vector<IntegrationPoint> points = [] {
    const double inner = std::sqrt(5.0 - 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
    const double outer = std::sqrt(5.0 + 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
    const double inner_weight = (322.0 + 13.0 * std::sqrt(70.0)) / 900.0;
    const double outer_weight = (322.0 - 13.0 * std::sqrt(70.0)) / 900.0;
    return Points{{-outer, 0, outer_weight},
                  {-inner, 0, inner_weight},
                  {0, 0, 128.0 / 225.0},
                  {inner, 0, inner_weight},
                  {outer, 0, outer_weight}};
  }();
  return points;
}

Shape side_shape(ElementType type, double s) {
  if (!mesh::is_quadratic(type)) return {{0.5 * (1 - s), 0.5 * (1 + s)}, {-0.5, 0.5}, {}};
  return {{0.5 * s * (s - 1), 0.5 * s * (s + 1), 1 - s * s}, {s - 0.5, s + 0.5, -2 * s}, {}};
}

}  // namespace dobra::fem
