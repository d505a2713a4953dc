#include "quebra/domain/selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "quebra/analysis/analysis.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::domain {
namespace {

using dobra::geom::Point;
using testing::ElementsAre;
using testing::HasSubstr;

/// A drawn rectangle is one curve; a round hole in it.
const std::string holed_plate = R"(
[[input.curve]]
name = "outline"
kind = "polygon"
points = [[0, 0], [4, 0], [4, 2], [0, 2]]
[[input.curve]]
name = "hole"
kind = "circle"
role = "hole"
centre = [2.0, 1.0]
radius = 0.5
)";

Domain domain_of(const std::string& input) {
  const auto run = test::run(input);
  EXPECT_TRUE(run.complete()) << (run.error ? to_string(*run.error) : "");
  return run.complete() ? test::last(run).domain : Domain{};
}

/// Length of the parts of the boundary where the condition holds.
double selected(const Domain& domain, const std::string& condition) {
  const auto selection = select(domain, condition);
  EXPECT_TRUE(selection.ok()) << condition << ": " << (selection ? "" : to_string(selection.error()));
  double sum = 0.0;
  if (selection) {
    for (const CurvePart& part : selection->parts) sum += part.to - part.from;
  }
  return sum;
}

std::string refusal(const Domain& domain, const std::string& condition) {
  const auto selection = select(domain, condition);
  EXPECT_FALSE(selection.ok()) << condition;
  return selection ? "" : to_string(selection.error());
}

TEST(Selection, SidesOfADrawnOutlineAreFoundByTheirPlace) {
  const Domain domain = domain_of(holed_plate);
  EXPECT_DOUBLE_EQ(selected(domain, "x = 0"), 2.0);
  EXPECT_DOUBLE_EQ(selected(domain, "y == 2"), 4.0);
  EXPECT_DOUBLE_EQ(selected(domain, "x = 0 or x = 4"), 4.0);
  EXPECT_DOUBLE_EQ(selected(domain, "x >= 4 and 0 <= y <= 2"), 2.0);
  EXPECT_NEAR(selected(domain, "hypot(x - 2, y - 1) = 0.5"), std::numbers::pi, 1e-12);
  EXPECT_NEAR(selected(domain, "(x - 2)^2 + (y - 1)^2 <= 0.25"), std::numbers::pi, 1e-12);
  EXPECT_NEAR(selected(domain, "y >= 0"), 12.0 + std::numbers::pi, 1e-12);
  // A slanted side too, to rounding of its own.
  const Domain slanted =
      domain_of("[[input.curve]]\nname = \"t\"\nkind = \"polygon\"\npoints = [[0, 0], [3, 1], [0.1, 2.7]]\n");
  EXPECT_DOUBLE_EQ(selected(slanted, "y = x / 3"), std::sqrt(10.0));
}

TEST(Selection, WhatHoldsNowhereListsWhatThereIs) {
  const Domain domain = domain_of(holed_plate);
  const std::string told = refusal(domain, "x = 5");
  EXPECT_THAT(told, HasSubstr("'outline' from (0, 0) to (4, 0)"));
  EXPECT_THAT(told, HasSubstr("'hole', closed, through (2.5, 1)"));
  // A millionth of the diagonal is near enough, ten are not.
  EXPECT_DOUBLE_EQ(selected(domain, "x = 4.000004"), 2.0);
  EXPECT_THAT(refusal(domain, "x = 4.00005"), HasSubstr("holds for no side"));
  EXPECT_THAT(refusal(domain, "x = "), HasSubstr("a side of a comparison is missing"));
  EXPECT_THAT(refusal(domain, "x = 0 and y"), HasSubstr("'y' compares nothing"));
  EXPECT_THAT(refusal(domain, "z = 0"), HasSubstr("'z'"));
  EXPECT_THAT(refusal(domain, "x != 0"), HasSubstr("'!'"));
}

TEST(Selection, AStretchOfASideIsRefusedUntilAPointEndsIt) {
  const Domain domain = domain_of(holed_plate);
  for (const std::string condition : {"y = 2 and x > 1", "x = 0 and y < 0.01", "hypot(x, y) < 3"})
    EXPECT_THAT(refusal(domain, condition), HasSubstr("for a stretch only")) << condition;
  const Domain with_point = domain_of(holed_plate + "[[input.point]]\nname = \"p\"\npoint = [1, 2]\n");
  EXPECT_DOUBLE_EQ(selected(with_point, "y = 2 and x > 1"), 3.0);
}

TEST(Selection, CornersAreFoundWhereNoSideIs) {
  const auto corner = select(domain_of(holed_plate), "x = 0 and y = 0");
  ASSERT_TRUE(corner.ok());
  EXPECT_TRUE(corner->parts.empty());
  EXPECT_THAT(corner->corners, ElementsAre(Point{0, 0}));
}

TEST(Selection, WhatCannotBeReadIsNamedWithItsCharacterInTheWholeCondition) {
  const Domain domain = domain_of(holed_plate);
  const std::vector<std::pair<std::string, std::string>> cases{
      {"x = foo", "character 5: 'foo' is not known here; there is x, y, pi, e"},
      {"y = 2 and yy > 1", "character 11: 'yy' is not known"},
      {"x = nan", "character 5: 'nan' is no finite number"},
      {"x = 1e400", "character 5: '1e400' is no finite number"},
      {"x = 0 && y > 1", "character 7: '&&' joins nothing here"},
      {"x = 0; y = 1", "character 6: ';' joins nothing here"},
      {"x = 0 AND y = 1", "character 7: 'AND' joins nothing here"},
      {"x = 0 and", "character 7: 'and' joins nothing here"},
      {"or x = 0", "character 1: 'or' joins nothing here"},
      {"x => 0", "character 4: a side of a comparison is missing"},
      {"x != 0", "character 3: '!'"},
      {"x = 0 and y", "character 11: 'y' compares nothing"},
      {"x = 1/0", "'x = 1/0' has no finite value"},
      {"y = 0 or x = tn(1)", "character 14: 'tn' is not known here; did you mean 'tan'?"}};
  for (const auto& [condition, wanted] : cases)
    EXPECT_THAT(refusal(domain, condition),
                testing::AllOf(HasSubstr("the condition '" + condition + "'"), HasSubstr(wanted)));
}

// A bar of 4 x 2 under a tension of 3: u = 3 x / E, v = -nu 3 y / E exactly, at any mesh.
const std::string bar =
    "[[input.curve]]\nname = \"outline\"\nkind = \"polygon\"\npoints = [[0, 0], [4, 0], [4, 2], [0, "
    "2]]\n[[step]]\noperation = \"mesh\"\nsize = 0.7\n";
const std::string by_place = R"(
[[step]]
operation = "problem"
[[step.material]]
young = 1000.0
poisson = 0.25
[[step.support]]
where = "x = 0"
normal = 0.0
[[step.support]]
where = "x = 0 and y = 0"
y = 0.0
[[step.load]]
where = "x = 4"
x = 3.0
[[step]]
operation = "analyse"
[[step]]
operation = "probe"
label = "end"
at = [4.0, 2.0]
)";

TEST(Selection, SupportsAndLoadsByPlaceGiveTheExactBar) {
  for (const char* const order : {"", "order = \"2\"\n"}) {
    const auto run = test::run(bar + order + by_place);
    ASSERT_TRUE(run.complete()) << to_string(*run.error);
    const analysis::Analysis& analysis = *test::last(run).analyses.back();
    for (std::size_t n = 0; n < analysis.meshed->mesh.points.size(); ++n) {
      const Point p = analysis.meshed->mesh.points[n];
      EXPECT_NEAR(analysis.solution.cases[0].displacements[n].x, 0.003 * p.x, 1e-14);
      EXPECT_NEAR(analysis.solution.cases[0].displacements[n].y, -0.00075 * p.y, 1e-14);
    }
  }
}

TEST(Selection, ConditionsAreInTheUnitsOfTheScenario) {
  const std::string millimetres =
      "unit_system = \"mm, N, MPa\"\n[[input.curve]]\nname = \"outline\"\nkind = \"polygon\"\npoints = [[0, 0], [4000, "
      "0], [4000, 2000], [0, 2000]]\n";
  const Domain domain = domain_of(millimetres);
  EXPECT_NEAR(selected(domain, "x = 4000"), 2.0, 1e-12);
  EXPECT_NEAR(selected(domain, "hypot(x, y) >= 2000 and y = 2000"), 4.0, 1e-12);
  EXPECT_THAT(refusal(domain, "x = 4"), HasSubstr("holds for no side"));
}

TEST(Selection, OnlyTheSidesOfThePartAreInItsSet) {
  // Half of the top by a point at its middle, and an arc between two points of a hole.
  const std::string input = holed_plate +
                            "[[input.point]]\nname = \"p\"\npoint = [2, 2]\n[[input.point]]\nname = \"e\"\npoint = "
                            "[2.5, 1]\n[[input.point]]\nname = \"w\"\npoint = [1.5, 1]\n";
  const auto run = test::run(input + "[[step]]\noperation = \"mesh\"\nsize = 0.3\n");
  ASSERT_TRUE(run.complete()) << to_string(*run.error);
  const model::Model model = test::last(run);
  const auto& own = model.meshes.back()->mesh;
  const std::vector<std::string> words{"y = 2 and x < 2", "hypot(x - 2, y - 1) = 0.5 and y > 1", "outline"};
  const auto with = with_sets(model.domain, own, words);
  ASSERT_TRUE(with.ok()) << to_string(with.error());
  const auto length_of = [&](const std::string& set) {
    double sum = 0.0;
    for (const auto& side : with->side_sets.at(set)) {
      const auto nodes = side_nodes(*with, side);
      sum += distance(with->point(nodes[0]), with->point(nodes[1]));
    }
    return sum;
  };
  EXPECT_NEAR(length_of(words[0]), 2.0, 1e-12);
  EXPECT_NEAR(length_of(words[1]), 0.5 * length_of("hole"), 1e-9);
  EXPECT_EQ(with->side_sets.size(), own.side_sets.size() + 2);
}

TEST(Selection, UnknownNamesComeWithThoseThatThereAre) {
  const auto trouble = [&](const std::string& step) {
    const auto run = test::run(holed_plate + step);
    return run.error ? to_string(*run.error) : std::string();
  };
  EXPECT_THAT(trouble("[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\n[[step.support]]\nwhere = "
                      "\"bottom\"\nx = 0.0\n"),
              HasSubstr("there is no curve, lip or point 'bottom'; there is 'outline', 'hole'"));
  EXPECT_THAT(trouble("[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\n[[step.load]]\nwhere = \"x = "
                      "9\"\nx = 1.0\n"),
              HasSubstr("'outline' from (4, 0) to (4, 2)"));
  EXPECT_THAT(trouble("[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\n[[step.load]]\nwhere = \"x = "
                      "0 and y = 0\"\nx = 1.0\n"),
              HasSubstr("corners only"));
  EXPECT_THAT(trouble("[[step]]\noperation = \"zone\"\ncurves = [\"holes\"]\nsize = 0.1\nwidth = 0.1\n"),
              HasSubstr("there is no curve 'holes'; did you mean 'hole'? There is 'outline', 'hole'"));
  EXPECT_THAT(trouble("[[step]]\noperation = \"constraints\"\ncurves = [\"bottom\"]\ncount = 1\ndistance = 0.1\n"),
              HasSubstr("there is no curve 'bottom'; there is 'outline', 'hole'"));
}

}  // namespace
}  // namespace quebra::domain
