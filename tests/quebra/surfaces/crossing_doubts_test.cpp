// Surfaces that cut through or cover each other are told with a place on what they have in common, known in closed
// form; those that meet in lines, touch, or only come near are not.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "quebra/surfaces/mesh_surfaces.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces::crossing_doubts_test {
namespace {

using namespace dobra;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<surf::mesh::Finding> doubts(const std::string& text, double size, double turn = 0.0) {
  const auto made = test::surfaces_of(text);
  EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  std::vector<surf::mesh::Finding> kept;
  if (!made) return kept;
  model::SurfaceSet set{.faces = made->faces, .chart_units = {}, .parts = made->parts};
  for (const ChartUnits& units : made->units) set.chart_units.push_back({units.u, units.v});
  SurfaceMeshOptions options{.sizes = {.largest = size}};
  if (turn > 0.0) options.sizes.turn = turn;
  const auto mesh = mesh_surfaces(set, options);
  EXPECT_TRUE(mesh.ok()) << (mesh ? "" : to_string(mesh.error()));
  if (!mesh) return kept;
  for (const auto& each : mesh->findings) {
    if (each.code == "surfaces_cross" || each.code == "surfaces_overlap") kept.push_back(each);
  }
  return kept;
}

std::vector<std::string> codes(const std::string& text, double size, double turn = 0.0) {
  std::vector<std::string> all;
  for (const auto& finding : doubts(text, size, turn)) all.push_back(finding.code);
  return all;
}

std::string surface(const std::string& name, const std::string& kind, const std::string& more) {
  return "[[input.surface]]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\n" + more + "\n";
}
std::string internal(const std::string& on, const std::string& points, const std::string& role = "internal") {
  return "[[input.trim]]\nname = \"" + on + role + "\"\nsurface = \"" + on + "\"\nkind = \"line\"\nrole = \"" + role +
         "\"\npoints = " + points + "\n";
}
const std::string plate = test::plate;
/// Upright over y = 5 of the plate, from z = low to high.
std::string web(const std::string& low, const std::string& high) {
  return surface(
      "web", "plane",
      "u = [1, 9]\nv = [" + low + ", " + high + "]\norigin = [0, 5, 0]\naxis = [0, -1, 0]\nx_axis = [1, 0, 0]");
}
std::string pipe(const std::string& name, double radius, double y, double z, const std::string& u = "[0, 360]",
                 const std::string& v = "[0, 8]") {
  return surface(name, "cylinder",
                 "axis = [1, 0, 0]\nx_axis = [0, 1, 0]\nv = " + v + "\nradius = " + fmt::format("{:.17g}", radius) +
                     "\nu = " + u + "\norigin = [0, " + std::to_string(y) + ", " + std::to_string(z) + "]");
}

TEST(CrossingDoubts, AWebThroughAPlateIsToldOnTheirLine) {
  for (const double size : {0.3, 1.0, 4.0}) {
    const auto found = doubts(plate + web("-2", "3"), size);
    ASSERT_EQ(found.size(), 1U) << size;
    EXPECT_EQ(found[0].code, "surfaces_cross");
    EXPECT_THAT(found[0].message, HasSubstr("line: 1; the first is 'plate' and 'web'"));
    ASSERT_TRUE(found[0].place.x && found[0].place.y && found[0].place.z);
    EXPECT_NEAR(*found[0].place.y, 5.0, 1e-12);
    EXPECT_NEAR(*found[0].place.z, 0.0, 1e-12);
    EXPECT_TRUE(*found[0].place.x >= 1.0 && *found[0].place.x <= 9.0);
  }
}

TEST(CrossingDoubts, AShallowCrossingOfPlanesIsTold) {
  EXPECT_THAT(codes(plate + web("-0.001", "3"), 1.0), ElementsAre("surfaces_cross"));
}

TEST(CrossingDoubts, ALineOfBothIsNoCrossing) {
  const std::string tool =
      "[[input.trim]]\nname = \"l\"\nsurface = \"plate\"\nkind = \"surface\"\ntool = \"web\"\nrole = \"internal\"\n";
  EXPECT_THAT(
      codes(plate + web("-2", "3") + internal("plate", "[[1, 5], [9, 5]]") + internal("web", "[[1, 0], [9, 0]]"), 0.7),
      IsEmpty());
  EXPECT_THAT(codes(plate + web("0", "3") + tool, 0.7), IsEmpty());
  // A line in one of them alone joins nothing.
  EXPECT_THAT(codes(plate + web("-2", "3") + internal("plate", "[[1, 5], [9, 5]]"), 0.7),
              ElementsAre("surfaces_cross"));
}

TEST(CrossingDoubts, LipsOfACrackAreNone) {
  EXPECT_THAT(codes(plate + web("0", "3") + internal("plate", "[[1, 5], [9, 5]]") +
                        internal("plate", "[[4, 2], [4, 8]]", "crack"),
                    0.7),
              IsEmpty());
}

TEST(CrossingDoubts, ManyPairsAreCounted) {
  const auto found = doubts(plate + web("-2", "3") + pipe("pipe", 1.0, 5.0, 0.0), 0.5);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].message, HasSubstr("line: 3; the first is 'plate' and 'web'"));
}

TEST(CrossingDoubts, PlatesOfOnePlaneThatCoverEachOtherAreTold) {
  // Tilted, so that no two corners lie exactly in one plane.
  for (const std::string axis :
       {"axis = [0, 0, 1]\nx_axis = [1, 0, 0]", "axis = [0.3, 0.5, 0.7]\nx_axis = [1, 0.2, 0]"}) {
    const std::string a = surface("a", "plane", "u = [0, 5]\nv = [0, 5]\n" + axis);
    const auto found = doubts(a + surface("b", "plane", "u = [4, 9]\nv = [-1, 3.3]\n" + axis), 0.6);
    ASSERT_EQ(found.size(), 1U) << axis;
    EXPECT_EQ(found[0].code, "surfaces_overlap");
    EXPECT_THAT(codes(a + surface("b", "plane", "u = [1, 4]\nv = [1, 4]\n" + axis), 0.6),
                ElementsAre("surfaces_overlap"));
    EXPECT_THAT(codes(a + surface("b", "plane", "u = [5, 9]\nv = [0, 5]\n" + axis), 0.6), IsEmpty());
    EXPECT_THAT(codes(a + surface("b", "plane", "u = [5, 9]\nv = [1, 2]\n" + axis), 0.6), IsEmpty());
    EXPECT_THAT(codes(a + surface("b", "plane", "u = [5.001, 9]\nv = [0, 5]\n" + axis), 0.6), IsEmpty());
  }
}

/// Nearer than 1e-5 of the smaller one's diagonal, here 5 sqrt(2): whichever is first, whatever the unit, and wherever
/// they stand beside what is far larger.
TEST(CrossingDoubts, PlatesThatLieOnEachOtherAreTold) {
  const auto sheet = [](const std::string& name, double side, double from, double z) {
    return surface(
        name, "plane",
        fmt::format("u = [0, {0:.17g}]\nv = [0, {0:.17g}]\norigin = [{1:.17g}, {1:.17g}, {2:.17g}]", side, from, z));
  };
  for (const double unit : {1e-3, 1.0, 1e3}) {
    const std::string base = sheet("base", 10.0 * unit, 0.0, 0.0);
    for (const double z : {0.0, 1e-7, 1e-6, 1e-5, 5e-5, -5e-5}) {
      const std::string patch = sheet("patch", 5.0 * unit, 2.0 * unit, z * unit);
      EXPECT_THAT(codes(base + patch, unit), ElementsAre("surfaces_overlap")) << z << ' ' << unit;
      EXPECT_THAT(codes(patch + base, unit), ElementsAre("surfaces_overlap")) << z << ' ' << unit;
    }
    for (const double z : {1e-4, 1e-3, -1e-3}) {
      const std::string patch = sheet("patch", 5.0 * unit, 2.0 * unit, z * unit);
      EXPECT_THAT(codes(base + patch, unit), IsEmpty()) << z << ' ' << unit;
      EXPECT_THAT(codes(base + patch + sheet("far", unit, 1e3 * unit, 0.0), unit), IsEmpty()) << z << ' ' << unit;
    }
  }
}

TEST(CrossingDoubts, SheetsOfTwoCylindersThatLieOnEachOtherAreTold) {
  // Diagonal of the smaller one, 30 degrees of radius 1 and 1 long: sqrt(1 + (2 sin 15)^2) = 1.126. Triangles of sheets
  // farther apart cut through each other where they are made otherwise, and the sheets do not.
  const auto sheets = [](double radius) {
    return codes(pipe("a", 1.0, 0.0, 0.0, "[0, 60]", "[0, 2]") + pipe("b", radius, 0.0, 0.0, "[20, 50]", "[0.5, 1.5]"),
                 0.2);
  };
  for (const double off : {1e-6, -1e-6, 1e-5, -1e-5})
    EXPECT_THAT(sheets(1.0 + off), ElementsAre("surfaces_overlap")) << off;
  for (const double off : {2e-5, -2e-5, 1e-4, -1e-4, 1e-3, -1e-3, 0.01, -0.01})
    EXPECT_THAT(sheets(1.0 + off), IsEmpty()) << off;
}

TEST(CrossingDoubts, SheetsOfOneCylinderThatCoverEachOtherAreTold) {
  for (const double size : {0.2, 0.5}) {
    EXPECT_THAT(codes(pipe("a", 1.0, 0.0, 0.0, "[0, 200]") + pipe("b", 1.0, 0.0, 0.0, "[170, 300]", "[1, 7]"), size),
                ElementsAre("surfaces_overlap"));
    EXPECT_THAT(codes(pipe("a", 1.0, 0.0, 0.0, "[0, 200]") + pipe("b", 1.0, 0.0, 0.0, "[200, 300]"), size), IsEmpty());
  }
}

TEST(CrossingDoubts, PipesThatCrossAreTold) {
  const std::string other = surface("b", "cylinder",
                                    "axis = [0, 1, 0]\nx_axis = [1, 0, 0]\nv = [-4, 4]\nradius = 0.6\n"
                                    "origin = [4, 0, 0.3]");
  for (const double size : {0.2, 0.5, 2.0}) {
    const auto found = doubts(pipe("a", 1.0, 0.0, 0.0) + other, size);
    ASSERT_EQ(found.size(), 1U) << size;
    EXPECT_EQ(found[0].code, "surfaces_cross");
    const double y = *found[0].place.y, z = *found[0].place.z, x = *found[0].place.x;
    EXPECT_NEAR(std::hypot(y, z), 1.0, 0.05);
    EXPECT_NEAR(std::hypot(x - 4.0, z - 0.3), 0.6, 0.05);
  }
  EXPECT_THAT(codes(pipe("a", 1.0, 0.0, 0.0) + pipe("b", 1.0, 1.5, 0.0), 0.3), ElementsAre("surfaces_cross"));
}

/// Less deep than the triangles are off the pipe and the ball.
TEST(CrossingDoubts, PipesAndBallsThatArePressedIntoAPlateAreTold) {
  for (const double by : {0.005, 0.01, 0.02}) {
    EXPECT_THAT(codes(plate + pipe("pressed", 2.0, 5.0, 2.0 - by), 1.0, 15.0), ElementsAre("surfaces_cross")) << by;
    EXPECT_THAT(codes(plate + pipe("pressed", 2.0, 5.0, 2.0 - by), 0.5, 10.0), ElementsAre("surfaces_cross")) << by;
  }
  EXPECT_THAT(codes(plate + surface("ball", "sphere", "radius = 2\norigin = [5, 5, 1.97]"), 1.0, 15.0),
              ElementsAre("surfaces_cross"));
}

TEST(CrossingDoubts, WhatTouchesOrComesNearIsNotTold) {
  for (const double size : {0.2, 0.5}) {
    EXPECT_THAT(codes(pipe("a", 1.0, 0.0, 0.0) + pipe("b", 1.0, 2.0, 0.0), size), IsEmpty()) << "beside";
    EXPECT_THAT(codes(pipe("a", 1.0, 0.0, 0.0) + pipe("b", 0.6, 0.4, 0.0), size), IsEmpty()) << "in it";
    EXPECT_THAT(codes(pipe("a", 1.0, 0.0, 0.0) + pipe("b", 1.01, 0.0, 0.0), size), IsEmpty()) << "round it";
    EXPECT_THAT(codes(plate + surface("ball", "sphere", "radius = 1\norigin = [5, 5, 1]"), size), IsEmpty()) << "ball";
    EXPECT_THAT(codes(plate + web("0.01", "3"), size), IsEmpty()) << "above";
    EXPECT_THAT(codes(plate + pipe("lying", 1.0, 5.0, 1.0), size), IsEmpty()) << "pipe on a plate";
  }
}

/// Triangles of a side of a twentieth are nearer to the plate than 1e-5 of its size where the pipe touches it.
TEST(CrossingDoubts, APipeThatTouchesAPlateDoesNotLieOnIt) {
  const std::string small = surface("plate", "plane", "u = [4, 6]\nv = [4, 6]\n");
  EXPECT_THAT(codes(small + pipe("lying", 1.0, 5.0, 1.0, "[250, 290]", "[4, 6]"), 0.05), IsEmpty());
  EXPECT_THAT(codes(small + pipe("lying", 1.0, 5.0, 1.0, "[265, 275]", "[4, 4.2]"), 0.01), IsEmpty());
}

/// A cubic that crosses itself at (2, 0, 12/7), by symmetry where x = 2: x - 2 = s (28 s^2 - 3), z = 12 (1/4 - s^2).
const std::string loop =
    "[[input.space_curve]]\nname = \"loop\"\nkind = \"bezier\"\npoints = [[0, 0, 0], [6, 0, 4], [-2, 0, 4], [4, 0, "
    "0]]\n";

TEST(CrossingDoubts, ASurfaceThatCutsThroughItselfIsToldWhereItDoes) {
  const std::string extruded = loop + surface("eight", "extruded", "curves = [\"loop\"]\nby = [1, 5, 0.5]");
  for (const double size : {0.3, 1.5}) {
    const auto found = doubts(extruded, size, 15.0);
    ASSERT_EQ(found.size(), 1U) << size;
    EXPECT_EQ(found[0].code, "surfaces_cross");
    EXPECT_THAT(found[0].message, HasSubstr("themselves: 1; the first is 'eight'"));
    const double y = *found[0].place.y;
    EXPECT_TRUE(y >= 0.0 && y <= 5.0) << y;
    EXPECT_NEAR(*found[0].place.x, 2.0 + y / 5.0, 0.05) << size;
    EXPECT_NEAR(*found[0].place.z, 12.0 / 7.0 + 0.1 * y, 0.05) << size;
  }
  const auto turned = doubts(
      loop + surface("ring", "revolved", "curves = [\"loop\"]\norigin = [9, 0, 0]\naxis = [0, 0, 1]\nu = [0, 360]"),
      0.7, 15.0);
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_NEAR(std::hypot(*turned[0].place.x - 9.0, *turned[0].place.y), 7.0, 0.1);
  EXPECT_NEAR(*turned[0].place.z, 12.0 / 7.0, 0.1);
}

TEST(CrossingDoubts, APatchThatLoopsThroughItselfIsTold) {
  // The loop above, sheared along the patch and made of a grid of points.
  std::string points = "[";
  for (const char* const at : {"0, {}, 0", "6, {}, 4", "-2, {}, 4", "4, {}, 0"}) {
    for (int k = 0; k < 4; ++k) {
      std::string point = at;
      point.replace(point.find("{}"), 2, std::to_string(2 * k));
      points += "[" + point + "], ";
    }
  }
  points.replace(points.size() - 2, 2, "]");
  const std::string patch =
      surface("patch", "nurbs",
              "degree = 3\nknots_u = [0, 0, 0, 0, 1, 1, 1, 1]\nknots_v = [0, 0, 0, 0, 1, 1, 1, 1]\npoints = " + points);
  const auto found = doubts(patch, 0.5, 15.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(*found[0].place.x, 2.0, 0.05);
  EXPECT_NEAR(*found[0].place.z, 12.0 / 7.0, 0.05);
}

TEST(CrossingDoubts, PlainSurfacesDoNotCutThroughThemselves) {
  EXPECT_THAT(codes(surface("c", "torus", "radius = 3\nminor_radius = 2.99"), 1.0, 20.0), IsEmpty());
  for (const double size : {0.5, 4.0}) {
    EXPECT_THAT(codes(surface("c", "torus", "radius = 3\nminor_radius = 1"), size), IsEmpty()) << size;
    EXPECT_THAT(codes(pipe("c", 1.0, 0.0, 0.0), size), IsEmpty()) << size;
    EXPECT_THAT(codes(surface("c", "sphere", "radius = 2"), size), IsEmpty()) << size;
    EXPECT_THAT(codes(plate + internal("plate", "[[4, 2], [4, 8]]", "crack"), size), IsEmpty()) << size;
    EXPECT_THAT(codes(pipe("c", 2.0, 0.0, 0.0) + internal("c", "[[90, 2], [200, 6]]", "crack"), size), IsEmpty())
        << size;
  }
  EXPECT_THAT(codes(pipe("c", 1.0, 0.0, 0.0, "[0, 359.9]"), 0.5), IsEmpty()) << "a narrow slit";
}

TEST(CrossingDoubts, ConesOfAnyAngleDoNotCutThroughThemselves) {
  for (const char* const angle : {"1", "20", "80"}) {
    const std::string cone =
        surface("c", "cone", std::string("radius = 0\nhalf_angle = ") + angle + "\nv = [0, 10]\nu = [0, 360]");
    EXPECT_THAT(codes(cone, 3.0), IsEmpty()) << angle;
  }
}

}  // namespace
}  // namespace quebra::surfaces::crossing_doubts_test
