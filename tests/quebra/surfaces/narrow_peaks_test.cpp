// Meshes of graphs whose formula rises over a place narrower than any net: the area is right, or a finding or a refusal
// tells the place.

#include "tests/support/narrow_peaks.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "quebra/surfaces/mesh_surfaces.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::narrow_peaks_test {
namespace {

using namespace dobra;

base::Result<model::SurfaceMeshed> meshed(const std::string& formula, double size, double turn = 15.0,
                                          SurfaceEngine engine = SurfaceEngine::Front, double half = 3.0) {
  const std::string range = fmt::format("[-{0}, {0}]", half);
  DOBRA_TRY(const Surfaces made, test::surfaces_of("[[input.surface]]\nname = \"g\"\nkind = \"graph\"\nformula = \"" +
                                                   formula + "\"\nu = " + range + "\nv = " + range + "\n"));
  model::SurfaceSet set{.faces = made.faces, .chart_units = {{1.0, 1.0}}, .parts = made.parts};
  SurfaceMeshOptions options{.sizes = {.largest = size, .turn = turn}};
  options.engine = engine;
  options.most_triangles = 400'000;
  return mesh_surfaces(set, options);
}
std::vector<std::string> codes_of(const model::SurfaceMeshed& mesh) {
  std::vector<std::string> codes;
  for (const auto& finding : mesh.findings) codes.push_back(finding.code);
  return codes;
}

TEST(MeshesOfNarrowPeaks, APeakIsMeshedWithItsArea) {
  const struct {
    const char* formula;
    double area;
  } cases[]{{"0.01 * exp(-10000 * (x^2 + y^2))", dobra::support::peak_area(0.01, 1e4)},
            {"0.01 * exp(-10000 * ((x - 0.137)^2 + (y + 0.211)^2))", dobra::support::peak_area(0.01, 1e4)},
            {"0.1 * exp(-3000 * ((x - 0.137)^2 + (y + 0.211)^2))", dobra::support::peak_area(0.1, 3e3)}};
  for (const auto& [formula, area] : cases) {
    for (const double size : {1.0, 0.3, 0.1}) {
      const auto mesh = meshed(formula, size);
      ASSERT_TRUE(mesh.ok()) << formula << ' ' << size << ' ' << (mesh ? "" : to_string(mesh.error()));
      EXPECT_NEAR(mesh->area_surface, area, 1e-6) << formula;
      // Triangles whose sides turn by 15 degrees lose about a hundredth of what the peak adds.
      EXPECT_NEAR(mesh->quality.area - 36.0, area - 36.0, 0.03 * (area - 36.0)) << formula << ' ' << size;
      EXPECT_GT(mesh->quality.alpha_min, 0.3) << formula << ' ' << size;
      // abs(x) has sides along its kink.
      EXPECT_THAT(codes_of(*mesh), testing::Each(testing::Eq("kink"))) << formula << ' ' << size;
    }
  }
}

/// On its flanks, 18 times as steep as wide, straight lines of the chart leave the surface's level at once.
TEST(MeshesOfNarrowPeaks, AHighPeakIsMeshedAtEverySize) {
  const double three = dobra::support::peak_area(3.0, 50.0) - 36.0;
  for (const char* const formula :
       {"3 * exp(-(x^2 + y^2) / 0.02)", "3 * exp(-((x - 0.137)^2 + (y - 0.21)^2) / 0.02)"}) {
    for (const double turn : {10.0, 20.0}) {
      for (const double size : {1.0, 0.4, 0.3}) {
        const auto mesh = meshed(formula, size, turn, SurfaceEngine::Front, 1.0);
        ASSERT_TRUE(mesh.ok()) << formula << ' ' << size << ' ' << turn << ' ' << to_string(mesh.error());
        EXPECT_NEAR(mesh->quality.area, 4.0 + three, 0.01 * three) << formula << ' ' << size << ' ' << turn;
        EXPECT_GT(mesh->quality.alpha_min, 0.3) << formula << ' ' << size << ' ' << turn;
        EXPECT_THAT(codes_of(*mesh), testing::IsEmpty()) << formula << ' ' << size << ' ' << turn;
      }
    }
  }
}

/// The area is right to a hundredth of what the feature adds, or the mesh says what it leaves out, or is refused where
/// the feature is.
TEST(MeshesOfNarrowPeaks, NoneIsLeftOutSilently) {
  const struct {
    const char* formula;
    double area;
    double reach;  ///< A place of the feature is so near to the line or point.
    std::function<double(geom::Point)> away;
  } cases[]{{"exp(-3000 * (x^2 + y^2))", dobra::support::peak_area(1.0, 3e3), 0.15,
             [](geom::Point p) {
               return geom::distance(p, {0, 0});
             }},
            {"exp(-10000 * ((x - 0.137)^2 + (y + 0.211)^2))", dobra::support::peak_area(1.0, 1e4), 0.15,
             [](geom::Point p) {
               return geom::distance(p, {0.137, -0.211});
             }},
            {"0.0001 * exp(-1e8 * ((x - 0.137)^2 + (y + 0.211)^2))", dobra::support::peak_area(1e-4, 1e8), 0.15,
             [](geom::Point p) {
               return geom::distance(p, {0.137, -0.211});
             }}};
  for (const auto& [formula, area, reach, away] : cases) {
    for (const double size : {2.0, 1.0}) {
      for (const SurfaceEngine engine : {SurfaceEngine::Front, SurfaceEngine::Paper}) {
        const auto mesh = meshed(formula, size, 15.0, engine);
        std::optional<base::Place> told;
        if (!mesh) {
          told = mesh.error().place;
          ASSERT_TRUE(told) << to_string(mesh.error());
        } else {
          EXPECT_NEAR(mesh->area_surface, area, 1e-5 * area) << formula;
          const auto found = std::find_if(mesh->findings.begin(), mesh->findings.end(),
                                          [](const auto& finding) { return finding.code == "feature_left_out"; });
          if (found != mesh->findings.end()) told = found->place;
          const double added = told ? area - 36.0 : mesh->quality.area - 36.0;
          EXPECT_NEAR(added, area - 36.0, 0.03 * (area - 36.0)) << formula << ' ' << size;
        }
        if (!told) continue;
        ASSERT_TRUE(told->x && told->y) << formula;
        EXPECT_LT(away({*told->x, *told->y}), reach) << formula << ' ' << size;
      }
    }
  }
}

TEST(MeshesOfNarrowPeaks, PlainGraphsHaveNoSuchFinding) {
  for (const char* const formula : {"x * y / 3", "sin(2 * x) * cos(y)", "exp(-(x^2 + y^2))", "tanh(3 * x)", "abs(x)"}) {
    for (const double size : {0.8, 0.3}) {
      const auto mesh = meshed(formula, size);
      ASSERT_TRUE(mesh.ok()) << formula;
      // abs(x) has sides along its kink.
      EXPECT_THAT(codes_of(*mesh), testing::Each(testing::Eq("kink"))) << formula << ' ' << size;
    }
  }
}

/// A ramp from 0 to 1 between two kinks adds length (sqrt(1 + width^2) - width) to the plane.
TEST(MeshesOfNarrowPeaks, RampsBetweenKinksAreMeshedOrTold) {
  for (const double width : {1.0, 0.1, 0.03, 0.003, 3e-4, 3e-6}) {
    const double wanted = 100.0 + 10.0 * (std::hypot(1.0, width) - width);
    for (const char* const name : {"x", "y"}) {
      const auto mesh =
          meshed(fmt::format("min(1, max(0, ({} - 0.7) / {}))", name, width), 1.0, 15.0, SurfaceEngine::Front, 5.0);
      ASSERT_TRUE(mesh.ok()) << width << ' ' << name << ' ' << to_string(mesh.error());
      EXPECT_NEAR(mesh->area_surface, wanted, 1e-6 * wanted) << width;
      // A millionth of the chart is as near as lines of a mesh come.
      if (width > 1e-5) {
        EXPECT_NEAR(mesh->quality.area, wanted, 1e-9 * wanted) << width << ' ' << name;
        EXPECT_THAT(codes_of(*mesh), testing::Each(testing::Eq("kink"))) << width << ' ' << name;
        continue;
      }
      const auto left_out = std::find_if(mesh->findings.begin(), mesh->findings.end(),
                                         [](const auto& finding) { return finding.code == "feature_left_out"; });
      ASSERT_NE(left_out, mesh->findings.end()) << width << ' ' << name;
      EXPECT_THAT(left_out->message, testing::HasSubstr("takes them for one"));
      EXPECT_NEAR(*name == 'x' ? *left_out->place.u : *left_out->place.v, 0.7, 2.0 * width);
    }
  }
}

/// What asks for too many triangles is refused before anything is meshed.
TEST(MeshesOfNarrowPeaks, ARidgeOfMillionsOfTrianglesIsRefusedWithItsPlace) {
  for (const double size : {1.0, 0.3}) {
    const auto refused = meshed("exp(-1000 * (x - y)^2)", size);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, base::ErrorCode::TooManyElements);
    EXPECT_THAT(refused.error().message, testing::HasSubstr("closely: trim this part"));
    ASSERT_TRUE(refused.error().place && refused.error().place->u && refused.error().place->v);
    EXPECT_LT(std::abs(*refused.error().place->u - *refused.error().place->v), 0.1);
  }
}

}  // namespace
}  // namespace quebra::surfaces::narrow_peaks_test
