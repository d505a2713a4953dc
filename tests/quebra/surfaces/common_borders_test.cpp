// Which borders and lines of several surfaces become one curve, and what is said where they do not.

#include "quebra/surfaces/common_borders.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "quebra/surfaces/mesh_surfaces.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::common_borders_test {
namespace {

using namespace dobra;
using test::plate;
using testing::HasSubstr;

std::string flat(const std::string& name, const std::string& ranges, const std::string& more = "") {
  return "[[input.surface]]\nname = \"" + name + "\"\nkind = \"plane\"\n" + ranges + more;
}
/// Upright over y = 5 of the plate.
std::string web(const std::string& u = "[0, 10]") {
  return flat("web", "u = " + u + "\nv = [0, 5]\n", "origin = [0, 5, 0]\naxis = [0, -1, 0]\nx_axis = [1, 0, 0]\n");
}
std::string internal(const std::string& points) {
  return "[[input.trim]]\nname = \"l\"\nsurface = \"plate\"\nkind = \"line\"\nrole = \"internal\"\npoints = " + points +
         "\n";
}

std::vector<std::string> codes(const std::vector<surf::mesh::Finding>& findings) {
  std::vector<std::string> all;
  for (const auto& finding : findings) all.push_back(finding.code);
  return all;
}

struct Made {
  std::vector<surf::mesh::Finding> findings;
  model::SurfaceMeshed mesh;
};
Made meshed(const std::string& text, bool quads = false) {
  auto made = test::surfaces_of(text);
  EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  model::SurfaceSet set{.faces = made->faces, .chart_units = {}};
  set.chart_units.assign(set.faces.size(), {1.0, 1.0});
  auto mesh = mesh_surfaces(set, {.sizes = {.largest = 2.0}, .quadrilaterals = quads});
  EXPECT_TRUE(mesh.ok()) << (mesh ? "" : to_string(mesh.error()));
  return {made->findings, *std::move(mesh)};
}

/// How many sides have so many triangles, with all their nodes on y = 5 and z = 0 or not.
std::map<std::size_t, int> sides(const surf::mesh::SurfaceMesh& mesh, bool on_line) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> count;
  for (const auto& corners : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = corners[i], b = corners[(i + 1) % 3];
      const auto on = [&](auto n) { return mesh.point(n).z == 0.0 && std::abs(mesh.point(n).y - 5.0) < 1e-9; };
      if ((on(a) && on(b)) == on_line) ++count[std::minmax(a.index(), b.index())];
    }
  }
  std::map<std::size_t, int> found;
  for (const auto& [ends, triangles] : count) ++found[triangles];
  return found;
}

TEST(CommonBorders, AWebOnAnInternalLineIsJoinedToIt) {
  for (const bool quads : {false, true}) {
    const Made made = meshed(plate + web() + internal("[[0, 5], [10, 5]]"), quads);
    const auto on = sides(made.mesh.mesh, true), off = sides(made.mesh.mesh, false);
    ASSERT_EQ(on.size(), 1U);  // every side of the line has a triangle of the web and two of the plate
    EXPECT_EQ(on.begin()->first, 3U);
    EXPECT_EQ(off.count(3), 0U);
    EXPECT_NEAR(made.mesh.quality.area, 150.0, 1e-9);
    EXPECT_EQ(made.mesh.quality.components, 3U);  // cut along the line
    EXPECT_LT(made.mesh.quality.gauss_bonnet, 1e-9);
  }
}

TEST(CommonBorders, AWebThatEndsInsideIsJoinedToAsMuchOfTheLine) {
  const Made made = meshed(plate + web("[2, 7]") + internal("[[0, 5], [10, 5]]"));
  const auto on = sides(made.mesh.mesh, true);
  EXPECT_GE(on.at(3), 3);  // over 5 of 10
  EXPECT_GE(on.at(2), 3);
  EXPECT_EQ(on.count(1), 0U);
}

TEST(CommonBorders, AWebWithoutALineIsToldWithItsPlace) {
  const auto made = test::surfaces_of(plate + web("[2, 7]"));
  ASSERT_TRUE(made.ok());
  ASSERT_THAT(codes(made->findings), testing::Contains("border_not_joined"));
  const auto& finding = made->findings.back();
  EXPECT_THAT(finding.message, HasSubstr("'web'"));
  EXPECT_THAT(finding.message, HasSubstr("'plate'"));
  EXPECT_NEAR(*finding.place.y, 5.0, 1e-9);
  EXPECT_NEAR(*finding.place.z, 0.0, 1e-9);
  // What is said there helps.
  const Made with_line =
      meshed(plate + web() +
             "[[input.trim]]\nname = \"l\"\nsurface = \"plate\"\nkind = \"surface\"\ntool = \"web\"\n"
             "role = \"internal\"\n");
  EXPECT_EQ(sides(with_line.mesh.mesh, true).count(1), 0U);
}

/// A gap of less than a thousandth of the smaller one, 6 x 4: 7.2e-3.
TEST(CommonBorders, AWebThatEndsAboveAPlateIsTold) {
  const auto above = [](double z, double unit, const std::string& more = "") {
    return flat("plate", fmt::format("u = [0, {0}]\nv = [0, {0}]\n", 10.0 * unit)) +
           flat("web", fmt::format("u = [{}, {}]\nv = [{:.17g}, {:.17g}]\n", 2.0 * unit, 8.0 * unit, z, z + 4.0 * unit),
                fmt::format("origin = [0, {}, 0]\naxis = [0, -1, 0]\nx_axis = [1, 0, 0]\n", 5.0 * unit)) +
           more;
  };
  for (const double unit : {1e-3, 1.0, 1e3}) {
    for (const double gap : {1e-4, 1e-3, 5e-3, -1e-3}) {
      // Below the plate it would cross it; there it ends with its upper border.
      const double z = gap > 0.0 ? gap * unit : gap * unit - 4.0 * unit;
      const auto made = test::surfaces_of(above(z, unit));
      ASSERT_TRUE(made.ok());
      ASSERT_EQ(codes(made->findings), std::vector<std::string>{"border_near_surface"}) << gap << ' ' << unit;
      const auto& finding = made->findings.front();
      EXPECT_THAT(finding.message, HasSubstr("'web'"));
      EXPECT_THAT(finding.message, HasSubstr("'plate'"));
      EXPECT_THAT(finding.message, HasSubstr(fmt::format("{:.3g} m", std::abs(gap) * unit)));
      EXPECT_NEAR(*finding.place.y, 5.0 * unit, 1e-9 * unit);
      EXPECT_NEAR(*finding.place.z, gap * unit, 1e-9 * unit);
      EXPECT_TRUE(*finding.place.x >= 2.0 * unit && *finding.place.x <= 8.0 * unit);
    }
    EXPECT_THAT(codes(test::surfaces_of(above(0.02 * unit, unit))->findings), testing::IsEmpty()) << unit;
  }
  // Sloping: at 45 degrees, and so that a border comes near with an end alone.
  const auto sloping = [](const std::string& axis, const std::string& x_axis) {
    return codes(
        test::surfaces_of(plate + flat("web", "u = [0, 4]\nv = [0, 3]\n",
                                       "origin = [3, 5, 0.001]\naxis = " + axis + "\nx_axis = " + x_axis + "\n"))
            ->findings);
  };
  EXPECT_EQ(sloping("[0, -1, 1]", "[1, 0, 0]"), std::vector<std::string>{"border_near_surface"});
  EXPECT_THAT(sloping("[0, -1, 0]", "[1, 0, 0.1]"), testing::IsEmpty());
}

TEST(CommonBorders, BordersThatAreMeantSoAreNotToldToEndAboveASurface) {
  const auto told = [](const std::string& text) {
    const auto made = test::surfaces_of(text);
    EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
    std::vector<std::string> all = codes(made->findings);
    return std::count(all.begin(), all.end(), "border_near_surface");
  };
  const std::string axes = "axis = [0, -1, 0]\nx_axis = [1, 0, 0]\n";
  EXPECT_EQ(told(plate + web() + internal("[[0, 5], [10, 5]]")), 0) << "joined";
  EXPECT_EQ(told(plate + flat("next", "u = [10, 15]\nv = [0, 10]\n")), 0) << "edge to edge";
  EXPECT_EQ(told(plate + flat("next", "u = [10.005, 15]\nv = [0, 10]\n")), 0) << "a gap in one plane";
  EXPECT_EQ(told(plate + flat("next", "u = [-5, -0.005]\nv = [0, 10]\n")), 0) << "a gap in one plane";
  EXPECT_EQ(told(plate + flat("wall", "u = [0, 10]\nv = [0, 4]\n", "origin = [0, 10, 0]\n" + axes)), 0) << "corner";
  EXPECT_EQ(told(plate + flat("patch", "u = [2, 7]\nv = [2, 7]\n", "origin = [0, 0, 0.001]\n")), 0) << "a second plate";
  EXPECT_EQ(told(plate + "[[input.surface]]\nname = \"pipe\"\nkind = \"cylinder\"\nradius = 1\nv = [2, 8]\naxis = [1, "
                         "0, 0]\norigin = [0, 5, 1.0001]\n"),
            0)
      << "a pipe just above it";
  EXPECT_EQ(told(plate +
                 "[[input.trim]]\nname = \"k\"\nsurface = \"plate\"\nkind = \"line\"\nrole = \"crack\"\npoints = "
                 "[[2, 5], [8, 5]]\n" +
                 flat("far", "u = [0, 10]\nv = [0, 10]\n", "origin = [0, 0, 3]\n")),
            0)
      << "lips of a crack";
}

TEST(CommonBorders, SurfacesThatStandApartOrTouchInAPointAreNotTold) {
  EXPECT_THAT(
      codes(test::surfaces_of(plate + flat("b", "u = [0, 10]\nv = [0, 10]\n", "origin = [0, 0, 1]\n"))->findings),
      testing::IsEmpty());
  EXPECT_THAT(codes(test::surfaces_of(plate + flat("b", "u = [0, 3]\nv = [0, 3]\n",
                                                   "origin = [5, 5, 0]\naxis = [1, -1, 0]\nx_axis = [1, 1, 1]\n"))
                        ->findings),
              testing::IsEmpty());
}

TEST(CommonBorders, ThreeSurfacesAtOneBorderShareItsNodes) {
  const Made made = meshed(flat("a", "u = [0, 10]\nv = [0, 5]\n") + flat("b", "u = [0, 10]\nv = [5, 10]\n") + web());
  const auto on = sides(made.mesh.mesh, true);
  ASSERT_EQ(on.size(), 1U);
  EXPECT_EQ(on.begin()->first, 3U);
}

TEST(CommonBorders, BordersThatOverlapInPartAreOneThere) {
  const Made made = meshed(flat("a", "u = [0, 10]\nv = [0, 5]\n") + flat("b", "u = [4, 14]\nv = [5, 10]\n"));
  const auto on = sides(made.mesh.mesh, true);
  double shared = 0.0, alone = 0.0;
  std::map<std::pair<std::size_t, std::size_t>, int> count;
  const auto& mesh = made.mesh.mesh;
  for (const auto& corners : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++count[std::minmax(corners[i].index(), corners[(i + 1) % 3].index())];
  }
  for (const auto& [ends, triangles] : count) {
    const auto p = mesh.points[ends.first], q = mesh.points[ends.second];
    if (std::abs(p.y - 5) > 1e-9 || std::abs(q.y - 5) > 1e-9) continue;
    (triangles == 2 ? shared : alone) += geom::distance(p, q);
  }
  EXPECT_NEAR(shared, 6.0, 1e-9);
  EXPECT_NEAR(alone, 8.0, 1e-9);
}

TEST(CommonBorders, SurfacesThatLookOppositeWaysAreNamedWithWhatToChange) {
  const std::string a = flat("a", "u = [0, 10]\nv = [0, 5]\n"), b = flat("b", "u = [0, 10]\nv = [5, 10]\n");
  const auto made = test::surfaces_of(a + b + "facing = \"against\"\n");
  ASSERT_TRUE(made.ok());
  const auto ways = check_ways(made->faces);
  ASSERT_FALSE(ways.ok());
  EXPECT_THAT(ways.error().message, HasSubstr("'a' and 'b'"));
  EXPECT_THAT(ways.error().message, HasSubstr("facing = \"along\""));
  EXPECT_NEAR(*ways.error().place->y, 5.0, 1e-9);
  EXPECT_TRUE(check_ways(test::surfaces_of(a + b)->faces).ok());
  EXPECT_TRUE(check_ways(test::surfaces_of(a + "facing = \"against\"\n" + b + "facing = \"against\"\n")->faces).ok());
}

TEST(CommonBorders, HowManyWereJoinedIsToldWithAPlace) {
  const auto made = test::surfaces_of(flat("a", "u = [0, 10]\nv = [0, 5]\n") + flat("b", "u = [0, 10]\nv = [5, 10]\n"));
  ASSERT_TRUE(made.ok());
  ASSERT_EQ(codes(made->findings), std::vector<std::string>{"borders_joined"});
  EXPECT_THAT(made->findings[0].message, HasSubstr("one curve: 1"));
  EXPECT_NEAR(made->findings[0].place.y.value_or(-1), 5.0, 1e-9);
}

}  // namespace
}  // namespace quebra::surfaces::common_borders_test
