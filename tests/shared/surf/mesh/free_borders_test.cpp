// Seams freed: what only cuts a surface leaves no trace, and what must stay does.

#include "shared/surf/mesh/free_borders.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "shared/surf/mesh/assemble.h"
#include "tests/shared/surf/surface_shapes.h"

namespace dobra::surf::mesh {
namespace {

using geom::Point;
using test::pi;

/// A whole cylinder of radius 1 in columns of squares cut along one diagonal; the seam at u = 0 is crooked: its inner
/// nodes are shifted along v, which makes the triangles beside it bad.
struct Cylinder {
  trim::TrimmedSurface face{.surface = *Surface::cylinder({}, 1.0, {{0.0, 0.0}, {2.0 * pi, 4.0}}), .loops = {}};
  SurfaceMesh mesh;
  std::size_t columns = 12, rows = 8;

  explicit Cylinder(double shift) {
    const double width = 2.0 * pi / static_cast<double>(columns), height = 4.0 / static_cast<double>(rows);
    const auto place = [&](std::size_t i, std::size_t j) {
      const bool seam = i % columns == 0 && j > 0 && j < rows;
      return Point{width * static_cast<double>(i), height * static_cast<double>(j) + (seam ? shift : 0.0)};
    };
    const auto node = [&](std::size_t i, std::size_t j) { return NodeId((i % columns) * (rows + 1) + j); };
    for (std::size_t i = 0; i < columns; ++i) {
      for (std::size_t j = 0; j <= rows; ++j) mesh.points.push_back(face.surface.at(place(i, j)));
    }
    const auto add = [&](std::array<std::size_t, 2> a, std::array<std::size_t, 2> b, std::array<std::size_t, 2> c) {
      mesh.triangles.push_back({node(a[0], a[1]), node(b[0], b[1]), node(c[0], c[1])});
      mesh.places.push_back({place(a[0], a[1]), place(b[0], b[1]), place(c[0], c[1])});
      mesh.faces.push_back(0);
      mesh.regions.push_back(1);
    };
    for (std::size_t i = 0; i < columns; ++i) {
      for (std::size_t j = 0; j < rows; ++j) {
        add({i, j}, {i + 1, j}, {i + 1, j + 1});
        add({i, j}, {i + 1, j + 1}, {i, j + 1});
      }
    }
    for (std::size_t j = 0; j < rows; ++j) mesh.constraint_sets["seam"].push_back({node(0, j), node(0, j + 1)});
  }
};

TEST(FreeBorders, SeamsAreSmoothedAwayAndTheSetIsGone) {
  Cylinder cylinder(0.2);
  ASSERT_TRUE(check(cylinder.mesh).ok());
  const SurfaceQuality before = quality_of(cylinder.mesh);
  const std::vector<std::size_t> owner{0};
  EXPECT_GT(free_borders(cylinder.mesh, {&cylinder.face, 1}, owner, "seam"), 0U);
  ASSERT_TRUE(check(cylinder.mesh).ok());
  const SurfaceQuality after = quality_of(cylinder.mesh);
  EXPECT_GT(after.alpha_min, before.alpha_min + 0.05);
  EXPECT_FALSE(cylinder.mesh.constraint_sets.contains("seam"));
  EXPECT_EQ(after.triangles, before.triangles);
  EXPECT_EQ(after.euler, before.euler);
  for (const geom::Point3 p : cylinder.mesh.points) EXPECT_NEAR(std::hypot(p.x, p.y), 1.0, 1e-12);
  // Each corner's place is where its node is.
  for (std::size_t t = 0; t < cylinder.mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const geom::Point3 at = cylinder.face.surface.at(cylinder.mesh.places[t][i]);
      EXPECT_LT(distance(at, cylinder.mesh.point(cylinder.mesh.triangles[t][i])), 1e-12);
    }
  }
}

TEST(FreeBorders, WhatIsAnotherSetOrABorderStays) {
  Cylinder cylinder(0.2);
  cylinder.mesh.node_sets["gauge"] = {NodeId(3)};
  const SurfaceMesh before = cylinder.mesh;
  cylinder.mesh.constraint_sets["line"] = cylinder.mesh.constraint_sets["seam"];
  const std::vector<std::size_t> owner{0};
  free_borders(cylinder.mesh, {&cylinder.face, 1}, owner, "seam");
  for (std::size_t j = 0; j <= cylinder.rows; ++j) EXPECT_EQ(cylinder.mesh.points[j], before.points[j]);
  for (std::size_t n = 0; n < before.points.size(); ++n) {
    if (before.points[n].z == 0.0 || before.points[n].z == 4.0) {
      EXPECT_EQ(cylinder.mesh.points[n], before.points[n]);
    }
  }
}

TEST(FreeBorders, ASetThatIsNotThereChangesNothing) {
  Cylinder cylinder(0.2);
  const SurfaceMesh before = cylinder.mesh;
  const std::vector<std::size_t> owner{0};
  EXPECT_EQ(free_borders(cylinder.mesh, {&cylinder.face, 1}, owner, "none"), 0U);
  EXPECT_EQ(cylinder.mesh, before);
}

}  // namespace
}  // namespace dobra::surf::mesh
