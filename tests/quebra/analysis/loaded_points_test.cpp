// Forces at single points, against Flamant's field of a force on a straight edge, whose error outside any disc is
// known.

#include "quebra/analysis/loaded_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "shared/fem/stress.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::analysis {
namespace {

using namespace dobra;
using namespace test;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Lower half of a square with a force of 1 N downwards in the middle of its upper edge, and Flamant's tractions on the
/// rest.
std::string half_plane(const std::string& at_the_load) {
  return R"([[input.curve]]
name = "rim"
points = [[-1, 0], [-1, -1], [1, -1], [1, 0]]
[[input.curve]]
name = "top"
points = [[1, 0], [-1, 0]]
[[input.point]]
name = "load"
point = [0, 0]
[[input.point]]
name = "foot"
point = [0, -1]
[[input.point]]
name = "guide"
point = [1, -1]
[[step]]
operation = "problem"
[[step.material]]
young = 1.0
poisson = 0.3
[[step.load]]
where = "rim"
kind = "stress"
stress_xx = "2 / pi * x^2 * y / (x^2 + y^2)^2"
stress_yy = "2 / pi * y^3 / (x^2 + y^2)^2"
stress_xy = "2 / pi * x * y^2 / (x^2 + y^2)^2"
)" + at_the_load;
}
const std::string pressed = half_plane(
    "[[step.support]]\nwhere = \"foot\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"guide\"\ny = "
    "0.0\n[[step.load]]\nwhere = \"load\"\nkind = \"force\"\ny = -1.0\n");
const std::string propped =
    half_plane("[[step.support]]\nwhere = \"load\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"foot\"\nx = 0.0\n");

/// Of the stress outside the neighbourhoods that the analysis leaves out.
double true_error_outside(const Analysis& analysis) {
  const auto& mesh = analysis.meshed->mesh;
  const fem::Material& material = analysis.problem.materials.begin()->second;
  const fem::Elasticity d = fem::elasticity(material);
  double sum = 0.0;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const fem::ElementGeometry element = fem::geometry_of(mesh, e);
    const auto points = fem::integration_points(element.type, fem::Rule::Curved);
    const auto shapes = fem::shapes_at(element.type, fem::Rule::Curved);
    for (std::size_t g = 0; g < points.size(); ++g) {
      const fem::Mapped m = fem::map(element.points(), shapes[g]);
      const LoadedPoint& load = analysis.fields[0].loaded.front();
      if (distance(m.at, load.at) < load.radius) continue;
      const auto [x, y] = m.at;
      const double factor = 2.0 / std::numbers::pi / std::pow(x * x + y * y, 2);
      fem::Voigt difference =
          fem::ElementSolution(element, material, analysis.solution.cases[0].displacements).stress(m);
      const fem::Voigt exact{factor * x * x * y, factor * y * y * y, factor * x * y * y};
      for (std::size_t k = 0; k < 3; ++k) difference[k] -= exact[k];
      sum += m.determinant * points[g].weight * fem::energy_product(d, difference, difference);
    }
  }
  return std::sqrt(sum);
}

TEST(LoadedPoints, TheLoopMeetsItsTargetOutsideThemAndJudgesTheErrorThereWell) {
  for (const std::string& problem : {pressed, propped}) {
    for (const auto& [target, order] : {std::pair{10.0, 1}, {5.0, 1}, {5.0, 2}, {2.0, 2}, {1.0, 2}, {0.5, 2}}) {
      const scenario::Run done =
          run(problem + "[[step]]\noperation = \"adapt\"\nmax_cycles = 12\ntarget = " + std::to_string(target) +
              "\norder = \"" + std::to_string(order) + "\"\n");
      const auto values = figures(done);
      const Analysis& analysis = *last(done).analyses.back();
      ASSERT_EQ(analysis.fields[0].loaded.size(), 1U);
      EXPECT_EQ(analysis.fields[0].loaded[0].name, "load");
      EXPECT_NEAR(analysis.fields[0].loaded[0].radius, 0.05, 1e-9);
      EXPECT_LE(values.at("eta"), target);
      EXPECT_FALSE(last(done).short_of_target);
      const double effectivity = values.at("case.load.error") / true_error_outside(analysis);
      EXPECT_GT(effectivity, 0.85) << target << " % T" << 3 * order;
      EXPECT_LT(effectivity, 1.2) << target << " % T" << 3 * order;
      printf(
          "[ figures  ] force at a point, T%d, %g %%: cycles %g, unknowns %g, eta %.2f %%, effectivity outside %.3f, "
          "left out %.1f %% of the energy\n",
          3 * order, target, values.at("cycles"), values.at("unknowns"), values.at("eta"), effectivity,
          values.at("case.load.left_out"));
    }
  }
}

TEST(LoadedPoints, AreToldAndCountIfTheUserAsksForIt) {
  const std::string adapt = "[[step]]\noperation = \"adapt\"\ntarget = 2.0\nmax_cycles = 6\n";
  EXPECT_THAT(
      last(run(pressed + adapt)).remarks,
      Contains(HasSubstr(
          "forces at single points ('load') have an infinite energy: their surroundings of radius 0.05 m hold")));
  const scenario::Run counted = run(pressed + adapt + "point_forces = \"count\"\n");
  EXPECT_TRUE(last(counted).short_of_target);
  EXPECT_THAT(last(counted).remarks, Contains(HasSubstr("('load') have an infinite energy, which no mesh meets")));
  EXPECT_EQ(figures(counted).at("case.load.left_out"), 0.0);
  // A radius of one's own; the same judgement in `analyse`.
  const scenario::Run once = run(
      pressed + "[[step]]\noperation = \"mesh\"\nsize = 0.05\n[[step]]\noperation = \"analyse\"\npoint_radius = 0.2\n");
  EXPECT_THAT(last(once).remarks, Contains(HasSubstr("of radius 0.2 m hold")));
  EXPECT_GT(figures(once).at("case.load.left_out"), 5.0);
  EXPECT_THAT(trouble(pressed + adapt + "point_radius = 3.0\n"),
              HasSubstr("hold 100 % of the energy, and nothing is left to judge: give a smaller point_radius"));
}

TEST(LoadedPoints, SupportsWithoutAReactionAndPointsOfHeldCurvesAreNone) {
  const std::string plate =
      "[input]\nspecimen = \"plate_with_hole\"\n[[input.point]]\nname = \"anchor\"\npoint = [-5, "
      "-5]\n[[input.point]]\nname = \"guide\"\npoint = [5, -5]\n[[step]]\noperation = "
      "\"problem\"\n[[step.material]]\nyoung = 1.0\n";
  const std::string pulled = "[[step.load]]\nwhere = \"top\"\ny = 1.0\n";
  const std::string analyse =
      "[[step]]\noperation = \"mesh\"\nsize = 1.0\norder = \"2\"\n[[step]]\noperation = \"analyse\"\n";
  const auto held = [](const char* where, const char* how) {
    return std::string("[[step.support]]\nwhere = \"") + where + "\"\n" + how + "\n";
  };
  const auto loaded = [&](const std::string& problem) {
    return names_of(last(run(plate + pulled + problem + analyse)).analyses.back()->fields[0].loaded);
  };
  EXPECT_EQ(loaded(held("anchor", "x = 0.0\ny = 0.0") + held("guide", "y = 0.0") +
                   "[[step.load]]\nwhere = \"bottom\"\ny = -1.0\n"),
            "");
  EXPECT_EQ(loaded(held("bottom", "y = 0.0") + held("anchor", "x = 0.0")), "");
  EXPECT_EQ(loaded(held("anchor", "x = 0.0\ny = 0.0") + held("guide", "y = 0.0")), "'anchor', 'guide'");
  EXPECT_EQ(loaded(held("bottom", "y = 0.0") + held("anchor", "x = 0.0") +
                   "[[step.load]]\nwhere = \"guide\"\nkind = \"force\"\nx = 1.0\ny = -9.0\n"),
            "'anchor', 'guide'");
  EXPECT_EQ(loaded(held("bottom", "y = 0.0") + held("anchor", "x = 0.0") +
                   "[[step.load]]\nwhere = \"guide\"\nkind = \"force\"\ny = -9.0\n"),
            "");
  EXPECT_EQ(loaded(held("anchor", "x = 0.0") +
                   "[[step.spring]]\nwhere = \"anchor\"\ny = 1.0\n[[step.support]]\nwhere = \"guide\"\ny = 0.0\n"),
            "'anchor', 'guide'");
}

TEST(LoadedPoints, TheRadiusIsATwentiethOfTheRoom) {
  const domain::Domain beam = last(run("[input]\nspecimen = \"three_point_bend\"\n")).domain;
  EXPECT_NEAR(radius_round(beam, {0.0, 1.0}), 0.5 / 20.0, 1e-12);  // the crack's tip is below
  EXPECT_NEAR(radius_round(beam, {-2.0, 0.0}), 1.0 / 20.0, 1e-12);
  const domain::Domain disc = last(run("[input]\nspecimen = \"brazilian_disc\"\ncrack_length = 0.1\n")).domain;
  EXPECT_NEAR(radius_round(disc, {0.0, 1.0}), 1.0 / 20.0, 1e-3);
  const domain::Domain plate =
      last(run("[input]\nspecimen = \"plate_with_hole\"\n[[input.point]]\nname = \"inside\"\npoint = [3, 0]\n")).domain;
  EXPECT_NEAR(radius_round(plate, {3.0, 0.0}), 2.0 / 20.0, 1e-3);
  EXPECT_NEAR(radius_round(plate, {-5.0, -5.0}), 6.0 / 20.0, 0.02);  // along the diagonal to the hole
  // Wherever on a side or a closed curve the point lies, the thickness there counts.
  const auto with = [](const std::string& input) { return last(run("[input]\n" + input)).domain; };
  const domain::Domain strip = with(
      "[[input.curve]]\nname = \"side\"\nkind = \"polygon\"\npoints = [[0, 1], [0, 0], [100, 0], [100, "
      "1]]\n[[input.point]]\nname = \"by_the_corner\"\npoint = [0.05, 1.0]\n");
  EXPECT_NEAR(radius_round(strip, {0.05, 1.0}), 1.0 / 20.0, 1e-9);
}

TEST(LoadedPoints, APointOfASymmetryLineKeepsWhatActsAlongIt) {
  const std::string half =
      "[input]\nspecimen = \"plate_with_hole\"\n[[input.point]]\nname = \"guide\"\npoint = [5, "
      "-5]\n[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\n";
  const std::string rest =
      "[[step.load]]\nwhere = \"guide\"\nkind = \"force\"\nx = 1.0\ny = -9.0\n[[step.support]]\nwhere = "
      "\"left\"\nnormal = 0.0\n[[step]]\noperation = \"mesh\"\nsize = 1.0\n[[step]]\noperation = \"analyse\"\n";
  for (const char* const how : {"y = 0.0", "normal = 0.0"}) {
    const auto loaded = last(run(half + "[[step.support]]\nwhere = \"bottom\"\n" + how + "\n" + rest))
                            .analyses.back()
                            ->fields[0]
                            .loaded;
    ASSERT_EQ(names_of(loaded), "'guide'") << how;
    EXPECT_NEAR(loaded[0].force.x, 1.0, 1e-9) << how;
    EXPECT_NEAR(loaded[0].force.y, 0.0, 1e-9) << how;
  }
}

TEST(LoadedPoints, ThreePointBendReachesFivePercent) {
  const std::string beam =
      "[input]\nspecimen = \"three_point_bend\"\n[[step]]\noperation = \"problem\"\nstate = "
      "\"strain\"\n[[step.material]]\nyoung = 1.0\npoisson = 0.3\n[[step.support]]\nwhere = \"support_left\"\ny = 0.0\n"
      "[[step.support]]\nwhere = \"support_right\"\ny = 0.0\n[[step.support]]\nwhere = \"load\"\nx = "
      "0.0\n[[step.load]]\nwhere = \"load\"\nkind = \"force\"\ny = -1.0\n";
  for (const char* const more : {"order = \"1\"\n", "", "rosettes = \"yes\"\n"}) {
    for (const double target : {5.0, 1.0}) {
      if (target < 5.0 && std::string(more).starts_with("order")) continue;
      const scenario::Run done = run(beam + "[[step]]\noperation = \"adapt\"\ntarget = " + std::to_string(target) +
                                     "\nmax_cycles = 12\n" + more);
      const auto values = figures(done);
      EXPECT_LE(values.at("eta"), target) << more;
      EXPECT_LT(values.at("case.load.left_out"), 8.0) << more;
      EXPECT_FALSE(last(done).short_of_target) << more << (last(done).remarks.empty() ? "" : last(done).remarks.back());
      printf(
          "[ figures  ] three-point bend, %s, %g %%: cycles %g, unknowns %g, eta %.2f %%, left out %.2f %% of the "
          "energy\n",
          *more == '\0'  ? "T6"
          : *more == 'r' ? "T6 and rosettes"
                         : "T3",
          target, values.at("cycles"), values.at("unknowns"), values.at("eta"), values.at("case.load.left_out"));
    }
  }
}

TEST(LoadedPoints, TheGreatestStressOfAForceAtAPointIsToldWithThatElsewhere) {
  const auto remark_of = [](double size) {
    const auto done = run(pressed + "[[step]]\noperation = \"mesh\"\norder = \"2\"\nsize = " + std::to_string(size) +
                          "\n[[step]]\noperation = \"analyse\"\n");
    std::string found;
    for (const std::string& remark : core::program().remarks_of(done.states.back()))
      found += remark.starts_with("max_von_mises") ? remark : "";
    return std::pair(found, figures(done).at("case.load.max_von_mises"));
  };
  const auto [coarse, most] = remark_of(0.1);
  EXPECT_THAT(coarse, HasSubstr("is that of a force at a single point"));
  const auto [fine, more] = remark_of(0.02);
  EXPECT_GT(more, 2.0 * most);
  const auto elsewhere = [](const std::string& remark) { return std::stod(remark.substr(remark.rfind("it is ") + 6)); };
  // Flamant's stress 2 F / (pi r) at the radius left out, on a mesh that has nodes near it.
  const double radius = radius_round(last(run(pressed)).domain, {0, 0});
  EXPECT_NEAR(elsewhere(fine), 2.0 / std::numbers::pi / radius, 0.3 * elsewhere(fine));
}

TEST(LoadedPoints, TheDisplacementUnderAForceGrowsAsTheRemarkSays) {
  // Flamant: u grows by 2 F ln 2 / (pi E t) each time the elements are halved.
  const auto under = [](double size) {
    const std::string input = pressed;
    const auto at = input.find("point = [0, 0]\n") + std::string("point = [0, 0]\n").size();
    const scenario::Run done =
        run(input.substr(0, at) + "size = " + std::to_string(size) + "\n" + input.substr(at) +
            "[[step]]\noperation = \"mesh\"\nsize = 0.2\norder = \"2\"\n[[step]]\noperation = \"analyse\"\n");
    EXPECT_THAT(last(done).remarks,
                Contains(HasSubstr("on a straight edge by up to 0.44 m each time the elements there are halved")))
        << size;
    return figures(done).at("case.load.point.load.u_y");
  };
  const double coarse = under(0.04), middle = under(0.02), fine = under(0.01);
  printf("[ figures  ] displacement under 1 N: %.4f, %.4f, %.4f\n", coarse, middle, fine);
  const double growth = 2.0 * std::numbers::ln2 / std::numbers::pi;
  EXPECT_NEAR(coarse - middle, growth, 0.1 * growth);
  EXPECT_NEAR(middle - fine, growth, 0.1 * growth);
}

TEST(LoadedPoints, ElementsTooCoarseForTheirSurroundingsAreTold) {
  const auto remarks = [](const std::string& mesh, const std::string& judged = "") {
    return last(run(pressed + "[[step]]\noperation = \"mesh\"\norder = \"2\"\n" + mesh +
                    "[[step]]\noperation = \"analyse\"\n" + judged))
        .remarks;
  };
  const auto coarse = remarks("size = 0.4\n", "point_radius = 0.001\n");
  EXPECT_THAT(coarse, Contains(AllOf(HasSubstr("the elements at 'load' (0, 0)"), HasSubstr("surroundings of 0.001 m"),
                                     HasSubstr("a size of 0.0005 m"))));
  EXPECT_THAT(coarse, Not(Contains(HasSubstr("hold 0 %"))));
  EXPECT_THAT(remarks("size = 0.05\n", "point_radius = 0.2\n"), Not(Contains(HasSubstr("the elements at 'load'"))));
}

}  // namespace
}  // namespace quebra::analysis
