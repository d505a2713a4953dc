#pragma once
// Meshes of simple solids for the tests, and what several tests say of solids.

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <vector>

#include "shared/mesh/polygon_mesh.h"
#include "shared/solid/boolean.h"
#include "shared/solid/measure.h"
#include "shared/solid/mesh_solid.h"

namespace dobra::solid::shapes {

using geom::Point3;
using mesh::PolygonMesh;

/// The box between two corners.
inline PolygonMesh box(Point3 a, Point3 b) {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.points.push_back({(i & 1) != 0 ? b.x : a.x, (i & 2) != 0 ? b.y : a.y, (i & 4) != 0 ? b.z : a.z});
  }
  mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

/// Over a polygon that runs anticlockwise, from one height to another.
inline PolygonMesh prism(const std::vector<std::pair<double, double>>& outline, double low, double high) {
  PolygonMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  std::vector<std::uint32_t> bottom;
  std::vector<std::uint32_t> top;
  for (const auto& [x, y] : outline) mesh.points.push_back({x, y, low});
  for (const auto& [x, y] : outline) mesh.points.push_back({x, y, high});
  for (std::uint32_t i = 0; i < n; ++i) {
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
    mesh.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  mesh.faces.push_back(bottom);
  mesh.faces.push_back(top);
  return mesh;
}

inline std::vector<std::pair<double, double>> regular(int corners, double radius, double turn = 0.0) {
  std::vector<std::pair<double, double>> outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2.0 * std::numbers::pi * i / corners;
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

/// Teeth between two radii.
inline std::vector<std::pair<double, double>> gear(int teeth, double inner, double outer, double turn = 0.0) {
  std::vector<std::pair<double, double>> outline;
  for (int i = 0; i < 4 * teeth; ++i) {
    const double radius = i % 4 < 2 ? outer : inner;
    const double angle = turn + 2.0 * std::numbers::pi * i / (4 * teeth);
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

/// @pre a, b, c, d are not in a plane; turned as need be.
inline PolygonMesh tetrahedron(Point3 a, Point3 b, Point3 c, Point3 d) {
  PolygonMesh mesh;
  mesh.points = {a, b, c, d};
  mesh.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  if (dot(cross(b - a, c - a), d - a) < 0.0) {
    for (auto& face : mesh.faces) std::swap(face[1], face[2]);
  }
  return mesh;
}

/// Triangles of a sphere: rows of latitude, columns of longitude.
inline PolygonMesh sphere(Point3 centre, double radius, std::uint32_t rows, std::uint32_t columns) {
  PolygonMesh mesh;
  for (std::uint32_t i = 1; i < rows; ++i) {
    const double polar = std::numbers::pi * i / rows;
    for (std::uint32_t j = 0; j < columns; ++j) {
      const double around = 2.0 * std::numbers::pi * j / columns;
      mesh.points.push_back({centre.x + radius * std::sin(polar) * std::cos(around),
                             centre.y + radius * std::sin(polar) * std::sin(around),
                             centre.z + radius * std::cos(polar)});
    }
  }
  const auto top = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back({centre.x, centre.y, centre.z + radius});
  mesh.points.push_back({centre.x, centre.y, centre.z - radius});
  for (std::uint32_t j = 0; j < columns; ++j) {
    const std::uint32_t k = (j + 1) % columns;
    mesh.faces.push_back({top, j, k});
    for (std::uint32_t i = 0; i + 2 < rows; ++i) {
      const std::uint32_t upper = i * columns;
      const std::uint32_t lower = upper + columns;
      mesh.faces.push_back({upper + j, lower + j, lower + k});
      mesh.faces.push_back({upper + j, lower + k, upper + k});
    }
    const std::uint32_t last = (rows - 2) * columns;
    mesh.faces.push_back({top + 1, last + k, last + j});
  }
  return mesh;
}

/// A block under a field of heights: the top has two triangles a cell, top(i, j) is its point at column i and row j.
/// @pre x goes up with i alone, y with j alone; all z are above low.
template <class Top>
PolygonMesh terrain(std::uint32_t columns, std::uint32_t rows, double low, Top&& top) {
  PolygonMesh mesh;
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= columns; ++i) mesh.points.push_back(top(i, j));
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return j * (columns + 1) + i; };
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  // The corners below, anticlockwise from above, and a polygon down from each side of the top.
  const auto below = static_cast<std::uint32_t>(mesh.points.size());
  const std::uint32_t corners[] = {at(0, 0), at(columns, 0), at(columns, rows), at(0, rows)};
  for (const std::uint32_t corner : corners) mesh.points.push_back({mesh.points[corner].x, mesh.points[corner].y, low});
  mesh.faces.push_back({below + 3, below + 2, below + 1, below});
  const auto side = [&](std::uint32_t k, std::uint32_t count, auto&& node) {
    std::vector<std::uint32_t> face{below + k, below + (k + 1) % 4};
    for (std::uint32_t i = 0; i <= count; ++i) face.push_back(node(count - i));
    mesh.faces.push_back(std::move(face));
  };
  side(0, columns, [&](std::uint32_t i) { return at(i, 0); });
  side(1, rows, [&](std::uint32_t j) { return at(columns, j); });
  side(2, columns, [&](std::uint32_t i) { return at(columns - i, rows); });
  side(3, rows, [&](std::uint32_t j) { return at(0, rows - j); });
  return mesh;
}

/// Turned about an axis through the origin, rounded to doubles.
inline PolygonMesh rotated(PolygonMesh mesh, geom::Vector3 axis, double angle) {
  const geom::Vector3 n = normalised(axis);
  for (Point3& p : mesh.points) {
    const geom::Vector3 v = p - Point3{};
    const geom::Vector3 w =
        std::cos(angle) * v + std::sin(angle) * cross(n, v) + (1.0 - std::cos(angle)) * dot(n, v) * n;
    p = Point3{} + w;
  }
  return mesh;
}

inline PolygonMesh moved(PolygonMesh mesh, geom::Vector3 by) {
  for (Point3& p : mesh.points) p = p + by;
  return mesh;
}

inline Solid solid(const PolygonMesh& mesh, const std::string& name = "") {
  FromMeshOptions options;
  options.name = name;
  return from_mesh(mesh, options).value();
}
inline Solid box_solid(Point3 a, Point3 b) { return solid(box(a, b)); }

inline Combined combined(const std::vector<Solid>& operands, Operation operation) {
  return combine(operands, operation).value();
}
inline Solid unite(const std::vector<Solid>& operands) { return combined(operands, Operation::Union).solid; }
inline Solid common(const std::vector<Solid>& operands) { return combined(operands, Operation::Intersection).solid; }
inline Solid subtract(const std::vector<Solid>& operands) { return combined(operands, Operation::Difference).solid; }

/// A cube and the square bars that are to be taken from it, so that a Menger sponge of that depth remains.
/// @pre 3^depth divides the side, so that all is exact.
inline std::vector<Solid> menger_operands(int depth, double side = 27.0) {
  std::vector<Solid> operands{box_solid({0, 0, 0}, {side, side, side})};
  double cell = side;
  for (int level = 0; level < depth; ++level) {
    const double width = cell / 3.0;
    const int count = static_cast<int>(std::lround(side / cell));
    for (int i = 0; i < count; ++i) {
      for (int j = 0; j < count; ++j) {
        // Bars that lie in a wider one are left out.
        bool covered = false;
        for (int k = i, l = j; k > 0 || l > 0; k /= 3, l /= 3) covered = covered || (k % 3 == 1 && l % 3 == 1);
        if (covered) continue;
        const double u = i * cell + width;
        const double v = j * cell + width;
        operands.push_back(box_solid({-1, u, v}, {side + 1, u + width, v + width}));
        operands.push_back(box_solid({u, -1, v}, {u + width, side + 1, v + width}));
        operands.push_back(box_solid({u, v, -1}, {u + width, v + width, side + 1}));
      }
    }
    cell = width;
  }
  return operands;
}

/// What DOBRA_SOLID_CASES asks for; 0 where nothing does.
inline int cases_asked() {
  const char* const wanted = std::getenv("DOBRA_SOLID_CASES");
  return wanted != nullptr ? std::atoi(wanted) : 0;
}

/// The relation of Euler and Poincare, written once more.
inline bool euler_holds(const Counts& c) {
  return static_cast<long>(c.vertices + c.faces) - static_cast<long>(c.edges) ==
         2 * (static_cast<long>(c.shells) - c.handles) + static_cast<long>(c.rings);
}

}  // namespace dobra::solid::shapes
