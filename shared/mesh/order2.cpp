#include "shared/mesh/order2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dobra::mesh {

using geom::Point;
using geom::Vector;

namespace {

/// Coordinates of an element's nodes, and what the Jacobian is made of.
struct Shape {
  ElementType type;
  std::array<Point, 8> node;
};

/// Derivatives of the shape functions of T3/T6 on (0,0) (1,0) (0,1), of Q4/Q8 on [-1,1]^2.
std::array<Vector, 8> derivatives(ElementType type, double x, double y) {
  std::array<Vector, 8> d{};
  switch (type) {
    case ElementType::T3:
      d = {{{-1, -1}, {1, 0}, {0, 1}}};
      break;
    case ElementType::T6: {
      const double z = 1.0 - x - y;
      d = {{{1 - 4 * z, 1 - 4 * z},
            {4 * x - 1, 0},
            {0, 4 * y - 1},
            {4 * (z - x), -4 * x},
            {4 * y, 4 * x},
            {-4 * y, 4 * (z - y)}}};
      break;
    }
    case ElementType::Q4:
    case ElementType::Q8: {
      constexpr std::array<Vector, 4> corner{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
      for (std::size_t i = 0; i < 4; ++i) {
        const auto [a, b] = corner[i];
        d[i] = type == ElementType::Q4
                   ? Vector{0.25 * a * (1 + b * y), 0.25 * b * (1 + a * x)}
                   : Vector{0.25 * a * (1 + b * y) * (2 * a * x + b * y), 0.25 * b * (1 + a * x) * (2 * b * y + a * x)};
      }
      if (type == ElementType::Q8) {
        d[4] = {-x * (1 - y), -0.5 * (1 - x * x)};
        d[5] = {0.5 * (1 - y * y), -y * (1 + x)};
        d[6] = {-x * (1 + y), 0.5 * (1 - x * x)};
        d[7] = {-0.5 * (1 - y * y), -y * (1 - x)};
      }
      break;
    }
  }
  return d;
}

double jacobian(const Shape& shape, double x, double y) {
  const std::array<Vector, 8> d = derivatives(shape.type, x, y);
  Vector by_x, by_y;
  for (std::size_t i = 0; i < node_count(shape.type); ++i) {
    const Vector at = shape.node[i] - shape.node[0];
    by_x = by_x + d[i].x * at;
    by_y = by_y + d[i].y * at;
  }
  return geom::cross(by_x, by_y);
}

/// The determinant of a T6 is a quadratic: corners are coefficients, mid-sides give the other three.
double triangle_bound(const Shape& shape) {
  const std::array<double, 3> corner{jacobian(shape, 0, 0), jacobian(shape, 1, 0), jacobian(shape, 0, 1)};
  const std::array<double, 3> middle{jacobian(shape, 0.5, 0), jacobian(shape, 0.5, 0.5), jacobian(shape, 0, 0.5)};
  double least = std::min({corner[0], corner[1], corner[2]});
  for (std::size_t i = 0; i < 3; ++i)
    least = std::min(least, 2.0 * middle[i] - 0.5 * (corner[i] + corner[(i + 1) % 3]));
  return least;
}

/// Cubic Bernstein coefficients from the values at 0, 1/3, 2/3, 1.
std::array<double, 4> bernstein(const std::array<double, 4>& f) {
  return {f[0], (-5 * f[0] + 18 * f[1] - 9 * f[2] + 2 * f[3]) / 6, (2 * f[0] - 9 * f[1] + 18 * f[2] - 5 * f[3]) / 6,
          f[3]};
}

/// The determinant of a Q8 is of degree three in each variable at most.
double quadrilateral_bound(const Shape& shape) {
  std::array<std::array<double, 4>, 4> rows{};
  for (std::size_t j = 0; j < 4; ++j) {
    std::array<double, 4> values{};
    for (std::size_t i = 0; i < 4; ++i) {
      values[i] = jacobian(shape, -1.0 + 2.0 * static_cast<double>(i) / 3.0, -1.0 + 2.0 * static_cast<double>(j) / 3.0);
    }
    rows[j] = bernstein(values);
  }
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i) {
    for (const double c : bernstein({rows[0][i], rows[1][i], rows[2][i], rows[3][i]})) least = std::min(least, c);
  }
  return least;
}

Shape shape_at(const ElementMesh& mesh, ElementId element) {
  Shape shape{mesh.types[element.index()], {}};
  const auto nodes = mesh.nodes_of(element);
  for (std::size_t i = 0; i < nodes.size(); ++i) shape.node[i] = mesh.point(nodes[i]);
  return shape;
}

/// The same elements with room for mid-side nodes, and straight sides.
ElementMesh with_midpoints(const ElementMesh& linear) {
  ElementMesh mesh;
  mesh.points = linear.points;
  mesh.regions = linear.regions;
  mesh.region_names = linear.region_names;
  mesh.side_sets = linear.side_sets;
  mesh.node_sets = linear.node_sets;
  mesh.tips = linear.tips;
  mesh.first.reserve(linear.first.size());
  mesh.nodes.reserve(2 * linear.nodes.size());
  mesh.first.push_back(0);
  const std::vector<ElementSide> neighbours = neighbours_of(linear);
  std::size_t side = 0;
  for (std::size_t e = 0; e < linear.element_count(); ++e) {
    const auto corners = linear.nodes_of(ElementId(e));
    mesh.types.push_back(corners.size() == 3 ? ElementType::T6 : ElementType::Q8);
    mesh.nodes.insert(mesh.nodes.end(), corners.begin(), corners.end());
    for (std::uint32_t i = 0; i < corners.size(); ++i, ++side) {
      const ElementSide across = neighbours[side];
      if (across.element.valid() && across.element < ElementId(e)) {
        const std::size_t there = corner_count(linear.types[across.element.index()]);
        mesh.nodes.push_back(mesh.nodes[mesh.first[across.element.index()] + there + across.side]);
        continue;
      }
      mesh.nodes.push_back(NodeId(mesh.points.size()));
      mesh.points.push_back(geom::midpoint(linear.point(corners[i]), linear.point(corners[(i + 1) % corners.size()])));
    }
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.nodes.size()));
  }
  return mesh;
}

}  // namespace

double scaled_jacobian_bound(const ElementMesh& mesh, ElementId element) {
  const Shape shape = shape_at(mesh, element);
  const bool triangle = corner_count(shape.type) == 3;
  double straight = 0.0;
  for (std::size_t i = 1; i + 1 < corner_count(shape.type); ++i) {
    straight += 0.5 * geom::cross(shape.node[i] - shape.node[0], shape.node[i + 1] - shape.node[0]);
  }
  return triangle ? triangle_bound(shape) / (2.0 * straight) : quadrilateral_bound(shape) / (0.25 * straight);
}

bool is_quarter_point(const ElementMesh& mesh, ElementId element) {
  constexpr double rounding = 1e-6;
  const ElementType type = mesh.types[element.index()];
  if (!is_quadratic(type)) return false;
  const auto nodes = mesh.nodes_of(element);
  const std::size_t n = corner_count(type);
  const auto at_quarter = [&](std::size_t corner, std::size_t other, std::size_t middle) {
    const Point from = mesh.point(nodes[corner]), to = mesh.point(nodes[other]);
    return distance(mesh.point(nodes[middle]), geom::interpolate(from, to, 0.25)) <= rounding * distance(from, to);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    if (at_quarter(i, (i + 1) % n, n + i) && at_quarter(i, before, n + before)) return true;
  }
  return false;
}

SecondOrder to_second_order(ElementMesh linear, const std::map<std::string, MiddleOfCurve>& curves) {
  SecondOrder result{with_midpoints(linear), 0, {}};
  ElementMesh& mesh = result.mesh;
  const std::vector<ElementSide> neighbours = neighbours_of(linear);
  std::vector<std::size_t> first_side(linear.element_count() + 1, 0);
  for (std::size_t e = 0; e < linear.element_count(); ++e)
    first_side[e + 1] = first_side[e] + corner_count(linear.types[e]);
  for (const auto& [name, middle] : curves) {
    const auto set = mesh.side_sets.find(name);
    if (set == mesh.side_sets.end()) continue;
    for (const ElementSide& side : set->second) {
      const auto [from, to, mid] = side_nodes(mesh, side);
      const Point straight = mesh.point(mid);
      const Point curved = middle(mesh.point(from), mesh.point(to));
      if (curved == straight) continue;
      mesh.points[mid.index()] = curved;
      const ElementSide across = neighbours[first_side[side.element.index()] + side.side];
      const auto inverted = [&](ElementId element) {
        return element.valid() && !(scaled_jacobian_bound(mesh, element) > 0.0);
      };
      if (inverted(side.element) || inverted(across.element)) {
        mesh.points[mid.index()] = straight;
        result.straightened.push_back(side);
      } else {
        ++result.curved;
      }
    }
  }
  return result;
}

}  // namespace dobra::mesh
