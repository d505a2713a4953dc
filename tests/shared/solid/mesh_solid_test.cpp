#include "shared/solid/mesh_solid.h"

#include <gmock/gmock.h>

#include <limits>

#include "shared/solid/check/validate.h"
#include "shared/solid/section.h"
#include "tests/shared/solid/shapes.h"

namespace dobra::solid {
namespace {

using namespace shapes;
using base::ErrorCode;

PolygonMesh joined(PolygonMesh a, const PolygonMesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (auto face : b.faces) {
    for (std::uint32_t& p : face) p += shift;
    a.faces.push_back(face);
  }
  return a;
}
PolygonMesh turned_over(PolygonMesh mesh) {
  for (auto& face : mesh.faces) std::reverse(face.begin(), face.end());
  return mesh;
}

TEST(FromMesh, NamesTheOpenEdgeAndItsFace) {
  PolygonMesh open = box({0, 0, 0}, {1, 1, 1});
  open.faces.pop_back();  // at x = 1
  const auto made = from_mesh(open);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, ErrorCode::NotClosed);
  EXPECT_THAT(made.error().message, testing::HasSubstr("face "));
  ASSERT_TRUE(made.error().place);
  EXPECT_EQ(made.error().place->x, 1.0);
  EXPECT_EQ(base::exit_code(made.error().code), 3);
  PolygonMesh one_turned = box({0, 0, 0}, {1, 1, 1});
  std::reverse(one_turned.faces[2].begin(), one_turned.faces[2].end());
  const auto turned = from_mesh(one_turned);
  EXPECT_EQ(turned.error().code, ErrorCode::NotClosed);
  EXPECT_THAT(turned.error().message, testing::HasSubstr("face 2 is turned against its neighbours"));
  EXPECT_EQ(turned.error().place->y, 0.0);  // its middle
}

TEST(FromMesh, NamesAFaceThatIsThereTwice) {
  PolygonMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.faces.push_back(mesh.faces[3]);
  const auto made = from_mesh(mesh);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, ErrorCode::SelfIntersection);
  EXPECT_THAT(made.error().message, testing::HasSubstr("faces 3 and 6 cover each other"));
}

TEST(FromMesh, RefusesWhatIsInsideOut) {
  const auto made = from_mesh(turned_over(box({0, 0, 0}, {1, 1, 1})));
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, ErrorCode::InsideOut);
  EXPECT_THAT(made.error().message, testing::HasSubstr("inside out"));
}

TEST(FromMesh, NamesBothFacesThatCrossAndThePlace) {
  const auto made = from_mesh(joined(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})));
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, ErrorCode::SelfIntersection);
  // Face 1 is the first one's upper side; faces 6 and on are the second's.
  EXPECT_THAT(made.error().message, testing::HasSubstr("faces 1 and 8 cross"));
  ASSERT_TRUE(made.error().place);
  EXPECT_EQ(made.error().place->z, 2.0);
  const auto twice = from_mesh(joined(box({0, 0, 0}, {2, 2, 2}), box({0, 0, 0}, {2, 2, 2})));
  ASSERT_FALSE(twice.ok());
  EXPECT_THAT(twice.error().message, testing::HasSubstr("cover each other"));
  const auto nested = from_mesh(joined(box({0, 0, 0}, {3, 3, 3}), box({1, 1, 1}, {2, 2, 2})));
  ASSERT_FALSE(nested.ok());
  EXPECT_THAT(nested.error().message, testing::HasSubstr("lies within another part"));
}

TEST(FromMesh, NamesAFaceThatCrossesItself) {
  PolygonMesh mesh = prism({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 0, 1);
  std::swap(mesh.faces[4][0], mesh.faces[4][1]);
  const auto made = from_mesh(mesh);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, ErrorCode::SelfIntersection);
  EXPECT_THAT(made.error().message, testing::HasSubstr("face 4 crosses or touches itself"));
}

TEST(FromMesh, RefusesBadCornersAndNumbers) {
  PolygonMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.faces[3][1] = 99;
  EXPECT_EQ(from_mesh(mesh).error().code, ErrorCode::BadFormat);
  mesh = box({0, 0, 0}, {1e100, 1, 1});
  EXPECT_THAT(from_mesh(mesh).error().message, testing::HasSubstr("beyond 1e75"));
  mesh = box({0, 0, 0}, {1, 1, NAN});
  EXPECT_EQ(from_mesh(mesh).error().code, ErrorCode::NotFinite);
  FromMeshOptions options;
  options.face_names = {"one"};
  EXPECT_EQ(from_mesh(box({0, 0, 0}, {1, 1, 1}), options).error().code, ErrorCode::InvalidOption);
}

TEST(FromMesh, AcceptsCavitiesPartsThatTouchAndSeamsBetweenUnequalEdges) {
  const Solid hollow = solid(joined(box({0, 0, 0}, {3, 3, 3}), turned_over(box({1, 1, 1}, {2, 2, 2}))));
  EXPECT_EQ(hollow.counts(), (Counts{16, 24, 12, 0, 2, 0}));
  EXPECT_EQ(volume(hollow), 26.0);
  const Solid touching = solid(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 1}, {2, 2, 2})));
  EXPECT_EQ(touching.counts(), (Counts{16, 24, 12, 0, 2, 0}));
  // One face of a box is cut into two at an edge's middle, which its neighbours do not have as a corner.
  PolygonMesh seam = box({0, 0, 0}, {2, 2, 2});
  seam.points.push_back({1, 0, 2});
  seam.points.push_back({1, 2, 2});
  seam.faces[1] = {4, 8, 9, 6};
  seam.faces.push_back({8, 5, 7, 9});
  EXPECT_EQ(solid(seam).counts(), (Counts{8, 12, 6, 0, 1, 0}));
  // Equal places under several numbers, as in STL, and triangles without area.
  PolygonMesh soup;
  for (const auto& face : box({0, 0, 0}, {2, 2, 2}).faces) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      const auto first = static_cast<std::uint32_t>(soup.points.size());
      for (const std::uint32_t p : {face[0], face[i], face[i + 1]})
        soup.points.push_back(box({0, 0, 0}, {2, 2, 2}).points[p]);
      soup.faces.push_back({first, first + 1, first + 2});
    }
  }
  soup.faces.push_back({0, 1, 1});
  EXPECT_EQ(solid(soup).counts(), (Counts{8, 12, 6, 0, 1, 0}));
}

// Faces 0 to 11 are two boxes' in the order x-y planes, x-z planes, y-z planes; 5 is the first one's at its greater x,
// 10 the second one's at its lesser.
TEST(TakeMesh, TellsTheWallBetweenTwoBoxesOfOneFile) {
  const auto taken = take(joined(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}))).value();
  EXPECT_EQ(volume(taken.solid), 2.0);
  EXPECT_EQ(taken.solid.counts(), (Counts{8, 12, 6, 0, 1, 0}));
  ASSERT_EQ(taken.opposite.size(), 1U);
  EXPECT_EQ(taken.opposite[0].face, 5U);
  EXPECT_EQ(taken.opposite[0].against, 10U);
  EXPECT_EQ(taken.opposite[0].pairs, 1U);
  EXPECT_TRUE(taken.opposite[0].inside);
  EXPECT_EQ(taken.opposite[0].at.x, 1.0);
  // A part of a face counts as well, and the place is in it.
  const auto part = take(joined(box({0, 0, 0}, {1, 4, 4}), box({1, 2, 3}, {2, 3, 4}))).value();
  ASSERT_EQ(part.opposite.size(), 1U);
  EXPECT_EQ(part.opposite[0].at.x, 1.0);
  EXPECT_GE(part.opposite[0].at.y, 2.0);
  EXPECT_LE(part.opposite[0].at.y, 3.0);
  EXPECT_GE(part.opposite[0].at.z, 3.0);
  EXPECT_THAT(message(part.opposite[0]),
              testing::AllOf(testing::HasSubstr("faces 5 and 10"), testing::HasSubstr("wall")));
}

TEST(TakeMesh, TellsASheetWithoutThicknessOutsideWithinAndOnABox) {
  const auto sheet = [](double x, double z) {
    PolygonMesh mesh;
    mesh.points = {{x, 1, z}, {x + 1, 1, z}, {x + 1, 2, z}, {x, 2, z}, {x + 2, 1, z}, {x + 2, 2, z}};
    mesh.faces = {{0, 1, 2, 3}, {3, 2, 1, 0}, {1, 4, 5, 2}, {2, 5, 4, 1}};
    return mesh;
  };
  struct Case {
    double x, z;
    bool inside;
    const char* word;
  };
  for (const Case& c : {Case{5, 1, false, "sheet"}, Case{1, 1, true, "wall"}, Case{1, 4, false, "sheet"}}) {
    const auto taken = take(joined(box({0, 0, 0}, {4, 4, 4}), sheet(c.x, c.z))).value();
    EXPECT_EQ(volume(taken.solid), 64.0);
    EXPECT_EQ(taken.solid.counts(), (Counts{8, 12, 6, 0, 1, 0}));
    ASSERT_EQ(taken.opposite.size(), 1U) << c.x;  // both halves hang together
    EXPECT_EQ(taken.opposite[0].pairs, 2U);
    EXPECT_EQ(taken.opposite[0].inside, c.inside);
    EXPECT_EQ(taken.opposite[0].at.z, c.z);
    EXPECT_GE(taken.opposite[0].at.x, c.x);
    EXPECT_THAT(message(taken.opposite[0]), testing::HasSubstr(c.word));
  }
  // Apart they are two, in the order of their faces.
  const auto apart = take(joined(joined(box({0, 0, 0}, {4, 4, 4}), sheet(9, 0)), sheet(5, 0))).value();
  ASSERT_EQ(apart.opposite.size(), 2U);
  EXPECT_EQ(apart.opposite[0].face, 6U);
  EXPECT_EQ(apart.opposite[1].face, 10U);
}

TEST(TakeMesh, SaysNothingWhereNoFacesCoverEachOther) {
  const PolygonMesh cube = box({0, 0, 0}, {4, 4, 4});
  for (const PolygonMesh& mesh :
       {cube, joined(cube, turned_over(box({1, 1, 1}, {2, 2, 2}))), joined(cube, box({4, 4, 4}, {5, 5, 5})),
        joined(cube, box({4, 4, 0}, {5, 5, 4})), joined(cube, box({4.5, 0, 0}, {5, 4, 4})),
        sphere({0, 0, 0}, 1.0, 6, 9),
        // Thin, but not without thickness; and planes that faces of one box have in common without a common part.
        box({0, 0, 0}, {1, 1, std::numeric_limits<double>::denorm_min()}), joined(cube, box({4, 4, 0}, {8, 8, 4}))}) {
    EXPECT_THAT(take(mesh).value().opposite, testing::IsEmpty());
  }
}

TEST(FromMesh, CutsWarpedFacesAlikeWhicheverCornerTheyBeginWith) {
  PolygonMesh warped = box({0, 0, 0}, {1, 1, 1});
  warped.points[7].z = 1.5;
  // The diagonal of the top that is not lifted is the shorter one, so the corner makes a tetrahedron of 0.25 over it.
  for (std::size_t turn = 0; turn < 4; ++turn) {
    for (auto& face : warped.faces) std::rotate(face.begin(), face.begin() + 1, face.end());
    const Solid s = solid(warped);
    EXPECT_THAT(check::violations(s), testing::IsEmpty());
    EXPECT_EQ(s.counts(), (Counts{8, 13, 7, 0, 1, 0}));
    EXPECT_DOUBLE_EQ(volume(s), 1.0 + 0.25 / 3.0);
  }
}

TEST(FromMesh, SolidsSideBySideCutTheirCommonWarpedFaceAlike) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> real(-0.2, 0.2);
  for (int i = 0; i < 50; ++i) {
    PolygonMesh below = prism(regular(5 + i % 4, 1.0, 0.3), 0, 1);
    const std::size_t n = below.points.size() / 2;
    for (std::size_t k = n; k < 2 * n; ++k) below.points[k].z += real(random);
    // The same points, with a wall up to 3 from each; the common face is turned over and begins elsewhere.
    PolygonMesh above = prism(regular(5 + i % 4, 1.0, 0.3), 0, 3);
    for (std::size_t k = 0; k < n; ++k) above.points[k] = below.points[n + k];
    auto& common = above.faces[n];
    std::rotate(common.begin(), common.begin() + i % 5, common.end());
    const Combined both = combined({solid(below), solid(above)}, Operation::Intersection);
    EXPECT_EQ(both.contact, Contact::Face) << i;
    EXPECT_TRUE(both.solid.empty()) << i;
  }
}

TEST(FromMesh, TellsWarpedFacesAndWhatTheyMeanForTheVolume) {
  EXPECT_FALSE(take(box({0, 0, 0}, {1, 1, 1})).value().warped);
  // Off its plane by what rounding does alone.
  EXPECT_FALSE(take(rotated(prism(regular(9, 1.0), 0, 1), {1, 2, 3}, 0.7)).value().warped);
  PolygonMesh warped = box({0, 0, 0}, {1, 1, 1});
  warped.points[7].z = 1.5;
  const auto told = take(warped).value().warped;
  ASSERT_TRUE(told);
  EXPECT_EQ(told->count, 1U);
  EXPECT_EQ(told->face, 1U);
  // Between both diagonals lies a tetrahedron of area 1/2 and height 1/2.
  EXPECT_NEAR(told->volume, 0.25 / 3.0, 1e-15);
  EXPECT_NEAR(told->distance, 0.125, 0.01);
}

TEST(FromMesh, TheVolumeOfAWarpedPolygonDiffersByWhatIsToldAtMost) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> real(-0.3, 0.3);
  for (int i = 0; i < 30; ++i) {
    const auto n = static_cast<std::uint32_t>(5 + i % 4);
    PolygonMesh mesh = prism(regular(static_cast<int>(n), 1.0), 0, 1);
    for (std::uint32_t k = n; k < 2 * n; ++k) mesh.points[k].z += real(random);
    const Taken taken = take(mesh).value();
    ASSERT_TRUE(taken.warped);
    // Every fan of the top is one of the ways to cut it.
    const auto top = mesh.faces.back();
    double low = volume(taken.solid);
    double high = low;
    for (std::uint32_t first = 0; first < n; ++first) {
      PolygonMesh fan = mesh;
      fan.faces.pop_back();
      for (std::uint32_t k = 1; k + 1 < n; ++k)
        fan.faces.push_back({top[first], top[(first + k) % n], top[(first + k + 1) % n]});
      low = std::min(low, volume(solid(fan)));
      high = std::max(high, volume(solid(fan)));
    }
    EXPECT_LE(high - low, taken.warped->volume + 1e-15) << i;
    EXPECT_GT(high - low, 0.2 * taken.warped->volume) << i;
  }
}

TEST(ToMesh, IsTheSolidAgainWhereNothingIsRounded) {
  const Solid block =
      subtract({box_solid({0, 0, 0}, {5, 3, 3}), box_solid({1, 1, -1}, {2, 2, 4}), box_solid({3, 1, 1}, {4, 2, 3})});
  const ToMesh out = to_mesh(block).value();
  EXPECT_EQ(out.displacement, 0.0);
  const Solid back = solid(out.mesh);
  EXPECT_EQ(back.counts(), block.counts());
  EXPECT_EQ(volume(back), volume(block));
  EXPECT_THAT(mesh::check(out.mesh, mesh::Closedness::Solid), testing::IsEmpty());
}

TEST(ToMesh, TellsHowFarRoundingMovedVertices) {
  const Solid s =
      subtract({solid(sphere({0, 0, 0}, 1.0, 8, 12)), solid(rotated(box({0, 0, 0}, {2, 2, 2}), {1, 2, 3}, 0.3))});
  const ToMesh out = to_mesh(s).value();
  EXPECT_GT(out.displacement, 0.0);
  EXPECT_LT(out.displacement, 2e-16);
  EXPECT_NEAR(volume(solid(out.mesh)), volume(s), 1e-15);
  EXPECT_EQ(out.names.size(), out.mesh.faces.size());
}

TEST(ToMesh, HasOneTriangulationForRandomFacesWithHoles) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 20; ++i) {
    std::vector<Solid> operands{box_solid({0, 0, 0}, {16, 16, 1})};
    for (int k = 0; k < 12; ++k) {
      const double x = static_cast<double>(random() % 15);
      const double y = static_cast<double>(random() % 15);
      operands.push_back(box_solid({x, y, -1}, {x + 1 + static_cast<double>(random() % 2), y + 1, 2}));
    }
    const Solid sheet = subtract(operands);
    const auto out = to_mesh(sheet);
    ASSERT_TRUE(out.ok()) << i << out.error().message;
    const Solid back = solid(out->mesh);
    EXPECT_EQ(volume(back), volume(sheet));
    EXPECT_EQ(back.counts(), sheet.counts());
  }
}

}  // namespace
}  // namespace dobra::solid
