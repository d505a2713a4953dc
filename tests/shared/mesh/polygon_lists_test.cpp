#include "shared/mesh/polygon_lists.h"

#include <gmock/gmock.h>

#include <random>

#include "tests/shared/mesh/polygon_shapes.h"

namespace dobra::mesh {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(PolygonLists, PM_c_EdgeListsThatDoNotHangTogetherAreRefused) {
  EdgeListMesh good = with_edges(unit_box());
  ASSERT_TRUE(with_points(good));
  EdgeListMesh list = good;
  std::swap(list.faces[0][0], list.faces[0][1]);
  EXPECT_THAT(with_points(list).error().message, HasSubstr("face 0: edge"));
  list = good;
  list.faces[2][1].backwards = !list.faces[2][1].backwards;
  EXPECT_THAT(with_points(list).error().message, HasSubstr("face 2"));
  list = good;
  list.faces[1][0].edge = 99;
  EXPECT_THAT(with_points(list).error().message, HasSubstr("edge 99 does not exist"));
  list = good;
  list.edges[good.faces[3][0].edge].faces = {0, 1};
  EXPECT_THAT(with_points(list).error().message, HasSubstr("which does not name it"));
  list = good;
  list.edges[good.faces[0][0].edge].faces.push_back(4);
  EXPECT_THAT(with_points(list).error().message, HasSubstr("face 4: edge"));
  list = good;
  list.edges[0].b = 77;
  EXPECT_FALSE(with_points(list));
}

TEST(PolygonLists, PM_c_RoundTripsGiveTheSameMesh) {
  const PolygonMesh mesh = unit_box();
  EXPECT_THAT(with_edges(mesh).edges, SizeIs(12));
  EXPECT_TRUE(equal(with_points(with_edges(mesh)).value(), mesh));
  EXPECT_TRUE(equal(with_points(explicit_polygons(mesh)), mesh));
  EXPECT_EQ(explicit_polygons(with_points(explicit_polygons(mesh))), explicit_polygons(mesh));
  // A face that passes one edge both ways, and a point of no face: lists of edges keep both.
  const PolygonMesh slit{{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {1, 1, 0}, {9, 9, 9}}, {{0, 1, 2, 0, 3}}};
  EXPECT_TRUE(equal(with_points(with_edges(slit)).value(), slit));
}

TEST(PolygonLists, PM_c_ExplicitPolygonsMergeAtTheTolerance) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> off(-0.2e-6, 0.2e-6);
  ExplicitPolygons polygons = explicit_polygons(unit_box());
  for (auto& polygon : polygons) {
    for (geom::Point3& p : polygon) p = p + geom::Vector3{off(random), off(random), off(random)};
  }
  EXPECT_THAT(with_points(polygons).points, SizeIs(24));
  EXPECT_THAT(with_points(polygons, 1e-9).points, SizeIs(24));
  const PolygonMesh merged = with_points(polygons, 1e-6);
  EXPECT_EQ(merged.faces, unit_box().faces);
  EXPECT_THAT(check(merged, Closedness::Solid), IsEmpty());
  // A chain of points is one, however long; what is farther stays.
  EXPECT_THAT(merged_points({{3, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3.5, 1, 0}, {-0.0, 0, 0}}, 1.0),
              ElementsAre(0, 0, 0, 0, 4, 0));
  EXPECT_THAT(merged_points({{1, 0, 0}, {0, 0, 0}, {-0.0, 0, 0}, {1, 0, 1e-300}}, 0.0), ElementsAre(0, 1, 1, 3));
}

TEST(PolygonLists, MergingFindsTheSamePointsAsAllPairs) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<geom::Point3> points;
    for (int i = 0; i < 60; ++i) points.push_back({double(random() % 7), double(random() % 7), double(random() % 3)});
    for (const double tolerance : {0.0, 1.0, 1.5}) {
      std::vector<std::uint32_t> expected(points.size());
      for (std::uint32_t i = 0; i < expected.size(); ++i) expected[i] = i;
      for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < points.size(); ++i) {
          for (std::size_t j = 0; j < points.size(); ++j) {
            if (distance(points[i], points[j]) > tolerance || expected[j] >= expected[i]) continue;
            expected[i] = expected[j];
            changed = true;
          }
        }
      }
      EXPECT_EQ(merged_points(points, tolerance), expected);
    }
  }
}

}  // namespace
}  // namespace dobra::mesh
