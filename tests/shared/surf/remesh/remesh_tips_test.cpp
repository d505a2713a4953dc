// Tips of a mesh stay in the new one, wherever the cut runs; what is rough, blunt or beside a line is no tip.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "shared/surf/remesh/remesh.h"
#include "tests/support/sheets.h"

namespace dobra::surf::remesh::tips_test {
namespace {

using geom::Point3;
using test::disk_mesh;

/// The tip at the origin, slant length 2, half angle in degrees: a fan of `around` triangles, and rings round it.
dobra::mesh::PolygonMesh cone(double half_angle, std::uint32_t around = 48, std::uint32_t rings = 20) {
  const double a = half_angle * std::numbers::pi / 180.0;
  dobra::mesh::PolygonMesh mesh;
  mesh.points.push_back({0, 0, 0});
  for (std::uint32_t r = 1; r <= rings; ++r) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const double slant = 2.0 * r / rings, turn = 2.0 * std::numbers::pi * k / around;
      mesh.points.push_back(
          {slant * std::sin(a) * std::cos(turn), slant * std::sin(a) * std::sin(turn), -slant * std::cos(a)});
    }
  }
  for (std::uint32_t k = 0; k < around; ++k) {
    const std::uint32_t next = (k + 1) % around;
    mesh.faces.push_back({0, 1 + k, 1 + next});
    for (std::uint32_t r = 1; r < rings; ++r) {
      const std::uint32_t in = 1 + (r - 1) * around, out = 1 + r * around;
      mesh.faces.push_back({in + k, out + k, out + next});
      mesh.faces.push_back({in + k, out + next, in + next});
    }
  }
  return mesh;
}

double nearest(const Remeshed& made, Point3 p) {
  double best = 1e300;
  for (const Point3 q : made.mesh.points) best = std::min(best, geom::distance(p, q));
  return best;
}
bool tells(const Remeshed& made, const std::string& code) {
  return std::any_of(made.findings.begin(), made.findings.end(), [&](const auto& f) { return f.code == code; });
}

TEST(RemeshTips, OfAConeStays) {
  for (const double half_angle : {20.0, 35.0, 50.0}) {
    for (const double size : {0.1, 0.25, 0.5}) {
      const auto made = remesh(cone(half_angle), {.size = size});
      ASSERT_TRUE(made.ok()) << half_angle << ' ' << size << ' ' << made.error().message;
      EXPECT_EQ(made->tips, 1U) << half_angle << ' ' << size;
      EXPECT_LT(nearest(*made, {0, 0, 0}), 1e-12) << half_angle << ' ' << size;
      EXPECT_EQ(made->folded, 0U);
      // Without the tip the new mesh would be off by about size times the cosine over two.
      if (size > 0.3) continue;  // few triangles round the tip
      EXPECT_LT(made->deviation, 0.2 * size) << half_angle << ' ' << size;
      EXPECT_NEAR(made->quality.area, made->area_before, 0.02 * made->area_before) << half_angle << ' ' << size;
    }
  }
}

TEST(RemeshTips, OfADoubleConeStaysWhereverItIsCut) {
  // Two cones base to base: closed, so that the cut runs from tip to tip or elsewhere.
  const auto upper = cone(40.0);
  auto both = upper;
  const auto count = static_cast<std::uint32_t>(upper.points.size());
  const double base = 2.0 * std::cos(40.0 * std::numbers::pi / 180.0);
  for (const Point3 p : upper.points) both.points.push_back({p.x, p.y, -2.0 * base - p.z});
  for (auto face : upper.faces) {
    std::reverse(face.begin(), face.end());
    for (auto& v : face) v += count;
    both.faces.push_back(face);
  }
  for (const double size : {0.2, 0.4}) {
    const auto made = remesh(both, {.size = size});
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_EQ(made->tips, 2U);
    EXPECT_LT(nearest(*made, {0, 0, 0}), 1e-12);
    EXPECT_LT(nearest(*made, {0, 0, -2.0 * base}), 1e-12);
    EXPECT_EQ(made->quality.euler, 2);
  }
}

TEST(RemeshTips, OfAPyramidIsTheEndOfItsEdgesOrATip) {
  // A cone of six sides at its tip and more and more below: its creases are shorter than a side.
  const auto pyramid = disk_mesh(30, [](double r, double a) {
    return Point3{r * std::cos(a), r * std::sin(a), -2.0 * r};
  });
  for (const double size : {0.1, 0.3}) {
    const auto made = remesh(pyramid, {.size = size});
    ASSERT_TRUE(made.ok()) << made.error().message;
    EXPECT_EQ(made->tips, 1U) << size;
    EXPECT_LT(nearest(*made, {0, 0, 0}), 1e-12) << size;
  }
}

TEST(RemeshTips, WhatIsBluntOrRoughIsNone) {
  const auto blunt = remesh(cone(75.0), {.size = 0.25});
  ASSERT_TRUE(blunt.ok());
  EXPECT_EQ(blunt->tips, 0U);
  // A plane whose vertices stand off by up to a fifth of the side of its triangles.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-0.005, 0.005);
  const auto rough = remesh(disk_mesh(40,
                                      [&](double r, double a) {
                                        return Point3{r * std::cos(a), r * std::sin(a), off(random)};
                                      }),
                            {.size = 0.2, .crease = 120.0});
  ASSERT_TRUE(rough.ok()) << rough.error().message;
  EXPECT_EQ(rough->tips, 0U);
  EXPECT_FALSE(tells(*rough, "tip_left_out"));
}

TEST(RemeshTips, OfTwoNearEachOtherOneIsLeftOutAndTold) {
  const auto peaks = [](double apart, double radius) {
    return test::grid_mesh(128, 128, [=](double u, double v) {
      const double x = 2.0 * u - 1.0, y = 2.0 * v - 1.0;
      const auto peak = [&](double at) { return std::max(0.0, radius - std::hypot(x - at, y)) * 1.5; };
      return Point3{x, y, std::max(peak(-0.5 * apart), peak(0.5 * apart))};
    });
  };
  const auto fine = remesh(peaks(0.5, 0.25), {.size = 0.1});
  ASSERT_TRUE(fine.ok()) << fine.error().message;
  EXPECT_EQ(fine->tips, 2U);
  EXPECT_LT(nearest(*fine, {0.25, 0, 0.375}), 1e-12);
  const auto coarse = remesh(peaks(0.125, 0.0625), {.size = 0.3});
  ASSERT_TRUE(coarse.ok()) << coarse.error().message;
  EXPECT_EQ(coarse->tips + coarse->tips_out, 2U);
  EXPECT_GE(coarse->tips_out, 1U);
  EXPECT_TRUE(tells(*coarse, "tip_left_out"));
}

}  // namespace
}  // namespace dobra::surf::remesh::tips_test
