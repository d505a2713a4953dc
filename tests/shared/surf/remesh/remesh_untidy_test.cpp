// What is told of meshes whose parts meet in points, or almost meet.
#include <gtest/gtest.h>

#include <algorithm>

#include "shared/surf/remesh/remesh.h"
#include "tests/support/sheets.h"

namespace dobra::surf::remesh {
namespace {

using geom::Point3;
using test::PolygonMesh;

std::vector<mesh::Finding> findings_with(const Remeshed& made, const std::string& code, const std::string& text = "") {
  std::vector<mesh::Finding> found;
  for (const mesh::Finding& finding : made.findings) {
    if (finding.code == code && finding.message.find(text) != std::string::npos) found.push_back(finding);
  }
  return found;
}

void expect_at(const mesh::Finding& finding, Point3 p) {
  EXPECT_EQ(finding.place.x, p.x);
  EXPECT_EQ(finding.place.y, p.y);
  EXPECT_EQ(finding.place.z, p.z);
}

/// The quadrilaterals of a box, with their own eight points.
void add_box(PolygonMesh& mesh, Point3 low, Point3 high) {
  const auto n = static_cast<std::uint32_t>(mesh.points.size());
  for (const double z : {low.z, high.z}) {
    for (const double y : {low.y, high.y}) {
      for (const double x : {low.x, high.x}) mesh.points.push_back({x, y, z});
    }
  }
  for (const auto& f : std::vector<std::vector<std::uint32_t>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    mesh.faces.push_back({n + f[0], n + f[1], n + f[2], n + f[3]});
}

TEST(RemeshUntidy, PointsInWhichPiecesMeetAreToldWithTheirPlace) {
  PolygonMesh boxes;
  add_box(boxes, {0, 0, 0}, {1, 1, 1});
  add_box(boxes, {1, 1, 1}, {2, 2, 2});
  add_box(boxes, {2, 2, 2}, {3, 3, 3});
  const auto made = remesh(boxes, {.size = 0.5});
  ASSERT_TRUE(made.ok()) << made.error().message;
  const auto told = findings_with(*made, "mended", "parts of the mesh meet");
  ASSERT_EQ(told.size(), 2U);
  EXPECT_NE(told[0].message.find(": 2"), std::string::npos) << told[0].message;
  expect_at(told[0], {1, 1, 1});
  expect_at(told[1], {2, 2, 2});
  // Apart there is nothing to tell.
  PolygonMesh apart;
  add_box(apart, {0, 0, 0}, {1, 1, 1});
  add_box(apart, {1, 1, 1.5}, {2, 2, 2.5});
  const auto alone = remesh(apart, {.size = 0.5});
  ASSERT_TRUE(alone.ok()) << alone.error().message;
  EXPECT_TRUE(findings_with(*alone, "mended", "meet").empty());
  EXPECT_TRUE(findings_with(*alone, "slit").empty());
}

TEST(RemeshUntidy, SidesThatAlmostMeetAreToldWithTheirPlace) {
  const auto sheets = [](double gap) {
    return PolygonMesh{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1 + gap, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1 + gap, 1, 0}},
        {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
  };
  const auto near = remesh(sheets(1e-9), {.size = 0.5});
  ASSERT_TRUE(near.ok()) << near.error().message;
  const auto told = findings_with(*near, "slit");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].message.find(": 4;"), std::string::npos) << told[0].message;
  expect_at(told[0], {1, 0, 0});
  // Two pieces may be two surfaces, and then nothing is wrong.
  EXPECT_NE(told[0].message.find("surfaces that only meet"), std::string::npos) << told[0].message;
  const auto apart = remesh(sheets(0.01), {.size = 0.5});
  ASSERT_TRUE(apart.ok()) << apart.error().message;
  EXPECT_TRUE(findings_with(*apart, "slit").empty());
}

TEST(RemeshUntidy, APointOnTheSideOfANeighbourIsToldWithItsPlace) {
  PolygonMesh box;
  add_box(box, {0, 0, 0}, {1, 1, 1});
  box.points.push_back({0.5, 0, 0});
  box.faces[2] = {0, 8, 1, 5, 4};  // at y = 0; the bottom does not know the point
  const auto made = remesh(box, {.size = 0.5});
  ASSERT_TRUE(made.ok()) << made.error().message;
  const auto told = findings_with(*made, "slit");
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].message.find(": 1;"), std::string::npos) << told[0].message;
  expect_at(told[0], {0.5, 0, 0});
  EXPECT_NE(told[0].message.find("the mesh is open there"), std::string::npos) << told[0].message;
  box.faces[0] = {0, 2, 3, 1, 8};
  const auto whole = remesh(box, {.size = 0.5});
  ASSERT_TRUE(whole.ok()) << whole.error().message;
  EXPECT_TRUE(findings_with(*whole, "slit").empty());
}

}  // namespace
}  // namespace dobra::surf::remesh
