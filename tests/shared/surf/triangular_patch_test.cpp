#include "shared/surf/triangular_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shared/surf/measure.h"

namespace dobra::surf {
namespace {

using geom::Point3;
using geom::Vector3;

constexpr double quarter = std::numbers::pi / 2.0;

/// The patch between the three quarters of great circles of a unit sphere.
TriangularPatch octant() {
  const Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  return *TriangularPatch::make(*Curve::arc({}, x, y, 0.0, quarter), *Curve::arc({}, y, z, 0.0, quarter),
                                *Curve::arc({}, z, x, 0.0, quarter));
}

Curve bezier(std::vector<Point3> points) { return *Curve::bezier(std::move(points)); }

struct Three {
  Curve first, second, third;
};
Three arbitrary() {
  return {bezier({{0, 0, 0}, {1, -0.4, 0.8}, {2.2, 0.3, -1}, {3, 0, 0.5}}),
          bezier({{3, 0, 0.5}, {3.5, 1, 1.5}, {1.5, 2, 1}}), bezier({{1.5, 2, 1}, {0.2, 1.4, 0}, {0, 0, 0}})};
}

TEST(TriangularPatch, ThreeCurvesThatDoNotMeetAreRefusedWithTheGapAndItsPlace) {
  const auto apart = TriangularPatch::make(*Curve::line({0, 0, 0}, {4, 0, 0}), *Curve::line({4, 0, 0}, {0, 3, 0.25}),
                                           *Curve::line({0, 3, 0}, {0, 0, 0}));
  ASSERT_FALSE(apart.ok());
  EXPECT_EQ(apart.error().code, base::ErrorCode::DegenerateCurve);
  EXPECT_NE(apart.error().message.find("0.25 m"), std::string::npos) << apart.error().message;
  ASSERT_TRUE(apart.error().place && apart.error().place->z);
  EXPECT_NEAR(*apart.error().place->y, 3.0, 1e-12);
  EXPECT_NEAR(*apart.error().place->z, 0.125, 1e-12);
}

TEST(TriangularPatch, CornersOnALineAreRefused) {
  const auto flat = TriangularPatch::make(*Curve::line({0, 0, 0}, {1, 0, 0}), *Curve::line({1, 0, 0}, {3, 0, 0}),
                                          *Curve::line({3, 0, 0}, {0, 0, 0}));
  EXPECT_FALSE(flat.ok());
}

TEST(TriangularPatch, CurvesMayRunEitherWay) {
  const auto [a, b, c] = arbitrary();
  const auto turned = TriangularPatch::make(bezier({{3, 0, 0.5}, {2.2, 0.3, -1}, {1, -0.4, 0.8}, {0, 0, 0}}), b,
                                            bezier({{0, 0, 0}, {0.2, 1.4, 0}, {1.5, 2, 1}}));
  ASSERT_TRUE(turned.ok());
  const auto plain = TriangularPatch::make(a, b, c);
  EXPECT_LT(geom::distance(turned->at(0.2, 0.5, 0.3), plain->at(0.2, 0.5, 0.3)), 1e-14);
}

TEST(TriangularPatch, TRI_a_ThreeArbitraryCurvesAreReproducedOnTheSides) {
  const auto [a, b, c] = arbitrary();
  const TriangularPatch patch = *TriangularPatch::make(a, b, c);
  double worst = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.0;
    worst = std::max({worst, geom::distance(patch.at(1.0 - t, t, 0.0), a.at(t)),
                      geom::distance(patch.at(0.0, 1.0 - t, t), b.at(t)),
                      geom::distance(patch.at(t, 0.0, 1.0 - t), c.at(t))});
  }
  EXPECT_LT(worst, 1e-12);
  // And 1e-7 beside the corners, where a difference is divided by as little.
  EXPECT_LT(geom::distance(patch.at(1.0 - 1e-7, 1e-7, 0.0), a.at(1e-7)), 1e-12);
}

TEST(TriangularPatch, TRI_a_StraightSidesGiveTheAffineMap) {
  const Point3 p{1, 2, 3}, q{4, 2, 0}, r{0, 5, 1};
  const TriangularPatch patch = *TriangularPatch::make(*Curve::line(p, q), *Curve::line(q, r), *Curve::line(r, p));
  const Point3 centre = patch.at(1.0 / 3, 1.0 / 3, 1.0 / 3);
  EXPECT_LT(geom::distance(centre, {5.0 / 3, 3.0, 4.0 / 3}), 1e-14);
  const Point3 other = patch.at(0.7, 0.1, 0.2);
  EXPECT_LT(geom::distance(other, {0.7 + 0.4, 1.4 + 0.2 + 1.0, 2.1 + 0.2}), 1e-14);
}

TEST(TriangularPatch, TRI_a_CornersAreTheEndsOfTheCurves) {
  const auto [a, b, c] = arbitrary();
  const TriangularPatch patch = *TriangularPatch::make(a, b, c);
  EXPECT_LT(geom::distance(patch.at(1, 0, 0), {0, 0, 0}), 1e-15);
  EXPECT_LT(geom::distance(patch.at(0, 1, 0), {3, 0, 0.5}), 1e-15);
  EXPECT_LT(geom::distance(patch.at(0, 0, 1), {1.5, 2, 1}), 1e-15);
}

TEST(TriangularPatch, TRI_b_TheOctantHasItsCentreInsideTheSphere) {
  const Point3 centre = octant().at(1.0 / 3, 1.0 / 3, 1.0 / 3);
  EXPECT_NEAR(centre.x, 0.516346, 5e-7);
  EXPECT_NEAR(centre.y, 0.516346, 5e-7);
  EXPECT_NEAR(centre.z, 0.516346, 5e-7);
  EXPECT_NEAR(geom::distance(centre, {}), 0.894338, 5e-7);
}

TEST(TriangularPatch, TRI_b_EightPartsOfTheOctantAre45NodesAnd64Triangles) {
  const TriangularGrid made = grid(octant(), 8);
  ASSERT_EQ(made.points.size(), 45U);
  ASSERT_EQ(made.triangles.size(), 64U);
  Vector3 area;
  for (const auto& [a, b, c] : made.triangles) {
    const Vector3 twice = cross(made.points[b] - made.points[a], made.points[c] - made.points[a]);
    EXPECT_GT(dot(twice, {1, 1, 1}), 0.0);
    area = area + 0.5 * twice;
  }
  // The border is three polygons of eight chords, each of which bounds this with the origin in its plane.
  const double flat = 8 * 0.5 * std::sin(quarter / 8);
  EXPECT_NEAR(area.x, flat, 1e-12);
  EXPECT_NEAR(area.y, flat, 1e-12);
  EXPECT_NEAR(area.z, flat, 1e-12);
}

TEST(TriangularPatch, DerivativesAreThoseOfDifferencesUpToTheCorners) {
  const auto [a, b, c] = arbitrary();
  const Surface surface = *TriangularPatch::make(a, b, c)->surface();
  for (const geom::Point uv : {geom::Point{0.3, 0.4}, {0.003, 0.003}, {0.5, 0.97}, {0.9995, 0.01}, {0.0, 0.5}}) {
    const Jet jet = surface.jet(uv);
    const double h = 1e-4;
    const auto at = [&](double du, double dv) { return surface.at({uv.x + du * h, uv.y + dv * h}); };
    EXPECT_LT(geom::length((at(1, 0) - at(-1, 0)) / (2 * h) - jet.u), 1e-6);
    EXPECT_LT(geom::length((at(0, 1) - at(0, -1)) / (2 * h) - jet.v), 1e-6);
    EXPECT_LT(geom::length(((at(1, 0) - at(0, 0)) + (at(-1, 0) - at(0, 0))) / (h * h) - jet.uu), 2e-5);
    EXPECT_LT(geom::length(((at(0, 1) - at(0, 0)) + (at(0, -1) - at(0, 0))) / (h * h) - jet.vv), 2e-5);
    EXPECT_LT(geom::length(((at(1, 1) - at(1, -1)) - (at(-1, 1) - at(-1, -1))) / (4 * h * h) - jet.uv), 2e-5);
  }
}

TEST(TriangularPatch, AsASurfaceItsTopIsOnePointAndItsAreaThatOfAFineGrid) {
  const Surface surface = *octant().surface();
  EXPECT_TRUE(surface.collapsed(Side::Top));
  EXPECT_FALSE(surface.collapsed(Side::Bottom));
  const TriangularGrid fine = grid(octant(), 200);
  double sum = 0.0;
  for (const auto& [a, b, c] : fine.triangles)
    sum += 0.5 * geom::length(cross(fine.points[b] - fine.points[a], fine.points[c] - fine.points[a]));
  EXPECT_NEAR(area(surface).value, sum, 1e-4);
}

}  // namespace
}  // namespace dobra::surf
