// Sections as lines and regions: planes that miss and touch first, then caps in pieces, with holes and materials.

#include "shared/solid/cap.h"

#include <gmock/gmock.h>

#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

using namespace shapes;
using testing::ElementsAre;

Cap cap(const std::vector<Solid>& solids, const CutPlane& plane) { return cap_of(Sections(solids).cut(plane).value()); }
Contact contact(const Solid& s, const CutPlane& plane) { return contact_with(std::vector{s}, plane).value().most; }

double area(const Cap& c) {
  double sum = 0.0;
  for (const CapRegion& region : c.regions) sum += region.area;
  return sum;
}
double length(const Cap& c) {
  double sum = 0.0;
  for (const CapLine& line : c.lines) sum += geom::length(line.line);
  return sum;
}

TEST(Cap, TellsHowAPlaneThatCutsNothingTouches) {
  const Solid cube = box_solid({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(contact(cube, {0, 0, 1, -2}), Contact::Nothing);
  EXPECT_EQ(contact(cube, {1, 1, 1, -3}), Contact::Vertex);
  EXPECT_EQ(contact(cube, {1, 1, 0, -2}), Contact::Edge);
  EXPECT_EQ(contact(cube, {0, 0, 1, -1}), Contact::Face);
  EXPECT_EQ(contact(cube, {0, 0, 1, -0.5}), Contact::Volume);
  for (const CutPlane& plane : {CutPlane{0, 0, 1, -2}, CutPlane{1, 1, 1, -3}, CutPlane{1, 1, 0, -2}})
    EXPECT_TRUE(cap({cube}, plane).empty());
  // In a face: what is just below the plane counts.
  EXPECT_EQ(area(cap({cube}, {0, 0, 1, -1})), 1.0);
  EXPECT_TRUE(cap({cube}, {0, 0, 1, 0}).empty());
  EXPECT_FALSE(contact_with(std::vector{cube}, {0, 0, 0, 1}));
}

TEST(Cap, AFaceInThePlaneIsToldWhereThePlaneCutsTheSolidElsewhere) {
  // The tread of a step: below the plane the section is 2 wide, above it 1.
  const std::vector<Solid> stairs{solid(prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 0, 1))};
  const PlaneContact tread = contact_with(stairs, {0, 1, 0, -1}).value();
  EXPECT_EQ(tread.most, Contact::Volume);
  EXPECT_TRUE(tread.in_face);
  EXPECT_EQ(area(cap(stairs, {0, 1, 0, -1})), 2.0);
  EXPECT_EQ(area(cap(stairs, {0, -1, 0, 1})), 1.0);
  const PlaneContact beside = contact_with(stairs, {0, 1, 0, -1.5}).value();
  EXPECT_EQ(beside.most, Contact::Volume);
  EXPECT_FALSE(beside.in_face);
}

TEST(Cap, APlaneBetweenTwoShellsTouchesNothing) {
  const Solid apart = unite({box_solid({0, 0, 0}, {1, 1, 1}), box_solid({0, 0, 3}, {1, 1, 4})});
  EXPECT_EQ(contact(apart, {0, 0, 1, -2}), Contact::Nothing);
  EXPECT_TRUE(cap({apart}, {0, 0, 1, -2}).empty());
  EXPECT_EQ(contact(apart, {0, 0, 1, -3}), Contact::Face);
}

TEST(Cap, HasAPieceForEachArmAndAHoleForEachBore) {
  const Solid u = solid(prism({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 0, 1));
  const Cap arms = cap({u}, {0, 1, 0, -2});
  EXPECT_EQ(arms.regions.size(), 2U);
  EXPECT_EQ(area(arms), 2.0);
  EXPECT_EQ(arms.lines.size(), 2U);
  EXPECT_TRUE(arms.lines[0].line.closed);

  const Solid plate =
      subtract({box_solid({0, 0, 0}, {6, 4, 1}), box_solid({1, 1, -1}, {2, 2, 2}), box_solid({3, 1, -1}, {5, 3, 2})});
  const Cap bored = cap({plate}, {0, 0, 1, -0.5});
  ASSERT_EQ(bored.regions.size(), 1U);
  EXPECT_EQ(bored.regions[0].holes, 2U);
  EXPECT_EQ(area(bored), 24.0 - 1.0 - 4.0);
  EXPECT_EQ(length(bored), 20.0 + 4.0 + 8.0);
}

TEST(Cap, LinesEndWhereNamesOrMaterialsChange) {
  const Solid left = solid(box({0, 0, 0}, {1, 1, 1}), "left");
  const Solid right = solid(box({1, 0, 0}, {3, 1, 1}), "right");
  const Cap both = cap({left, right}, {0, 0, 1, -0.5});
  ASSERT_EQ(both.lines.size(), 3U);
  std::size_t between = 0;
  for (const CapLine& line : both.lines) {
    EXPECT_FALSE(line.line.closed);
    if (line.right == outside) {
      EXPECT_EQ(line.line.points.size(), 4U);
      EXPECT_THAT(line.names, ElementsAre(line.left == 0 ? "left" : "right"));
    } else {
      ++between;
      EXPECT_THAT(line.names, ElementsAre("left", "right"));
      EXPECT_EQ(geom::length(line.line), 1.0);
    }
  }
  EXPECT_EQ(between, 1U);
  ASSERT_EQ(both.regions.size(), 2U);
  EXPECT_EQ(both.regions[0].area + both.regions[1].area, 3.0);
}

TEST(Cap, AnIslandOfAnotherMaterialIsAHoleThatIsFilled) {
  const Solid rock = subtract({box_solid({0, 0, 0}, {4, 4, 2}), box_solid({1, 1, -1}, {3, 3, 3})});
  const Solid core = box_solid({1, 1, 0}, {3, 3, 2});
  const Cap both = cap({rock, core}, {0, 0, 1, -1});
  ASSERT_EQ(both.regions.size(), 2U);
  EXPECT_EQ(both.regions[0].area + both.regions[1].area, 16.0);
  EXPECT_EQ(both.regions[0].holes + both.regions[1].holes, 1U);
  // Where solids overlap the first counts.
  const Cap over = cap({box_solid({0, 0, 0}, {2, 2, 2}), box_solid({1, 0, 0}, {3, 2, 2})}, {0, 0, 1, -1});
  ASSERT_EQ(over.regions.size(), 2U);
  for (const CapRegion& region : over.regions) EXPECT_EQ(region.area, region.solid == 0 ? 4.0 : 2.0);
}

TEST(Cap, DiagonalsOfTriangulatedFacesLeaveNoCorners) {
  PolygonMesh mesh = sphere({0, 0, 0}, 1.0, 8, 12);
  const Solid ball = solid(mesh, "ball");
  // Every face of the cube as two triangles that are named apart stays one side of the section.
  PolygonMesh cube = box({0, 0, 0}, {1, 1, 1});
  PolygonMesh triangles{cube.points, {}};
  for (const auto& f : cube.faces) {
    triangles.faces.push_back({f[0], f[1], f[2]});
    triangles.faces.push_back({f[0], f[2], f[3]});
  }
  FromMeshOptions options;
  for (std::size_t i = 0; i < triangles.faces.size(); ++i) options.face_names.push_back(i % 2 == 0 ? "a" : "b");
  const Solid s = from_mesh(rotated(triangles, {1, 2, 3}, 0.4), options).value();
  const geom::Vector3 n = rotated(PolygonMesh{{{0, 0, 1}}, {}}, {1, 2, 3}, 0.4).points[0] - Point3{};
  const Cap c = cap({s}, {n.x, n.y, n.z, -0.3});
  EXPECT_NEAR(area(c), 1.0, 1e-12);
  EXPECT_EQ(c.lines.size(), 8U);  // a and b on each side of four
  const Cap round = cap({ball}, {0, 0, 1, -0.1});
  ASSERT_EQ(round.lines.size(), 1U);
  EXPECT_EQ(round.lines[0].line.points.size(), 12U);  // the columns
}

}  // namespace
}  // namespace dobra::solid
