#include "shared/mesh/quality.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

namespace dobra::mesh {
namespace {

using geom::Point;

/// Isosceles triangle of base 1 and height r: alpha = 2 sqrt(3) r / (1.5 + 2 r^2).
double isosceles(double r) { return alpha({0, 0}, {1, 0}, {0.5, r}); }

TEST(Quality, SUR_a_AlphaTakesThePublishedValues) {
  EXPECT_NEAR(alpha({0, 0}, {1, 0}, {0.5, 0.5 * std::numbers::sqrt3}), 1.0, 1e-12);
  EXPECT_NEAR(alpha({0, 0}, {1, 0}, {0, 1}), 0.866025, 1e-6);
  EXPECT_NEAR(alpha({0, 0}, {3, 0}, {0, 4}), 0.831384, 1e-6);
  EXPECT_NEAR(isosceles(0.5), 0.866025, 1e-6);
  EXPECT_NEAR(isosceles(1.0), 0.989743, 1e-6);
  EXPECT_NEAR(isosceles(2.0), 0.729285, 1e-6);
}

TEST(Quality, SUR_a_AlphaIsAtLeastNineTenthsForHeightsFrom0543To1381) {
  EXPECT_GE(isosceles(0.544), 0.9);
  EXPECT_GE(isosceles(1.380), 0.9);
  EXPECT_LT(isosceles(0.542), 0.9);
  EXPECT_LT(isosceles(1.382), 0.9);
}

TEST(Quality, AlphaChangesSignWithTheDirectionAndVanishesForFlatTriangles) {
  EXPECT_DOUBLE_EQ(alpha({0, 0}, {0, 1}, {1, 0}), -alpha({0, 0}, {1, 0}, {0, 1}));
  EXPECT_EQ(alpha({0, 0}, {1, 1}, {2, 2}), 0.0);
  EXPECT_EQ(alpha({1, 1}, {1, 1}, {1, 1}), 0.0);
}

TEST(Quality, AnglesOfTheThreeFourFiveTriangle) {
  const AngleRange angles = angles_of({0, 0}, {3, 0}, {0, 4});
  EXPECT_NEAR(angles.least.degrees(), 36.869898, 1e-6);
  EXPECT_NEAR(angles.greatest.degrees(), 90.0, 1e-12);
}

TEST(Quality, StatisticsOfTwoTrianglesAreThoseWorkedOutByHand) {
  TriangleMesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {0, 1}, {3, 0}};
  mesh.triangles = {{NodeId(0), NodeId(1), NodeId(2)}, {NodeId(1), NodeId(3), NodeId(2)}};
  mesh.regions = {0, 0};
  const MeshQuality quality = quality_of(mesh);
  EXPECT_EQ(quality.nodes, 4U);
  EXPECT_EQ(quality.triangles, 2U);
  EXPECT_DOUBLE_EQ(quality.area, 1.5);
  EXPECT_DOUBLE_EQ(quality.gradation_p95, 2.0);
  EXPECT_EQ(quality.worst, TriangleId(1));
  // Sides 2, sqrt(10), sqrt(2): alpha = 2 sqrt(3) * 2 / 16.
  EXPECT_NEAR(quality.alpha_min, 4.0 * std::numbers::sqrt3 / 16.0, 1e-14);
  EXPECT_NEAR(quality.alpha_mean, 0.5 * (0.5 * std::numbers::sqrt3 + 0.25 * std::numbers::sqrt3), 1e-14);
  EXPECT_EQ(quality.alpha_90, 0.0);
  EXPECT_EQ(std::accumulate(quality.histogram.begin(), quality.histogram.end(), std::size_t{0}), 2U);
  EXPECT_EQ(quality.histogram[17], 1U);
  EXPECT_EQ(quality.histogram[8], 1U);
}

TEST(Quality, AnEmptyMeshHasNoWorstTriangle) {
  const MeshQuality quality = quality_of({});
  EXPECT_EQ(quality.triangles, 0U);
  EXPECT_FALSE(quality.worst.valid());
}

}  // namespace
}  // namespace dobra::mesh
