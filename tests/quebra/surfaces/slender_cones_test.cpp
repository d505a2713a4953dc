// Full cones and sectors of them whose sides are 1 to 10 degrees from the axis, by size: area by pi r s, triangles that
// look as the surface does, and angles.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "quebra/surfaces/mesh_surfaces.h"
#include "shared/surf/measure.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::slender_cones_test {
namespace {

using namespace dobra;

constexpr double height = 10.0;

struct Cone {
  double half_angle;  ///< Degrees.
  double turn = 360;  ///< Degrees.
  [[nodiscard]] double sine() const { return std::sin(half_angle * std::numbers::pi / 180.0); }
  [[nodiscard]] double slant() const { return height / std::cos(half_angle * std::numbers::pi / 180.0); }
  [[nodiscard]] double area() const { return std::numbers::pi * slant() * slant() * sine() * turn / 360.0; }
  [[nodiscard]] std::string text() const {
    std::string made =
        "[[input.surface]]\nname = \"c\"\nkind = \"cone\"\nradius = 0\nhalf_angle = " + std::to_string(half_angle) +
        "\nv = [0, " + std::to_string(slant()) + "]\n";
    if (turn < 360) made += "u = [10, " + std::to_string(10.0 + turn) + "]\n";
    return made;
  }
};

base::Result<model::SurfaceMeshed> meshed(const std::string& text, double size) {
  DOBRA_TRY(const Surfaces made, test::surfaces_of(text));
  model::SurfaceSet set{.faces = made.faces, .chart_units = {}, .parts = made.parts};
  for (const ChartUnits& units : made.units) set.chart_units.push_back({units.u, units.v});
  SurfaceMeshOptions options{.sizes = {.largest = size}};
  options.most_triangles = 2'000'000;
  return mesh_surfaces(set, options);
}

/// Triangles whose normal is against the one of the cone round the z axis at their middle.
std::size_t folded(const surf::mesh::SurfaceMesh& mesh, const Cone& cone) {
  std::size_t count = 0;
  const double tangent = cone.sine() / std::sqrt(1.0 - cone.sine() * cone.sine());
  for (const auto& corners : mesh.triangles) {
    const geom::Point3 a = mesh.point(corners[0]), b = mesh.point(corners[1]), c = mesh.point(corners[2]);
    const geom::Vector3 middle = ((a - geom::Point3{}) + (b - geom::Point3{}) + (c - geom::Point3{})) / 3.0;
    const double r = std::hypot(middle.x, middle.y);
    const geom::Vector3 out{middle.x / r, middle.y / r, -tangent};
    if (!(dot(cross(b - a, c - a), out) > 0.0)) ++count;
  }
  return count;
}

class SlenderCones : public testing::TestWithParam<double> {};

TEST_P(SlenderCones, AreMeshedWholeAtAnySize) {
  const Cone cone{GetParam()};
  for (const double size : {2.0, 0.5, 0.1}) {
    if (size < 0.5 && cone.half_angle < 2.0) continue;  // many triangles
    const auto mesh = meshed(cone.text(), size);
    ASSERT_TRUE(mesh.ok()) << size << ' ' << (mesh ? "" : to_string(mesh.error()));
    EXPECT_NEAR(mesh->quality.area, cone.area(), 3e-3 * cone.area()) << size;
    EXPECT_EQ(folded(mesh->mesh, cone), 0u) << size;
    EXPECT_GT(mesh->quality.alpha_mean, 0.95) << size;
    // Closed but for the rim: each side of the others is of two triangles.
    std::size_t open = 0;
    for (const auto& [name, edges] : mesh->mesh.boundary_sets) open += edges.size();
    EXPECT_GT(open, 10u);
    const auto euler = static_cast<long>(mesh->mesh.points.size()) * 2 - static_cast<long>(mesh->mesh.triangles.size());
    EXPECT_EQ(euler, static_cast<long>(open) + 2) << size;  // V - E + F = 1 and 2 E = 3 F + open
  }
}

TEST_P(SlenderCones, SectorsAreAsGoodAsTheirCorner) {
  const Cone cone{GetParam(), 90.0};
  const double corner = cone.sine() * 0.5 * std::numbers::pi;
  const double bound = std::sqrt(3.0) * std::sin(corner) / (2.0 - std::cos(corner));
  for (const double size : {2.0, 0.5, 0.1}) {
    if (size < 0.5 && cone.half_angle < 2.0) continue;
    const auto mesh = meshed(cone.text(), size);
    ASSERT_TRUE(mesh.ok()) << size << ' ' << (mesh ? "" : to_string(mesh.error()));
    EXPECT_NEAR(mesh->quality.area, cone.area(), 3e-3 * cone.area()) << size;
    EXPECT_EQ(folded(mesh->mesh, cone), 0u) << size;
    EXPECT_GT(mesh->quality.alpha_min, 0.85 * bound) << size;
  }
}

INSTANTIATE_TEST_SUITE_P(ByHalfAngle, SlenderCones, testing::Values(1.0, 2.0, 5.0, 10.0));

}  // namespace
}  // namespace quebra::surfaces::slender_cones_test
