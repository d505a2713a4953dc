// Forces, springs, supports and ties at points on cracks: one force acts once, whatever number of nodes the point has,
// and each lip can be named. Intensities of wedge forces against their closed forms.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "shared/fem/assemble.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::analysis {
namespace {

using namespace dobra;
using namespace test;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// A plate 4 x 4 with side "bottom" and the rest "rim".
const std::string bare_plate = R"([[input.curve]]
name = "bottom"
points = [[0, 0], [4, 0]]
[[input.curve]]
name = "rim"
points = [[4, 0], [4, 4], [0, 4], [0, 0]]
)";
std::string crack_input(const std::string& name, const std::string& points) {
  return "[[input.crack]]\nname = \"" + name + "\"\npoints = " + points + "\n";
}
std::string line_input(const std::string& name, const std::string& points) {
  return "[[input.curve]]\nrole = \"internal\"\nname = \"" + name + "\"\npoints = " + points + "\n";
}
std::string point(const std::string& at) { return "[[input.point]]\nname = \"p\"\npoint = " + at + "\n"; }
const std::string soft_problem = "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 100.0\npoisson = 0.2\n";
const std::string held = "[[step.support]]\nwhere = \"bottom\"\nx = 0.0\ny = 0.0\n";
std::string force(const std::string& where, double x, double y, const std::string& load_case = "load") {
  return "[[step.load]]\nkind = \"force\"\nwhere = \"" + where + "\"\nx = " + std::to_string(x) +
         "\ny = " + std::to_string(y) + "\ncase = \"" + load_case + "\"\n";
}
const std::string analyse_step =
    "[[step]]\noperation = \"mesh\"\nsize = 0.5\norder = \"2\"\n[[step]]\noperation = \"analyse\"\n";

struct Balance {
  geom::Vector applied, reactions;
};
Balance balance_of(const Analysis& analysis, std::size_t c) {
  Balance sum;
  for (const geom::Vector f : fem::load_vector(analysis.meshed->mesh, analysis.problem, analysis.problem.cases[c]))
    sum.applied = sum.applied + f;
  for (const geom::Vector r : analysis.solution.cases[c].reactions) sum.reactions = sum.reactions + r;
  return sum;
}

struct Place {
  const char* name;
  std::string input;
  std::size_t nodes;              ///< Of the point.
  std::vector<std::string> lips;  ///< Names of those on one lip.
};

/// Points where a crack gives several nodes, and where it does not.
std::vector<Place> places() {
  const std::vector<std::string> two{"p_left", "p_right"};
  const std::vector<std::string> four{"p_a_left", "p_a_right", "p_b_left", "p_b_right"};
  const std::string inner = crack_input("a", "[[1, 2], [3, 2]]");
  return {{"in the middle of a crack", inner + point("[2, 2]"), 2, two},
          {"at a corner of a crack", crack_input("a", "[[1, 2], [2, 2.3], [3, 2]]") + point("[2, 2.3]"), 2, two},
          {"at a mouth", crack_input("a", "[[0, 2], [2, 2]]") + point("[0, 2]"), 2, two},
          {"at a crossing", inner + crack_input("b", "[[2, 1], [2, 3]]") + point("[2, 2]"), 4, four},
          {"at a branch", inner + crack_input("b", "[[2, 2], [2, 3]]") + point("[2, 2]"), 3, four},
          {"at two mouths",
           crack_input("a", "[[0, 2], [2, 3]]") + crack_input("b", "[[0, 2], [2, 1]]") + point("[0, 2]"), 3, four},
          {"at a tip", inner + point("[3, 2]"), 1, {}},
          {"at a tip on an internal line",
           crack_input("a", "[[1, 2], [2, 2]]") + line_input("b", "[[2, 1], [2, 3]]") + point("[2, 2]"),
           1,
           {}},
          {"on an internal line", line_input("b", "[[1, 2], [3, 2]]") + point("[2, 2]"), 1, {}}};
}

TEST(CrackPoints, AForceActsOnceWhateverNodesThePointHas) {
  for (const Place& place : places()) {
    std::string loads = force("p", 3.0, -2.0);
    for (const std::string& lip : place.lips) loads += force(lip, 1.0, 5.0, lip);
    const scenario::Run done = run(bare_plate + place.input + soft_problem + held + loads + analyse_step);
    ASSERT_TRUE(done.complete()) << place.name << ": " << to_string(*done.error);
    const Analysis& analysis = *last(done).analyses.back();
    EXPECT_EQ(analysis.meshed->mesh.node_sets.at("p").size(), place.nodes) << place.name;
    ASSERT_EQ(analysis.problem.cases.size(), 1 + place.lips.size()) << place.name;
    for (std::size_t c = 0; c < analysis.problem.cases.size(); ++c) {
      const auto [applied, reactions] = balance_of(analysis, c);
      const geom::Vector given = c == 0 ? geom::Vector{3.0, -2.0} : geom::Vector{1.0, 5.0};
      EXPECT_LT(length(applied - given), 1e-12) << place.name << c;
      EXPECT_LT(length(reactions + given), 1e-9) << place.name << c;
    }
    const auto shared = Contains(HasSubstr("'p' lies on a crack and has " + std::to_string(place.nodes) + " nodes ('"));
    if (place.nodes > 1) {
      EXPECT_THAT(last(done).remarks, shared) << place.name;
      continue;
    }
    EXPECT_THAT(last(done).remarks, Not(Contains(HasSubstr("lies on a crack")))) << place.name;
    EXPECT_THAT(trouble(bare_plate + place.input + soft_problem + held + force("p_left", 1, 0) + analyse_step),
                HasSubstr("there is no curve, lip or point 'p_left'"))
        << place.name;
  }
}

TEST(CrackPoints, TheNodesOfALipAreItsOwn) {
  const Place crossing = places()[3];
  const scenario::Run done = run(bare_plate + crossing.input + "[[step]]\noperation = \"mesh\"\nsize = 0.5\n");
  const auto& mesh = last(done).meshes.back()->mesh;
  // The copies on the left of a have all their elements above it, those on the left of b (which goes up) to its left.
  const auto middle_of = [&](const std::string& set) {
    geom::Vector sum;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      const auto nodes = mesh.nodes_of(mesh::ElementId(e));
      for (const mesh::NodeId own : mesh.node_sets.at(set)) {
        if (std::find(nodes.begin(), nodes.end(), own) == nodes.end()) continue;
        for (const mesh::NodeId node : nodes) sum = sum + (mesh.point(node) - geom::Point{2, 2});
      }
    }
    return sum;
  };
  EXPECT_EQ(mesh.node_sets.at("p_a_left").size(), 2U);
  EXPECT_GT(middle_of("p_a_left").y, 0.5);
  EXPECT_LT(middle_of("p_a_right").y, -0.5);
  EXPECT_LT(middle_of("p_b_left").x, -0.5);
  EXPECT_GT(middle_of("p_b_right").x, 0.5);
}

TEST(CrackPoints, ASpringCountsOnceAndASupportHoldsBothLipsOrTheOneNamed) {
  const std::string input = bare_plate + crack_input("a", "[[0, 2], [2, 2]]") + point("[0, 2]") + soft_problem;
  const std::string pulled = "[[step.load]]\nwhere = \"rim\"\nx = 0.25\n";
  const std::string roller = "[[step.support]]\nwhere = \"bottom\"\ny = 0.0\n";
  const scenario::Run done = run(input + roller + pulled + "[[step.spring]]\nwhere = \"p\"\nx = 8.0\n" + analyse_step);
  const auto sprung = figures(done);
  const geom::Vector applied = balance_of(*last(done).analyses.back(), 0).applied;  // nothing else bears it along x
  EXPECT_NEAR(4.0 * (sprung.at("case.load.point.p_left.u_x") + sprung.at("case.load.point.p_right.u_x")), applied.x,
              1e-8);
  EXPECT_THAT(last(done).remarks, Contains(HasSubstr("each has an equal part of the spring")));

  const auto support = [](const char* where) {
    return std::string("[[step.support]]\nwhere = \"") + where + "\"\nx = 0.0\ny = 0.0\n";
  };
  const std::string load = "[[step.load]]\nwhere = \"rim\"\ny = 1.0\n";
  const scenario::Run both = run(input + held + support("p") + load + analyse_step);
  EXPECT_EQ(figures(both).at("case.load.point.p_left.u_y"), 0.0);
  EXPECT_EQ(figures(both).at("case.load.point.p_right.u_y"), 0.0);
  EXPECT_THAT(last(both).remarks, Contains(HasSubstr("the support holds all of them")));
  const auto one = figures(run(input + held + support("p_right") + load + analyse_step));
  EXPECT_GT(one.at("case.load.point.p_left.u_y"), 1e-3);
  EXPECT_EQ(one.at("case.load.point.p_right.u_y"), 0.0);
}

TEST(CrackPoints, ATieAsksForTheLip) {
  const std::string input = bare_plate + crack_input("a", "[[1, 2], [3, 2]]") + point("[2, 2]") + soft_problem + held;
  const auto tie = [](const char* a, const char* b) {
    return std::string("[[step.tie]]\npoints = [\"") + a + "\", \"" + b +
           "\"]\naxes = [\"y\", \"y\"]\ncoefficients = [1.0, -1.0]\n";
  };
  EXPECT_THAT(trouble(input + tie("p", "a_end") + analyse_step),
              HasSubstr("point 'p' lies on a crack and moves with each lip by itself; tie one of 'p_left', 'p_right'"));
  const auto tied =
      figures(run(input + tie("p_left", "p_right") + "[[step.load]]\nwhere = \"rim\"\ny = 1.0\n" + analyse_step));
  EXPECT_NEAR(tied.at("case.load.point.p_left.u_y"), tied.at("case.load.point.p_right.u_y"), 1e-12);
}

/// Cracks of half length 1 in the middle of a plate 40 times as wide, with forces of 1 N on the lips at x = b.
std::string wedged(double b, const std::string& forces, const std::string& mesh = "size = 8.0\n",
                   const std::string& crack_step = "") {
  return "[[input.curve]]\nname = \"rim\"\nkind = \"polygon\"\npoints = [[-40, -40], [40, -40], [40, 40], [-40, "
         "40]]\n" +
         crack_input("a", "[[-1, 0], [1, 0]]") + point("[" + std::to_string(b) + ", 0]") +
         "[[input.point]]\nname = \"anchor\"\npoint = [-40, -40]\n[[input.point]]\nname = \"guide\"\npoint = [40, "
         "-40]\n" +
         soft_problem +
         "[[step.support]]\nwhere = \"anchor\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"guide\"\ny = 0.0\n" +
         forces + "[[step]]\noperation = \"mesh\"\norder = \"2\"\nrosettes = \"yes\"\n" + mesh +
         "[[step]]\noperation = \"analyse\"\n[[step]]\noperation = \"crack\"\n" + crack_step;
}
const std::string opened = force("p_left", 0.0, 1.0) + force("p_right", 0.0, -1.0);
/// K of a crack of half length 1 with wedge forces of 1 N at b, at x = sign.
double wedge_intensity(double b, double sign) {
  return std::sqrt((1.0 + sign * b) / (1.0 - sign * b) / std::numbers::pi);
}

TEST(CrackPoints, WedgeForcesHaveTheIntensityOfTheirClosedForm) {
  for (const double b : {0.0, 0.5, -0.25, 0.9, 0.99}) {
    const scenario::Run done = run(wedged(b, opened));
    const auto values = figures(done);
    EXPECT_THAT(last(done).remarks, Not(Contains(HasSubstr("part by more than")))) << b;
    for (const auto& [tip, sign] : {std::pair{"a_end", 1.0}, {"a_start", -1.0}}) {
      const double exact = wedge_intensity(b, sign);
      const std::string name = std::string("tip.load.") + tip;
      printf("[ figures  ] wedge at %g, %s: K_I %.4f, closed form %.4f, %+.2f %%; spread %.2f %%, contour %.3f\n", b,
             tip, values.at(name + ".K_I"), exact, 100.0 * (values.at(name + ".K_I") / exact - 1.0),
             values.at(name + ".spread"), values.at(name + ".contour"));
      EXPECT_NEAR(values.at(name + ".K_I"), exact, 0.005 * exact) << b << tip;
      EXPECT_NEAR(values.at(name + ".K_II"), 0.0, 0.005 * exact) << b << tip;
      EXPECT_NEAR(values.at(name + ".J"), exact * exact / 100.0, 0.01 * exact * exact / 100.0) << b << tip;
      EXPECT_LE(values.at(name + ".contour"), 0.5 * (1.0 - sign * b) + 1e-9) << b << tip;  // far from the force
      EXPECT_LT(values.at(name + ".spread"), 1.0) << b << tip;
    }
  }
  // Along the lips: K_II.
  const auto sheared = figures(run(wedged(0.0, force("p_left", 1.0, 0.0) + force("p_right", -1.0, 0.0))));
  EXPECT_NEAR(std::abs(sheared.at("tip.load.a_end.K_II")), std::sqrt(1.0 / std::numbers::pi), 0.005);
}

TEST(CrackPoints, JIsLeftOutWhereItsRingCannotKeepClearOfTheForce) {
  // Elements of the tip as long as 1/8 of the way to the force, and a ring that is asked to go nearly there.
  const scenario::Run near = run(wedged(0.9, opened, "size = 8.0\ntip_radius = 0.0125\n", "contour = 0.095\n"));
  const auto values = figures(near);
  EXPECT_FALSE(values.contains("tip.load.a_end.J"));
  EXPECT_NEAR(values.at("tip.load.a_end.K_I"), wedge_intensity(0.9, 1.0), 0.005 * wedge_intensity(0.9, 1.0));
  EXPECT_THAT(last(near).remarks, Contains(AllOf(HasSubstr("crack tip 'a_end' at (1, 0)"), HasSubstr("J is not given"),
                                                 HasSubstr("(0.9, 0), 0.1 m from the tip"))));
  EXPECT_TRUE(values.contains("tip.load.a_start.J"));  // far from the force
  EXPECT_THAT(last(near).remarks, Not(Contains(AllOf(HasSubstr("'a_start'"), HasSubstr("J is not given")))));
  // A ring that would hold the force is refused with its place.
  const scenario::Run beyond = run(wedged(0.9, opened, "size = 8.0\ntip_radius = 0.0125\n", "contour = 0.2\n"));
  EXPECT_THAT(last(beyond).remarks, Contains(AllOf(HasSubstr("'a_end' at (1, 0) has no K"),
                                                   HasSubstr("the node at (0.9, 0): at most 0.1 m"))));
}

TEST(CrackPoints, AForceOnTheTipItselfIsNoCrackTipAnyMore) {
  const scenario::Run done = run(wedged(1.0, force("p", 1.0, 0.0)));
  EXPECT_THAT(last(done).remarks, Contains(AllOf(HasSubstr("'a_end'"), HasSubstr("a force acts on the tip itself"))));
  EXPECT_TRUE(figures(done).contains("tip.load.a_start.K_I"));
}

TEST(CrackPoints, NodalForcesAlongALipBoundTheRingToo) {
  // 1 N at every node of the lip: what the rings hold of them is not known to J.
  const scenario::Run done = run(wedged(0.0,
                                        "[[step.load]]\nkind = \"force\"\nwhere = \"a_left\"\ny = "
                                        "1.0\n[[step.load]]\nkind = \"force\"\nwhere = \"a_right\"\ny = -1.0\n"));
  ASSERT_TRUE(done.error.has_value());
  EXPECT_THAT(to_string(*done.error), HasSubstr("a force acts on the tip itself"));
}

TEST(CrackPoints, FiguresThatPartAreTold) {
  // Displacement correlation from elements as long as 1/4 of the way to the force is 5 % off.
  const scenario::Run coarse = run(wedged(0.95, opened, "size = 8.0\ntip_radius = 0.0125\n"));
  EXPECT_GT(figures(coarse).at("tip.load.a_end.spread"), 2.0);
  EXPECT_THAT(last(coarse).remarks,
              Contains(AllOf(HasSubstr("crack tip 'a_end' at (1, 0)"), HasSubstr("part by more than 2 %"),
                             HasSubstr("by displacement correlation"),
                             HasSubstr("0.0125 m long, in a room of 0.05 m: try tip_radius"))));
  EXPECT_THAT(last(coarse).remarks, Not(Contains(AllOf(HasSubstr("'a_start'"), HasSubstr("part by more than")))));
}

TEST(CrackPoints, TheOpeningUnderAForceIsToldToGrowWithoutEnd) {
  EXPECT_THAT(last(run(wedged(0.5, opened))).remarks,
              Contains(AllOf(HasSubstr("'p_left'"), HasSubstr("and how far a crack opens there"),
                             HasSubstr("grow without end"))));
  const std::string spread =
      "[[step.load]]\nkind = \"pressure\"\nwhere = \"a_left\"\nvalue = 1.0\n[[step.load]]\nkind = \"pressure\"\nwhere "
      "= \"a_right\"\nvalue = 1.0\n";
  EXPECT_THAT(last(run(wedged(0.5, spread))).remarks, Not(Contains(HasSubstr("grow without end"))));
}

}  // namespace
}  // namespace quebra::analysis
