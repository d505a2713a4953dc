#include "shared/surf/param/sheet.h"

#include <gtest/gtest.h>

#include "tests/support/sheets.h"

namespace dobra::surf::param {
namespace {

using test::grid_mesh;
using test::PolygonMesh;

geom::Point3 flat(double u, double v) { return {u, v, 0.0}; }

base::Error refusal(const PolygonMesh& mesh) {
  const auto made = sheet_of(mesh);
  EXPECT_FALSE(made.ok());
  return made ? base::Error{} : made.error();
}

TEST(Sheet, ASideOfThreeTrianglesIsRefusedWithItsPlace) {
  const base::Error error =
      refusal({{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}});
  EXPECT_EQ(error.code, base::ErrorCode::BadMesh);
  EXPECT_NE(error.message.find("not manifold"), std::string::npos) << error.message;
  ASSERT_TRUE(error.place);
  EXPECT_EQ(error.place->x, 1.0);
  EXPECT_EQ(error.place->y, 0.0);
  EXPECT_EQ(error.place->z, 0.0);
}

TEST(Sheet, PartsThatMeetInOnePointAreRefusedWithIt) {
  // Two triangles at one point hang together over nothing, so they are pieces; a bow tie of a ring is one piece.
  const base::Error pieces =
      refusal({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}});
  EXPECT_NE(pieces.message.find("pieces"), std::string::npos) << pieces.message;
  PolygonMesh bow{{{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {2, 0, 1}, {-1, 1, 0}, {-1, -1, 0}, {-2, 0, 1}, {0, 3, 2}}, {}};
  bow.faces = {{0, 2, 1}, {2, 3, 1}, {0, 4, 5}, {4, 6, 5}, {1, 3, 7}, {4, 7, 6}, {3, 6, 7}};
  const base::Error meeting = refusal(bow);
  EXPECT_NE(meeting.message.find("meet in point 0"), std::string::npos) << meeting.message;
}

TEST(Sheet, AFaceWhoseSidesCrossIsRefusedWithThePlace) {
  // In each of the planes of the axes; the corners 1 and 2 of a square changed places, so its diagonals are sides.
  for (const int axis : {0, 1, 2}) {
    const auto at = [&](double u, double v) {
      return axis == 0 ? geom::Point3{5, u, v} : axis == 1 ? geom::Point3{v, 5, u} : geom::Point3{u, v, 5};
    };
    PolygonMesh mesh{{at(0, 0), at(1, 1), at(1, 0), at(0, 1), at(-1, 0)}, {{0, 3, 4}, {0, 1, 2, 3}}};
    const base::Error even = refusal(mesh);
    EXPECT_EQ(even.code, base::ErrorCode::BadMesh);
    EXPECT_NE(even.message.find("sides of face 1 cross"), std::string::npos) << even.message;
    ASSERT_TRUE(even.place);
    const geom::Point3 middle = at(0.5, 0.5);
    EXPECT_NEAR(*even.place->x, middle.x, 1e-12);
    EXPECT_NEAR(*even.place->y, middle.y, 1e-12);
    EXPECT_NEAR(*even.place->z, middle.z, 1e-12);
    EXPECT_FALSE(sheets_of(mesh).ok());
    // Its halves are not alike: it has an area. The diagonal y = x meets x + 3 y = 3 at 3/4.
    mesh.points[2] = at(3, 0);
    const base::Error uneven = refusal(mesh);
    ASSERT_TRUE(uneven.place);
    const geom::Point3 crossing = at(0.75, 0.75);
    EXPECT_NEAR(*uneven.place->x, crossing.x, 1e-12);
    EXPECT_NEAR(*uneven.place->y, crossing.y, 1e-12);
    EXPECT_NEAR(*uneven.place->z, crossing.z, 1e-12);
  }
}

TEST(Sheet, FacesWhoseSidesMeetButDoNotCrossAreTaken) {
  // Not convex; warped so that it folds by more than a right angle.
  EXPECT_TRUE(sheet_of({{{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}, {{0, 1, 2, 3}}}).ok());
  EXPECT_TRUE(sheet_of({{{0, 0, 0}, {1, 0.2, 0}, {0, 1, 0}, {0.8, 0.6, 1}}, {{0, 1, 2, 3}}}).ok());
}

TEST(Sheet, AMoebiusStripIsRefused) {
  PolygonMesh strip;
  constexpr std::uint32_t n = 12;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * i / n;
    for (const double s : {-0.3, 0.3}) {
      const double r = 1.0 + s * std::cos(0.5 * a);
      strip.points.push_back({r * std::cos(a), r * std::sin(a), s * std::sin(0.5 * a)});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    const std::uint32_t a = 2 * i, b = a + 1, c = last ? 1 : a + 2, d = last ? 0 : a + 3;
    strip.faces.push_back({a, c, d});
    strip.faces.push_back({a, d, b});
  }
  EXPECT_NE(refusal(strip).message.find("one side only"), std::string::npos);
}

TEST(Sheet, SeveralPiecesAreRefusedWithAPlaceInTheSmallerOne) {
  PolygonMesh mesh = grid_mesh(3, 3, flat);
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), {{7, 0, 0}, {8, 0, 0}, {7, 1, 0}});
  mesh.faces.insert(mesh.faces.begin(), {first, first + 1, first + 2});
  const base::Error error = refusal(mesh);
  ASSERT_TRUE(error.place);
  EXPECT_GE(*error.place->x, 7.0);
}

TEST(Sheet, CornersThatAreNoNumbersOrDoNotExistAreRefused) {
  PolygonMesh mesh = grid_mesh(2, 2, flat);
  mesh.points[4].z = std::nan("");
  EXPECT_EQ(refusal(mesh).code, base::ErrorCode::NotFinite);
  mesh = grid_mesh(2, 2, flat);
  mesh.faces[0][1] = 99;
  EXPECT_EQ(refusal(mesh).code, base::ErrorCode::BadMesh);
  EXPECT_EQ(refusal({}).code, base::ErrorCode::BadMesh);
}

TEST(Sheet, FacesThatAreTurnedDoubledOrWithoutAreaAreMendedAndCounted) {
  PolygonMesh mesh = grid_mesh(4, 4, flat);
  const std::size_t triangles = mesh.faces.size();
  std::swap(mesh.faces[5][0], mesh.faces[5][1]);
  mesh.faces.push_back(mesh.faces[7]);
  mesh.faces.push_back({3, 3, 4});
  mesh.points.push_back({9, 9, 9});
  // A point in the middle of an inner side, in a triangle without area with its ends.
  const auto middle = static_cast<std::uint32_t>(mesh.points.size());
  const std::uint32_t a = mesh.faces[12][0], b = mesh.faces[12][1], c = mesh.faces[12][2];
  mesh.points.push_back(geom::midpoint(mesh.points[a], mesh.points[b]));
  mesh.faces[12] = {a, middle, c};
  mesh.faces.push_back({middle, b, c});
  mesh.faces.push_back({a, b, middle});
  const auto made = sheet_of(mesh);
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(made->mended.turned, 1U);
  EXPECT_EQ(made->mended.dropped, 2U);
  EXPECT_EQ(made->mended.flipped, 1U);
  EXPECT_EQ(made->mended.unused, 1U);
  EXPECT_TRUE(made->sheet.disk());
  EXPECT_EQ(made->sheet.triangles.size(), triangles + 2);
  double area = 0.0;
  for (const auto& [p, q, r] : made->sheet.triangles) {
    const auto& at = made->sheet.points;
    area += 0.5 * cross(at[q] - at[p], at[r] - at[p]).z;
  }
  EXPECT_NEAR(std::abs(area), 1.0, 1e-12);
}

/// By the theorem of Gauss, from the origin.
double volume(const Sheet& sheet) {
  double sum = 0.0;
  for (const auto& [a, b, c] : sheet.triangles) {
    const geom::Point3 p = sheet.points[a], q = sheet.points[b], r = sheet.points[c];
    sum += p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
  }
  return sum / 6.0;
}

TEST(Sheet, FewTrianglesAreTurnedTheWayOfTheManyWhicheverComesFirst) {
  const PolygonMesh ball = test::sphere_mesh(6);
  const double full = volume(sheet_of(ball)->sheet);
  ASSERT_GT(full, 3.5);
  for (const std::size_t count : {1U, 5U, 100U}) {  // of 288
    PolygonMesh turned = ball;
    for (std::size_t f = 0; f < count; ++f) std::swap(turned.faces[f][1], turned.faces[f][2]);
    const auto made = sheet_of(turned);
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_EQ(made->mended.turned, count);
    EXPECT_NEAR(volume(made->sheet), full, 1e-12);
    // The rest turned instead: a cavity stays one.
    for (auto& face : turned.faces) std::swap(face[1], face[2]);
    EXPECT_NEAR(volume(sheet_of(turned)->sheet), -full, 1e-12);
  }
  // Half of them: it is no cavity.
  PolygonMesh half = ball;
  for (std::size_t f = 0; f < half.faces.size() / 2; ++f) std::swap(half.faces[f][1], half.faces[f][2]);
  EXPECT_NEAR(volume(sheet_of(half)->sheet), full, 1e-12);
}

TEST(Sheet, PointsAtOnePlaceAreOne) {
  const auto made = sheet_of(test::sphere_mesh(4));
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->sheet.euler(), 2);
  EXPECT_EQ(made->sheet.loops.size(), 0U);
  EXPECT_EQ(made->mended.merged, 8U * 15 - 66);
}

void expect_disk(const Opened& opened, const Sheet& before) {
  EXPECT_TRUE(opened.sheet.disk());
  EXPECT_EQ(opened.sheet.triangles.size(), before.triangles.size());
  for (std::size_t t = 0; t < before.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(opened.origin[opened.sheet.triangles[t][k]], before.triangles[t][k]);
  }
}

TEST(Sheet, ADiskStaysAsItIs) {
  const Sheet sheet = sheet_of(grid_mesh(4, 3, flat))->sheet;
  const Opened opened = open(sheet);
  EXPECT_EQ(opened.sides, 0U);
  EXPECT_EQ(opened.sheet.triangles, sheet.triangles);
}

TEST(Sheet, ATubeIsCutAlongItsShortestWayFromEndToEnd) {
  // The tube is dented on one side: there the way is straight, elsewhere it is longer.
  const Sheet sheet =
      sheet_of(test::tube(24, 10, false, [](double u, double v) {
        const double a = 2.0 * std::numbers::pi * u;
        return geom::Point3{std::cos(a), std::sin(a), 4.0 * v + 0.5 * std::sin(9.0 * v) * (1 - std::cos(a))};
      }))->sheet;
  ASSERT_EQ(sheet.loops.size(), 2U);
  const Opened opened = open(sheet);
  expect_disk(opened, sheet);
  EXPECT_NEAR(opened.length, 4.0, 1e-12);
  EXPECT_EQ(opened.sides, 10U);
}

TEST(Sheet, HolesHandlesAndClosedSurfacesAreOpenedToOneDisk) {
  const Sheet holes = sheet_of(grid_mesh(12, 12, flat, [](std::uint32_t i, std::uint32_t j) {
                        return (i == 3 || i == 8) && (j == 4 || j == 7);
                      }))->sheet;
  ASSERT_EQ(holes.loops.size(), 5U);
  expect_disk(open(holes), holes);
  const Sheet torus = sheet_of(test::torus_mesh(24, 12))->sheet;
  ASSERT_EQ(torus.genus(), 1);
  const Opened ring = open(torus);
  expect_disk(ring, torus);
  // No cut is shorter than once round the tube and once round the hole inside, 2 pi 0.7 and 2 pi 1.3, by chords.
  const double least = 12 * 1.4 * std::sin(std::numbers::pi / 12) + 24 * 2.6 * std::sin(std::numbers::pi / 24);
  EXPECT_GE(ring.length, least - 1e-9);
  EXPECT_LE(ring.length, 1.25 * least);
  const Sheet sphere = sheet_of(test::sphere_mesh(6))->sheet;
  expect_disk(open(sphere), sphere);
}

TEST(Sheet, PartsThatMeetInOnePointGetACopyEach) {
  // Two triangles that share a corner, one of them turned; and a ring of four with a pinch: its first and third corner
  // are one.
  const dobra::mesh::PolygonMesh bow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 4, 3}}};
  const auto two = sheets_of(bow);
  ASSERT_TRUE(two.ok()) << two.error().message;
  ASSERT_EQ(two->size(), 2U);
  for (const SheetMade& made : *two) EXPECT_EQ(made.sheet.points.size(), 3U);
  const dobra::mesh::PolygonMesh pinched{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0.5, 1}, {0.5, 0.5, 1}},
                                         {{0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {2, 4, 3}, {3, 4, 0}}};
  const auto one = sheets_of(pinched);
  ASSERT_TRUE(one.ok()) << one.error().message;
  ASSERT_EQ(one->size(), 1U);
  EXPECT_EQ(one->front().mended.parted, 1U);
  EXPECT_EQ(one->front().sheet.points.size(), 7U);
  EXPECT_TRUE(one->front().sheet.disk());
  EXPECT_FALSE(sheet_of(pinched).ok());
}

}  // namespace
}  // namespace dobra::surf::param
