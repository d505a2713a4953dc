// How far normals turn along the sides of a mesh, by the angle between the radii of a sphere: docs/user/surfaces.md.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "quebra/surfaces/mesh_surfaces.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces {
namespace {

using namespace dobra;

struct Turns {
  double mean = 0.0, most = 0.0;  ///< Degrees.
};

/// Of the sides of a sphere of radius 5, each as often as it has triangles: twice.
Turns turns_of_sphere(double turn) {
  const auto made = test::surfaces_of("[[input.surface]]\nname = \"s\"\nkind = \"sphere\"\nradius = 5\n");
  EXPECT_TRUE(made.ok());
  model::SurfaceSet set{.faces = made->faces, .chart_units = {}, .parts = made->parts};
  for (const ChartUnits& units : made->units) set.chart_units.push_back({units.u, units.v});
  const auto meshed = mesh_surfaces(set, {.sizes = {.largest = 50.0, .turn = turn}});
  EXPECT_TRUE(meshed.ok());
  if (!meshed) return {};
  Turns turns;
  for (const auto& corners : meshed->mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double side = geom::distance(meshed->mesh.point(corners[i]), meshed->mesh.point(corners[(i + 1) % 3]));
      const double own = 2.0 * std::asin(side / (2.0 * 5.0)) * 180.0 / std::numbers::pi;
      turns.mean += own / (3.0 * static_cast<double>(meshed->mesh.triangles.size()));
      turns.most = std::max(turns.most, own);
    }
  }
  return turns;
}

TEST(TurnOfSides, IsAsAskedInTheMeanAndHalfAsMuchAgainAtMost) {
  for (const double turn : {5.0, 10.0, 15.0}) {
    const Turns found = turns_of_sphere(turn);
    std::cout << fmt::format("sphere, turn {}: normals turn by {:.2f} degrees in the mean, {:.2f} at most\n", turn,
                             found.mean, found.most);
    EXPECT_NEAR(found.mean, turn, 0.1 * turn);
    EXPECT_GT(found.most, turn);  // or the page would say too little
    EXPECT_LE(found.most, 1.5 * turn);
  }
}

}  // namespace
}  // namespace quebra::surfaces
