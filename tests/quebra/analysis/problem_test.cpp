// Every kind of support, spring, tie and load as scenario files write them, against closed forms; and each fault by its
// place.

#include "quebra/analysis/problem.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "shared/fem/assemble.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::analysis {
namespace {

using namespace dobra;
using namespace test;
using testing::HasSubstr;

/// A strip 4 x 1 with sides bottom, right, top, left; E = 100, nu = 0, thickness 0.5.
const std::string strip = R"([[input.curve]]
name = "bottom"
points = [[0, 0], [4, 0]]
[[input.curve]]
name = "right"
points = [[4, 0], [4, 1]]
[[input.curve]]
name = "top"
points = [[4, 1], [0, 1]]
[[input.curve]]
name = "left"
points = [[0, 1], [0, 0]]
[[input.point]]
name = "tip"
point = [4, 0.5]
[[input.point]]
name = "corner"
point = [0, 0]
[[input.point]]
name = "foot"
point = [4, 0]
[[step]]
operation = "problem"
[[step.material]]
young = 100.0
poisson = 0.0
thickness = 0.5
)";
const std::string clamped =
    "[[step.support]]\nwhere = \"left\"\nx = 0.0\n[[step.support]]\nwhere = \"corner\"\ny = 0.0\n";
const std::string solve =
    "[[step]]\noperation = \"mesh\"\nsize = 0.5\norder = \"2\"\n[[step]]\noperation = \"analyse\"\n";

std::string load(const std::string& where, const std::string& rest) {
  return "[[step.load]]\nwhere = \"" + where + "\"\n" + rest + "\n";
}

geom::Vector total(const model::Model& model, std::size_t c = 0) {
  const Analysis& analysis = *model.analyses.back();
  geom::Vector sum;
  for (const geom::Vector f : fem::load_vector(analysis.meshed->mesh, analysis.problem, analysis.problem.cases[c]))
    sum = sum + f;
  return sum;
}

double tip(const std::string& problem, const char* quantity = "case.load.point.tip.u_x") {
  return figures(run(strip + problem + solve)).at(quantity);
}

TEST(Problem, EveryKindOfLoadStretchesAStripAsItShould) {
  // sigma = F / A = 2: u = sigma L / E = 0.08.
  EXPECT_NEAR(tip(clamped + load("right", "x = 2.0")), 0.08, 1e-12);
  EXPECT_NEAR(tip(clamped + load("right", "kind = \"pressure\"\nvalue = -2.0")), 0.08, 1e-12);
  EXPECT_NEAR(tip(clamped + load("right", "kind = \"stress\"\nstress_xx = \"2 + 0 * y\"")), 0.08, 1e-12);
  EXPECT_NEAR(tip(clamped + load("right", "x_formula = \"2 * nx\"")), 0.08, 1e-12);
  EXPECT_NEAR(tip(clamped + load("right", "kind = \"pressure\"\nvalue_formula = \"-x / 2\"")), 0.08, 1e-12);
  // Body force b: u = b L^2 / (2 E); linear, b x / L from 0: b L^2 / (3 E).
  EXPECT_NEAR(tip(clamped + load("", "kind = \"body\"\nx = 1.0")), 0.08, 1e-12);
  EXPECT_NEAR(tip(clamped + load("", "kind = \"body\"\nx_formula = \"x / 4\"")), 16.0 / 300.0, 1e-5);
  EXPECT_NEAR(tip(clamped + load("", "kind = \"body\"\nfrom = [0, 0]\nto = [4, 0]\nx_to = 1.0")), 16.0 / 300.0, 1e-5);
  // A force at a point: the same resultant.
  const model::Model pulled = last(run(strip + clamped + load("tip", "kind = \"force\"\nx = 1.0\ny = -0.25") + solve));
  EXPECT_NEAR(total(pulled).x, 1.0, 1e-13);
  EXPECT_NEAR(total(pulled).y, -0.25, 1e-13);
}

TEST(Problem, LinearTractionsHaveTheirForceAndMoment) {
  // Pure bending: sigma_x = 4 (y - 1/2) is exact for second-order elements; the curvature is 4 / E.
  const std::string linear = load("right", "from = [4, 0]\nto = [4, 1]\nx = -2.0\nx_to = 2.0");
  const scenario::Run bent = run(strip + clamped + linear + solve);
  const auto values = figures(bent);
  EXPECT_NEAR(total(last(bent)).x, 0.0, 1e-13);
  EXPECT_NEAR(values.at("case.load.point.tip.u_x"), 0.0, 1e-9);
  // At the lower edge, where corner and foot lie, y = -1/2 from the axis: u_x = -x y k.
  EXPECT_NEAR(values.at("case.load.point.foot.u_x"), -0.5 * 4.0 * 0.04, 1e-9);
  EXPECT_NEAR(values.at("case.load.point.foot.u_y"), -0.5 * 16.0 * 0.04, 1e-9);
  const double formula =
      figures(run(strip + clamped + load("right", "x_formula = \"4 * (y - 0.5)\"") + solve)).at("case.load.energy");
  EXPECT_NEAR(values.at("case.load.energy"), formula, 1e-12);
  // A wall of water: pressure from 0 at the top to 1 at the bottom.
  EXPECT_NEAR(total(last(run(strip + clamped +
                             load("right", "kind = \"pressure\"\nfrom = [4, 1]\nto = [4, 0]\nvalue_to = 1.0") + solve)))
                  .x,
              -0.25, 1e-13);
}

TEST(Problem, ExactTractionsByFormulaAreThoseOfTheBuiltInField) {
  const std::string plate =
      "[input]\nspecimen = \"quarter_plate\"\nwidth = 4.0\nradius = 1.0\n[[step]]\noperation = "
      "\"problem\"\n[[step.material]]\nyoung = 1000.0\n"
      "[[step.support]]\nwhere = \"bottom\"\nnormal = 0.0\n[[step.support]]\nwhere = \"left\"\nnormal = 0.0\n";
  const std::string formulas =
      "kind = \"stress\"\n"
      "stress_xx = \"1 - (1.5 * cos(2 * atan2(y, x)) + cos(4 * atan2(y, x))) / (x^2 + y^2) + 1.5 * cos(4 * atan2(y, "
      "x)) / (x^2 + y^2)^2\"\n"
      "stress_yy = \"-(0.5 * cos(2 * atan2(y, x)) - cos(4 * atan2(y, x))) / (x^2 + y^2) - 1.5 * cos(4 * atan2(y, x)) / "
      "(x^2 + y^2)^2\"\n"
      "stress_xy = \"-(0.5 * sin(2 * atan2(y, x)) + sin(4 * atan2(y, x))) / (x^2 + y^2) + 1.5 * sin(4 * atan2(y, x)) / "
      "(x^2 + y^2)^2\"";
  const std::string kirsch = "kind = \"kirsch\"\nvalue = 1.0";
  const auto by_name = figures(run(plate + load("right", kirsch) + load("top", kirsch) + solve));
  const auto by_formula = figures(run(plate + load("right", formulas) + load("top", formulas) + solve));
  EXPECT_NEAR(by_formula.at("case.load.energy"), by_name.at("case.load.energy"),
              1e-12 * by_name.at("case.load.energy"));
}

TEST(Problem, SpringsBedsAndTiesCarryWhatTheyShould) {
  // Rigid across (a tie), on a spring of 3 N/m at the free end and pulled with 1 N: u = F / (k + E A / L).
  const std::string alike = "[[step.tie]]\nwhere = \"right\"\naxis = \"x\"\n";
  const std::string pull = load("tip", "kind = \"force\"\nx = 1.0");
  EXPECT_NEAR(tip(clamped + alike + pull + "[[step.spring]]\nwhere = \"tip\"\nx = 3.0\n"), 1.0 / (3.0 + 12.5), 1e-10);
  // A bed of 6 N/m3 along the end, 0.5 m2: the same 3 N/m.
  EXPECT_NEAR(tip(clamped + alike + pull + "[[step.spring]]\nwhere = \"right\"\nkind = \"bed\"\nx = 6.0\n"),
              1.0 / (3.0 + 12.5), 1e-10);
  // u_x(tip) = 2 u_y(tip) + 0.01: an equation between two displacements of a point.
  const auto tied = figures(run(
      strip + clamped + pull +
      "[[step.tie]]\npoints = [\"tip\", \"tip\"]\naxes = [\"x\", \"y\"]\ncoefficients = [1.0, -2.0]\nvalue = 0.01\n" +
      solve));
  EXPECT_NEAR(tied.at("case.load.point.tip.u_x") - 2.0 * tied.at("case.load.point.tip.u_y"), 0.01, 1e-14);
}

TEST(Problem, LoadCasesAreSolvedSideBySideAndSettlementsBelongToThem) {
  const std::string pushed = "[[step.support]]\nwhere = \"right\"\nx = 0.02\n";
  const std::string cases = load("top", "y = 1.0\ncase = \"wind\"") +
                            "[[step.case]]\nname = \"wind\"\nsettlement = 0.0\n[[step.case]]\nname = "
                            "\"settled\"\n[[step.case]]\nname = \"twice\"\nsettlement = 2.0\n";
  const auto values = figures(run(strip + clamped + pushed + cases + solve));
  EXPECT_NEAR(values.at("case.wind.point.tip.u_x"), 0.0, 1e-14);
  EXPECT_NEAR(values.at("case.settled.point.tip.u_x"), 0.02, 1e-14);
  EXPECT_NEAR(values.at("case.twice.point.tip.u_x"), 0.04, 1e-14);
  EXPECT_NEAR(values.at("case.twice.energy"), 4.0 * values.at("case.settled.energy"), 1e-12);
}

TEST(Problem, DisplacementsByFormulaGiveTheLinearField) {
  std::string held;
  for (const char* const side : {"bottom", "right", "top", "left"})
    held += std::string("[[step.support]]\nwhere = \"") + side +
            "\"\nx_formula = \"0.01 * x + 0.003 * y\"\ny_formula = \"-0.002 * x + 0.004 * y\"\n";
  const auto values = figures(run(strip + held + solve));
  // sigma = E eps for nu = 0; shear (0.003 - 0.002) E / 2.
  const double c = 0.7, r = std::hypot(0.3, 0.05);
  EXPECT_NEAR(values.at("case.load.max_principal"), c + r, 1e-9);
  EXPECT_NEAR(values.at("case.load.eta"), 0.0, 1e-9);
}

TEST(Problem, PressureInACrackOpensIt) {
  // In a wide plate K_I = p sqrt(pi a); square plate, a/W = 0.1: + 1.4 % under pressure as under tension.
  const std::string text =
      "[input]\nspecimen = \"centre_crack\"\nwidth = 20.0\ncrack_length = 1.0\n[[input.point]]\nname = "
      "\"anchor\"\npoint = [-10, -10]\n[[input.point]]\nname = \"guide\"\npoint = [10, -10]\n"
      "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\n[[step.support]]\nwhere = \"anchor\"\nx = "
      "0.0\ny = 0.0\n[[step.support]]\nwhere = \"guide\"\ny = 0.0\n" +
      load("crack_left", "kind = \"pressure\"\nvalue = 1.0\ncase = \"in\"") +
      load("crack_right", "kind = \"pressure\"\nvalue = 1.0\ncase = \"in\"") + load("top", "y = 1.0\ncase = \"far\"") +
      load("bottom", "y = -1.0\ncase = \"far\"") +
      "[[step]]\noperation = \"mesh\"\nsize = 1.0\norder = \"2\"\nrosettes = \"yes\"\n[[step]]\noperation = "
      "\"analyse\"\n[[step]]\noperation = \"crack\"\n";
  const auto values = figures(run(text));
  EXPECT_NEAR(values.at("tip.in.crack_end.K_I"), values.at("tip.far.crack_end.K_I"),
              1e-4 * values.at("tip.far.crack_end.K_I"));
  EXPECT_NEAR(values.at("tip.far.crack_end.K_I"), 1.014 * std::sqrt(M_PI), 5e-3);
}

TEST(Problem, EachFaultIsNamedWithTheLineOfItsTable) {
  const auto fault = [](const std::string& rows) { return trouble(strip + rows + solve); };
  // The first row after the strip's text begins in line 30 of the document.
  EXPECT_THAT(fault(load("rihgt", "x = 1.0")), HasSubstr("test.toml:30:1: load 1: "));
  EXPECT_THAT(fault(load("rihgt", "x = 1.0")), HasSubstr("there is no curve or lip 'rihgt'; did you mean 'right'?"));
  EXPECT_THAT(fault(load("right", "x_formula = \"2 * z\"")), HasSubstr("'z' is not known here"));
  EXPECT_THAT(fault(load("right", "from = [0, 0]")), HasSubstr("needs both `from` and `to`"));
  EXPECT_THAT(fault(load("right", "x_to = 1.0")), HasSubstr("give `from` and `to`"));
  EXPECT_THAT(fault(load("right", "from = [0, 0]\nto = [1, 0]\nx_formula = \"x\"")), HasSubstr("not both"));
  EXPECT_THAT(fault(load("right", "kind = \"pressure\"\nx = 1.0")), HasSubstr("a pressure has no direction"));
  EXPECT_THAT(fault(load("right", "kind = \"stress\"")), HasSubstr("needs stress_xx"));
  EXPECT_THAT(fault(load("tip", "kind = \"force\"\nx_formula = \"x\"")),
              HasSubstr("only tractions, pressures and body forces"));
  EXPECT_THAT(fault(load("right", "kind = \"body\"\nx = 1.0")), HasSubstr("there is no region 'right'"));
  EXPECT_THAT(fault("[[step.support]]\nwhere = \"left\"\n"), HasSubstr("holds nothing; give x, y or normal"));
  EXPECT_THAT(fault("[[step.support]]\nwhere = \"tip\"\nnormal = 0.0\n"), HasSubstr("there is no curve or lip 'tip'"));
  EXPECT_THAT(fault("[[step.support]]\nwhere = \"left\"\nx_formula = \"x\"\n"), HasSubstr("prescribes both"));
  EXPECT_THAT(fault("[[step.spring]]\nwhere = \"lft\"\nx = 1.0\n"), HasSubstr("did you mean 'left'?"));
  EXPECT_THAT(fault("[[step.spring]]\nwhere = \"left\"\nx = -1.0\n"), HasSubstr("x"));
  EXPECT_THAT(fault("[[step.tie]]\npoints = [\"tip\"]\naxes = [\"x\"]\ncoefficients = []\n"),
              HasSubstr("as many axes and coefficients"));
  EXPECT_THAT(fault("[[step.tie]]\npoints = [\"tip\"]\naxes = [\"z\"]\ncoefficients = [1.0]\n"),
              HasSubstr("'z' is no axis"));
  EXPECT_THAT(fault("[[step.tie]]\naxis = \"x\"\n"), HasSubstr("needs `where`, a curve, or `points`"));
  EXPECT_THAT(fault("[[step.material]]\nregion = \"steel\"\nyoung = 1.0\n"), HasSubstr("there is no region 'steel'"));
  EXPECT_THAT(fault(clamped + load("right", "x_formula = \"1 / (y - y)\"")),
              HasSubstr("load 1: the load on 'right' of case 'load' has no finite value here"));
  EXPECT_THAT(
      fault("[[step.support]]\nwhere = \"left\"\nx_formula = \"log(-1)\"\ny = 0.0\n" + load("right", "x = 1.0")),
      HasSubstr("support 1: the support on 'left' prescribes a displacement that has no finite value here"));
}

TEST(Problem, WhatWouldBeLostIsRefusedWithItsLine) {
  const auto refused = [](const std::string& more, const std::string& line_of, const char* why) {
    const std::string text = strip + clamped + more;
    const std::string error = trouble(text);
    EXPECT_THAT(error, HasSubstr(why));
    // `trouble` puts two lines before.
    const auto line =
        3 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.rfind(line_of)), '\n');
    EXPECT_THAT(error, HasSubstr("test.toml:" + std::to_string(line))) << error;
  };
  refused("[[step.material]]\nyoung = 1.0\n", "[[step.material]]", "has a material already, number 1");
  refused(load("right", "x = 2.0\nx_formula = \"y\""), "[[step.load]]", "a number or a formula, not both");
  refused(load("right", "kind = \"pressure\"\nvalue = 2.0\nvalue_formula = \"y\""), "[[step.load]]",
          "a number or a formula, not both");
  refused("[[step.support]]\nwhere = \"right\"\nx = 1.0\nx_formula = \"y\"\ny = 0.0\n", "[[step.support]]",
          "a number or a formula, not both");
  refused("[[step.support]]\nwhere = \"right\"\nnormal = 1.0\nx_formula = \"y\"\ny = 0.0\n", "[[step.support]]",
          "leave `normal` out");
  refused(load("tip", "kind = \"force\"\nvalue = 2.0"), "[[step.load]]", "`value` is of a pressure");
  refused(load("right", "kind = \"stress\"\nstress_xx = \"1\"\nx = 2.0"), "[[step.load]]", "leave x, y and value out");
  refused(load("right", "x = 2.0\nradius = 0.5"), "[[step.load]]", "`radius` is of kind");
  refused(load("right", "x = 2.0\ncase = \"water\"") + "[[step.case]]\nname = \"watre\"\nsettlement = 0.0\n",
          "[[step.case]]", "nothing acts in load case 'watre': no load is of it; did you mean 'water'?");
  refused(load("right", "x = 2.0") + "[[step.case]]\nname = \"load\"\n[[step.case]]\nname = \"load\"\n",
          "[[step.case]]", "has its settings already");
  refused(load("right", "x = 2.0") + "[[step.case]]\nname = \"load\"\nsettlment = 0.0\n", "settlment",
          "did you mean 'settlement'?");
  refused(load("top", "y = 1.0") + load("right", "x_formula = \"1 / (y - 1) + 1 / (y - y)\"") + solve, "[[step.load]]",
          "load 2: the load on 'right' of case 'load' has no finite value here");
  refused("[[step.support]]\nwhere = \"right\"\nx_formula = \"log(-y)\"\ny = 0.0\n" + solve, "[[step.support]]",
          "support 3: the support on 'right' prescribes a displacement that has no finite value here");
  // Where prescribed displacements act a case may be without loads; a name near another's is told.
  const model::Model told = last(run(strip + clamped + "[[step.support]]\nwhere = \"right\"\nx = 0.02\n" +
                                     load("top", "y = 1.0\ncase = \"water\"") + "[[step.case]]\nname = \"watre\"\n"));
  EXPECT_THAT(told.remarks, testing::Contains(HasSubstr("no load is of load case 'watre'")));
}

}  // namespace
}  // namespace quebra::analysis
