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

TEST(Remesh, TenMeshesKeepTheirShapeWithoutAFlipAndWithGoodTriangles) {
  for (const Case& each : ten()) {
    SCOPED_TRACE(each.name);
    const auto made = remesh(each.mesh, {.size = each.size, .chord = each.chord});
    ASSERT_TRUE(made.ok()) << made.error().message;
    std::printf("%-12s %6zu triangles  mean %.4f  least %.3f  deviation %.5f of %.5f  %d rounds %zu creases\n",
                each.name.c_str(), made->quality.triangles, made->quality.alpha_mean, made->quality.alpha_min,
                made->deviation, each.chord, made->rounds, made->creases);
    for (const auto& f : made->findings) std::printf("   %s: %s\n", f.code.c_str(), f.message.c_str());
    EXPECT_EQ(made->flipped, 0U);
    EXPECT_LE(made->deviation, each.chord);
    EXPECT_GE(made->quality.alpha_mean, 0.97);
  }
}

}  // namespace
}  // namespace dobra::surf::remesh
