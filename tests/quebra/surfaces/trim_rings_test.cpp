// What holes cut by planes and other surfaces take away, and which of them have no inside.

#include "quebra/surfaces/trim_rings.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "quebra/surfaces/mesh_surfaces.h"
#include "shared/surf/trim/area.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::trim_rings_test {
namespace {

using namespace dobra;
using test::plate;
using test::surfaces_of;
using testing::HasSubstr;
constexpr double pi = std::numbers::pi;

const std::string pipe = "[[input.surface]]\nname = \"c\"\nkind = \"cylinder\"\nradius = 2\nv = [0, 10]\n";
const std::string ball = "[[input.surface]]\nname = \"c\"\nkind = \"sphere\"\nradius = 2\n";
const std::string ring = "[[input.surface]]\nname = \"c\"\nkind = \"torus\"\nradius = 5\nminor_radius = 1\n";

std::string by_plane(const std::string& at, const std::string& normal, const char* role = "hole") {
  return "[[input.trim]]\nname = \"t\"\nkind = \"plane\"\nrole = \"" + std::string(role) + "\"\nat = " + at +
         "\nnormal = " + normal + "\n";
}
std::string by_sphere(const std::string& centre, const char* radius) {
  return "[[input.surface]]\nname = \"b\"\nkind = \"sphere\"\nuse = \"tool\"\nradius = " + std::string(radius) +
         "\norigin = " + centre + "\n[[input.trim]]\nname = \"t\"\nkind = \"surface\"\ntool = \"b\"\nrole = \"hole\"\n";
}
double area_of(const std::string& text) {
  const auto made = surfaces_of(text);
  EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  return made ? surf::trim::area(made->faces[0]).value : 0.0;
}
base::Error refusal(const std::string& text) {
  const auto made = surfaces_of(text);
  EXPECT_FALSE(made.ok()) << text;
  return made ? base::Error{} : made.error();
}

TEST(TrimRings, HolesThatGoRoundASurfaceAreRefusedWithAdvice) {
  for (const std::string& text :
       {pipe + by_plane("[0, 0, 5]", "[0, 0.2, 1]"), pipe + by_sphere("[0, 0, 5]", "3"),
        ball + by_plane("[0, 0, 1]", "[0, 0.1, 1]"), ring + by_plane("[0, 0, 0.5]", "[0, 0, 1]"),
        ring + by_plane("[0, 0, 0]", "[0, 1, 0]"), pipe + by_plane("[0, 0, 5]", "[0, 0, 1]", "outline")}) {
    const base::Error error = refusal(text);
    EXPECT_THAT(error.message, HasSubstr("goes round the surface")) << text;
    EXPECT_THAT(error.message, HasSubstr("role = \"cut\""));
    EXPECT_THAT(error.message, HasSubstr("[[input.part]]"));
    ASSERT_TRUE(error.place && error.place->z && error.place->u);
  }
}

TEST(TrimRings, WhatAdviceSaysDoesWhatWasMeant) {
  EXPECT_NEAR(area_of(pipe + by_plane("[0, 0, 6]", "[0, 0, 1]", "cut") + "[[input.part]]\nplace = [2, 0, 1]\n"),
              24 * pi, 1e-6);
}

TEST(TrimRings, APlaneThroughAPoleCutsACap) {
  // Its circle comes to the pole along the seam where the normal is at right angles to it.
  const double cap = 2 * pi * 2 * (2 - std::sqrt(2.0));
  for (const std::string normal : {"[0, 1, 1]", "[0, -1, 1]", "[1, 0, 1]", "[-1, 0, 1]"})
    EXPECT_NEAR(
        area_of(ball + by_plane("[0, 0, 2]", normal, "cut") + "[[input.part]]\nfate = \"drop\"\nplace = [0, 0, -2]\n"),
        cap, 1e-6)
        << normal;
}

TEST(TrimRings, HolesFromBorderToBorderAreRefusedWithAdvice) {
  EXPECT_THAT(refusal(plate + by_plane("[5, 0, 0]", "[1, 0, 0]")).message, HasSubstr("from border to border"));
  // A corner: which side of the arc is meant is plain to see, and not said.
  EXPECT_THAT(refusal(plate + by_sphere("[0, 0, 0]", "1")).message, HasSubstr("from border to border"));
}

TEST(TrimRings, HolesFromOneSideToTheSameSideAreClosedAlongIt) {
  EXPECT_NEAR(area_of(plate + by_sphere("[0, 5, 0]", "1")), 100 - pi / 2, 1e-6);
  EXPECT_NEAR(area_of(plate + by_sphere("[5, 10, 0]", "2")), 100 - 2 * pi, 1e-6);
}

TEST(TrimRings, HolesOverASeamTakeTheSameAsElsewhere) {
  const double elsewhere = area_of(pipe + by_sphere("[-2, 0, 5]", "1"));
  EXPECT_LT(elsewhere, 40 * pi - 3.0);
  EXPECT_NEAR(area_of(pipe + by_sphere("[2, 0, 5]", "1")), elsewhere, 1e-6);
  // Over both seams of a torus, at the corner of its chart.
  EXPECT_NEAR(area_of(ring + by_sphere("[6, 0, 0]", "0.5")), area_of(ring + by_sphere("[-6, 0, 0]", "0.5")), 1e-6);
  EXPECT_LT(area_of(ring + by_sphere("[6, 0, 0]", "0.5")), 20 * pi * pi - 0.7);
}

/// Two pipes of one radius meet in ellipses that cross in two places, where the pipes touch.
TEST(TrimRings, EqualPipesMeetWhereverTheirSeamsAre) {
  for (const char* const x_of_pipe : {"[1, 0, 0]", "[0, 1, 0]", "[0, -1, 0]"}) {
    for (const double turn : {0.0, 20.0, 90.0, 180.0, 270.0}) {
      const double angle = turn * pi / 180.0;
      const auto made = surfaces_of(fmt::format(
          "[[input.surface]]\nname = \"c\"\nkind = \"cylinder\"\nradius = 2\nx_axis = {}\nv = [-5, 5]\n"
          "[[input.surface]]\nname = \"branch\"\nkind = \"cylinder\"\nradius = 2\naxis = [1, 0, 0]\n"
          "x_axis = [0, {}, {}]\nv = [0, 5]\n"
          "[[input.trim]]\nname = \"hole\"\nkind = \"surface\"\nsurface = \"c\"\ntool = \"branch\"\nrole = \"hole\"\n"
          "[[input.trim]]\nname = \"end\"\nkind = \"surface\"\nsurface = \"branch\"\ntool = \"c\"\nrole = \"cut\"\n"
          "[[input.part]]\nsurface = \"branch\"\nat = [45, 4.5]\n",
          x_of_pipe, std::cos(angle), std::sin(angle)));
      ASSERT_TRUE(made.ok()) << x_of_pipe << " " << turn << " " << to_string(made.error());
      ASSERT_EQ(made->faces.size(), 2U);
      // A lens of one pipe is 2 r^2 times the integral of the cosine over half a turn, and there are two on the branch.
      EXPECT_NEAR(surf::trim::area(made->faces[0]).value, 40 * pi - 16, 1e-5) << x_of_pipe << " " << turn;
      EXPECT_NEAR(surf::trim::area(made->faces[1]).value, 20 * pi - 16, 1e-5) << x_of_pipe << " " << turn;
    }
  }
}

TEST(TrimRings, AnEqualPipeThroughAPipeTakesBothLensesWhereverTheSeamIs) {
  for (const char* const range : {"[0, 360]", "[-180, 180]", "[90, 450]", "[45, 405]"}) {
    const std::string text = std::string("[[input.surface]]\nname = \"c\"\nkind = \"cylinder\"\nradius = 2\nu = ") +
                             range +
                             "\nv = [-6, 6]\n[[input.surface]]\nname = \"b\"\nkind = \"cylinder\"\nuse = \"tool\"\n"
                             "radius = 2\naxis = [1, 0, 0]\nx_axis = [0, 1, 0]\nv = [-12, 12]\n"
                             "[[input.trim]]\nname = \"t\"\nkind = \"surface\"\ntool = \"b\"\nrole = \"hole\"\n";
    EXPECT_NEAR(area_of(text), 48 * pi - 32, 1e-5) << range;
    EXPECT_TRUE(surfaces_of(text)->findings.empty()) << range;  // they touch, and cross nowhere
  }
}

TEST(TrimRings, ALineAlongASeamIsASetOfTheMesh) {
  const std::string along = "[[input.trim]]\nname = \"l\"\nkind = \"line\"\nrole = \"internal\"\npoints = ";
  const auto length = [](const std::string& text) {
    auto made = surfaces_of(text);
    EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
    model::SurfaceSet set{.faces = made->faces, .chart_units = {}, .parts = made->parts};
    for (const ChartUnits& units : made->units) set.chart_units.push_back({units.u, units.v});
    const auto mesh = mesh_surfaces(set, {.sizes = {.largest = 0.5}});
    EXPECT_TRUE(mesh.ok()) << (mesh ? "" : to_string(mesh.error()));
    double sum = 0.0;
    const auto found = mesh->mesh.constraint_sets.find("l");
    if (found == mesh->mesh.constraint_sets.end()) return sum;
    for (const auto& side : found->second) sum += distance(mesh->mesh.point(side[0]), mesh->mesh.point(side[1]));
    return sum;
  };
  EXPECT_NEAR(length(pipe + along + "[[0, 2], [0, 7]]\n"), 5.0, 1e-9);
  EXPECT_NEAR(length(ring + along + "[[90, 0], [180, 0]]\n"), 3 * pi, 0.1);
  EXPECT_NEAR(length(ring + along + "[[0, 90], [0, 180]]\n"), pi / 2, 0.05);
  EXPECT_NEAR(length(ball + along + "[[0, -30], [0, 60]]\n"), pi, 0.05);  // into both charts of the poles
}

}  // namespace
}  // namespace quebra::surfaces::trim_rings_test
