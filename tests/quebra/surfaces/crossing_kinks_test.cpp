// Graphs of formulas with kinks along x and along y that cross: pieces are planes, so the area is that of the planes,
// exactly, wherever the kinks run.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "quebra/surfaces/mesh_surfaces.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::crossing_kinks_test {
namespace {

using namespace dobra;

base::Result<model::SurfaceMeshed> meshed(const std::string& formula, double low, double high, double size) {
  DOBRA_TRY(const Surfaces made,
            test::surfaces_of(fmt::format(
                "[[input.surface]]\nname = \"g\"\nkind = \"graph\"\nformula = \"{}\"\nu = [{}, {}]\nv = [{}, {}]\n",
                formula, low, high, low, high)));
  model::SurfaceSet set{.faces = made.faces, .chart_units = {{1.0, 1.0}}, .parts = made.parts};
  return mesh_surfaces(set, {.sizes = {.largest = size, .turn = 15.0}, .most_triangles = 400'000});
}

/// Rises by 1 over `width` from `from` on.
struct Ramp {
  double from, width;
  [[nodiscard]] std::string of(char name) const {
    return fmt::format("min(1, max(0, ({} - {}) / {}))", name, from, width);
  }
};

/// Of sums of ramps along x and ramps along y, by the planes between their kinks; ramps do not overlap.
double area_of(const std::vector<Ramp>& along_x, const std::vector<Ramp>& along_y, double length) {
  struct Part {
    double width, slope;
  };
  const auto parts = [&](const std::vector<Ramp>& ramps) {
    std::vector<Part> made;
    double rest = length;
    for (const Ramp& ramp : ramps) made.push_back({ramp.width, 1.0 / ramp.width}), rest -= ramp.width;
    made.push_back({rest, 0.0});
    return made;
  };
  double area = 0.0;
  for (const Part& x : parts(along_x)) {
    for (const Part& y : parts(along_y)) area += x.width * y.width * std::hypot(1.0, x.slope, y.slope);
  }
  return area;
}

void expect_sound(const base::Result<model::SurfaceMeshed>& mesh, double area, const std::string& what) {
  ASSERT_TRUE(mesh.ok()) << what << ": " << to_string(mesh.error());
  EXPECT_NEAR(mesh->quality.area, area, 1e-9 * area) << what;
  EXPECT_NEAR(mesh->area_surface, area, 1e-6 * area) << what;
  EXPECT_GE(mesh->quality.alpha_min, 0.1) << what;
  for (const auto& finding : mesh->findings) EXPECT_EQ(finding.code, "kink") << what << ": " << finding.message;
}

TEST(CrossingKinks, TwoRampsAreMeshedWhereverTheyCross) {
  std::mt19937 random(7);
  std::vector<std::array<double, 4>> cases{{-5, 5, 0.7, 0.7}, {0, 10, 5, 4}, {-5, 5, 0.1, -0.3}};
  for (int i = 0; i < 12; ++i) {
    std::uniform_int_distribution<int> digits(-45'000, 43'000);
    cases.push_back({-5, 5, digits(random) / 1e4, digits(random) / 1e4});
  }
  for (const auto& [low, high, a, b] : cases) {
    const Ramp x{a, 0.1}, y{b, 0.1};
    const std::string formula = x.of('x') + " + " + y.of('y');
    for (const double size : {1.0, 0.4})
      expect_sound(meshed(formula, low, high, size), area_of({x}, {y}, high - low),
                   fmt::format("{} {}", formula, size));
  }
}

TEST(CrossingKinks, ManyRampsOfOtherWidths) {
  const std::vector<Ramp> x{{-3.3, 0.7}, {-0.1, 0.05}, {1.7, 0.3}}, y{{-4.1, 0.2}, {0.9, 1.1}, {2.3, 0.06}};
  std::string formula;
  for (const Ramp& ramp : x) formula += (formula.empty() ? "" : " + ") + ramp.of('x');
  for (const Ramp& ramp : y) formula += " + " + ramp.of('y');
  for (const double size : {1.0, 0.3}) expect_sound(meshed(formula, -5, 5, size), area_of(x, y, 10.0), formula);
}

TEST(CrossingKinks, RoofsOfAbsoluteValues) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> digits(-4500, 4500);
  for (int i = 0; i < 10; ++i) {
    const double a = digits(random) / 1e3, b = digits(random) / 1e3;
    for (const double slope : {1.0, 3.0}) {
      const std::string formula = fmt::format("{} * (abs(x - {}) + abs(y - {}))", slope, a, b);
      expect_sound(meshed(formula, -5, 5, 0.7), 100.0 * std::sqrt(1.0 + 2.0 * slope * slope), formula);
    }
  }
}

TEST(CrossingKinks, AJumpAcrossAKinkIsRefusedWhereItIs) {
  const auto refused = meshed("abs(x - 0.3) + floor(y - 0.7)", -3.0, 3.0, 0.5);
  ASSERT_FALSE(refused.ok());
  ASSERT_TRUE(refused.error().place && refused.error().place->y);
  const double y = *refused.error().place->y - 0.7;
  EXPECT_NEAR(y, std::round(y), 1e-6);
}

}  // namespace
}  // namespace quebra::surfaces::crossing_kinks_test
