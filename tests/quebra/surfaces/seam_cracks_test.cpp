// A crack along the seam of a closed surface opens it as one anywhere else does: lips of its length, tips at its ends,
// and one more contour of the border. The seam is where the chart begins; where that is, is no matter of the crack.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "quebra/surfaces/mesh_surfaces.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::seam_cracks_test {
namespace {

using namespace dobra;
using geom::Point3;

constexpr double pi = std::numbers::pi;

struct Made {
  std::vector<std::string> codes;
  model::SurfaceMeshed mesh;

  [[nodiscard]] double length(const std::string& set) const {
    double sum = 0.0;
    const auto found = mesh.mesh.boundary_sets.find(set);
    if (found == mesh.mesh.boundary_sets.end()) return 0.0;
    for (const auto& side : found->second) sum += geom::distance(mesh.mesh.point(side[0]), mesh.mesh.point(side[1]));
    return sum;
  }
  /// Where a tip is; far off where there is none.
  [[nodiscard]] Point3 tip(const std::string& set) const {
    const auto found = mesh.mesh.node_sets.find(set);
    if (found == mesh.mesh.node_sets.end() || found->second.size() != 1) return {1e9, 1e9, 1e9};
    return mesh.mesh.point(found->second[0]);
  }
};

Made made(const std::string& text, double size = 0.5, SurfaceEngine engine = SurfaceEngine::Front) {
  const auto read = test::surfaces_of(text);
  EXPECT_TRUE(read.ok()) << (read ? "" : to_string(read.error()));
  if (!read) return {};
  model::SurfaceSet set{.faces = read->faces, .chart_units = {}, .parts = read->parts};
  for (const ChartUnits& units : read->units) set.chart_units.push_back({units.u, units.v});
  auto mesh = mesh_surfaces(set, {.sizes = {.largest = size, .turn = 20.0}, .engine = engine});
  EXPECT_TRUE(mesh.ok()) << (mesh ? "" : to_string(mesh.error()));
  if (!mesh) return {};
  Made all{{}, *std::move(mesh)};
  for (const auto& finding : read->findings) all.codes.push_back(finding.code);
  for (const auto& finding : all.mesh.findings) all.codes.push_back(finding.code);
  return all;
}

std::string crack(const std::string& points) {
  return "[[input.trim]]\nname = \"k\"\nkind = \"line\"\nrole = \"crack\"\npoints = " + points + "\n";
}
/// Radius 2, from z = 0 to 10; its seam at (2, 0, z).
const std::string tube = "[[input.surface]]\nname = \"tube\"\nkind = \"cylinder\"\nradius = 2\nv = [0, 10]\n";

void is_slit(const Made& all, Point3 start, Point3 end, double length, std::size_t loops, std::int64_t euler,
             double within = 1e-9) {
  EXPECT_EQ(all.mesh.quality.loops, loops);
  EXPECT_EQ(all.mesh.quality.euler, euler);
  EXPECT_EQ(all.mesh.quality.components, 1U);
  EXPECT_NEAR(all.length("k_left"), length, within * length);
  EXPECT_NEAR(all.length("k_right"), length, within * length);
  EXPECT_LT(geom::distance(all.tip("k_start"), start), 1e-9);
  EXPECT_LT(geom::distance(all.tip("k_end"), end), 1e-9);
  EXPECT_FALSE(all.mesh.mesh.constraint_sets.contains("k"));
  EXPECT_THAT(all.codes, testing::IsEmpty());
  // The left lip is on the left of the way from start to end: its triangles are.
  const auto left = all.mesh.mesh.boundary_sets.find("k_left");
  ASSERT_NE(left, all.mesh.mesh.boundary_sets.end());
  std::size_t along = 0;
  for (const auto& side : left->second) {
    for (const auto& corners : all.mesh.mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) along += corners[i] == side[0] && corners[(i + 1) % 3] == side[1] ? 1 : 0;
    }
  }
  EXPECT_EQ(along, left->second.size());
}

TEST(SeamCracks, OfACylinderOpens) {
  for (const auto engine : {SurfaceEngine::Front, SurfaceEngine::Paper}) {
    for (const char* u : {"0", "360", "180"}) {
      const double x = u == std::string("180") ? -2.0 : 2.0;
      const auto points = [&](const char* from, const char* to) {
        return std::string("[[") + u + ", " + from + "], [" + u + ", " + to + "]]";
      };
      is_slit(made(tube + crack(points("3", "7")), 0.5, engine), {x, 0, 3}, {x, 0, 7}, 4.0, 3, -1);
      is_slit(made(tube + crack(points("7", "3")), 0.5, engine), {x, 0, 7}, {x, 0, 3}, 4.0, 3, -1);
    }
  }
}

TEST(SeamCracks, OfAFaceThatLooksInwardsOpens) {
  const std::string inwards = tube + "facing = \"against\"\n";
  is_slit(made(inwards + crack("[[0, 3], [0, 7]]")), {2, 0, 3}, {2, 0, 7}, 4.0, 3, -1);
}

TEST(SeamCracks, FromEndToEndMakeASheet) {
  const Made all = made(tube + crack("[[0, 0], [0, 10]]"));
  EXPECT_EQ(all.mesh.quality.loops, 1U);
  EXPECT_EQ(all.mesh.quality.euler, 1);
  EXPECT_NEAR(all.length("k_left"), 10.0, 1e-9);
  EXPECT_NEAR(all.length("k_right"), 10.0, 1e-9);
}

TEST(SeamCracks, OnTheSeamAndOffItAreOne) {
  // 60 degrees along z = 5 of radius 2, after 3 on the seam; either way round.
  const double arc = 2.0 * pi / 3.0;
  for (const char* end : {"60", "-60"}) {
    const double a = std::stod(end) * pi / 180.0;
    const Point3 off{2 * std::cos(a), 2 * std::sin(a), 5};
    is_slit(made(tube + crack(std::string("[[0, 2], [0, 5], [") + end + ", 5]]"), 0.2), {2, 0, 2}, off, 3.0 + arc, 3,
            -1, 2e-3);
    is_slit(made(tube + crack(std::string("[[") + end + ", 5], [0, 5], [0, 2]]"), 0.2), off, {2, 0, 2}, 3.0 + arc, 3,
            -1, 2e-3);
  }
}

TEST(SeamCracks, OfASphereThroughAPoleOpens) {
  const std::string ball = "[[input.surface]]\nname = \"ball\"\nkind = \"sphere\"\nradius = 2\n";
  const auto at = [](double latitude) {
    return Point3{2 * std::cos(latitude * pi / 180), 0.0, 2 * std::sin(latitude * pi / 180)};
  };
  is_slit(made(ball + crack("[[0, 20], [0, 70]]"), 0.2), at(20), at(70), 2 * 50 * pi / 180, 1, 1, 2e-3);
  is_slit(made(ball + crack("[[0, 70], [0, -50]]"), 0.2), at(70), at(-50), 2 * 120 * pi / 180, 1, 1, 2e-3);
}

TEST(SeamCracks, OfAConeOpens) {
  // The apex at the origin; 10 along the side. A slender one keeps its seam where its chart goes round the apex.
  for (const double half_angle : {5.0, 30.0}) {
    const double a = half_angle * pi / 180;
    const auto at = [&](double v) { return Point3{v * std::sin(a), 0.0, v * std::cos(a)}; };
    is_slit(made("[[input.surface]]\nname = \"c\"\nkind = \"cone\"\nradius = 0\nhalf_angle = " +
                     std::to_string(half_angle) + "\nv = [0, 10]\n" + crack("[[0, 4], [0, 7]]"),
                 half_angle < 10 ? 0.3 : 0.6),
            at(4), at(7), 3.0, 2, 0);
  }
}

TEST(SeamCracks, OfATorusOpenBothWays) {
  const std::string ring = "[[input.surface]]\nname = \"ring\"\nkind = \"torus\"\nradius = 5\nminor_radius = 2\n";
  const auto at = [](double u, double v) {
    const double a = u * pi / 180, b = v * pi / 180, r = 5 + 2 * std::cos(b);
    return Point3{r * std::cos(a), r * std::sin(a), 2 * std::sin(b)};
  };
  is_slit(made(ring + crack("[[40, 0], [100, 0]]"), 0.3), at(40, 0), at(100, 0), 7 * 60 * pi / 180, 1, -1, 2e-3);
  is_slit(made(ring + crack("[[0, 40], [0, 200]]"), 0.3), at(0, 40), at(0, 200), 2 * 160 * pi / 180, 1, -1, 2e-3);
  // Round the corner of the chart.
  is_slit(made(ring + crack("[[0, 60], [0, 0], [30, 0]]"), 0.3), at(0, 60), at(30, 0), (2 * 60 + 7 * 30) * pi / 180, 1,
          -1, 2e-3);
}

/// Lines round a crack go over the seam with it, and its ends are written a turn further on.
TEST(SeamCracks, HaveBandsAndRosettesOverTheSeam) {
  const std::string round = "bands = [0.4]\nrosette = 0.2\n";
  for (const char* points : {"[[340, 3], [390, 7]]", "[[370, 3], [390, 7]]", "[[0, 3], [0, 7]]"}) {
    const Made all = made(tube + crack(points) + round);
    EXPECT_THAT(all.codes, testing::IsEmpty()) << points;
    EXPECT_EQ(all.mesh.quality.loops, 3U) << points;
  }
  const Made ball = made("[[input.surface]]\nname = \"ball\"\nkind = \"sphere\"\nradius = 2\n" +
                         crack("[[30, 10], [80, 50]]") + round);
  EXPECT_THAT(ball.codes, testing::IsEmpty());
}

TEST(SeamCracks, BesideAHoleOverTheSeamEndAtIt) {
  const Made all = made(tube + crack("[[0, 2], [0, 8]]") +
                        "[[input.trim]]\nname = \"h\"\nkind = \"ellipse\"\nrole = \"hole\"\ncentre = [0, 5]\n"
                        "radii = [20, 1]\n");
  EXPECT_EQ(all.mesh.quality.loops, 3U);  // both slits are of the hole's contour
  EXPECT_NEAR(all.length("k_left"), 4.0, 1e-9);
  EXPECT_NEAR(all.length("k_right"), 4.0, 1e-9);
  EXPECT_LT(geom::distance(all.tip("k_start"), {2, 0, 2}), 1e-9);
  EXPECT_LT(geom::distance(all.tip("k_end"), {2, 0, 8}), 1e-9);
}

TEST(SeamCracks, WhereOneSideIsCutAwayOpenNothing) {
  const Made all =
      made(tube + crack("[[0, 2], [0, 8]]") +
           "[[input.trim]]\nname = \"c\"\nkind = \"line\"\nrole = \"cut\"\npoints = [[0, 0], [0, 10]]\n"
           "[[input.trim]]\nname = \"d\"\nkind = \"line\"\nrole = \"cut\"\npoints = [[180, 0], [180, 10]]\n"
           "[[input.part]]\nfate = \"keep\"\nat = [90, 5]\n");
  EXPECT_THAT(all.codes, testing::Contains("crack_opens_nothing"));
  EXPECT_EQ(all.mesh.quality.loops, 1U);
}

/// What runs along a crack there is told as it is at 180 degrees, on whichever side of the seam each is written.
TEST(SeamCracks, LinesOnACrackOfTheSeamAreTold) {
  const auto trim = [](const char* name, const char* role, const std::string& u, const char* from, const char* to) {
    return fmt::format(
        "[[input.trim]]\nname = \"{0}\"\nkind = \"line\"\nrole = \"{1}\"\npoints = [[{2}, {3}], [{2}, {4}]]\n", name,
        role, u, from, to);
  };
  for (const auto& [first, second] : std::vector<std::pair<std::string, std::string>>{
           {"180", "180"}, {"0", "0"}, {"0", "360"}, {"360", "0"}, {"360", "360"}}) {
    for (const char* const role : {"crack", "internal"}) {
      const std::string told = fmt::format("{} {} {}", first, second, role);
      const Made all = made(tube + trim("k", "crack", first, "1", "6") + trim("m", role, second, "5", "9"));
      EXPECT_EQ(all.codes, std::vector<std::string>{"line_on_crack"}) << told;
      EXPECT_NEAR(all.length("k_left"), 5.0, 1e-9) << told;
      EXPECT_NEAR(all.length("k_right"), 5.0, 1e-9) << told;
      if (role != std::string("crack")) continue;
      EXPECT_NEAR(all.length("m_left"), 3.0, 1e-9) << told;
      EXPECT_NEAR(all.length("m_right"), 3.0, 1e-9) << told;
      EXPECT_EQ(all.mesh.quality.loops, 3U) << told;
      EXPECT_EQ(all.mesh.quality.components, 1U) << told;
    }
  }
  // They end where the other begins, or lie apart.
  EXPECT_THAT(made(tube + trim("k", "crack", "0", "1", "5") + trim("m", "crack", "360", "5", "9")).codes,
              testing::IsEmpty());
  EXPECT_THAT(made(tube + trim("k", "crack", "360", "1", "4") + trim("m", "internal", "0", "6", "9")).codes,
              testing::IsEmpty());
}

}  // namespace
}  // namespace quebra::surfaces::seam_cracks_test
