#pragma once
// Triangle meshes in space for the tests of parametrisations and remeshing.

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "shared/mesh/polygon_mesh.h"
#include "shared/surf/triangular_patch.h"

namespace dobra::surf::test {

using dobra::mesh::PolygonMesh;

/// A rectangle of columns x rows cells in two triangles each, over [0, 1]^2, each corner where `at` puts it; diagonals
/// change from cell to cell. Cells for which `leave_out` holds are not there.
inline PolygonMesh grid_mesh(std::uint32_t columns, std::uint32_t rows,
                             const std::function<geom::Point3(double, double)>& at,
                             const std::function<bool(std::uint32_t, std::uint32_t)>& leave_out = {}) {
  PolygonMesh mesh;
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= columns; ++i)
      mesh.points.push_back(at(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
  }
  const auto number = [&](std::uint32_t i, std::uint32_t j) { return j * (columns + 1) + i; };
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      if (leave_out && leave_out(i, j)) continue;
      const std::uint32_t a = number(i, j), b = number(i + 1, j), c = number(i + 1, j + 1), d = number(i, j + 1);
      if ((i + j) % 2 == 0) {
        mesh.faces.push_back({a, b, c});
        mesh.faces.push_back({a, c, d});
      } else {
        mesh.faces.push_back({a, b, d});
        mesh.faces.push_back({b, c, d});
      }
    }
  }
  return mesh;
}

/// The same with the corners inside moved at random by a part of a cell.
inline PolygonMesh shaken_grid(std::uint32_t columns, std::uint32_t rows, double by, unsigned seed,
                               const std::function<geom::Point3(double, double)>& at) {
  std::mt19937_64 random(seed);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
  return grid_mesh(columns, rows, [&](double u, double v) {
    const double x = by * unit() / columns, y = by * unit() / rows;
    const bool inside = u > 0.0 && u < 1.0 && v > 0.0 && v < 1.0;
    return inside ? at(u + x, v + y) : at(u, v);
  });
}

inline TriangularPatch octant_patch() {
  const geom::Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const double quarter = std::numbers::pi / 2.0;
  return *TriangularPatch::make(*Curve::arc({}, x, y, 0.0, quarter), *Curve::arc({}, y, z, 0.0, quarter),
                                *Curve::arc({}, z, x, 0.0, quarter));
}

inline PolygonMesh octant_mesh(std::uint32_t n) {
  const TriangularGrid made = grid(octant_patch(), n);
  PolygonMesh mesh{made.points, {}};
  for (const auto& t : made.triangles) mesh.faces.push_back({t[0], t[1], t[2]});
  return mesh;
}

/// A disk of rings round a middle, radius 0 .. 1 and angle put into space by `at`.
inline PolygonMesh disk_mesh(std::uint32_t rings, const std::function<geom::Point3(double, double)>& at) {
  PolygonMesh mesh;
  mesh.points.push_back(at(0.0, 0.0));
  const std::uint32_t spokes = 6;
  std::uint32_t before = 0;
  for (std::uint32_t r = 1; r <= rings; ++r) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size()), count = spokes * r;
    for (std::uint32_t k = 0; k < count; ++k)
      mesh.points.push_back(at(static_cast<double>(r) / rings, 2.0 * std::numbers::pi * k / count));
    for (std::uint32_t s = 0; s < spokes; ++s) {
      for (std::uint32_t k = 0; k < r; ++k) {
        const std::uint32_t out = first + s * r + k, next = first + (s * r + k + 1) % count;
        const std::uint32_t in = r == 1 ? 0 : before + (s * (r - 1) + k) % (spokes * (r - 1));
        mesh.faces.push_back({out, next, in});
        if (k + 1 < r) mesh.faces.push_back({next, before + (s * (r - 1) + k + 1) % (spokes * (r - 1)), in});
      }
    }
    before = first;
  }
  return mesh;
}

inline PolygonMesh half_sphere(std::uint32_t rings) {
  return disk_mesh(rings, [](double r, double a) {
    const double polar = r * std::numbers::pi / 2.0;
    return geom::Point3{std::sin(polar) * std::cos(a), std::sin(polar) * std::sin(a), std::cos(polar)};
  });
}

/// A grid whose left and right sides are joined, and whose bottom and top are too if it is a torus.
inline PolygonMesh tube(std::uint32_t around, std::uint32_t along, bool torus,
                        const std::function<geom::Point3(double, double)>& at) {
  PolygonMesh mesh;
  const std::uint32_t rows = torus ? along : along + 1;
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < around; ++i)
      mesh.points.push_back(at(static_cast<double>(i) / around, static_cast<double>(j) / along));
  }
  const auto number = [&](std::uint32_t i, std::uint32_t j) { return (j % rows) * around + i % around; };
  for (std::uint32_t j = 0; j < along; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      mesh.faces.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      mesh.faces.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  }
  return mesh;
}

inline PolygonMesh torus_mesh(std::uint32_t around, std::uint32_t along) {
  return tube(around, along, true, [](double u, double v) {
    const double a = 2.0 * std::numbers::pi * u, b = 2.0 * std::numbers::pi * v, r = 2.0 + 0.7 * std::cos(b);
    return geom::Point3{r * std::cos(a), r * std::sin(a), 0.7 * std::sin(b)};
  });
}

/// An octahedron whose faces are cut `times` and whose points lie on the unit sphere.
inline PolygonMesh sphere_mesh(std::uint32_t n) {
  PolygonMesh mesh;
  const std::array<geom::Point3, 6> tips{{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  const std::array<std::array<std::size_t, 3>, 8> faces{
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
  for (const auto& f : faces) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const auto number = [&](std::uint32_t i, std::uint32_t k) { return first + k * (2 * n + 3 - k) / 2 + i; };
    for (std::uint32_t k = 0; k <= n; ++k) {
      for (std::uint32_t i = 0; i + k <= n; ++i) {
        // Whole numbers, so that points of two faces are the same to the last bit.
        geom::Vector3 p;
        p = p + static_cast<double>(n - i - k) * (tips[f[0]] - geom::Point3{});
        p = p + static_cast<double>(i) * (tips[f[1]] - geom::Point3{});
        p = p + static_cast<double>(k) * (tips[f[2]] - geom::Point3{});
        mesh.points.push_back(geom::Point3{} + p / geom::length(p));
        if (i + k < n) mesh.faces.push_back({number(i, k), number(i + 1, k), number(i, k + 1)});
        if (i + k + 1 < n) mesh.faces.push_back({number(i + 1, k), number(i + 1, k + 1), number(i, k + 1)});
      }
    }
  }
  return mesh;
}

}  // namespace dobra::surf::test
