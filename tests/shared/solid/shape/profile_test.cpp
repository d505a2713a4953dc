// Sweeps and instances: what is degenerate and what folds is refused first; then volumes by formulas of their own.

#include "shared/solid/shape/profile.h"

#include <gmock/gmock.h>

#include "shared/solid/check/validate.h"
#include "shared/solid/placement.h"
#include "shared/solid/shape/instance.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

using namespace shape;
using base::ErrorCode;
using shapes::euler_holds;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double pi = std::numbers::pi;

Profile square(double half) { return {{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, true}, {}}; }

Solid made(const base::Result<Shape>& shape) {
  EXPECT_TRUE(shape) << (shape ? "" : shape.error().message);
  const auto solid = solid_of(shape.value());
  EXPECT_TRUE(solid) << (solid ? "" : solid.error().message);
  EXPECT_THAT(check::violations(*solid), IsEmpty());
  EXPECT_TRUE(euler_holds(solid->counts()));
  return *solid;
}

TEST(Profile, DegenerateProfilesAreRefused) {
  EXPECT_EQ(extrude({{{{0, 0}, {1, 0}}, true}, {}}, {0, 0, 1}).error().code, ErrorCode::DegenerateCurve);
  EXPECT_EQ(extrude({{{{0, 0}, {1, 0}, {2, 0}}, true}, {}}, {0, 0, 1}).error().code, ErrorCode::DegenerateCurve);
  EXPECT_EQ(extrude({{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, true}, {}}, {0, 0, 1}).error().code,
            ErrorCode::DegenerateCurve);
  EXPECT_EQ(extrude(square(1), {1, 1, 0}).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(extrude({{{{0, 0}, {NAN, 0}, {1, 1}}, true}, {}}, {0, 0, 1}).error().code, ErrorCode::NotFinite);
  EXPECT_EQ(draw_to_point(square(1), {0, 0, 0}).error().code, ErrorCode::InvalidOption);
  // A bow tie, and a hole that crosses the outline.
  EXPECT_EQ(extrude({{{{0, 0}, {2, 2}, {2, 0}, {0, 1}}, true}, {}}, {0, 0, 1}).error().code,
            ErrorCode::SelfIntersection);
  Profile crossed = square(1);
  crossed.holes.push_back({{{0, 0}, {3, 0}, {3, 0.5}}, true});
  EXPECT_EQ(extrude(crossed, {0, 0, 1}).error().code, ErrorCode::SelfIntersection);
}

TEST(Profile, APathThatFoldsIsRefusedWithItsPlace) {
  const auto back = sweep(square(0.1), {{0, 0, 0}, {0, 0, 2}, {0, 0, 1}});
  ASSERT_FALSE(back);
  EXPECT_THAT(back.error().message, HasSubstr("folds at its point 2"));
  EXPECT_EQ(back.error().place->z, 2.0);
  // Between two right angles there is too little room for the inner side.
  const std::vector<geom::Point3> narrow{{0, 0, 0}, {5, 0, 0}, {5, 0.3, 0}, {0, 0.3, 0}};
  const auto hairpin = sweep(square(0.2), narrow);
  ASSERT_FALSE(hairpin);
  EXPECT_THAT(hairpin.error().message, HasSubstr("folds at its point 3"));
  EXPECT_EQ(hairpin.error().place->x, 5.0);
  EXPECT_TRUE(sweep(square(0.1), narrow));
  EXPECT_FALSE(sweep(square(0.1), {{0, 0, 0}, {0, 0, 0}}));
  EXPECT_FALSE(sweep(square(0.1), {{0, 0, 0}}));
  EXPECT_FALSE(sweep(square(0.1), {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}));
  // Far parts that run into each other are no solid.
  const auto knot = sweep(square(0.2), {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 4, 0}, {2, -4, 0}});
  ASSERT_TRUE(knot);
  EXPECT_EQ(solid_of(*knot).error().code, ErrorCode::SelfIntersection);
}

TEST(Profile, SOL_d_ExtrusionsAndConesHaveTheirVolumes) {
  EXPECT_EQ(volume(made(extrude({{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true}, {}}, {0, 0, 2}))), 2.0);
  const std::array<double, 3> prisms{6.122935, 6.242890, 6.273097};
  const std::array<double, 3> cones{2.040978, 2.080963, 2.091032};
  for (std::size_t i = 0; i < 3; ++i) {
    const int n = 16 << i;
    EXPECT_NEAR(volume(made(prism(n, 1.0, 2.0))), prisms[i], 5e-7);
    EXPECT_NEAR(volume(made(cylinder(1.0, 2.0, {.segments = n}))), prisms[i], 5e-7);
    EXPECT_NEAR(volume(made(pyramid(n, 1.0, 2.0))), cones[i], 5e-7);
    EXPECT_NEAR(volume(made(cone(1.0, 0.0, 2.0, {.segments = n}))), cones[i], 5e-7);
  }
}

TEST(Profile, OutlinesMayRunEitherWayAndVectorsDown) {
  Profile clockwise = square(1);
  std::reverse(clockwise.outline.points.begin(), clockwise.outline.points.end());
  clockwise.holes.push_back({{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, true});
  for (const geom::Vector3 by : {geom::Vector3{0, 0, 2}, geom::Vector3{1, 3, -2}}) {
    const Solid tube = made(extrude(clockwise, by));
    EXPECT_EQ(volume(tube), 6.0);
    EXPECT_EQ(tube.counts().handles, 1);
  }
  // The names are those of the outline's segments as given: 1 is the one from the first corner to the second.
  const Shape shape = extrude(clockwise, {0, 0, 1}).value();
  for (std::size_t f = 0; f < shape.names.size(); ++f) {
    if (shape.names[f] != "side_1") continue;
    for (const std::uint32_t corner : shape.mesh.faces[f][0])
      EXPECT_EQ(shape.mesh.points[corner].y, 1.0);  // (-1, 1) to (1, 1)
  }
}

TEST(Profile, SOL_e_RevolutionsHaveTheirVolumesAndHandles) {
  const geom::Polyline unit{{{1.5, 0}, {2.5, 0}, {2.5, 1}, {1.5, 1}}, true};
  const std::array<int, 3> counts{8, 16, 64};
  const std::array<double, 3> volumes{11.313708, 12.245870, 12.546194};
  for (std::size_t i = 0; i < 3; ++i) {
    const Solid ring = made(revolve(unit, {.segments = counts[i]}));
    EXPECT_NEAR(volume(ring), volumes[i], 5e-7);
    EXPECT_EQ(ring.counts().handles, 1);
  }
  // A quarter of it.
  const Solid quarter = made(revolve(unit, {.angle = 90.0, .segments = 16}));
  EXPECT_NEAR(volume(quarter), volumes[2] / 4.0, 5e-7);
  EXPECT_EQ(quarter.counts().handles, 0);
}

TEST(Profile, RevolutionsCloseOnTheAxisAndRefuseToCrossIt) {
  EXPECT_THAT(revolve({{{-1, 0}, {1, 0}, {1, 1}}, true}).error().message, HasSubstr("point 1"));
  EXPECT_FALSE(revolve({{{0, 0}, {1, 0}, {1, 1}}, true}, {.segments = 2}));
  EXPECT_FALSE(revolve({{{0, 0}, {1, 0}, {1, 1}}, true}, {.angle = 0.0}));
  EXPECT_FALSE(revolve({{{0, 0}, {1, 0}, {1, 1}}, true}, {.angle = 270.0, .segments = 1}));
  const auto n = [](int m) { return m * std::sin(2 * pi / m) / 2.0; };  // area of the m-gon in the unit circle
  EXPECT_NEAR(volume(made(revolve({{{0, 0}, {1, 0}, {0, 3}}, true}, {.segments = 24}))), n(24), 1e-12);
  // An hourglass touches itself on the axis.
  const Solid glass = made(revolve({{{0, 0}, {1, -1}, {1, 1}}, true}, {.segments = 12}));
  EXPECT_NEAR(volume(glass), 2.0 * n(12) - 2.0 / 3.0 * n(12), 1e-12);
}

TEST(Profile, SweptProfilesKeepTheirVolumeAlongTheirMiddle) {
  // With a profile that is symmetric about the path, mitres take as much as they give.
  const Solid bent = made(sweep(square(0.5), {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {4, 3, 5}}));
  EXPECT_NEAR(volume(bent), 12.0, 1e-12);
  EXPECT_EQ(bent.counts().faces, 10U);  // two sides of each bend lie in one plane
  const Solid skew = made(sweep(square(0.25), {{0, 0, 0}, {1, 2, 3}, {4, 2, 1}}));
  EXPECT_NEAR(volume(skew), 0.25 * (std::sqrt(14.0) + std::sqrt(13.0)), 1e-12);
}

TEST(Instance, SizesThatAreNoSizesAreRefusedByName) {
  EXPECT_THAT(cylinder(0.0, 1.0).error().message, HasSubstr("radius is 0"));
  EXPECT_THAT(block({1, -2, 1}).error().message, HasSubstr("second number of size"));
  EXPECT_THAT(prism(2, 1, 1).error().message, HasSubstr("sides is 2"));
  EXPECT_THAT(torus(1.0, 1.0).error().message, HasSubstr("minor_radius"));
  EXPECT_FALSE(sphere(NAN));
  EXPECT_FALSE(cone(1, -1, 1));
}

TEST(Instance, HaveVolumesThatApproachTheirFormulas) {
  EXPECT_EQ(volume(made(block({2, 3, 4}))), 24.0);
  EXPECT_EQ(made(block({2, 3, 4})).counts(), (Counts{8, 12, 6, 0, 1, 0}));
  const auto error = [&](int m) {
    return std::array<double, 3>{
        4.0 / 3.0 * pi - volume(made(sphere(1.0, {.segments = 2 * m, .rows = m}))),
        2.0 * pi * pi * 3.0 - volume(made(torus(3.0, 1.0, {.segments = 2 * m, .rows = m}))),
        pi / 3.0 * (4.0 + 2.0 + 1.0) * 3.0 - volume(made(cone(2.0, 1.0, 3.0, {.segments = 2 * m})))};
  };
  const auto coarse = error(8);
  const auto fine = error(16);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(fine[i], 0.0);  // all corners lie on the true surface
    EXPECT_NEAR(coarse[i] / fine[i], 4.0, 0.15);
  }
}

}  // namespace
}  // namespace dobra::solid
