#include "shared/mesh/polygon_repair.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/shared/mesh/polygon_shapes.h"

namespace dobra::mesh {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(PolygonRepair, ReportsNameThePlaceOfEachFinding) {
  PolygonMesh mesh = unit_box(2.0, {10, 0, 0});
  std::reverse(mesh.faces[0].begin(), mesh.faces[0].end());
  mesh.faces.erase(mesh.faces.begin() + 1);
  mesh.points.push_back({5, 6, 7});
  const PolygonReport told = report(mesh, Closedness::Solid);
  ASSERT_THAT(told.findings, SizeIs(3));
  EXPECT_EQ(told.findings[0].fault, PolygonFault::OpenBoundary);
  EXPECT_EQ(told.places[0], (geom::Point3{11, 1, 2}));
  EXPECT_EQ(told.findings[1].fault, PolygonFault::ReversedFace);
  EXPECT_EQ(told.places[1], (geom::Point3{11, 1, 0}));
  EXPECT_EQ(told.findings[2].fault, PolygonFault::UnusedPoint);
  EXPECT_EQ(told.places[2], (geom::Point3{5, 6, 7}));
  EXPECT_EQ(told.parts, 1U);
}

TEST(PolygonRepair, ReportsTellPartsAndFacesThatAreNotPlane) {
  PolygonMesh mesh = unit_box();
  const PolygonMesh other = unit_box(1.0, {5, 0, 0});
  for (const auto& face : other.faces) {
    mesh.faces.push_back(face);
    for (auto& corner : mesh.faces.back()) corner += 8;
  }
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  EXPECT_EQ(report(mesh, Closedness::Solid).parts, 2U);
  EXPECT_THAT(report(mesh, Closedness::Solid).warped, IsEmpty());
  const PolygonMesh quad{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}, {{0, 1, 2, 3}}};
  const PolygonReport warped = report(quad, Closedness::Sheet);
  ASSERT_THAT(warped.warped, SizeIs(1));
  EXPECT_NEAR(warped.warped[0].distance, 0.024938, 5e-7);
}

std::vector<PolygonRepair::Kind> kinds(const RepairedPolygons& repaired) {
  std::vector<PolygonRepair::Kind> kinds;
  for (const PolygonRepair& repair : repaired.repairs) kinds.push_back(repair.kind);
  return kinds;
}

TEST(PolygonRepair, GoodMeshesStayAsTheyAre) {
  const RepairedPolygons same = repaired(unit_box());
  EXPECT_TRUE(equal(same.mesh, unit_box()));
  EXPECT_THAT(same.repairs, IsEmpty());
}

TEST(PolygonRepair, EachFaultIsMendedAndTold) {
  using Kind = PolygonRepair::Kind;
  PolygonMesh mesh = unit_box();
  mesh.faces.push_back({3, 0, 1, 2});  // face 0 once more
  mesh.faces.push_back({2, 1, 0, 3});  // and turned over
  mesh.faces.push_back({0, 0, 1});
  mesh.faces.push_back({0, 1, 77});
  mesh.points.push_back({4, 4, 4});
  std::reverse(mesh.faces[4].begin(), mesh.faces[4].end());
  const RepairedPolygons mended = repaired(mesh);
  EXPECT_TRUE(equal(mended.mesh, unit_box()) || check(mended.mesh, Closedness::Solid).empty());
  EXPECT_THAT(mended.mesh.faces, SizeIs(6));
  EXPECT_THAT(kinds(mended), ElementsAre(Kind::DroppedFaces, Kind::DroppedFaces, Kind::DroppedRepeats,
                                         Kind::DroppedRepeats, Kind::TurnedFaces, Kind::DroppedPoints));
  EXPECT_THAT(mended.repairs[4].items, ElementsAre(4));
  EXPECT_EQ(mended.repairs[4].place, (geom::Point3{0.5, 1.0, 0.5}));
}

TEST(PolygonRepair, HolesAreFilledTheWayTheyShouldTurn) {
  PolygonMesh mesh = unit_box();
  mesh.faces.erase(mesh.faces.begin() + 3);
  const RepairedPolygons filled = repaired(mesh);
  EXPECT_THAT(check(filled.mesh, Closedness::Solid), IsEmpty());
  ASSERT_THAT(filled.repairs, SizeIs(1));
  EXPECT_EQ(filled.repairs[0].place, (geom::Point3{1.0, 0.5, 0.5}));
  EXPECT_EQ(filled.faces.back(), RepairedPolygons::none);
  EXPECT_THAT(repaired(mesh, {.fill = false}).repairs, IsEmpty());
  EXPECT_THAT(repaired(mesh, {.longest = 3}).repairs, IsEmpty());
}

TEST(PolygonRepair, PartsAreTurnedOutwardsAndCavitiesInwards) {
  for (int which = 0; which < 8; ++which) {
    PolygonMesh mesh;
    int part = 0;
    // A cube, a cavity in it, and a core in the cavity; each turned the right or the wrong way.
    for (const double size : {6.0, 4.0, 2.0}) {
      const PolygonMesh own = unit_box(size, {-size / 2, -size / 2, -size / 2});
      const auto shift = static_cast<std::uint32_t>(mesh.points.size());
      mesh.points.insert(mesh.points.end(), own.points.begin(), own.points.end());
      for (auto face : own.faces) {
        for (auto& corner : face) corner += shift;
        if ((which >> part & 1) != 0) std::reverse(face.begin(), face.end());
        mesh.faces.push_back(face);
      }
      ++part;
    }
    const RepairedPolygons turned = repaired(mesh);
    double volume = 0.0;
    for (const auto& face : turned.mesh.faces) {
      for (std::size_t i = 1; i + 1 < face.size(); ++i) {
        const auto at = [&](std::size_t k) { return turned.mesh.points[face[k]] - geom::Point3{}; };
        volume += dot(at(0), cross(at(i), at(i + 1))) / 6.0;
      }
    }
    EXPECT_NEAR(volume, 216.0 - 64.0 + 8.0, 1e-10) << which;
    EXPECT_EQ(turned.repairs.empty(), which == 2) << which;
  }
}

TEST(PolygonRepair, WhatCannotBeTurnedAlikeStays) {
  // A Moebius band of five quads.
  PolygonMesh band;
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * 3.141592653589793 * i / 5;
    for (const double s : {-0.3, 0.3}) {
      const double r = 1 + s * std::cos(a / 2);
      band.points.push_back({r * std::cos(a), r * std::sin(a), s * std::sin(a / 2)});
    }
  }
  for (std::uint32_t i = 0; i < 4; ++i) band.faces.push_back({2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2});
  band.faces.push_back({8, 9, 0, 1});
  const auto left = check(repaired(band, {.fill = false}).mesh, Closedness::Sheet);
  ASSERT_THAT(left, SizeIs(1));
  EXPECT_EQ(left[0].fault, PolygonFault::NotOrientable);
}

}  // namespace
}  // namespace dobra::mesh
