// Convex solids rounded: what cannot be is refused first; volumes against those of true cylinders and spheres.

#include "shared/solid/shape/rounding.h"

#include <gmock/gmock.h>

#include <set>

#include "shared/solid/check/validate.h"
#include "shared/solid/section.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

using shape::round_convex;
using namespace shapes;
using testing::HasSubstr;

TEST(Rounding, NotchesAndRadiiThatAreTooLargeAreRefused) {
  const Solid l = solid(prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 0, 1), "l");
  EXPECT_THAT(round_convex(l, {.radius = 0.1}).error().message, HasSubstr("only convex"));
  EXPECT_TRUE(round_convex(l, {.radius = 0.1}).error().place.has_value());
  const Solid two = unite({box_solid({0, 0, 0}, {1, 1, 1}), box_solid({2, 0, 0}, {3, 1, 1})});
  EXPECT_THAT(round_convex(two, {.radius = 0.1}).error().message, HasSubstr("2 shells"));
  const Solid flat = solid(box({0, 0, 0}, {4, 4, 1}), "slab");
  EXPECT_THAT(round_convex(flat, {.radius = 0.6}).error().message, HasSubstr("too large"));
  // The small face at the top of a frustum goes, though there is room for the ball.
  const PolygonMesh frustum{
      {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, {-0.1, -0.1, 2}, {0.1, -0.1, 2}, {0.1, 0.1, 2}, {-0.1, 0.1, 2}},
      {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  EXPECT_FALSE(round_convex(solid(frustum), {.radius = 0.5}));
  EXPECT_FALSE(round_convex(flat, {.radius = 0.0}));
  EXPECT_FALSE(round_convex(flat, {.radius = 0.1, .segments = 1}));
  EXPECT_FALSE(round_convex(Solid(), {.radius = 0.1}));
}

/// Of a box with edges a, b, c whose edges and corners are rounded with r.
double true_volume(double a, double b, double c, double r) {
  const double u = a - 2 * r;
  const double v = b - 2 * r;
  const double w = c - 2 * r;
  const double pi = std::numbers::pi;
  return u * v * w + 2 * r * (u * v + v * w + w * u) + pi * r * r * (u + v + w) + 4.0 / 3.0 * pi * r * r * r;
}

TEST(Rounding, VolumesFallToTheTrueOneAsTheSquareOfSegments) {
  const Solid block = box_solid({0, 0, 0}, {2, 3, 1});
  std::vector<double> errors;
  for (const int segments : {2, 4}) {
    const Solid rounded = round_convex(block, {.radius = 0.25, .segments = segments}).value();
    EXPECT_THAT(check::violations(rounded), testing::IsEmpty());
    EXPECT_EQ(rounded.counts().shells, 1U);
    EXPECT_EQ(rounded.counts().handles, 0);
    errors.push_back(volume(rounded) - true_volume(2, 3, 1, 0.25));
  }
  EXPECT_GT(errors[1], 0.0);
  EXPECT_LT(errors[1], 0.1 * (6.0 - true_volume(2, 3, 1, 0.25)));
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.7);
}

/// By cutting the solid with the planes of the new faces, one boolean after another.
Solid cut_one_by_one(Solid solid, const Solid& rounded, const std::string& name) {
  for (std::uint32_t f = 0; f < rounded.face_count(); ++f) {
    if (rounded.name(FaceId(f)) != name) continue;
    const Plane& plane = rounded.space().plane(rounded.boundary().soup.facets[f].plane);
    const geom::Point3 n = plane.through[0];
    solid = halve(solid, {n.x, n.y, n.z, *plane.constant}, name).value().below;
  }
  return solid;
}

TEST(Rounding, IsWhatTheSamePlanesCutOneByOne) {
  // Four and more faces round a corner, planes that meet in one point, many faces.
  const std::vector<Solid> solids{box_solid({0, 0, 0}, {2, 3, 1}), solid(prism(regular(7, 2.0), 0, 2), "p"),
                                  solid(PolygonMesh{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1.5}},
                                                    {{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}},
                                        "pyramid"),
                                  // Corners that are no doubles.
                                  halve(box_solid({0, 0, 0}, {3, 3, 3}), {1, 0.7, 0.9, -5.3}).value().below};
  for (const Solid& solid : solids) {
    for (const int segments : {2, 3, 4}) {
      const Solid rounded = round_convex(solid, {.radius = 0.15, .segments = segments, .name = "r"}).value();
      EXPECT_THAT(check::violations(rounded), testing::IsEmpty());
      const Solid other = cut_one_by_one(solid, rounded, "r");
      EXPECT_EQ(volume(rounded), volume(other));
      EXPECT_EQ(rounded.counts(), other.counts());
      EXPECT_EQ(subtract({rounded, other}).face_count() + subtract({other, rounded}).face_count(), 0U);
    }
  }
}

TEST(Rounding, FacesOfOnePlaneKeepTheirNames) {
  // The top of the block is two faces.
  FromMeshOptions names;
  names.face_names = {"below", "left", "front", "back", "side", "other", "right"};
  PolygonMesh block = box({0, 0, 0}, {2, 2, 1});
  block.points.insert(block.points.end(), {{1, 0, 1}, {1, 2, 1}});
  block.faces = {{0, 2, 3, 1}, {4, 8, 9, 6}, {0, 1, 5, 8, 4}, {2, 6, 9, 7, 3},
                 {0, 4, 6, 2}, {1, 3, 7, 5}, {8, 5, 7, 9}};
  const Solid solid = from_mesh(block, names).value();
  const Solid rounded = round_convex(solid, {.radius = 0.2, .segments = 4, .name = "r"}).value();
  EXPECT_THAT(check::violations(rounded), testing::IsEmpty());
  std::set<std::string> found;
  for (std::uint32_t f = 0; f < rounded.face_count(); ++f) found.insert(rounded.name(FaceId(f)));
  EXPECT_EQ(found, (std::set<std::string>{"below", "left", "front", "back", "side", "other", "right", "r"}));
  // Where the seam ends, planes touch the edge between those that round it alike.
  const double whole = volume(round_convex(box_solid({0, 0, 0}, {2, 2, 1}), {.radius = 0.2, .segments = 4}).value());
  EXPECT_LE(volume(rounded), whole);
  EXPECT_GT(volume(rounded), true_volume(2, 2, 1, 0.2));
}

TEST(Rounding, FarFromTheOriginNothingIsLost) {
  const Solid near = round_convex(box_solid({0, 0, 0}, {2, 3, 1}), {.radius = 0.25, .segments = 6}).value();
  const Solid far =
      round_convex(box_solid({1e6, 2e6, -1e6}, {1e6 + 2, 2e6 + 3, -1e6 + 1}), {.radius = 0.25, .segments = 6}).value();
  EXPECT_THAT(check::violations(far), testing::IsEmpty());
  EXPECT_NEAR(volume(far), volume(near), 1e-8);
}

TEST(Rounding, ManySegmentsComeNearToTheBall) {
  const Solid rounded = round_convex(box_solid({0, 0, 0}, {2, 3, 1}), {.radius = 0.25, .segments = 20}).value();
  const double off = volume(rounded) - true_volume(2, 3, 1, 0.25);
  EXPECT_GT(off, 0.0);
  EXPECT_LT(off, 5e-4);
  EXPECT_THAT(check::violations(rounded), testing::IsEmpty());
}

TEST(Rounding, KeepsTheFacesWhereTheyAre) {
  const Solid tetrahedron = solid(shapes::tetrahedron({0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {0, 0, 3}), "t");
  const Solid rounded = round_convex(tetrahedron, {.radius = 0.2, .segments = 3, .name = "r"}).value();
  std::size_t kept = 0;
  for (std::uint32_t f = 0; f < rounded.face_count(); ++f) kept += rounded.name(FaceId(f)) == "t" ? 1U : 0U;
  EXPECT_EQ(kept, 4U);
  EXPECT_EQ(subtract({rounded, tetrahedron}).face_count(), 0U);
}

}  // namespace
}  // namespace dobra::solid
