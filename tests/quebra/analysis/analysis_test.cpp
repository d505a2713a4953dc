// Problem, analysis, adaptive loop and crack tips through QUEBRA's table of operations, as scenario files call them.

#include "quebra/analysis/analysis.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <numbers>

#include "tests/support/quebra_scenarios.h"

namespace quebra::analysis {
namespace {

using namespace dobra;
using namespace test;
using testing::Contains;
using testing::HasSubstr;

const std::string kirsch_problem = R"([input]
specimen = "quarter_plate"
width = 4.0
radius = 1.0
[[step]]
operation = "problem"
[[step.material]]
young = 1000.0
[[step.support]]
where = "bottom"
normal = 0.0
[[step.support]]
where = "left"
normal = 0.0
[[step.load]]
where = "right"
kind = "kirsch"
value = 1.0
[[step.load]]
where = "top"
kind = "kirsch"
value = 1.0
)";
constexpr double kirsch_energy = 0.00844491271144;

std::string adapt_step(double target, const std::string& more = "") {
  return "[[step]]\noperation = \"adapt\"\ntarget = " + std::to_string(target) + "\n" + more;
}

double effectivity(const model::Model& model, double exact) {
  const Analysis& analysis = *model.analyses.back();
  return analysis.fields[0].estimate.error / fem::error::true_error(exact, analysis.solution.cases[0].energy);
}

TEST(Analysis, KirschsPlateReachesTheErrorAskedForAndJudgesItWithinATenth) {
  struct Case {
    double target;
    const char* order;
  };
  for (const auto& [target, order] : {Case{5.0, "1"}, Case{5.0, "2"}, Case{1.0, "2"}, Case{0.2, "2"}}) {
    const scenario::Run done = run(kirsch_problem + adapt_step(target, std::string("order = \"") + order + "\"\n"));
    const auto values = figures(done);
    EXPECT_LE(values.at("eta"), target);
    EXPECT_LE(values.at("cycles"), 6.0);
    EXPECT_GT(effectivity(last(done), kirsch_energy), 0.9) << target << ' ' << order;
    EXPECT_LT(effectivity(last(done), kirsch_energy), 1.1) << target << ' ' << order;
  }
}

/// sigma_x where the hole cuts the y axis.
double stress_at_the_hole(const Analysis& analysis) {
  const auto stresses = fem::error::nodal_mean(analysis.meshed->mesh, analysis.fields[0].recovered.at_element_nodes);
  for (std::size_t n = 0; n < stresses.size(); ++n) {
    if (distance(analysis.meshed->mesh.points[n], geom::Point{0, 1}) < 1e-9) return stresses[n][0];
  }
  return std::nan("");
}

TEST(Analysis, QUE_f_TheLoopReachesFivePercentWithAndWithoutConstraintsAndTheStressAtTheHoleIsRight) {
  // The plate of Figs 12 and 13, an arc of four sides, the six constraints of Fig 13; energy in closed form.
  constexpr double energy = 0.01297541968196;
  std::string plate = kirsch_problem;
  plate.replace(plate.find("width = 4.0"), 11, "width = 5.0");
  const std::string bands =
      "[[step]]\noperation = \"constraints\"\ncurves = [\"hole\"]\ncount = 6\ndistance = 0.065\nfactor = 1.3\n";
  for (const auto& [order, target] :
       {std::pair{"1", 5.0}, std::pair{"1", 1.0}, std::pair{"2", 5.0}, std::pair{"2", 1.0}}) {
    for (const std::size_t count : {0U, 6U}) {
      const scenario::Run done = run(plate + (count > 0 ? bands : "") +
                                     adapt_step(target, std::string("turn = 22.5\norder = \"") + order + "\"\n"));
      const auto values = figures(done);
      EXPECT_LE(values.at("eta"), target) << order << count;
      EXPECT_LE(values.at("cycles"), 6.0) << order << count;
      const Analysis& first = *last(done).analyses.front();
      const Analysis& analysis = *last(done).analyses.back();
      EXPECT_LE(analysis.eta, first.eta) << order << count;
      EXPECT_EQ(analysis.meshed->constraints, count);
      EXPECT_GT(effectivity(last(done), energy), target < 5.0 ? 0.9 : 0.8) << order << count;
      EXPECT_LT(effectivity(last(done), energy), target < 5.0 ? 1.1 : 1.2) << order << count;
      EXPECT_NEAR(stress_at_the_hole(analysis), 3.0, 0.15) << order << count;
      printf(
          "[ figures  ] plate T%s, %zu bands: cycles %g, unknowns %g, eta %.4f -> %.4f, effectivity %.3f, stress "
          "%.3f\n",
          order[0] == '1' ? "3" : "6", count, values.at("cycles"), values.at("unknowns"), first.eta, analysis.eta,
          effectivity(last(done), energy), stress_at_the_hole(analysis));
    }
  }
}

const std::string& corner = sheared_l;

TEST(Analysis, TheReEntrantCornerReachesTheErrorAskedForWithBothRules) {
  for (const char* const rule : {"optimal", "equal"}) {
    for (const double target : {5.0, 1.0}) {
      const scenario::Run done =
          run(corner + adapt_step(target, std::string("max_cycles = 12\nrule = \"") + rule + "\"\n"));
      const auto values = figures(done);
      EXPECT_LE(values.at("eta"), target) << rule;
      EXPECT_NEAR(values.at("case.load.energy"), 60.619, 60.619 * 2.0 * std::pow(0.01 * target, 2)) << rule;
      printf("[ figures  ] corner, %s to %g %%: effectivity %.3f\n", rule, target, effectivity(last(done), 60.619));
      EXPECT_GT(effectivity(last(done), 60.619), 0.8) << rule << ' ' << target;
      EXPECT_LT(effectivity(last(done), 60.619), 1.1) << rule << ' ' << target;
    }
  }
}

TEST(Analysis, TheDefaultRuleOfSizesNeedsAtMostThreeTenthsMoreUnknownsThanTheBetterOne) {
  for (const std::string* problem : {&kirsch_problem, &corner}) {
    for (const double target : {5.0, 1.0}) {
      const double optimal = unknowns_of(*last(run(*problem + adapt_step(target))).analyses.back());
      const double equal = unknowns_of(*last(run(*problem + adapt_step(target, "rule = \"equal\"\n"))).analyses.back());
      EXPECT_LE(optimal, 1.3 * std::min(optimal, equal)) << target;
      printf("[ figures  ] %s to %g %%: unknowns %g optimal, %g equal\n",
             problem == &kirsch_problem ? "plate" : "corner", target, optimal, equal);
    }
  }
}

/// The slope of log(error) over log(unknowns) by least squares.
double rate(const std::vector<std::pair<double, double>>& points) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [unknowns, error] : points) {
    const double a = std::log(unknowns), b = std::log(error);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

TEST(Analysis, AtTheReEntrantCornerAdaptedMeshesConvergeAtTheFullRateAndUniformOnesDoNot) {
  // Of the exact error: opening mode of the corner, energy in closed form.
  const std::string exact = R"([[input.curve]]
name = "face_1"
points = [[0, 0], [1, 0]]
[[input.curve]]
name = "loaded"
points = [[1, 0], [1, 1], [-1, 1], [-1, -1], [0, -1]]
[[input.curve]]
name = "face_2"
points = [[0, -1], [0, 0]]
[[input.point]]
name = "origin"
point = [0, 0]
[[input.point]]
name = "far"
point = [0, 1]
[[step]]
operation = "problem"
state = "strain"
[[step.material]]
young = 1.0
[[step.support]]
where = "origin"
x = 0.0
y = 0.0
[[step.support]]
where = "far"
x = 0.0
[[step.load]]
where = "loaded"
kind = "l_shape"
)";
  const auto error_of = [](const Analysis& analysis) {
    return fem::error::true_error(4.15454423, analysis.solution.cases[0].energy);
  };
  for (const int order : {1, 2}) {
    const std::string elements = "order = \"" + std::to_string(order) + "\"\n";
    std::vector<std::pair<double, double>> adapted, uniform;
    for (const double target : order == 1 ? std::vector{10.0, 5.0, 2.5} : std::vector{2.0, 1.0, 0.5, 0.25}) {
      const Analysis analysis = *last(run(exact + adapt_step(target, elements + "max_cycles = 12\n"))).analyses.back();
      EXPECT_LE(100.0 * analysis.eta, target);
      adapted.emplace_back(unknowns_of(analysis), error_of(analysis));
      printf("[ figures  ] corner T%d to %g %%: unknowns %g, exact error %.4f J^0.5\n", 3 * order, target,
             adapted.back().first, adapted.back().second);
    }
    for (const double size : {0.2, 0.1, 0.05}) {
      const std::string mesh = "[[step]]\noperation = \"mesh\"\nsize = " + std::to_string(size) + "\n" + elements +
                               "[[step]]\noperation = \"analyse\"\n";
      const Analysis analysis = *last(run(exact + mesh)).analyses.back();
      uniform.emplace_back(unknowns_of(analysis), error_of(analysis));
    }
    printf("[ figures  ] corner T%d: error as unknowns to the power %.3f adapted, %.3f uniform\n", 3 * order,
           rate(adapted), rate(uniform));
    EXPECT_LT(rate(adapted), -0.95 * 0.5 * order) << order;
    EXPECT_NEAR(rate(uniform), -0.272, 0.02) << order;
  }
}

TEST(Analysis, TheLoopSaysWhenItStopsShort) {
  const scenario::Run done = run(corner + adapt_step(0.1, "max_cycles = 2\n"));
  EXPECT_GT(figures(done).at("eta"), 0.1);
  EXPECT_THAT(last(done).remarks.back(), HasSubstr("after 2 cycles the error is"));
  EXPECT_EQ(last(done).analyses.size(), 2U);
}

TEST(Analysis, TheExampleOfACrackMeetsItsExpectations) {
  const auto document =
      scenario::read_document(std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/examples/quebra/edge_crack.toml")
          .value();
  scenario::Runner runner(core::program());
  const scenario::Run done = runner.run(document);
  ASSERT_TRUE(done.complete()) << to_string(*done.error);
  for (const auto& verdict : scenario::judge(document, core::program(), done))
    EXPECT_TRUE(verdict.met) << verdict.message;
}

const std::string centre_crack = R"([input]
specimen = "centre_crack"
width = 20.0
crack_length = 1.0
[[input.point]]
name = "anchor"
point = [-10, -10]
[[input.point]]
name = "guide"
point = [10, -10]
[[step]]
operation = "problem"
[[step.material]]
young = 1.0
[[step.support]]
where = "anchor"
x = 0.0
y = 0.0
[[step.support]]
where = "guide"
y = 0.0
[[step.load]]
where = "top"
y = 1.0
[[step.load]]
where = "bottom"
y = -1.0
)";

TEST(Analysis, QUE_h_ACentreCrackHasItsIntensityAtBothTips) {
  const scenario::Run done = run(centre_crack +
                                 "[[step]]\noperation = \"mesh\"\nsize = 1.0\norder = \"2\"\nrosettes = "
                                 "\"yes\"\n[[step]]\noperation = \"analyse\"\n[[step]]\noperation = \"crack\"\n");
  const auto values = figures(done);
  for (const std::string tip : {"tip.load.crack_start.", "tip.load.crack_end."}) {
    EXPECT_NEAR(values.at(tip + "K_I"), 1.7835, 0.02 * 1.7835);  // of a long strip; a square plate has 1 % more
    EXPECT_LT(values.at(tip + "spread"), 1.5);
  }
}

/// A bore under a pressure of 1 in a thick ring, plane strain; the radial stress there is -1.
std::string bore(const char* poisson, const char* order) {
  return std::string(R"([[input.curve]]
name = "outer"
kind = "circle"
centre = [0, 0]
radius = 4.0
[[input.curve]]
name = "bore"
kind = "circle"
role = "hole"
centre = [0, 0]
radius = 1.0
[[input.point]]
name = "a"
point = [4, 0]
[[input.point]]
name = "b"
point = [-4, 0]
[[step]]
operation = "problem"
state = "strain"
[[step.support]]
where = "a"
x = 0.0
y = 0.0
[[step.support]]
where = "b"
y = 0.0
[[step.load]]
where = "bore"
kind = "pressure"
value = 1.0
[[step.material]]
young = 1000.0
poisson = )") +
         poisson + "\n[[step]]\noperation = \"mesh\"\nsize = 0.3\norder = \"" + order +
         "\"\n[[step]]\noperation = \"analyse\"\n[[step]]\noperation = \"probe\"\nlabel = \"wall\"\nat = [1, 0]\n";
}

TEST(Analysis, NearIncompressibilityABoreIsRightOrRefused) {
  for (const char* const nu : {"0.3", "0.45", "0.46", "0.49", "0.499", "0.4999999"}) {
    const double stress = figures(run(bore(nu, "2"))).at("probe.wall.load.s_xx");
    printf("[ figures  ] bore, T6, nu %s: radial stress %.3f\n", nu, stress);
    EXPECT_NEAR(stress, -1.0, 0.04) << nu;
  }
  for (const char* const nu : {"0.3", "0.4", "0.45"}) {
    const scenario::Run done = run(bore(nu, "1"));
    printf("[ figures  ] bore, T3, nu %s: radial stress %.3f\n", nu, figures(done).at("probe.wall.load.s_xx"));
    const auto told =
        Contains(HasSubstr("elements of first order begin to lock in plane strain with Poisson's ratio 0.45"));
    EXPECT_EQ(testing::Value(last(done).remarks, told), std::string(nu) == "0.45") << nu;
  }
  for (const char* const nu : {"0.46", "0.4999999"})
    EXPECT_THAT(trouble(bore(nu, "1")), HasSubstr("mesh with order = \"2\""));
  EXPECT_THAT(trouble(bore("0.49999999", "2")), HasSubstr("plane strain needs -1 < nu <= 0.4999999"));
}

TEST(Analysis, BadInputIsNamed) {
  EXPECT_THAT(trouble("[input]\nspecimen = \"cook\"\n[[step]]\noperation = \"analyse\"\n"),
              HasSubstr("put a step 'problem'"));
  EXPECT_THAT(trouble(kirsch_problem + "[[step]]\noperation = \"analyse\"\n"), HasSubstr("put a step 'mesh' before"));
  EXPECT_THAT(trouble(kirsch_problem + "[[step]]\noperation = \"crack\"\n"), HasSubstr("there is no analysis"));
  const std::string solve = "[[step]]\noperation = \"mesh\"\n[[step]]\noperation = \"analyse\"\n";
  std::string wrong = corner;
  wrong.replace(wrong.find("where = \"right\""), 15, "where = \"rihgt\"");
  EXPECT_THAT(trouble(wrong + solve), HasSubstr("load 1: there is no curve or lip 'rihgt'; did you mean 'right'?"));
  EXPECT_THAT(trouble(corner + solve + "[[step]]\noperation = \"crack\"\n"), HasSubstr("the mesh has no crack tips"));
  const std::string rosettes = "[[step]]\noperation = \"mesh\"\nrosettes = \"yes\"\n";
  EXPECT_THAT(trouble(centre_crack + rosettes), HasSubstr("give order = \"2\""));
  EXPECT_THAT(trouble(centre_crack + rosettes + "order = \"2\"\ntip_radius = 0.5\n"),
              HasSubstr("crack tip 'crack_end': its rosette of radius 1.5 m overlaps that of 'crack_start'"));
}

TEST(Analysis, AForceOnACurveHasARemarkWithItsResultantAndTheTractionThatSpreadsIt) {
  const std::string head =
      "[input]\nspecimen = \"l_shape\"\n[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\nthickness = "
      "0.5\n[[step.support]]\nwhere = \"bottom\"\nx = 0.0\ny = 0.0\n[[step.load]]\nwhere = \"right\"\n";
  const std::string steps = "[[step]]\noperation = \"mesh\"\nsize = 10.0\n[[step]]\noperation = \"analyse\"\n";
  const auto done = run(head + "kind = \"force\"\ny = 100.0\n" + steps);
  const auto& mesh = last(done).meshes.back()->mesh;
  const double nodes = static_cast<double>(dobra::fem::find_nodes(mesh, "right")->size());
  const std::string wanted = fmt::format(
      "the force on 'right' acts at each of its {} nodes: (0, {}) N in all, more on a finer mesh; for (0, 100) N "
      "spread over the curve give kind = \"traction\", x = 0 Pa, y = 4 Pa",
      nodes, 100 * nodes);
  EXPECT_THAT(core::program().remarks_of(done.states.back()), testing::Contains(wanted));  // 100 N / (50 m x 0.5 m)
  // That traction has the resultant.
  const auto spread = run(head + "y = 4.0\n" + steps);
  double sum = 0.0;
  for (const auto reaction : last(spread).analyses.back()->solution.cases[0].reactions) sum += reaction.y;
  EXPECT_NEAR(sum, -100.0, 1e-9);
  EXPECT_THAT(core::program().remarks_of(spread.states.back()),
              testing::Not(testing::Contains(testing::HasSubstr("acts at each of its"))));
}

TEST(Analysis, NearlyFlatElementsAreToldWithTheWorstPlace) {
  // A strip 1 high with a side of its top divided so finely that long sides below face short ones, or not.
  const auto remarks = [](const std::string& divisions) {
    const scenario::Run done =
        run("[[input.curve]]\nname = \"bottom\"\npoints = [[0, 0], [10, 0]]\nsegments = " + divisions +
            "\n[[input.curve]]\nname = \"rim\"\npoints = [[10, 0], [10, 0.2], [0, 0.2], [0, 0]]\n" +
            "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\n[[step.support]]\nwhere = "
            "\"bottom\"\nx = 0.0\ny = 0.0\n[[step.load]]\nwhere = \"rim\"\ny = 1.0\n" +
            "[[step]]\noperation = \"mesh\"\nsize = 0.2\nnarrow = 0\n[[step]]\noperation = \"analyse\"\n");
    EXPECT_TRUE(done.complete()) << to_string(*done.error);
    return last(done).remarks;
  };
  EXPECT_THAT(remarks("2"), testing::Contains(testing::AllOf(testing::HasSubstr("the worst at ("),
                                                             testing::HasSubstr("take a smaller size there"))));
  EXPECT_THAT(remarks("50"), testing::Not(testing::Contains(testing::HasSubstr("nearly flat elements"))));
}

}  // namespace
}  // namespace quebra::analysis
