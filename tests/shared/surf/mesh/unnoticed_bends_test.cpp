// Bends of less extent than anyone asks for: what files round, and corners of charts that are flat in space.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "shared/surf/mesh/chart_mesher.h"
#include "shared/surf/mesh/chart_sizes.h"
#include "shared/surf/mesh/surface_elements.h"
#include "tests/shared/surf/mesh/faces.h"

namespace dobra::surf::mesh {
namespace {

using geom::Point;
using geom::Point3;

struct Outcome {
  std::size_t triangles = 0;
  SurfaceQuality quality;
};

Outcome outcome_of(const trim::TrimmedSurface& face, double largest) {
  const SizeOptions sizes{.largest = largest, .turn = 15.0};
  const Division division = test::divided({&face, 1}, {.sizes = sizes});
  auto mesher = ChartMesher::start(division.faces[0], {.sizes = sizes});
  if (!mesher) {
    ADD_FAILURE() << base::to_string(mesher.error());
    return {};
  }
  while (!mesher->done()) {
    if (const auto stepped = mesher->step(1000); !stepped) {
      ADD_FAILURE() << base::to_string(stepped.error());
      return {};
    }
  }
  const std::array faces{mesher->mesh()};
  const auto mesh = assemble({&face, 1}, division, faces);
  EXPECT_TRUE(mesh) << base::to_string(mesh.error());
  return {faces[0].chart.triangles.size(), quality_of(*mesh)};
}

/// A fan of a quarter turn and radius 1, a little domed; its sharp end is a side of the chart, `noise` off one point.
trim::TrimmedSurface fan(double noise) {
  std::vector<Point3> points;
  for (int i = 0; i < 4; ++i) {
    const double angle = test::pi / 6.0 * i;
    for (int j = 0; j < 4; ++j) {
      const double r = j / 3.0;
      constexpr std::array dome{0.0, 0.0, 1.0 / 3.0, 1.0};  // v * v
      points.push_back({r * std::cos(angle), r * std::sin(angle), -0.1 * dome.at(static_cast<std::size_t>(j))});
      // As the last digits of a file: no pattern, each of its own sign.
      if (j == 0)
        points.back() = {noise * std::sin(7.0 * i), noise * std::cos(11.0 * i), noise * std::sin(13.0 * i + 1)};
    }
  }
  const std::vector<double> knots{0, 0, 0, 0, 1, 1, 1, 1};
  trim::TrimmedSurface face{.surface = *Surface::nurbs(3, knots, 3, knots, points)};
  face.loops.push_back(test::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}));
  for (trim::ChartEdge& edge : face.loops[0].edges) edge.tolerance = 1e-7;  // as files say
  return face;
}

TEST(UnnoticedBends, NoiseOfACollapsedSideCostsNoTriangles) {
  const Outcome exact = outcome_of(fan(0.0), 0.1);
  ASSERT_GT(exact.triangles, 100u);
  for (const double noise : {1e-12, 1e-10, 1e-8, 3e-8}) {
    const Outcome noisy = outcome_of(fan(noise), 0.1);
    EXPECT_NEAR(static_cast<double>(noisy.triangles), static_cast<double>(exact.triangles),
                0.1 * static_cast<double>(exact.triangles))
        << noise;
    EXPECT_NEAR(noisy.quality.area, exact.quality.area, 1e-3 * exact.quality.area) << noise;
    EXPECT_GT(noisy.quality.alpha_mean, 0.95) << noise;
  }
}

/// Where both isolines run along x at a corner, the surface is flat there, though the normals beside it are many.
TEST(UnnoticedBends, ACornerWhereIsolinesTouchIsMeshed) {
  const std::vector<Point3> points{{1, 1, 0}, {0.8, 0.7, -1}, {0.5, 0, 0}, {0.3, 0.2, -0.5}, {0, 0, 0}, {-0.25, 0, 0}};
  const trim::TrimmedSurface face{.surface = *Surface::nurbs(2, {0, 0, 0, 1, 1, 1}, 1, {0, 0, 1, 1}, points)};
  const Outcome made = outcome_of(face, 0.1);
  EXPECT_GT(made.triangles, 50u);
  EXPECT_LT(made.triangles, 5000u);
}

/// A bend that is smaller than the extent is followed all the same where the surface turns for good.
TEST(UnnoticedBends, ATurnThatStaysIsFollowed) {
  const SizeOptions sizes{.largest = 1.0, .turn = 15.0};
  const double extent = unnoticed_bend(1.0, sizes);
  EXPECT_EQ(extent, 1e-3);
  for (const double part : {0.01, 0.1, 0.5, 2.0}) {
    const Surface tube = *Surface::cylinder({}, part * extent, {{0, 0}, {test::pi, 10.0 * extent}});
    for (const double u : {0.0, 0.3, 1.5, test::pi}) {
      const double bend = followed_bend(tube, {u, extent}, tube.jet({u, extent}), extent, sizes);
      EXPECT_NEAR(bend * part * extent, 1.0, 1e-9) << part;
    }
  }
  const Outcome wire = outcome_of({.surface = *Surface::cylinder({}, 3e-4, {{0, 0}, {test::pi, 2e-3}})}, 1.0);
  EXPECT_NEAR(wire.quality.area, test::pi * 3e-4 * 2e-3, 0.01 * test::pi * 3e-4 * 2e-3);
  EXPECT_GT(wire.triangles, 24u * 7u);  // 180 / 15 sides round, and as short ones along
}

/// The apex of a cone is no noise: its normals are many however near one looks.
TEST(UnnoticedBends, AnApexIsNoNoise) {
  const SizeOptions sizes{.largest = 1.0, .turn = 15.0};
  const Surface cone = *Surface::cone({}, 0.0, test::pi / 6.0, {{0, 0}, {6.0, 1.0}});
  const Jet near = cone.jet({3.0, 1e-6});
  EXPECT_NEAR(followed_bend(cone, {3.0, 1e-6}, near, 1e-3, sizes) * 1e-6 * std::tan(test::pi / 6.0), 1.0, 1e-9);
}

TEST(UnnoticedBends, TheChordLimitsThem) {
  EXPECT_EQ(unnoticed_bend(1.0, {.turn = 15.0, .chord = 1e-4}), 2.5e-5);
  EXPECT_EQ(unnoticed_bend(1.0, {.turn = 15.0, .chord = 1.0}), 1e-3);
}

TEST(Division, AnEdgeNoLongerThanItsToleranceIsOneNode) {
  const auto face = [](double length, double tolerance) {
    trim::TrimmedSurface made{.surface = test::flat(10, 10),
                              .loops = {test::polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, length}}, "side")}};
    made.loops[0].edges.back().name = "stub";
    made.loops[0].edges.back().tolerance = tolerance;
    return test::divided({&made, 1}, {.sizes = {.largest = 1.0}});
  };
  const Division one = face(1e-3, 2e-3), apart = face(1e-3, 5e-4);
  EXPECT_EQ(test::count_of(apart.faces[0], "stub"), 1u);
  EXPECT_EQ(one.nodes + 1, apart.nodes);
  // A ring within its tolerance is a hole that is there, not a point.
  trim::TrimmedSurface holed{.surface = test::flat(10, 10),
                             .loops = {test::polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}})}};
  holed.loops.push_back({{test::backwards(test::circle({5, 5}, 0.1, "hole"))}});
  holed.loops[1].edges[0].tolerance = 1.0;
  EXPECT_GE(test::count_of(test::divided({&holed, 1}, {.sizes = {.largest = 1.0}}).faces[0], "hole"), 3u);
}

}  // namespace
}  // namespace dobra::surf::mesh
