#include "shared/mesh/polygon_surface.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/shared/mesh/polygon_shapes.h"

namespace dobra::mesh {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Two triangles over the unit square, its far side raised by one.
PolygonMesh ramp() { return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 1}}, {{0, 1, 2}, {0, 2, 3}}}; }

TEST(PolygonSurface, AFaceWithoutAreaIsAFaultWithItsPlace) {
  PolygonMesh mesh = ramp();
  mesh.points.push_back({2, 0, 0});
  mesh.faces.push_back({1, 0, 4});
  const PolygonSurface told = surface_of(mesh, Closedness::Sheet);
  ASSERT_THAT(told.faults, SizeIs(1));
  EXPECT_EQ(told.faults[0].message, "face 2 has no area");
  EXPECT_EQ(told.faults[0].place, (geom::Point3{1, 0, 0}));
  EXPECT_EQ(told.alpha_min, 0.0);
  EXPECT_EQ(told.worst, (geom::Point3{1, 0, 0}));
}

TEST(PolygonSurface, AFaceGivenTwiceIsAFaultHoweverItsCornersBegin) {
  PolygonMesh mesh = ramp();
  mesh.faces.push_back({2, 0, 1});
  const PolygonSurface told = surface_of(mesh, Closedness::Sheet);
  ASSERT_FALSE(told.faults.empty());
  EXPECT_EQ(told.faults.back().message, "face 2 has the corners of face 0: it is given twice");
}

TEST(PolygonSurface, AFaceGivenTwiceOverPointsOfItsOwnIsAFaultToo) {
  PolygonMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, -0.0}, {0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}, {3, 4, 5}}};
  const PolygonSurface told = surface_of(mesh, Closedness::Sheet);
  ASSERT_THAT(told.faults, SizeIs(1));
  EXPECT_THAT(told.faults[0].message, HasSubstr("given twice"));
  EXPECT_EQ(told.shared_places, 3U);
}

TEST(PolygonSurface, AnEdgeOfThreeFacesATurnedOneAndABadCornerAreFaults) {
  PolygonMesh mesh = ramp();
  mesh.points.push_back({1, 0, 5});
  mesh.faces.push_back({0, 2, 4});
  EXPECT_THAT(surface_of(mesh, Closedness::Sheet).faults.at(0).message, HasSubstr("edge 0-2 is shared by 3 faces"));
  mesh = ramp();
  std::reverse(mesh.faces[1].begin(), mesh.faces[1].end());
  EXPECT_THAT(surface_of(mesh, Closedness::Sheet).faults.at(0).message, HasSubstr("turned against its neighbours"));
  mesh = ramp();
  mesh.faces.push_back({0, 1, 9});
  const PolygonSurface told = surface_of(mesh, Closedness::Sheet);
  ASSERT_THAT(told.faults, SizeIs(1));
  EXPECT_NEAR(told.area, std::sqrt(2.0), 1e-15);
}

TEST(PolygonSurface, BordersAreFiguresOfASheetAndFaultsOfASolid) {
  const PolygonSurface sheet = surface_of(ramp(), Closedness::Sheet);
  EXPECT_THAT(sheet.faults, IsEmpty());
  EXPECT_EQ(sheet.borders, 1U);
  EXPECT_EQ(sheet.open_edges, 4U);
  EXPECT_EQ(sheet.parts, 1U);
  EXPECT_NEAR(sheet.area, std::sqrt(2.0), 1e-15);
  EXPECT_THAT(surface_of(ramp(), Closedness::Solid).faults, SizeIs(1));
}

TEST(PolygonSurface, ATubeHasTwoBordersAndABoxNone) {
  const PolygonMesh box = unit_box();
  const PolygonSurface closed = surface_of(box, Closedness::Solid);
  EXPECT_THAT(closed.faults, IsEmpty());
  EXPECT_EQ(closed.borders, 0U);
  EXPECT_NEAR(closed.area, 6.0, 1e-14);
  EXPECT_EQ(closed.triangles, 0U);
  PolygonMesh tube = box;
  tube.faces.erase(tube.faces.begin(), tube.faces.begin() + 2);  // Floor and ceiling, or two opposite walls.
  EXPECT_EQ(surface_of(tube, Closedness::Sheet).open_edges, 8U);
  EXPECT_EQ(surface_of(tube, Closedness::Sheet).borders, 2U);
}

TEST(PolygonSurface, AMeshWithoutFacesIsNothing) {
  const PolygonSurface told = surface_of({}, Closedness::Sheet);
  EXPECT_THAT(told.faults, IsEmpty());
  EXPECT_EQ(told.area, 0.0);
}

}  // namespace
}  // namespace dobra::mesh
