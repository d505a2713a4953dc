// Egg crates: graphs whose flanks are six times as steep as wide, between narrow crests. Meshed whole, with their area,
// and no triangle looks down.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "quebra/surfaces/mesh_surfaces.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::steep_waves_test {
namespace {

using namespace dobra;

struct Waves {
  double height, along_x, along_y;
  [[nodiscard]] std::string formula() const {
    return fmt::format("{} * sin({} * x) * cos({} * y)", height, along_x, along_y);
  }
  /// Over [low, high] x [low, high], by the midpoint rule of the slopes by hand.
  [[nodiscard]] double area(double low, double high) const {
    constexpr int n = 500;
    const double step = (high - low) / n;
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const double x = low + (i + 0.5) * step, y = low + (j + 0.5) * step;
        const double by_x = height * along_x * std::cos(along_x * x) * std::cos(along_y * y);
        const double by_y = -height * along_y * std::sin(along_x * x) * std::sin(along_y * y);
        sum += std::sqrt(1.0 + by_x * by_x + by_y * by_y);
      }
    }
    return sum * step * step;
  }
};

TEST(SteepWaves, AreMeshedWithTheirArea) {
  for (const Waves& waves : {Waves{0.3, 20, 17}, Waves{0.5, 14, 14}, Waves{0.2, 30, 5}}) {
    for (const double turn : {20.0, 30.0}) {
      const auto made = test::surfaces_of("[[input.surface]]\nname = \"g\"\nkind = \"graph\"\nformula = \"" +
                                          waves.formula() + "\"\nu = [0, 0.5]\nv = [0, 0.5]\n");
      ASSERT_TRUE(made.ok()) << to_string(made.error());
      model::SurfaceSet set{.faces = made->faces, .chart_units = {{1.0, 1.0}}, .parts = made->parts};
      SurfaceMeshOptions options{.sizes = {.largest = 0.1, .turn = turn}};
      options.most_triangles = 400'000;
      const auto mesh = mesh_surfaces(set, options);
      ASSERT_TRUE(mesh.ok()) << waves.formula() << ' ' << turn << ' ' << to_string(mesh.error());
      const double area = waves.area(0.0, 0.5);
      EXPECT_NEAR(mesh->quality.area, area, 0.01 * area) << waves.formula() << ' ' << turn;
      EXPECT_GT(mesh->quality.alpha_mean, 0.97) << waves.formula() << ' ' << turn;
      EXPECT_GT(mesh->quality.alpha_min, 0.3) << waves.formula() << ' ' << turn;
      EXPECT_THAT(mesh->findings, testing::IsEmpty()) << waves.formula() << ' ' << turn;
      for (const auto& corners : mesh->mesh.triangles) {
        const geom::Point3 a = mesh->mesh.point(corners[0]), b = mesh->mesh.point(corners[1]);
        ASSERT_GT(cross(b - a, mesh->mesh.point(corners[2]) - a).z, 0.0) << waves.formula() << ' ' << turn;
      }
    }
  }
}

}  // namespace
}  // namespace quebra::surfaces::steep_waves_test
