#pragma once
// Small structured meshes for the tests and benchmarks of shared/fem: mapped grids of every element type, and polar
// grids round a crack tip with quarter points.

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "shared/mesh/element_mesh.h"

namespace dobra::fem::test {

using geom::Point;
using geom::Vector;
using mesh::ElementMesh;
using mesh::ElementType;
using mesh::NodeId;

inline const std::vector<ElementType> all_types{ElementType::T3, ElementType::T6, ElementType::Q4, ElementType::Q8};
inline const char* name_of(ElementType type) {
  return std::array{"T3", "T6", "Q4", "Q8"}[static_cast<std::size_t>(type)];
}

/// nx x ny cells of the unit square (triangles: two a cell), mapped by `place`; quadratic mid-sides are mapped too.
/// `keep(i, j)` leaves cells out; `region(i, j)` tags them. Side sets bottom, right, top, left (of the unit square).
struct GridOptions {
  std::function<bool(int, int)> keep = [](int, int) { return true; };
  std::function<std::int32_t(int, int)> region = [](int, int) { return 0; };
};

inline ElementMesh mapped_grid(ElementType type, int nx, int ny, const std::function<Point(double, double)>& place,
                               const GridOptions& options = {}) {
  ElementMesh mesh;
  std::map<std::pair<int, int>, NodeId> nodes;  // by half steps
  const auto node = [&](int i, int j) {
    const auto [at, added] = nodes.try_emplace({i, j}, NodeId(mesh.points.size()));
    if (added) mesh.points.push_back(place(0.5 * i / nx, 0.5 * j / ny));
    return at->second;
  };
  const auto add = [&](const std::vector<std::pair<int, int>>& corners, std::int32_t region) {
    std::vector<NodeId> own;
    for (const auto& [i, j] : corners) own.push_back(node(i, j));
    if (mesh::is_quadratic(type)) {
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto [i, j] = corners[k];
        const auto [p, q] = corners[(k + 1) % corners.size()];
        own.push_back(node((i + p) / 2, (j + q) / 2));
      }
    }
    const auto element = add_element(mesh, type, own, region);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto [i, j] = corners[k];
      const auto [p, q] = corners[(k + 1) % corners.size()];
      const mesh::ElementSide side{element, static_cast<std::uint32_t>(k)};
      if (j == 0 && q == 0) mesh.side_sets["bottom"].push_back(side);
      if (i == 2 * nx && p == 2 * nx) mesh.side_sets["right"].push_back(side);
      if (j == 2 * ny && q == 2 * ny) mesh.side_sets["top"].push_back(side);
      if (i == 0 && p == 0) mesh.side_sets["left"].push_back(side);
    }
  };
  for (int cy = 0; cy < ny; ++cy) {
    for (int cx = 0; cx < nx; ++cx) {
      if (!options.keep(cx, cy)) continue;
      const int i = 2 * cx;
      const int j = 2 * cy;
      const std::int32_t region = options.region(cx, cy);
      if (mesh::corner_count(type) == 4) {
        add({{i, j}, {i + 2, j}, {i + 2, j + 2}, {i, j + 2}}, region);
      } else if ((cx + cy) % 2 == 0) {
        add({{i, j}, {i + 2, j}, {i + 2, j + 2}}, region);
        add({{i, j}, {i + 2, j + 2}, {i, j + 2}}, region);
      } else {
        add({{i, j}, {i + 2, j}, {i, j + 2}}, region);
        add({{i + 2, j}, {i + 2, j + 2}, {i, j + 2}}, region);
      }
    }
  }
  return mesh;
}

inline Point unit_square(double s, double t) { return {s, t}; }

/// The quarter plate [0, side]^2 with a hole of radius 1: n cells a quarter of arc (even), m outwards, finer at the
/// hole. Side sets: left = hole, right = outer (both sides), bottom = y 0, top = x 0.
inline ElementMesh quarter_plate(ElementType type, int n, double side = 4.0, double grading = 1.5) {
  return mapped_grid(type, n, n, [=](double s, double t) {
    const double angle = 0.5 * std::numbers::pi * t;
    const Point in{t == 1.0 ? 0.0 : std::cos(angle), t == 0.0 ? 0.0 : std::sin(angle)};
    const Point out = t <= 0.5 ? Point{side, 2.0 * t * side} : Point{(2.0 - 2.0 * t) * side, side};
    return geom::interpolate(in, out, std::pow(s, grading));
  });
}

/// [-1,1]^2 without the quadrant x > 0, y < 0; the corner at the origin; `power` > 1 grades the cells towards it.
inline ElementMesh l_shape(ElementType type, int n, double power = 1.0) {
  const auto corner = [=](double i) {
    const double x = i / n - 1.0;
    return std::copysign(std::pow(std::abs(x), power), x);
  };
  // Mid-sides stand in the middle.
  const auto graded = [=](double s) { return 0.5 * (corner(std::floor(2 * n * s)) + corner(std::ceil(2 * n * s))); };
  ElementMesh mesh = mapped_grid(type, 2 * n, 2 * n,
                                 [&](double s, double t) {
                                   return Point{graded(s), graded(t)};
                                 },
                                 {.keep = [n](int i, int j) { return i < n || j >= n; }});
  mesh.side_sets["loaded"] = boundary_sides(mesh);
  std::erase_if(mesh.side_sets["loaded"], [&](const mesh::ElementSide& side) {
    const auto nodes = side_nodes(mesh, side);
    const Point p = geom::midpoint(mesh.point(nodes[0]), mesh.point(nodes[1]));
    return (p.x > -1e-9 && p.y < 1e-9 && p.x < 1 - 1e-9 && p.y > -1 + 1e-9);
  });
  return mesh;
}

/// Cook's membrane, graded towards the clamped side and both its corners; n even: (48, 52) is a node.
inline ElementMesh cook(ElementType type, int n) {
  return mapped_grid(type, n, n, [](double s, double t) {
    const double x = std::pow(s, 1.8);
    const double y = 0.5 + std::copysign(0.5 - 0.5 * std::pow(1.0 - std::abs(2.0 * t - 1.0), 1.8), t - 0.5);
    return Point{48.0 * x, (1.0 - y) * 44.0 * x + y * (44.0 + 16.0 * x)};
  });
}

inline void name_node(ElementMesh& mesh, const std::string& name, Point at) {
  const auto nearest = std::min_element(mesh.points.begin(), mesh.points.end(),
                                        [&](Point a, Point b) { return distance(a, at) < distance(b, at); });
  mesh.node_sets[name] = {NodeId(static_cast<std::size_t>(nearest - mesh.points.begin()))};
}

inline NodeId node_at(const ElementMesh& mesh, Point at) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (distance(mesh.points[i], at) < 1e-9) return NodeId(i);
  }
  return {};
}

/// A convex region round one crack tip, meshed by rays from the tip: a rosette of `sectors` quarter-point T6, then
/// rings that grow from the circle to the outline. The crack runs straight from the tip to the outline.
struct TipMesh {
  std::vector<Point> outline;  ///< Anticlockwise, star-shaped round the tip; side i is the side set "side i".
  Point tip;
  Vector ahead;          ///< Unit; the crack points there.
  int sectors = 24;      ///< About; rays to the corners come on top.
  double radius = 0.05;  ///< Of the quarter-point elements.
  int circle_rings = 4;  ///< Circular rings, the rosette's included, each `radius` thick.
  double growth = 1.2;   ///< Of the rings beyond them.
  bool quarter = true;   ///< Quarter points (or plain T6).
};

namespace detail {

inline double ray_length(const std::vector<Point>& outline, Point tip, Vector d) {
  double best = 1e300;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point a = outline[i];
    const Vector e = outline[(i + 1) % outline.size()] - a;
    const double det = cross(d, e);
    if (std::abs(det) < 1e-14) continue;
    const double t = cross(a - tip, e) / det;
    const double s = cross(a - tip, d) / det;
    if (t > 1e-12 && s > -1e-9 && s < 1 + 1e-9) best = std::min(best, t);
  }
  return best;
}

}  // namespace detail

/// T6 everywhere. Side sets: "side i", "crack:left", "crack:right"; tip "crack:end".
inline ElementMesh tip_mesh(const TipMesh& options) {
  const auto& [outline, tip, ahead, sectors, radius, circle_rings, growth, quarter] = options;
  const double pi = std::numbers::pi;
  // Rays: the corners of the outline and even steps between them, from -pi (right lip) to pi (left lip).
  std::vector<double> corner_angles{-pi, 0.0, pi};
  for (const Point p : outline) {
    const double angle = std::atan2(cross(ahead, p - tip), dot(ahead, p - tip));
    if (std::abs(std::abs(angle) - pi) > 1e-6 && std::abs(angle) > 1e-6) corner_angles.push_back(angle);
  }
  std::sort(corner_angles.begin(), corner_angles.end());
  const double step = 2.0 * pi / sectors;
  // Inside the circle the rays are even; outside they bend to the corners: count the sectors between corners.
  std::vector<double> outer;
  for (std::size_t k = 0; k + 1 < corner_angles.size(); ++k) {
    const double span = corner_angles[k + 1] - corner_angles[k];
    const int pieces = std::max(1, static_cast<int>(std::lround(span / step)));
    for (int i = 0; i < pieces; ++i) outer.push_back(corner_angles[k] + span * i / pieces);
  }
  outer.push_back(pi);
  // The rosette has the outer rays too, so that every ray is straight.
  const int rays = static_cast<int>(outer.size()) - 1;
  std::vector<double> levels;  // circles, then fractions beyond 1 of the way from the last circle to the outline
  for (int i = 1; i <= circle_rings; ++i) levels.push_back(radius * i);
  const double last = levels.back();
  double shortest = 1e300;
  double longest = 0.0;
  for (const double angle : outer) {
    const Vector d = std::cos(angle) * ahead + std::sin(angle) * left_of(ahead);
    shortest = std::min(shortest, detail::ray_length(outline, tip, d));
    longest = std::max(longest, detail::ray_length(outline, tip, d));
  }
  std::vector<double> fractions{0.0};
  double width = radius * growth / (longest - last);
  while (fractions.back() + width < 1.0) {
    fractions.push_back(fractions.back() + width);
    width *= growth;
  }
  const double all = fractions.back() + 0.5 * width > 1.0 ? fractions.back() : fractions.back() + width;
  if (all > fractions.back()) fractions.push_back(all);
  for (double& f : fractions) f /= all;

  ElementMesh mesh;
  std::map<std::pair<int, int>, NodeId> nodes;  // (level in half steps, ray in half steps); level 0 is the tip
  const int top_level = 2 * (circle_rings + static_cast<int>(fractions.size()) - 1);
  const auto place = [&](int level, int ray) {
    const auto corner = [&](int l, int r) -> Point {
      const double angle = outer[static_cast<std::size_t>(r / 2)];
      const Vector d = r == 0 || r == 2 * rays ? -ahead : std::cos(angle) * ahead + std::sin(angle) * left_of(ahead);
      const int ring = l / 2;
      if (ring <= circle_rings) return tip + (radius * ring) * d;
      const double f = fractions[static_cast<std::size_t>(ring - circle_rings)];
      return tip + (last + f * (detail::ray_length(outline, tip, d) - last)) * d;
    };
    const auto between = [](int k) { return std::pair{k - k % 2, k + k % 2}; };
    const auto [l0, l1] = between(level);
    const auto [r0, r1] = between(ray);
    // Straight sides: a mid-side stands in the middle of its corners. Diagonals run from (l1, r0) to (l0, r1).
    if (level % 2 != 0 && ray % 2 != 0) return geom::midpoint(corner(l1, r0), corner(l0, r1));
    const Point a = corner(l0, r0);
    const Point b = corner(l1, r1);
    if (level == 1 && quarter) return geom::interpolate(a, b, 0.25);
    return geom::midpoint(a, b);
  };
  const auto node = [&](int level, int ray) {
    const auto [at, added] =
        nodes.try_emplace(level == 0 ? std::pair{0, 0} : std::pair{level, ray}, NodeId(mesh.points.size()));
    if (added) mesh.points.push_back(level == 0 ? tip : place(level, ray));
    return at->second;
  };
  const auto add = [&](const std::vector<std::pair<int, int>>& c) {
    std::vector<NodeId> own;
    for (const auto& [l, r] : c) own.push_back(node(l, r));
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [l, r] = c[k];
      auto [p, q] = c[(k + 1) % 3];
      const int ray = l == 0 ? q : (p == 0 ? r : (r + q) / 2);
      own.push_back(node((l + p) / 2, ray));
    }
    const auto element = add_element(mesh, ElementType::T6, own, 0);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [l, r] = c[k];
      const auto [p, q] = c[(k + 1) % 3];
      const int ray = l == 0 ? q : r;
      const int other = p == 0 ? r : q;
      if (ray == 0 && other == 0) mesh.side_sets["crack:right"].push_back({element, k});
      if (ray == 2 * rays && other == 2 * rays) mesh.side_sets["crack:left"].push_back({element, k});
      if (l == top_level && p == top_level) {
        const Point middle = geom::midpoint(mesh.point(own[k]), mesh.point(own[(k + 1) % 3]));
        for (std::size_t i = 0; i < outline.size(); ++i) {
          const Vector e = outline[(i + 1) % outline.size()] - outline[i];
          const double along = dot(e, middle - outline[i]) / length_squared(e);
          if (std::abs(cross(normalised(e), middle - outline[i])) < 1e-9 && along > 0.0 && along < 1.0)
            mesh.side_sets["side " + std::to_string(i)].push_back({element, k});
        }
      }
    }
  };
  for (int r = 0; r < 2 * rays; r += 2) add({{0, 0}, {2, r}, {2, r + 2}});
  for (int l = 2; l < top_level; l += 2) {
    for (int r = 0; r < 2 * rays; r += 2) {
      add({{l, r}, {l + 2, r}, {l, r + 2}});
      add({{l + 2, r}, {l + 2, r + 2}, {l, r + 2}});
    }
  }
  mesh.tips.push_back({"crack:end", node(0, 0), ahead});
  mesh.node_sets["crack:end"] = {node(0, 0)};
  return mesh;
}

}  // namespace dobra::fem::test
