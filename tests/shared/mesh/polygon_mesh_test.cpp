#include "shared/mesh/polygon_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace dobra::mesh {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Outward faces: bottom, top, front, right, back, left.
PolygonMesh cube() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
          {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

TEST(PolygonMesh, PM_a_GoodCubeHasNoFault) {
  EXPECT_THAT(check(cube(), Closedness::Solid), IsEmpty());
  EXPECT_THAT(check(cube(), edges_of(cube()), Closedness::Solid), IsEmpty());
  EXPECT_THAT(edges_of(cube()), SizeIs(12));
}

TEST(PolygonMesh, PM_a_MissingFaceIsNamedByItsLoopTheWayItShouldTurn) {
  PolygonMesh mesh = cube();
  mesh.faces.erase(mesh.faces.begin() + 1);
  const auto findings = check(mesh, Closedness::Solid);
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_EQ(findings[0].fault, PolygonFault::OpenBoundary);
  EXPECT_THAT(findings[0].points, ElementsAre(4, 5, 6, 7));
  EXPECT_THAT(findings[0].message, HasSubstr("4-5-6-7"));
  EXPECT_THAT(check(mesh, Closedness::Sheet), IsEmpty());
}

TEST(PolygonMesh, PM_a_ReversedFaceIsNamedAlone) {
  for (std::uint32_t f = 0; f < 6; ++f) {
    PolygonMesh mesh = cube();
    std::reverse(mesh.faces[f].begin(), mesh.faces[f].end());
    const auto findings = check(mesh, Closedness::Solid);
    ASSERT_THAT(findings, SizeIs(1));
    EXPECT_EQ(findings[0].fault, PolygonFault::ReversedFace);
    EXPECT_THAT(findings[0].faces, ElementsAre(f));
  }
}

TEST(PolygonMesh, PM_a_OfAsManyFacesThoseOfLessAreaAreReversedThenThoseThatTurnABodyInsideOut) {
  PolygonMesh half = cube();  // three faces round a corner, of six alike
  std::vector<std::uint32_t> turned;
  for (std::uint32_t f = 0; f < 6; ++f) {
    if (std::find(half.faces[f].begin(), half.faces[f].end(), half.faces[0][0]) == half.faces[f].end()) continue;
    std::reverse(half.faces[f].begin(), half.faces[f].end());
    turned.push_back(f);
  }
  const auto volume = check(half, Closedness::Solid);
  ASSERT_THAT(volume, SizeIs(3));  // the face of number 0 is among them
  std::vector<std::uint32_t> named;
  for (const PolygonFinding& finding : volume) named.push_back(finding.faces.at(0));
  EXPECT_THAT(named, testing::UnorderedElementsAreArray(turned));
  const PolygonMesh two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 3, 0}}, {{0, 1, 2}, {1, 2, 3}}};
  const auto area = check(two, Closedness::Sheet);
  ASSERT_THAT(area, SizeIs(1));
  EXPECT_THAT(area[0].faces, ElementsAre(0U));
}

TEST(PolygonMesh, PM_a_UnusedPointIsNamed) {
  PolygonMesh mesh = cube();
  mesh.points.push_back({2, 2, 2});
  const auto findings = check(mesh, Closedness::Solid);
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_EQ(findings[0].fault, PolygonFault::UnusedPoint);
  EXPECT_THAT(findings[0].points, ElementsAre(8));
}

TEST(PolygonMesh, PM_a_EdgeWithoutLengthIsNamedWithItsFaces) {
  PolygonMesh mesh = cube();
  mesh.points[5] = mesh.points[4];
  const auto findings = check(mesh, Closedness::Solid);
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_EQ(findings[0].fault, PolygonFault::ZeroLengthEdge);
  EXPECT_THAT(findings[0].points, ElementsAre(4, 5));
  EXPECT_THAT(findings[0].faces, ElementsAre(1, 2));
}

TEST(PolygonMesh, PM_a_EdgeTwiceInAPolygonIsNamed) {
  PolygonMesh mesh = cube();
  mesh.faces[1] = {4, 5, 6, 5, 6, 7};
  const auto findings = check(mesh, Closedness::Solid);
  ASSERT_FALSE(findings.empty());
  EXPECT_EQ(findings[0].fault, PolygonFault::RepeatedEdge);
  EXPECT_THAT(findings[0].faces, ElementsAre(1));
  EXPECT_THAT(findings[0].points, ElementsAre(5, 6));
}

TEST(PolygonMesh, PM_a_EdgeThatDoesNotReferBackIsNamedBothWays) {
  auto edges = edges_of(cube());
  ASSERT_EQ(edges[0], (PolygonEdge{0, 1, {0, 2}}));
  edges[0].faces = {0, 4};
  const auto findings = check(cube(), edges, Closedness::Solid);
  ASSERT_THAT(findings, SizeIs(2));
  EXPECT_EQ(findings[0].fault, PolygonFault::EdgeNotReciprocal);
  EXPECT_EQ(findings[0].message, "edge 0 (0-1) names face 4, which does not pass it");
  EXPECT_EQ(findings[1].message, "face 2 passes edge 0 (0-1), which does not name it");
  edges = edges_of(cube());
  edges[3] = edges[2];
  EXPECT_THAT(check(cube(), edges, Closedness::Solid), SizeIs(2)) << "one repeated, one absent";
}

TEST(PolygonMesh, CornersThatDoNotExistFinsAndMoebiusBandsAreNamed) {
  PolygonMesh mesh = cube();
  mesh.faces[1][2] = 99;
  auto findings = check(mesh, Closedness::Sheet);
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_EQ(findings[0].message, "face 1: corner 99 does not exist (8 points)");

  mesh = cube();
  mesh.points.push_back({0.5, 0.5, 2});
  mesh.faces.push_back({4, 5, 8});
  findings = check(mesh, Closedness::Sheet);
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_EQ(findings[0].fault, PolygonFault::TooManyFaces);
  EXPECT_THAT(findings[0].faces, ElementsAre(1, 2, 6));

  const PolygonMesh band{{{1, 0, 0}, {1, 0, 1}, {-1, 1, 0}, {-1, 1, 1}, {-1, -1, 0}, {-1, -1, 1}},
                         {{0, 2, 3, 1}, {2, 4, 5, 3}, {4, 1, 0, 5}}};
  findings = check(band, Closedness::Sheet);
  ASSERT_THAT(findings, SizeIs(1));
  EXPECT_EQ(findings[0].fault, PolygonFault::NotOrientable);
}

TEST(PolygonMesh, PM_b_NewellsNormalDoesNotDependOnTheCorner) {
  const std::array<geom::Point3, 4> square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
  EXPECT_EQ(newell_area(square), (geom::Point3{0, 0, 1}));

  // At the reflex corner (1, 1) the two sides turn the other way: their cross product has z = -8.
  const std::array<geom::Point3, 4> arrow{{{0, 0, 1}, {4, 0, 1}, {1, 1, 1}, {0, 4, 1}}};
  EXPECT_EQ((1.0 - 4.0) * (4.0 - 1.0) - (1.0 - 0.0) * (0.0 - 1.0), -8.0);
  EXPECT_EQ(newell_area(arrow), (geom::Point3{0, 0, 4}));

  const std::array<geom::Point3, 4> warped{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}};
  const geom::Point3 normal = newell_area(warped);
  EXPECT_NEAR(normal.x, -0.05, 1e-15);
  EXPECT_NEAR(normal.y, -0.05, 1e-15);
  EXPECT_NEAR(normal.z, 1.0, 1e-15);
  const auto distances = distances_from_mean_plane(warped);
  ASSERT_THAT(distances, SizeIs(4));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(distances[i], i % 2 == 0 ? 0.024938 : -0.024938, 5e-7) << i;
}

TEST(PolygonMesh, PolygonWithoutAreaHasNoPlane) {
  const std::array<geom::Point3, 3> line{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}};
  EXPECT_THAT(distances_from_mean_plane(line), IsEmpty());
}

}  // namespace
}  // namespace dobra::mesh
