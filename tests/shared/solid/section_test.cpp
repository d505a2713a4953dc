#include "shared/solid/section.h"

#include <gmock/gmock.h>

#include "shared/solid/check/validate.h"
#include "shared/topo/adjacency.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

using namespace shapes;

Section section(const std::vector<Solid>& solids, const CutPlane& plane) { return Sections(solids).cut(plane).value(); }

double cut_area(const Section& s) {
  double sum = 0.0;
  for (const topo::FaceId f : s.plane.faces()) {
    if (s.plane.attribute(f).has_value()) sum += topo::area(s.plane, f);
  }
  return sum;
}
std::size_t cut_count(const Section& s) {
  std::size_t count = 0;
  for (const topo::FaceId f : s.plane.faces()) count += s.plane.attribute(f).has_value() ? 1U : 0U;
  return count;
}

/// The faces that the cut made.
std::size_t caps(const Solid& s) {
  std::size_t count = 0;
  for (std::size_t f = 0; f < s.face_count(); ++f) count += s.name(FaceId(f)) == "cut" ? 1U : 0U;
  return count;
}

PolygonMesh u_shape() { return prism({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 0, 1); }

TEST(SolidSection, SOL_f_CutsACubeAcross) {
  const Solid cube = box_solid({0, 0, 0}, {2, 2, 2});
  const Halves parts = halve(cube, {0, 0, 1, -0.5}).value();
  EXPECT_EQ(volume(parts.below), 2.0);
  EXPECT_EQ(volume(parts.above), 6.0);
  EXPECT_EQ(caps(parts.below), 1U);
  EXPECT_EQ(caps(parts.above), 1U);
  EXPECT_EQ(cut_area(section({cube}, {0, 0, 1, -0.5})), 4.0);
}

TEST(SolidSection, SOL_g_CutsACubeThroughSixEdgeMiddles) {
  const Solid cube = box_solid({0, 0, 0}, {2, 2, 2});
  const Halves parts = halve(cube, {1, 1, 1, -3}).value();
  for (const Solid& part : {parts.below, parts.above}) {
    EXPECT_EQ(volume(part), 4.0);
    EXPECT_EQ(part.counts(), (Counts{10, 15, 7, 0, 1, 0}));
    EXPECT_THAT(check::violations(part), testing::IsEmpty());
  }
  const Section s = section({cube}, {1, 1, 1, -3});
  EXPECT_NEAR(cut_area(s), 3.0 * std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(cut_area(s), 5.196152, 5e-7);
  EXPECT_EQ(s.plane.edge_count(), 6U);
  for (const topo::EdgeId e : s.plane.edges()) {
    const geom::Segment side = s.plane.segment(e);
    EXPECT_NEAR(std::hypot(side.to.x - side.from.x, side.to.y - side.from.y), std::sqrt(2.0), 1e-14);
  }
}

TEST(SolidSection, SOL_h_CutsBothArmsMissesAndLiesInAFace) {
  const Solid u = solid(u_shape());
  EXPECT_EQ(volume(u), 7.0);
  const Halves arms = halve(u, {0, 1, 0, -2}).value();
  EXPECT_EQ(arms.above.counts().shells, 2U);
  EXPECT_EQ(volume(arms.above), 2.0);
  EXPECT_EQ(arms.below.counts().shells, 1U);
  EXPECT_EQ(volume(arms.below), 5.0);
  EXPECT_EQ(cut_count(section({u}, {0, 1, 0, -2})), 2U);
  EXPECT_EQ(cut_area(section({u}, {0, 1, 0, -2})), 2.0);

  const Halves missed = halve(u, {0, 1, 0, -5}).value();
  EXPECT_TRUE(missed.above.empty());
  EXPECT_EQ(missed.below.counts(), u.counts());
  EXPECT_TRUE(section({u}, {0, 1, 0, -5}).empty());

  // In the face at the bottom of the gap, y = 1, and in the lowest face.
  const Halves in_face = halve(u, {0, 1, 0, -1}).value();
  EXPECT_EQ(volume(in_face.below), 3.0);
  EXPECT_EQ(volume(in_face.above), 4.0);
  EXPECT_EQ(cut_area(section({u}, {0, 1, 0, -1})), 3.0);  // just below
  EXPECT_EQ(cut_area(section({u}, {0, -1, 0, 1})), 2.0);  // turned over: just above
  const Halves lowest = halve(u, {0, 1, 0, 0}).value();
  EXPECT_TRUE(lowest.below.empty());
  EXPECT_EQ(lowest.contact, Contact::Face);
  EXPECT_EQ(volume(lowest.above), 7.0);
  EXPECT_TRUE(section({u}, {0, 1, 0, 0}).empty());
}

TEST(SolidSection, NamesTheSolidOfEveryAreaAndTheFacesOfEveryLine) {
  const Solid lower = solid(box({0, 0, 0}, {4, 2, 1}), "clay");
  const Solid upper = solid(box({0, 0, 1}, {4, 2, 3}), "sand");
  const Section s = section({lower, upper}, {0, -1, 0, 1});
  EXPECT_EQ(s.frame.along, (geom::Vector3{1, 0, 0}));
  EXPECT_EQ(s.frame.up, (geom::Vector3{0, 0, 1}));
  double clay = 0.0;
  double sand = 0.0;
  for (const topo::FaceId f : s.plane.faces()) {
    const auto* area = std::any_cast<SectionArea>(&s.plane.attribute(f));
    if (area != nullptr) (area->solid == 0 ? clay : sand) += topo::area(s.plane, f);
  }
  EXPECT_EQ(clay, 4.0);
  EXPECT_EQ(sand, 8.0);
  const topo::HalfEdgeId border = s.plane.between(*s.plane.vertex_at({0, 1}), *s.plane.vertex_at({4, 1}));
  ASSERT_TRUE(border.valid());
  EXPECT_THAT(std::any_cast<SectionLine>(s.plane.attribute(topo::Subdivision::edge(border))).names,
              testing::ElementsAre("clay", "sand"));
}

TEST(SolidSection, CutsRoundHolesAndCavities) {
  const Solid block =
      subtract({box_solid({0, 0, 0}, {9, 3, 3}), box_solid({1, 1, 1}, {2, 2, 2}), box_solid({4, 1, -1}, {5, 2, 4})});
  const Section s = section({block}, {0, 0, 1, -1.5});
  EXPECT_EQ(cut_area(s), 27.0 - 2.0);
  EXPECT_EQ(s.plane.face_count(), 4U);
  const Halves parts = halve(block, {0, 0, 1, -1.5}).value();
  EXPECT_EQ(volume(parts.below) + volume(parts.above), volume(block));
  EXPECT_EQ(parts.below.counts(), (Counts{24, 36, 15, 3, 1, 1}));  // a dent and half a hole
}

TEST(SolidSection, HalvesAlongRandomPlanesAddUp) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> real(-1.0, 1.0);
  const Solid s = subtract({solid(sphere({0, 0, 0}, 1.0, 8, 12)), solid(prism(gear(5, 0.2, 0.5), -2, 0.3))});
  for (int i = 0; i < 12; ++i) {
    const CutPlane plane{real(random), real(random), real(random), 0.5 * real(random)};
    const Halves parts = halve(s, plane).value();
    EXPECT_NEAR(volume(parts.below) + volume(parts.above), volume(s), 1e-14);
    EXPECT_THAT(check::violations(parts.below), testing::IsEmpty());
    EXPECT_THAT(check::violations(parts.above), testing::IsEmpty());
    const Solid again = unite({parts.below, parts.above});
    EXPECT_EQ(again.counts(), s.counts());
    EXPECT_EQ(volume(again), volume(s));
    // The area of the section is that of the caps.
    const auto cap_area = [](const Solid& part) {
      double sum = 0.0;
      const ToMesh out = to_mesh(part).value();
      for (std::size_t f = 0; f < out.mesh.faces.size(); ++f) {
        if (out.names[f] != "cut") continue;
        std::vector<Point3> corners;
        for (const std::uint32_t p : out.mesh.faces[f]) corners.push_back(out.mesh.points[p]);
        sum += length(mesh::newell_area(corners) - Point3{});
      }
      return sum;
    };
    const double area = cut_area(section({s}, plane));
    EXPECT_NEAR(cap_area(parts.below), area, 1e-13);
    EXPECT_NEAR(cap_area(parts.above), area, 1e-13);
  }
}

TEST(SolidSection, RefusesAPlaneWithoutANormal) {
  const Solid cube = box_solid({0, 0, 0}, {2, 2, 2});
  EXPECT_EQ(halve(cube, {0, 0, 0, 1}).error().code, base::ErrorCode::InvalidOption);
  EXPECT_EQ(Sections(std::span(&cube, 1)).cut({0, 0, NAN, 1}).error().code, base::ErrorCode::InvalidOption);
}

}  // namespace
}  // namespace dobra::solid
