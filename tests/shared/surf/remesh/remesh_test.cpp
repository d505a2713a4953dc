#include "shared/surf/remesh/remesh.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "tests/support/sheets.h"

namespace dobra::surf::remesh {
namespace {

using geom::Point3;
using test::grid_mesh;
using test::PolygonMesh;

constexpr double pi = std::numbers::pi;

struct Case {
  std::string name;
  PolygonMesh mesh;
  double size = 0.0, chord = 0.0;
};

std::vector<Case> ten() {
  std::mt19937_64 random(4);
  const auto noise = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
  std::vector<Case> cases;
  cases.push_back({"bumps",
                   test::shaken_grid(40, 40, 0.5, 1,
                                     [](double u, double v) {
                                       return Point3{u, v, 0.08 * std::sin(7 * u) * std::cos(6 * v)};
                                     }),
                   0.05, 0.004});
  cases.push_back({"saddle",
                   test::shaken_grid(30, 30, 0.6, 2,
                                     [](double u, double v) {
                                       const double x = 2 * u - 1, y = 2 * v - 1;
                                       return Point3{x, y, 0.6 * (x * x - y * y)};
                                     }),
                   0.12, 0.008});
  cases.push_back({"half sphere", test::half_sphere(20), 0.12, 0.006});
  cases.push_back({"folded",
                   grid_mesh(40, 20,
                             [](double u, double v) {
                               const double x = 4 * u, k = std::floor(x), part = x - k;
                               return Point3{x, 2 * v, static_cast<int>(k) % 2 == 0 ? part : 1 - part};
                             }),
                   0.2, 0.01});
  cases.push_back({"L",
                   grid_mesh(
                       30, 30,
                       [](double u, double v) {
                         return Point3{2 * u, 2 * v, 0.2 * std::sin(3 * u + v)};
                       },
                       [](std::uint32_t i, std::uint32_t j) { return i >= 12 && j >= 14; }),
                   0.1, 0.006});
  cases.push_back({"strip",
                   test::shaken_grid(120, 6, 0.5, 3,
                                     [](double u, double v) {
                                       return Point3{20 * u, v, std::sin(12 * u)};
                                     }),
                   0.2, 0.01});
  cases.push_back({"scan",
                   test::shaken_grid(60, 60, 0.8, 5,
                                     [&](double u, double v) {
                                       return Point3{u, v, 0.1 * std::sin(5 * u * v) + 0.001 * noise()};
                                     }),
                   0.05, 0.004});
  cases.push_back({"holes",
                   grid_mesh(
                       30, 30,
                       [](double u, double v) {
                         return Point3{3 * u, 3 * v, 0.3 * std::cos(2 * u + 2 * v)};
                       },
                       [](std::uint32_t i, std::uint32_t j) {
                         return (i >= 6 && i < 10 && j >= 8 && j < 13) || (i >= 18 && i < 24 && j >= 16 && j < 20);
                       }),
                   0.15, 0.008});
  cases.push_back({"tube",
                   test::tube(30, 20, false,
                              [](double u, double v) {
                                const double r = 1 + 0.2 * std::sin(4 * v);
                                return Point3{r * std::cos(2 * pi * u), r * std::sin(2 * pi * u), 3 * v};
                              }),
                   0.25, 0.02});
  cases.push_back({"roll",
                   test::shaken_grid(60, 15, 0.5, 6,
                                     [](double u, double v) {
                                       const double a = 1.6 * pi * u;
                                       return Point3{std::cos(a), std::sin(a), 1.5 * v};
                                     }),
                   0.15, 0.008});
  return cases;
}

bool told(const Remeshed& made, const std::string& code) {
  return std::ranges::any_of(made.findings, [&](const auto& f) { return f.code == code; });
}

TEST(Remesh, TenMeshesKeepTheirShapeWithoutAFlipAndWithGoodTriangles) {
  for (const Case& each : ten()) {
    SCOPED_TRACE(each.name);
    const auto made = remesh(each.mesh, {.size = each.size, .chord = each.chord});
    ASSERT_TRUE(made.ok()) << made.error().message;
    std::printf("%-12s %6zu triangles  mean %.4f  least %.3f  deviation %.5f of %.5f  rounds %d  creases %zu\n",
                each.name.c_str(), made->quality.triangles, made->quality.alpha_mean, made->quality.alpha_min,
                made->deviation, each.chord, made->rounds, made->creases);
    EXPECT_EQ(made->flipped, 0U);
    EXPECT_LE(made->deviation, each.chord);
    EXPECT_GE(made->quality.alpha_mean, 0.97);
    EXPECT_GT(made->quality.alpha_min, 0.3);
    EXPECT_EQ(told(*made, "cut"), each.name == "holes" || each.name == "tube");
    EXPECT_FALSE(told(*made, "deviation_above"));
    // What it is stays: pieces, borders, Euler's number, and about its area.
    const auto before = param::sheet_of(each.mesh)->sheet;
    EXPECT_EQ(made->quality.euler, before.euler());
    EXPECT_EQ(made->quality.loops, before.loops.size());
    EXPECT_LT(made->quality.gauss_bonnet, 1e-9);
    double area = 0.0;
    for (const auto& [a, b, c] : before.triangles)
      area += 0.5 * geom::length(cross(before.points[b] - before.points[a], before.points[c] - before.points[a]));
    EXPECT_NEAR(made->quality.area, area, 0.02 * area);
  }
}

TEST(Remesh, AChordThatTheSizeDoesNotKeepMakesSidesSmallerWhereItMust) {
  // Flat but for one bump.
  const PolygonMesh bump = test::shaken_grid(60, 60, 0.5, 7, [](double u, double v) {
    const double r2 = (u - 0.3) * (u - 0.3) + (v - 0.3) * (v - 0.3);
    return Point3{u, v, 0.1 * std::exp(-r2 / 0.01)};
  });
  const auto coarse = remesh(bump, {.size = 0.1}), fine = remesh(bump, {.size = 0.1, .chord = 0.004});
  ASSERT_TRUE(coarse.ok() && fine.ok());
  EXPECT_GT(coarse->deviation, 0.008);
  EXPECT_EQ(coarse->rounds, 1);
  EXPECT_LE(fine->deviation, 0.004);
  EXPECT_GT(fine->rounds, 1);
  EXPECT_GT(fine->quality.triangles, coarse->quality.triangles);
  EXPECT_LT(fine->quality.triangles, 10 * coarse->quality.triangles);
  EXPECT_GE(fine->quality.alpha_mean, 0.95);
}

TEST(Remesh, AChordBelowTheRoughnessOfTheMeshIsToldWithThePlace) {
  const auto scan = ten()[6];
  const auto made = remesh(scan.mesh, {.size = 0.2, .chord = 1e-7, .rounds = 1});
  ASSERT_TRUE(made.ok());
  EXPECT_TRUE(told(*made, "deviation_above"));
  EXPECT_GT(made->deviation, 1e-7);
  EXPECT_TRUE(made->findings.back().place.x.has_value());
}

TEST(Remesh, AFoldStaysALineAndWithoutItTheMeshCutsItsEdge) {
  const auto folded = ten()[3];
  const auto kept = remesh(folded.mesh, {.size = 0.15});
  const auto lost = remesh(folded.mesh, {.size = 0.15, .crease = 180.0});
  ASSERT_TRUE(kept.ok() && lost.ok());
  EXPECT_EQ(kept->creases, 3U);
  EXPECT_LT(kept->deviation, 1e-12);
  EXPECT_GT(lost->deviation, 0.01);
}

TEST(Remesh, ClosedMeshesAreCutAndStayClosed) {
  const PolygonMesh torus = test::torus_mesh(60, 30);
  const auto made = remesh(torus, {.size = 0.25});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_TRUE(told(*made, "cut"));
  EXPECT_EQ(made->flipped, 0U);
  EXPECT_EQ(made->quality.euler, 0);
  EXPECT_EQ(made->quality.boundary_edges, 0U);
  EXPECT_GE(made->quality.alpha_mean, 0.95);
  const auto ball = remesh(test::sphere_mesh(16), {.size = 0.15});
  ASSERT_TRUE(ball.ok()) << ball.error().message;
  EXPECT_EQ(ball->quality.euler, 2);
  EXPECT_EQ(ball->quality.boundary_edges, 0U);
  EXPECT_EQ(ball->flipped, 0U);
}

TEST(Remesh, MeshesThatAreNoSheetAreRefusedWithTheirPlace) {
  const PolygonMesh fan{{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  const auto made = remesh(fan, {.size = 0.5});
  ASSERT_FALSE(made.ok());
  EXPECT_TRUE(made.error().place && made.error().place->z);
  const PolygonMesh plane = grid_mesh(4, 4, [](double u, double v) { return Point3{u, v, 0}; });
  for (const double bad : {-1.0, std::nan("")}) {
    EXPECT_EQ(remesh(plane, {.size = bad}).error().code, base::ErrorCode::InvalidOption);
    EXPECT_EQ(remesh(plane, {.size = 0.5, .chord = bad}).error().code, base::ErrorCode::InvalidOption);
  }
}

TEST(Remesh, ATetrahedronKeepsItsFacesAndIsRefusedWhereOneSideGoesRoundIt) {
  const PolygonMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  const auto made = remesh(tetrahedron, {.size = 0.2});
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(made->quality.euler, 2);
  EXPECT_EQ(made->quality.boundary_edges, 0U);
  EXPECT_EQ(made->flipped, 0U);
  EXPECT_NEAR(made->quality.area, 1.5 + std::sqrt(3.0) / 2.0, 1e-12);
  EXPECT_LT(made->deviation, 1e-12);
  EXPECT_FALSE(remesh(tetrahedron, {.size = 1.0}).ok());
}

TEST(Remesh, OneTriangleAndASizeBeyondTheMeshAreMeshed) {
  const PolygonMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const auto fine = remesh(one, {.size = 0.2});
  ASSERT_TRUE(fine.ok()) << fine.error().message;
  EXPECT_NEAR(fine->quality.area, 0.5, 1e-12);
  const auto coarse = remesh(one, {.size = 50.0});
  ASSERT_TRUE(coarse.ok()) << coarse.error().message;
  EXPECT_NEAR(coarse->quality.area, 0.5, 1e-12);
}

TEST(Remesh, ItIsTheSameOnEveryCall) {
  const auto each = ten()[7];
  const auto once = remesh(each.mesh, {.size = 0.3}), again = remesh(each.mesh, {.size = 0.3});
  ASSERT_TRUE(once.ok() && again.ok());
  EXPECT_TRUE(once->mesh == again->mesh);
}

TEST(Remesh, TheDeviationOfParallelPlanesIsTheirDistance) {
  const auto at = [](double z) {
    return param::sheet_of(grid_mesh(3, 3, [z](double u, double v) { return Point3{u, v, z}; }))->sheet;
  };
  EXPECT_NEAR(deviation(at(0.0), at(0.25)), 0.25, 1e-15);
  // One way it is nought: the other sheet is a part of this one.
  const auto part = param::sheet_of(grid_mesh(3, 3, [](double u, double v) { return Point3{0.5 * u, v, 0.0}; }))->sheet;
  EXPECT_NEAR(deviation(part, at(0.0)), 0.5, 1e-15);
}

}  // namespace
}  // namespace dobra::surf::remesh
