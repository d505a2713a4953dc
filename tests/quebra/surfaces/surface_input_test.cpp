// Surfaces, curves, trims and parts of a scenario, and what is said where they are wrong.

#include "quebra/surfaces/surface_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "quebra/surfaces/mesh_surfaces.h"
#include "shared/surf/trim/area.h"
#include "tests/support/surface_scenarios.h"

namespace quebra::surfaces {
namespace {

using namespace dobra;
using geom::Point3;
using test::plate;
using test::surfaces_of;
using testing::HasSubstr;
constexpr double pi = std::numbers::pi;

double area_of(const std::string& text) {
  const auto made = surfaces_of(text);
  EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  double area = 0.0;
  if (made) {
    for (const auto& face : made->faces) area += surf::trim::area(face).value;
  }
  return area;
}
std::string refusal(const std::string& text) {
  const auto made = surfaces_of(text);
  EXPECT_FALSE(made.ok()) << text;
  return made ? "" : to_string(made.error());
}
std::string trim(const std::string& lines) { return "[[input.trim]]\nname = \"t\"\n" + lines; }

TEST(SurfaceInput, EveryKindHasTheAreaOfItsFormula) {
  const std::string head = "[[input.surface]]\nname = \"s\"\n";
  EXPECT_NEAR(area_of(head + "kind = \"sphere\"\nradius = 2\n"), 16 * pi, 1e-6);
  EXPECT_NEAR(area_of(head + "kind = \"sphere\"\nradius = 5\nu = [0, 180]\nv = [-60, 60]\n"), 136.034952, 1e-5);
  EXPECT_NEAR(area_of(head + "kind = \"cylinder\"\nradius = 5\nu = [0, 90]\nv = [0, 10]\n"), 25 * pi, 1e-6);
  EXPECT_NEAR(area_of(head + "kind = \"torus\"\nradius = 6\nminor_radius = 2\nu = [0, 270]\n"), 355.305758, 1e-5);
  // A cone of slant 5 from its apex, half angle whose sine is 3/5: pi r s.
  EXPECT_NEAR(area_of(head + "kind = \"cone\"\nradius = 0\nhalf_angle = 36.86989764584402\nv = [0, 5]\n"), pi * 3 * 5,
              1e-5);
  EXPECT_NEAR(area_of(head + "kind = \"graph\"\nformula = \"(x^2 - y^2) / 10\"\nu = [-10, 10]\nv = [-10, 10]\n"),
              744.625672, 1e-4);
  EXPECT_NEAR(area_of(plate), 100.0, 1e-9);
}

TEST(SurfaceInput, SweptSurfacesTakeCurvesByName) {
  const std::string line = "[[input.space_curve]]\nname = \"low\"\nkind = \"line\"\npoints = [[1, 0, 0], [1, 0, 2]]\n";
  EXPECT_NEAR(
      area_of(line + "[[input.surface]]\nname = \"s\"\nkind = \"extruded\"\ncurves = [\"low\"]\nby = [0, 3, 0]\n"), 6.0,
      1e-9);
  EXPECT_NEAR(area_of(line + "[[input.surface]]\nname = \"s\"\nkind = \"revolved\"\ncurves = [\"low\"]\nu = [0, 90]\n"),
              pi, 1e-8);
  const std::string arc =
      "[[input.space_curve]]\nname = \"arc\"\nkind = \"arc\"\npoints = [[3, 0, 0], [0, 3, 0], [-3, 0, 0]]\n"
      "[[input.space_curve]]\nname = \"up\"\nkind = \"circle\"\ncentre = [0, 0, 4]\nradius = 3\nsweep = 180\n";
  EXPECT_NEAR(area_of(arc + "[[input.surface]]\nname = \"s\"\nkind = \"ruled\"\ncurves = [\"arc\", \"up\"]\n"), 12 * pi,
              1e-6);
}

TEST(SurfaceInput, FramesPlaceAndTurn) {
  const auto made = surfaces_of(
      "[[input.surface]]\nname = \"s\"\nkind = \"cylinder\"\norigin = [1, 2, 3]\naxis = [0, 2, 0]\nx_axis = [0, 0, 1]\n"
      "radius = 2\nu = [0, 90]\nv = [0, 1]\n");
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  const Point3 p = made->faces[0].surface.at({pi / 2, 0.5});  // y cross ... : z = y, x = z, so y of the frame is x
  EXPECT_NEAR(p.x, 3.0, 1e-12);
  EXPECT_NEAR(p.y, 2.5, 1e-12);
  EXPECT_NEAR(p.z, 3.0, 1e-12);
}

TEST(SurfaceInput, UnitsOfTheDocumentHoldInChartsToo) {
  const std::string head = "unit_system = \"mm, N, MPa\"\n";
  EXPECT_NEAR(area_of(head + "[[input.surface]]\nname = \"plate\"\nkind = \"plane\"\nu = [0, 10]\nv = [0, 10]\n" +
                      trim("kind = \"circle\"\nrole = \"hole\"\ncentre = [5, 5]\nradius = 2\n")),
              (100 - 4 * pi) * 1e-6, 1e-13);
  EXPECT_NEAR(
      area_of(head + "[[input.surface]]\nname = \"c\"\nkind = \"cylinder\"\nradius = 10\nu = [0, 180]\nv = [0, 5]\n" +
              trim("kind = \"polygon\"\nrole = \"hole\"\npoints = [[45, 1], [90, 1], [90, 3], [45, 3]]\n")),
      (50 * pi - 10 * pi / 4 * 2) * 1e-6, 1e-13);
}

TEST(SurfaceInput, HolesOutlinesAndPartsLeaveWhatIsMeant) {
  const std::string circle = "kind = \"circle\"\ncentre = [5, 5]\nradius = 2\n";
  EXPECT_NEAR(area_of(plate + trim(circle + "role = \"hole\"\n")), 100 - 4 * pi, 1e-9);
  EXPECT_NEAR(area_of(plate + trim(circle + "role = \"outline\"\n")), 4 * pi, 1e-9);
  const std::string cut = plate + trim("kind = \"line\"\nrole = \"cut\"\npoints = [[3, 0], [3, 10]]\n");
  EXPECT_NEAR(area_of(cut), 100.0, 1e-9);
  EXPECT_NEAR(area_of(cut + "[[input.part]]\nat = [1, 1]\n"), 30.0, 1e-9);
  EXPECT_NEAR(area_of(cut + "[[input.part]]\nfate = \"drop\"\nplace = [1, 1, 0.5]\n"), 70.0, 1e-9);
  // An ellipse in the chart of a Coons patch over a square takes the ellipse in plan away.
  EXPECT_NEAR(
      area_of(plate + trim("kind = \"ellipse\"\nrole = \"hole\"\ncentre = [5, 5]\nradii = [3, 2]\nrotation = 30\n")),
      100 - 6 * pi, 1e-9);
}

TEST(SurfaceInput, PartsMayBeNamedByPlacesOnSeamsAndInPoles) {
  const std::string sphere = "[[input.surface]]\nname = \"s\"\nkind = \"sphere\"\nradius = 5\n";
  const auto cut = [&](const char* normal, const char* place) {
    return sphere +
           trim(std::string("kind = \"plane\"\nrole = \"cut\"\nat = ") + normal + "\nnormal = " + normal + "\n") +
           "[[input.part]]\nfate = \"keep\"\nplace = " + place + "\n";
  };
  // A cap of the height 4: 2 pi r h.
  EXPECT_NEAR(area_of(cut("[0, 0, 1]", "[0, 0, 5]")), 40 * pi, 1e-4);   // the pole
  EXPECT_NEAR(area_of(cut("[0, 0, 1]", "[0, 0, -5]")), 60 * pi, 1e-4);  // the other one
  EXPECT_NEAR(area_of(cut("[1, 0, 0]", "[5, 0, 0]")), 40 * pi, 1e-4);   // on the seam
  EXPECT_THAT(refusal(cut("[0, 0, 1]", "[4.898979485566356, 0, 1]")), HasSubstr("lies on a line"));
}

TEST(SurfaceInput, FormulasThatJumpOrHaveNoBoundAreRefused) {
  const auto graph = [](const std::string& formula) {
    return "[[input.surface]]\nname = \"g\"\nkind = \"graph\"\nformula = \"" + formula +
           "\"\nu = [-1, 1]\nv = [-1, 1]\n";
  };
  EXPECT_THAT(refusal(graph("x > 0 ? 1 : 0")), HasSubstr("jumps here"));
  EXPECT_THAT(refusal(graph("x > 0 ? 1 : 0")), HasSubstr("surface 'g'"));
  EXPECT_THAT(refusal(graph("1 / (x - 0.0137)")), HasSubstr("here: end the ranges `u` and `v` before it"));
  EXPECT_THAT(refusal(graph("sqrt(1 - x * x)")), HasSubstr("grows without bound here"));
  EXPECT_THAT(refusal(graph("abs(x)^(1 / 3)")), HasSubstr("grows without bound here"));
  // The numbers of the surface cross it, though what is left does not.
  EXPECT_THAT(refusal(graph("x > 0 ? 1 : 0") +
                      trim("kind = \"circle\"\nrole = \"outline\"\ncentre = [0.5, 0]\nradius = 0.4\n")),
              HasSubstr("jumps here"));
}

TEST(SurfaceInput, KinksAcrossTheChartAreRefusedWhereTheSurfaceIsLeft) {
  const auto graph = [](const std::string& formula) {
    return "[[input.surface]]\nname = \"g\"\nkind = \"graph\"\nformula = \"" + formula +
           "\"\nu = [-1, 1]\nv = [-1, 1]\n";
  };
  EXPECT_THAT(refusal(graph("abs(x - y)")), HasSubstr("neither along x nor along y"));
  EXPECT_TRUE(surfaces_of(graph("abs(x - y)") +
                          trim("kind = \"circle\"\nrole = \"outline\"\ncentre = [0.5, -0.5]\nradius = 0.4\n"))
                  .ok());
  EXPECT_TRUE(surfaces_of(graph("abs(x)")).ok());
  const auto cone = surfaces_of(graph("hypot(x - 0.1, y + 0.2)"));
  ASSERT_TRUE(cone.ok());
  ASSERT_EQ(cone->findings.size(), 1U);
  EXPECT_EQ(cone->findings[0].code, "kink");
  EXPECT_NEAR(*cone->findings[0].place.x, 0.1, 1e-6);
  EXPECT_NEAR(*cone->findings[0].place.y, -0.2, 1e-6);
}

TEST(SurfaceInput, SurfacesTooFarFromTheOriginAreRefused) {
  const auto at = [](const char* origin) { return plate + "origin = [" + origin + ", 0, 0]\n"; };
  EXPECT_THAT(refusal(at("1e17")), HasSubstr("move it nearer"));
  EXPECT_THAT(refusal(at("-1e10")), HasSubstr("move it nearer"));
  EXPECT_TRUE(surfaces_of(at("1e7")).ok());
}

TEST(SurfaceInput, SurfacesThatFoldOrHaveNoNormalInsideAreNotMeshed) {
  const auto mesh = [](const std::string& text) -> std::string {
    auto made = surfaces_of(text);
    EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
    if (!made) return {};
    model::SurfaceSet set{.faces = made->faces, .chart_units = {}, .parts = made->parts};
    for (const ChartUnits& units : made->units) set.chart_units.push_back({units.u, units.v});
    const auto meshed = mesh_surfaces(set, {.sizes = {.largest = 0.3}});
    return meshed ? "" : to_string(meshed.error());
  };
  const auto net = [](const std::string& points) {
    return "[[input.surface]]\nname = \"n\"\nkind = \"nurbs\"\ndegree = 1\nknots_u = [0, 0, 1, 2, 3, 3]\n"
           "knots_v = [0, 0, 1, 1]\npoints = [" +
           points + "]\n";
  };
  // A row in one place; a net that turns back; the same, put right.
  EXPECT_THAT(
      mesh(net("[0, 0, 0], [0, 1, 0], [1, 0.5, 0], [1, 0.5, 0], [2, 0.5, 0], [2, 0.5, 0], [3, 0, 0], [3, 1, 0]")),
      HasSubstr("no normal"));
  EXPECT_THAT(mesh(net("[0, 0, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0], [1, 0, 0], [1, 1, 0], [3, 0, 0], [3, 1, 0]")),
              HasSubstr("surface 'n'"));
  EXPECT_EQ(mesh(net("[0, 0, 0], [0, 1, 0], [1, 0, 0], [1, 1, 0], [2, 0, 0], [2, 1, 0], [3, 0, 0], [3, 1, 0]")), "");
  EXPECT_THAT(mesh("[[input.surface]]\nname = \"t\"\nkind = \"torus\"\nradius = 2\nminor_radius = 2\n"),
              HasSubstr("no normal"));
  EXPECT_THAT(mesh("[[input.space_curve]]\nname = \"a\"\nkind = \"line\"\npoints = [[-1, 0, 0], [2, 0, 3]]\n"
                   "[[input.surface]]\nname = \"r\"\nkind = \"revolved\"\ncurves = [\"a\"]\n"),
              HasSubstr("surface 'r'"));
}

TEST(SurfaceInput, OtherSurfacesAndPlanesCut) {
  const std::string half =
      "[[input.surface]]\nname = \"c\"\nkind = \"cylinder\"\nradius = 5\nu = [0, 180]\nv = [0, 10]\n";
  const auto made = surfaces_of(
      half +
      "[[input.surface]]\nname = \"drill\"\nkind = \"cylinder\"\nuse = \"tool\"\norigin = [0, 0, 5]\naxis = [0, 1, 0]\n"
      "radius = 2\nv = [1, 9]\n" +
      trim("surface = \"c\"\nkind = \"surface\"\nrole = \"hole\"\ntool = \"drill\"\n"));
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  ASSERT_EQ(made->faces.size(), 1U);
  EXPECT_EQ(made->faces[0].loops.size(), 2U);
  // The hole: 4 r integral over the quarter of sqrt(r^2 - x^2) R / sqrt(R^2 - x^2), by Simpson's rule.
  double hole = 0.0;
  constexpr int n = 2000;
  for (int i = 0; i <= n; ++i) {
    const double t = 0.5 * pi * i / n, x = 2 * std::sin(t);
    const double f = 2 * std::cos(t) * 2 * std::cos(t) * 5 / std::sqrt(25 - x * x);
    hole += f * (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2);
  }
  hole *= 4 * (0.5 * pi / n) / 3;
  EXPECT_NEAR(surf::trim::area(made->faces[0]).value, 50 * pi - hole, 1e-6);
  // A plane across the half cylinder at v = 4.
  EXPECT_NEAR(area_of(half + trim("kind = \"plane\"\nrole = \"cut\"\nat = [0, 0, 4]\nnormal = [0, 0, 1]\n") +
                      "[[input.part]]\nat = [90, 9]\n"),
              30 * pi, 1e-6);
}

TEST(SurfaceInput, CommonBordersAreOneAndAreTold) {
  const std::string two = plate +
                          "[[input.surface]]\nname = \"wall\"\nkind = \"plane\"\norigin = [0, 0, 0]\naxis = [0, -1, "
                          "0]\nx_axis = [1, 0, 0]\n"
                          "u = [2, 6]\nv = [0, 3]\n";
  const auto made = surfaces_of(two);
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  ASSERT_EQ(made->findings.size(), 1U);
  EXPECT_EQ(made->findings[0].code, "borders_joined");
  // The plate's lower side is cut at both ends of the wall's.
  ASSERT_EQ(made->faces[0].loops[0].edges.size(), 6U);
  std::size_t shared = 0;
  for (const auto& face : made->faces) {
    for (const auto& edge : face.loops[0].edges) shared += edge.shared ? 1U : 0U;
  }
  EXPECT_EQ(shared, 2U);
}

TEST(SurfaceInput, BordersThatOnlyComeNearAreNamedAndNotJoined) {
  const auto made = surfaces_of(
      plate +
      "[[input.surface]]\nname = \"next\"\nkind = \"plane\"\norigin = [10.0003, 0, 0]\nu = [0, 10]\nv = [0, 10]\n");
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  ASSERT_EQ(made->findings.size(), 1U);
  EXPECT_EQ(made->findings[0].code, "borders_near");
  EXPECT_THAT(made->findings[0].message, HasSubstr("0.0003 m apart"));
  for (const auto& face : made->faces) {
    for (const auto& edge : face.loops[0].edges) EXPECT_FALSE(edge.shared);
  }
}

TEST(SurfaceInput, SidesOfTheChartHaveNames) {
  const auto made = surfaces_of(plate);
  ASSERT_TRUE(made.ok());
  std::vector<std::string> names;
  for (const auto& edge : made->faces[0].loops[0].edges) names.push_back(edge.name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("plate_bottom", "plate_right", "plate_top", "plate_left"));
}

TEST(SurfaceInput, BadInputIsNamedWithItsLine) {
  EXPECT_THAT(refusal("[[input.surface]]\nname = \"n\"\nkind = \"nurbs\"\ndegree = 1\nknots_u = [0, 0, 1, 1]\n"
                      "knots_v = [0, 1, 0, 1]\npoints = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]\n"),
              testing::AllOf(HasSubstr("test.toml:8"), HasSubstr("surface 'n'"), HasSubstr("knots_v")));
  EXPECT_THAT(
      refusal(
          "[[input.surface]]\nname = \"n\"\nkind = \"nurbs\"\ndegree = 1\nknots_u = [0, 0, 1, 1]\n"
          "knots_v = [0, 0, 1, 1]\npoints = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]\nweights = [1, 1, -2, 1]\n"),
      testing::AllOf(HasSubstr("surface 'n'"), HasSubstr("weight")));
  EXPECT_THAT(refusal("[[input.surface]]\nname = \"s\"\nkind = \"sphere\"\n"),
              testing::AllOf(HasSubstr("test.toml:3"), HasSubstr("`radius` is needed")));
  EXPECT_THAT(refusal("[[input.surface]]\nname = \"s\"\nkind = \"ruled\"\ncurves = [\"a\", \"b\"]\n"),
              testing::AllOf(HasSubstr("test.toml:6"), HasSubstr("no space curve 'a'")));
  EXPECT_THAT(refusal(plate + plate), HasSubstr("two surfaces have this name"));
  const std::string border = "[[input.space_curve]]\nkind = \"line\"\nname = ";
  EXPECT_THAT(refusal(border + "\"a\"\npoints = [[0, 0, 0], [1, 0, 0]]\n" + border +
                      "\"b\"\npoints = [[0, 1, 0], [1, 1, 0]]\n" + border + "\"c\"\npoints = [[0, 0, 0], [0, 1, 0]]\n" +
                      border +
                      "\"d\"\npoints = [[1, 0, 0], [1, 1, 0.1]]\n"
                      "[[input.surface]]\nname = \"s\"\nkind = \"coons\"\ncurves = [\"a\", \"b\", \"c\", \"d\"]\n"),
              testing::AllOf(HasSubstr("surface 's'"), HasSubstr("0.1")));
}

TEST(SurfaceInput, APatchBetweenThreeCurvesIsMadeAndOneWithAGapRefused) {
  const auto text = [](const std::string& last) {
    const std::string border = "[[input.space_curve]]\nkind = \"line\"\nname = ";
    return border + "\"a\"\npoints = [[0, 0, 0], [4, 0, 0]]\n" + border + "\"b\"\npoints = [[0, 3, 0], [4, 0, 0]]\n" +
           border + "\"c\"\npoints = [[0, 3, 0], " + last +
           "]\n[[input.surface]]\nname = \"s\"\nkind = \"triangular\"\ncurves = [\"a\", \"b\", \"c\"]\n";
  };
  EXPECT_THAT(refusal(text("[0, 0, 0.25]")), testing::AllOf(HasSubstr("surface 's'"), HasSubstr("0.25")));
  const auto made = surfaces_of(text("[0, 0, 0]"));
  ASSERT_TRUE(made.ok()) << to_string(made.error());
  ASSERT_EQ(made->faces.size(), 1U);
  EXPECT_NEAR(surf::trim::area(made->faces[0]).value, 6.0, 1e-9);
  const auto meshed = mesh_surfaces({.faces = made->faces, .chart_units = {{1.0, 1.0}}}, {.sizes = {.largest = 0.5}});
  ASSERT_TRUE(meshed.ok()) << base::to_string(meshed.error());
  EXPECT_NEAR(meshed->quality.area, 6.0, 1e-9);
  EXPECT_GT(meshed->quality.alpha_mean, 0.95);
}

TEST(SurfaceInput, TrimsThatLeaveTheChartOrStayOpenAreNamedWithTheirPlace) {
  EXPECT_THAT(refusal(plate + trim("kind = \"circle\"\nrole = \"hole\"\ncentre = [9, 5]\nradius = 2\n")),
              testing::AllOf(HasSubstr("trim 't'"), HasSubstr("leaves the chart"), HasSubstr("(u, v = ")));
  EXPECT_THAT(refusal(plate + trim("kind = \"line\"\nrole = \"hole\"\npoints = [[1, 1], [2, 1], [2, 2]]\n")),
              testing::AllOf(HasSubstr("its ends do not meet"), HasSubstr("(u, v = 2, 2)")));
  EXPECT_THAT(refusal(plate + trim("kind = \"circle\"\nrole = \"hole\"\ncentre = [5, 5]\nradius = 2\n") +
                      "[[input.part]]\nat = [5, 5]\n"),
              HasSubstr("lies in a hole"));
  EXPECT_THAT(refusal(plate + "[[input.surface_point]]\nname = \"p\"\nat = [5, 11]\n"),
              testing::AllOf(HasSubstr("point 'p'"), HasSubstr("outside the chart")));
  EXPECT_THAT(refusal(plate + trim("kind = \"plane\"\nrole = \"cut\"\nat = [0, 0, 1]\nnormal = [0, 0, 1]\n")),
              HasSubstr("do not meet"));
}

std::vector<std::string> codes_of(const std::string& text) {
  const auto made = surfaces_of(text);
  EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
  std::vector<std::string> codes;
  if (made) {
    for (const auto& finding : made->findings) codes.push_back(finding.code);
  }
  return codes;
}
using Codes = std::vector<std::string>;

TEST(TrimDoubts, WhatIsDrawnAsItIsMeantRaisesNone) {
  const std::string cut = trim("kind = \"line\"\nrole = \"cut\"\npoints = [[0, 5], [10, 5]]\n");
  EXPECT_EQ(codes_of(plate + cut), Codes{});
  EXPECT_EQ(codes_of(plate + cut +
                     "[[input.trim]]\nname = \"k\"\nkind = \"line\"\nrole = \"crack\"\n"
                     "points = [[5, 5], [5, 8]]\n"),
            Codes{});
  EXPECT_EQ(codes_of(plate + trim("kind = \"circle\"\nrole = \"hole\"\ncentre = [5, 5]\nradius = 2\n") +
                     "[[input.trim]]\nname = \"k\"\nkind = \"line\"\nrole = \"crack\"\npoints = [[7, 5], [9, 5]]\n"),
            Codes{});
  // Over the seam of a pipe, beside another hole there.
  EXPECT_EQ(
      codes_of("[[input.surface]]\nname = \"p\"\nkind = \"cylinder\"\nradius = 5\nv = [0, 20]\n" +
               trim("kind = \"circle\"\nrole = \"hole\"\ncentre = [0, 5]\nradius = 3\n") +
               "[[input.trim]]\nname = \"k\"\nkind = \"circle\"\nrole = \"hole\"\ncentre = [360, 12]\nradius = 3\n"),
      Codes{});
}

TEST(TrimDoubts, ACutThatStopsShortIsToldWithTheEndAndTheDistance) {
  const std::string cut = trim("kind = \"line\"\nrole = \"cut\"\npoints = [[0, 5], [9.99, 5]]\n");
  const auto made = surfaces_of(plate + cut);
  ASSERT_TRUE(made.ok());
  ASSERT_EQ(made->findings.size(), 2U);
  EXPECT_EQ(made->findings[0].code, "line_short");
  EXPECT_EQ(made->findings[0].message,
            "'t' ends 0.01 m from the border and does not meet it: end it there, or farther off");
  EXPECT_NEAR(*made->findings[0].place.x, 9.99, 1e-9);
  EXPECT_EQ(made->findings[1].code, "cut_divides_nothing");
  EXPECT_NEAR(*made->findings[1].place.u, 9.99, 1e-9);
}

TEST(TrimDoubts, EndsNearOtherLinesAreToldAndThoseFarAreNot) {
  const std::string wall = trim("kind = \"line\"\nrole = \"internal\"\npoints = [[0, 5], [10, 5]]\n");
  const auto other = [&](double y) {
    return plate + wall + "[[input.trim]]\nname = \"k\"\nkind = \"line\"\nrole = \"crack\"\npoints = [[5, " +
           std::to_string(y) + "], [5, 8]]\n";
  };
  EXPECT_EQ(codes_of(other(5.02)), Codes{"line_short"});
  EXPECT_THAT(surfaces_of(other(5.02))->findings.at(0).message, HasSubstr("'k' ends 0.02 m from 't'"));
  EXPECT_EQ(codes_of(other(5.3)), Codes{});
  EXPECT_EQ(codes_of(other(5.0)), Codes{});
}

TEST(TrimDoubts, CracksAndLinesThatDoNothingAreTold) {
  const auto line = [](const char* role, const char* points) {
    return std::string("[[input.trim]]\nname = \"k\"\nkind = \"line\"\nrole = \"") + role + "\"\npoints = " + points +
           "\n";
  };
  const std::string hole = trim("kind = \"circle\"\nrole = \"hole\"\ncentre = [5, 5]\nradius = 3\n");
  EXPECT_EQ(codes_of(plate + line("crack", "[[0, 2], [0, 8]]")), Codes{"crack_opens_nothing"});
  EXPECT_EQ(codes_of(plate + hole + line("crack", "[[4, 5], [6, 5]]")), Codes{"crack_opens_nothing"});
  EXPECT_EQ(codes_of(plate + hole + line("internal", "[[4, 5], [6, 5]]")), Codes{"line_left_out"});
  EXPECT_EQ(codes_of(plate + hole + line("internal", "[[4, 5], [9, 5]]")), Codes{});  // a part of it stays
}

TEST(TrimDoubts, LoopsThatCrossAreToldWithAPlaceWhereTheyDo) {
  const std::string hole = trim("kind = \"circle\"\nrole = \"hole\"\ncentre = [4, 5]\nradius = 2\n");
  const auto other = [&](double x, double radius) {
    return plate + hole + "[[input.trim]]\nname = \"k\"\nkind = \"circle\"\nrole = \"hole\"\ncentre = [" +
           std::to_string(x) + ", 5]\nradius = " + std::to_string(radius) + "\n";
  };
  const auto crossing = surfaces_of(other(6, 2));
  ASSERT_TRUE(crossing.ok());
  ASSERT_EQ(crossing->findings.size(), 1U);
  EXPECT_EQ(crossing->findings[0].message, "the holes 't' and 'k' cross: what lies in either is taken away");
  EXPECT_NEAR(*crossing->findings[0].place.x, 5.0, 1e-6);
  EXPECT_NEAR(std::abs(*crossing->findings[0].place.y - 5.0), std::sqrt(3.0), 1e-6);
  // Two circles of radius 2 whose middles are 2 apart: the lens is 2 (4 pi / 3) - 2 sqrt 3 wide.
  EXPECT_NEAR(area_of(other(6, 2)), 100 - (8 * pi - (8 * pi / 3 - 2 * std::sqrt(3.0))), 1e-6);
  EXPECT_EQ(codes_of(other(8, 1)), Codes{});                       // beside it
  EXPECT_EQ(codes_of(other(4, 1)), Codes{"loop_bounds_nothing"});  // within it
  const auto eight =
      surfaces_of(plate + trim("kind = \"polygon\"\nrole = \"hole\"\npoints = [[2, 2], [8, 8], [8, 2], [2, 8]]\n"));
  ASSERT_TRUE(eight.ok());
  ASSERT_EQ(eight->findings.size(), 1U);
  EXPECT_EQ(eight->findings[0].code, "trims_cross");
  EXPECT_NEAR(*eight->findings[0].place.x, 5.0, 1e-6);
}

}  // namespace
}  // namespace quebra::surfaces
