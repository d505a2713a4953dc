// Sizes that are far too small or too large, and thin bodies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "shared/surf/remesh/polish.h"
#include "shared/surf/remesh/remesh.h"
#include "shared/surf/remesh/triangle_tree.h"
#include "tests/support/sheets.h"

namespace dobra::surf::remesh {
namespace {

using geom::Point3;
using test::PolygonMesh;

bool tells(const Remeshed& made, const std::string& code) {
  return std::ranges::any_of(made.findings, [&](const auto& f) { return f.code == code; });
}

/// The number behind the last "such as" of a refusal.
double advised(const base::Error& error) {
  const std::size_t at = error.message.rfind("such as ");
  return at == std::string::npos ? 0.0 : std::strtod(error.message.c_str() + at + 8, nullptr);
}

TEST(RemeshSizes, ASizeOrAChordThatMeansMoreTrianglesThanTheLimitIsRefusedAtOnceWithOneThatWorks) {
  const PolygonMesh plane = test::grid_mesh(3, 3, [](double u, double v) { return Point3{u, v, 0}; });
  // An equilateral triangle of side s has an area of sqrt(3) / 4 s2, so 0.01 means 23094 of them.
  const auto refused = remesh(plane, {.size = 0.01, .most_triangles = 20'000});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, base::ErrorCode::TooManyElements);
  const auto works = remesh(plane, {.size = advised(refused.error()), .most_triangles = 20'000});
  ASSERT_TRUE(works.ok()) << works.error().message;
  EXPECT_LT(works->quality.triangles, 20'000U);
  EXPECT_TRUE(remesh(plane, {.size = 0.013, .most_triangles = 20'000}).ok());
  for (const double unit : {1e-9, 1.0, 1e120}) {  // from one to 10^248 triangles
    PolygonMesh scaled = plane;
    for (Point3& p : scaled.points) p = {unit * p.x, unit * p.y, unit * p.z};
    const auto made = remesh(scaled, {.size = 1e-4 * std::min(unit, 1.0)});
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, base::ErrorCode::TooManyElements);
    EXPECT_GT(advised(made.error()), 1e-4 * unit);
  }
  // A sphere needs sides of sqrt(8 chord r): 4e-4 means 4 pi / (0.433 * 32e-4) = 9069 triangles.
  const PolygonMesh ball = test::sphere_mesh(24);
  const auto fine = remesh(ball, {.size = 0.3, .chord = 4e-4, .most_triangles = 3'000});
  ASSERT_FALSE(fine.ok());
  EXPECT_EQ(fine.error().code, base::ErrorCode::TooManyElements);
  const auto coarse = remesh(ball, {.size = 0.3, .chord = advised(fine.error()), .most_triangles = 3'000});
  ASSERT_TRUE(coarse.ok()) << coarse.error().message;
  EXPECT_LT(coarse->quality.triangles, 3'000U);
}

/// Of sides a, b and c, from the origin.
PolygonMesh block(double a, double b, double c) {
  return {{{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}, {0, 0, c}, {a, 0, c}, {a, b, c}, {0, b, c}},
          {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}
/// By the theorem of Gauss.
double volume_of(const Remeshed& made) {
  double sum = 0.0;
  for (const auto& t : made.mesh.triangles) {
    const Point3 p = made.mesh.point(t[0]), q = made.mesh.point(t[1]), r = made.mesh.point(t[2]);
    sum += p.x * (q.y * r.z - q.z * r.y) + p.y * (q.z * r.x - q.x * r.z) + p.z * (q.x * r.y - q.y * r.x);
  }
  return sum / 6.0;
}

TEST(RemeshSizes, AThinPlateKeepsItsShapeOrIsRefusedWithASizeThatDoes) {
  for (const double size : {5.0, 2.0, 1.0}) {
    auto made = remesh(block(10.0, 10.0, 0.1), {.size = size});
    if (!made && size > 2.0) made = remesh(block(10.0, 10.0, 0.1), {.size = advised(made.error())});
    ASSERT_TRUE(made.ok()) << size << ": " << made.error().message;
    EXPECT_NEAR(made->quality.area, 204.0, 1e-9) << size;
    EXPECT_NEAR(std::abs(volume_of(*made)), 10.0, 1e-9) << size;
    EXPECT_EQ(made->folded, 0U) << size;
    EXPECT_FALSE(tells(*made, "crease_left_out")) << size;
  }
}

TEST(RemeshSizes, ASizeWhoseAnswerHasAnAreaFarOffIsRefusedWithOneThatWorks) {
  const PolygonMesh ring = test::torus_mesh(40, 20);
  for (const double size : {2.0, 100.0}) {
    const auto refused = remesh(ring, {.size = size});
    ASSERT_FALSE(refused.ok()) << size;
    EXPECT_EQ(refused.error().code, base::ErrorCode::InvalidOption);
    EXPECT_NE(refused.error().message.find("is too large for this mesh"), std::string::npos);
    const double advice = advised(refused.error());
    ASSERT_GT(advice, 0.0) << refused.error().message;
    const auto works = remesh(ring, {.size = advice});
    ASSERT_TRUE(works.ok()) << advice << ": " << works.error().message;
    constexpr double smooth =
        4.0 * std::numbers::pi * std::numbers::pi * 2.0 * 0.7;  // the mesh given has a little less
    EXPECT_GT(works->quality.area, 0.88 * smooth);
    EXPECT_LT(works->quality.area, smooth);
    EXPECT_EQ(works->folded, 0U);
  }
}

TEST(RemeshSizes, CreasesShorterThanASideAreToldWhereTheMeshIsOff) {
  const auto coarse = remesh(block(3.0, 2.0, 1.0), {.size = 3.0});
  ASSERT_TRUE(coarse.ok()) << coarse.error().message;
  EXPECT_GT(coarse->deviation, 0.01);
  EXPECT_LT(coarse->creases, 12U);
  EXPECT_EQ(coarse->short_creases + coarse->creases, 12U);
  EXPECT_TRUE(tells(*coarse, "crease_left_out"));
  const auto fine = remesh(block(3.0, 2.0, 1.0), {.size = 0.5});
  ASSERT_TRUE(fine.ok()) << fine.error().message;
  EXPECT_EQ(fine->creases, 12U);
  EXPECT_FALSE(tells(*fine, "crease_left_out"));
}

TEST(RemeshSizes, WorkThatIsCancelledEndsInEveryStep) {
  const PolygonMesh hill = test::shaken_grid(30, 30, 0.5, 1, [](double u, double v) {
    return Point3{u, v, 0.08 * std::sin(7 * u) * std::cos(6 * v)};
  });
  const base::CancelToken token;
  token.cancel();
  const auto sheet = param::sheet_of(hill)->sheet;
  mesh::SurfaceMesh mesh = remesh(hill, {.size = 0.1})->mesh;
  const base::Progress progress(token, {});
  const auto polished = polish(mesh, sheet, TriangleTree(sheet.points, sheet.triangles), progress);
  ASSERT_FALSE(polished.ok());
  EXPECT_EQ(polished.error().code, base::ErrorCode::Cancelled);
  EXPECT_EQ(remesh(hill, {.size = 0.1}, progress).error().code, base::ErrorCode::Cancelled);
}

}  // namespace
}  // namespace dobra::surf::remesh
