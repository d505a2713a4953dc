// Bands and rosettes of cracks on surfaces: what is measured is measured in space, from the formulas of the surfaces.

#include "quebra/surfaces/crack_lines.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "quebra/surfaces/mesh_surfaces.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces {
namespace {

using namespace dobra;
using geom::Point3;
using test::plate;
using test::surfaces_of;

const std::string tube =
    "[[input.surface]]\nname = \"tube\"\nkind = \"cylinder\"\nradius = 2\nu = [0, 180]\nv = [0, 10]\n";
std::string crack(const std::string& points, const std::string& rest) {
  return "[[input.trim]]\nname = \"k\"\nkind = \"line\"\nrole = \"crack\"\npoints = " + points + "\n" + rest;
}

std::vector<std::string> codes(const Surfaces& made) {
  std::vector<std::string> all;
  for (const auto& finding : made.findings) all.push_back(finding.code);
  return all;
}

/// Places in space along the lines of a set.
std::vector<Point3> along(const surf::trim::TrimmedSurface& face, const std::string& name) {
  std::vector<Point3> all;
  for (const auto& line : face.lines) {
    for (const auto& edge : line.edges) {
      if (edge.name != name) continue;
      constexpr int n = 400;
      for (int i = 0; i <= n; ++i)
        all.push_back(face.surface.at(edge.at(edge.from + (edge.to - edge.from) * i / static_cast<double>(n))));
    }
  }
  return all;
}

/// The mesh with sides no longer than `size`.
model::SurfaceMeshed meshed(const Surfaces& made, double size) {
  model::SurfaceSet set;
  set.faces = made.faces;
  set.chart_units.assign(made.faces.size(), {1.0, 1.0});
  auto mesh = mesh_surfaces(set, {.sizes = {.largest = size, .turn = 30.0}});
  EXPECT_TRUE(mesh) << (mesh ? "" : to_string(mesh.error()));
  return mesh ? *std::move(mesh) : model::SurfaceMeshed{};
}

TEST(CrackLines, BandsOnACylinderHaveTheirDistanceInSpace) {
  // Along the axis, where u is an angle and v a length: the chart is not alike its image.
  const auto made = surfaces_of(tube + crack("[[90, 3], [90, 7]]", "bands = [0.25, 0.6]\n"));
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(codes(*made), std::vector<std::string>{});
  for (const auto& [name, distance] : {std::pair{"k_band_1", 0.25}, std::pair{"k_band_2", 0.6}}) {
    const auto places = along(made->faces[0], name);
    ASSERT_GT(places.size(), 100U) << name;
    double low = 10.0, high = 0.0;
    for (const Point3 p : places) {
      const double z = std::clamp(p.z, 3.0, 7.0);
      EXPECT_NEAR(std::sqrt(p.x * p.x + (p.y - 2) * (p.y - 2) + (p.z - z) * (p.z - z)), distance, 0.01 * distance);
      low = std::min(low, p.z), high = std::max(high, p.z);
    }
    EXPECT_NEAR(low, 3.0 - distance, 0.02 * distance);  // it goes round both ends
    EXPECT_NEAR(high, 7.0 + distance, 0.02 * distance);
  }
  const auto mesh = meshed(*made, 0.4);
  EXPECT_GE(mesh.quality.alpha_min, 0.3);
  EXPECT_EQ(mesh.mesh.constraint_sets.count("k_band_1"), 1U);
}

TEST(CrackLines, AlongTheMiddleBetweenTwoPolesAreOpened) {
  const std::string ball = "[[input.surface]]\nname = \"ball\"\nkind = \"sphere\"\nradius = 3\n";
  // An open crack makes a disk of a ball, one all round two disks.
  for (const auto& [points, euler] :
       {std::pair{"[[30, 0], [70, 0]]", 1}, std::pair{"[[30, 1e-6], [70, 1e-6]]", 1},
        std::pair{"[[30, 1], [70, 1]]", 1}, std::pair{"[[30, -10], [70, -10]]", 1},
        std::pair{"[[330, 0], [390, 0]]", 1}, std::pair{"[[30, -10], [50, 0], [90, 0]]", 1},
        std::pair{"[[0, 0], [360, 0]]", 2}}) {
    const auto made = surfaces_of(ball + crack(points, ""));
    ASSERT_TRUE(made) << points << to_string(made.error());
    const auto mesh = meshed(*made, 0.8);
    EXPECT_EQ(mesh.quality.euler, euler) << points;
    EXPECT_EQ(mesh.quality.components, static_cast<std::size_t>(euler)) << points;
    EXPECT_EQ(mesh.quality.loops, static_cast<std::size_t>(euler)) << points;
  }
}

/// The chart is 1.05 radians by 8 m: what is round in space is a flat oval there, whichever way the crack runs.
TEST(CrackLines, BandsAndRosettesRoundObliqueCracksOnACylinder) {
  const std::string arch =
      "[[input.surface]]\nname = \"arch\"\nkind = \"cylinder\"\nradius = 10\nu = [60, 120]\nv = [0, 8]\n";
  const auto place = [](double u, double v) {
    const double angle = u * std::numbers::pi / 180.0;
    return Point3{10.0 * std::cos(angle), 10.0 * std::sin(angle), v};
  };
  for (const auto& [u0, v0, u1, v1] : {std::array{78.0, 3.0, 102.0, 4.6}, std::array{80.0, 2.5, 100.0, 5.5},
                                       std::array{100.0, 3.1, 79.0, 4.9}, std::array{89.0, 2.0, 91.0, 6.0}}) {
    const std::string points = fmt::format("[[{}, {}], [{}, {}]]", u0, v0, u1, v1);
    const auto made = surfaces_of(arch + crack(points, "bands = [0.5, 1.0]\nrosette = 0.3\n"));
    ASSERT_TRUE(made) << points << to_string(made.error());
    EXPECT_EQ(codes(*made), std::vector<std::string>{}) << points;
    // The crack in space, by many places.
    std::vector<Point3> along_crack;
    constexpr int n = 4000;
    for (int i = 0; i <= n; ++i) along_crack.push_back(place(u0 + (u1 - u0) * i / n, v0 + (v1 - v0) * i / n));
    for (const auto& [name, distance] : {std::pair{"k_band_1", 0.5}, std::pair{"k_band_2", 1.0}}) {
      const auto places = along(made->faces[0], name);
      ASSERT_GT(places.size(), 100U) << points << name;
      for (std::size_t i = 0; i < places.size(); i += 10) {
        double least = 100.0;
        for (const Point3 p : along_crack) least = std::min(least, geom::distance(p, places[i]));
        ASSERT_NEAR(least, distance, 0.01 * distance) << points << name;
      }
    }
    const auto mesh = meshed(*made, 0.6);
    EXPECT_GE(mesh.quality.alpha_min, 0.3) << points;
    EXPECT_EQ(mesh.mesh.constraint_sets.count("k_band_2"), 1U);
    EXPECT_EQ(mesh.mesh.constraint_sets.count("k_rosette"), 1U);
  }
}

TEST(CrackLines, BandsOnASphereHaveTheirDistanceInSpace) {
  const std::string ball =
      "[[input.surface]]\nname = \"ball\"\nkind = \"sphere\"\nradius = 3\nu = [0, 180]\nv = [-80, 80]\n";
  const auto made = surfaces_of(ball + crack("[[90, 0], [90, 60]]", "bands = [0.3]\n"));  // u shrinks to a half
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(codes(*made), std::vector<std::string>{});
  const auto places = along(made->faces[0], "k_band_1");
  ASSERT_GT(places.size(), 100U);
  for (const Point3 p : places) {
    double nearest = 10.0;
    for (int i = 0; i <= 3000; ++i) {
      const double v = i / 3000.0 * std::numbers::pi / 3.0;
      nearest = std::min(nearest, geom::distance(p, Point3{0, 3 * std::cos(v), 3 * std::sin(v)}));
    }
    EXPECT_NEAR(nearest, 0.3, 0.01 * 0.3);
  }
}

TEST(CrackLines, AChartThatIsTooSkewedIsToldWithThePlace) {
  const std::string ball =
      "[[input.surface]]\nname = \"ball\"\nkind = \"sphere\"\nradius = 3\nu = [0, 180]\nv = [-89, 89]\n";
  const auto made = surfaces_of(ball + crack("[[90, 0], [90, 84]]", "bands = [0.1]\n"));
  ASSERT_TRUE(made) << to_string(made.error());
  ASSERT_THAT(codes(*made), testing::Contains("band_skewed"));
  EXPECT_NEAR(*made->findings[0].place.v, 84.0, 1e-6);  // in degrees, as it was written
}

TEST(CrackLines, BandsEndWhereTheChartDoes) {
  const auto made = surfaces_of(plate + crack("[[0, 5], [4, 5]]", "bands = [0.5]\n"));
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(codes(*made), std::vector<std::string>{});
  const auto places = along(made->faces[0], "k_band_1");
  ASSERT_FALSE(places.empty());
  double low = 10.0;
  for (const Point3 p : places) low = std::min(low, p.x);
  EXPECT_EQ(low, 0.0);
  const auto mesh = meshed(*made, 0.5);
  EXPECT_NEAR(mesh.quality.area, 100.0, 1e-9);
}

TEST(CrackLines, RosettesHaveTheirSectorsAndTheirRadiusInSpace) {
  const auto made = surfaces_of(tube + crack("[[70, 4], [110, 6]]", "rosette = 0.2\nsectors = 6\n"));
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(codes(*made), std::vector<std::string>{});
  const auto mesh = meshed(*made, 0.5);
  for (const char* name : {"k_start", "k_end"}) {
    ASSERT_EQ(mesh.mesh.node_sets.count(name), 1U) << name;
    const auto tip = mesh.mesh.node_sets.at(name).at(0);
    std::size_t triangles = 0;
    for (const auto& corners : mesh.mesh.triangles) {
      if (std::find(corners.begin(), corners.end(), tip) == corners.end()) continue;
      ++triangles;
      for (const auto node : corners) {
        if (node == tip) continue;
        EXPECT_NEAR(geom::distance(mesh.mesh.point(node), mesh.mesh.point(tip)), 0.2, 1e-6);
      }
    }
    EXPECT_EQ(triangles, 6U) << name;
  }
}

TEST(CrackLines, AnEndWithoutRoomHasNoRosetteAndAMouthNeedsNone) {
  const auto at = [&](const char* points) { return codes(*surfaces_of(plate + crack(points, "rosette = 0.4\n"))); };
  EXPECT_EQ(at("[[0, 5], [5, 5]]"), std::vector<std::string>{});
  EXPECT_EQ(at("[[5, 5], [9.8, 5]]"), std::vector<std::string>{"rosette_left_out"});
  EXPECT_EQ(at("[[5, 5], [5.3, 5]]"), (std::vector<std::string>{"rosette_left_out", "rosette_left_out"}));
}

}  // namespace
}  // namespace quebra::surfaces
