// Lines, probes and pictures of results through the table of operations.

#include "quebra/analysis/results.h"
#include <fmt/format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "quebra/core/result_picture.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::analysis {
namespace {

using namespace dobra;
using namespace test;
using testing::HasSubstr;

/// A quarter ring, radii 1 and 2, whose sides are moved by u = (0.01 x + 0.003 y, 0.004 y): exact in every element.
const std::string ring = R"([[input.curve]]
name = "inner"
kind = "arc"
centre = [0, 0]
points = [[0, 1], [1, 0]]
turning = "clockwise"
[[input.curve]]
name = "bottom"
points = [[1, 0], [2, 0]]
[[input.curve]]
name = "outer"
kind = "arc"
centre = [0, 0]
points = [[2, 0], [0, 2]]
[[input.curve]]
name = "left"
points = [[0, 2], [0, 1]]
[[step]]
operation = "problem"
[[step.material]]
young = 100.0
poisson = 0.0
)";
std::string moved() {
  std::string text;
  for (const char* const side : {"inner", "bottom", "outer", "left"})
    text += std::string("[[step.support]]\nwhere = \"") + side +
            "\"\nx_formula = \"0.01 * x + 0.003 * y\"\ny_formula = \"0.004 * y\"\n";
  return ring + text;
}
const std::string solve =
    "[[step]]\noperation = \"mesh\"\nsize = 0.3\norder = \"2\"\n[[step]]\noperation = \"analyse\"\n";

scenario::DataTable table(const scenario::Run& run, const std::string& name) {
  for (auto& one : core::program().tables_of(run.states.back())) {
    if (one.name == name) return one;
  }
  ADD_FAILURE() << "no table " << name;
  return {};
}

TEST(Results, ALineReadsTheFieldsWhereverItLiesInTheMaterial) {
  const scenario::Run done =
      run(moved() + solve +
          "[[step]]\noperation = \"line\"\nlabel = \"cut\"\nfrom = [0, 0]\nto = [1.8, 0.6]\ncount = 37\n");
  ASSERT_TRUE(done.complete()) << to_string(*done.error);
  const auto cut = table(done, "line_cut");
  ASSERT_EQ(cut.columns.size(), 12U);
  EXPECT_EQ(cut.columns[1], "s [m]");
  EXPECT_EQ(cut.columns.back(), "von_mises [Pa]");
  // From radius 1 on: s >= 1 of 1.897, 37 points.
  EXPECT_EQ(cut.rows.size(),
            static_cast<std::size_t>(std::floor((std::sqrt(3.6) - 1.0) / (std::sqrt(3.6) / 36.0)) + 1));
  for (const auto& row : cut.rows) {
    const auto number = [&](std::size_t i) { return std::get<double>(row[i]); };
    const double x = number(2), y = number(3);
    EXPECT_NEAR(std::hypot(x, y), number(1), 1e-12);
    EXPECT_NEAR(number(4), 0.01 * x + 0.003 * y, 1e-12);
    EXPECT_NEAR(number(5), 0.004 * y, 1e-12);
    EXPECT_NEAR(number(6), 1.0, 1e-9);
    EXPECT_NEAR(number(7), 0.4, 1e-9);
    EXPECT_NEAR(number(8), 0.15, 1e-9);
    EXPECT_NEAR(number(9), 0.7 + std::hypot(0.3, 0.15), 1e-9);
  }
}

TEST(Results, AProbeGivesQuantitiesOfEveryCase) {
  const auto values =
      figures(run(moved() + "[[step.case]]\nname = \"a\"\n[[step.case]]\nname = \"b\"\nsettlement = 2.0\n" + solve +
                  "[[step]]\noperation = \"probe\"\nlabel = \"gauge\"\nat = [1.2, 0.7]\n"));
  EXPECT_NEAR(values.at("probe.gauge.a.u_x"), 0.012 + 0.0021, 1e-12);
  EXPECT_NEAR(values.at("probe.gauge.b.s_xx"), 2.0, 1e-9);
}

TEST(Results, ProbesFindQuarterPointElementsAndTheTip) {
  const std::string crack =
      "[input]\nspecimen = \"single_edge_notch\"\n[[input.point]]\nname = \"anchor\"\npoint = [1, "
      "0]\n[[input.point]]\nname = \"guide\"\npoint = [1, -1.5]\n[[step]]\noperation = "
      "\"problem\"\n[[step.material]]\nyoung = 1.0\n"
      "[[step.support]]\nwhere = \"anchor\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"guide\"\nx = "
      "0.0\n[[step.load]]\nwhere = \"top\"\ny = 1.0\n[[step.load]]\nwhere = \"bottom\"\ny = -1.0\n"
      "[[step]]\noperation = \"mesh\"\nsize = 0.3\norder = \"2\"\nrosettes = \"yes\"\n[[step]]\noperation = "
      "\"analyse\"\n[[step]]\noperation = \"probe\"\nlabel = \"tip\"\nat = [0.5, 0.0]\n[[step]]\noperation = "
      "\"line\"\nfrom = [0.5, 0]\nto = [0.51, 0.002]\n";
  const scenario::Run done = run(crack);
  EXPECT_TRUE(figures(done).contains("probe.tip.load.u_x"));
  EXPECT_EQ(table(done, "line_line").rows.size(), 101U);
}

TEST(Results, AViewShowsItsFieldOnTheDeformedShape) {
  const scenario::Run done =
      run(moved() + solve +
          "[[step]]\noperation = \"view\"\nfield = \"u_x\"\ndeformation = 10.0\ncontours = 4\n[[step]]\noperation = "
          "\"view\"\nfield = \"error\"\nmesh = \"no\"\nextremes = \"no\"\n");
  ASSERT_TRUE(done.complete()) << to_string(*done.error);
  const scene::Picture picture = core::program().picture_of(done.states.back());
  ASSERT_EQ(picture.panels.size(), 2U);
  const auto layer = [&](std::size_t panel, const std::string& key) -> const scene::Layer* {
    const auto& layers = picture.panels[panel].layers;
    const auto found = std::find_if(layers.begin(), layers.end(), [&](const auto& one) { return one.key == key; });
    return found == layers.end() ? nullptr : &*found;
  };
  for (const char* const key : {"field", "elements", "contours", "before", "boundary", "extremes", "extreme_values"})
    EXPECT_NE(layer(0, key), nullptr) << key;
  for (const char* const key : {"elements", "contours", "extremes"}) EXPECT_EQ(layer(1, key), nullptr) << key;
  const auto& field = std::get<scene::Mesh>(layer(0, "field")->content);
  for (std::size_t i = 0; i < field.points.size(); ++i) {
    // p + 10 u: the place before is found by the inverse of that map.
    const double y = field.points[i].y / 1.04;
    const double x = (field.points[i].x - 0.03 * y) / 1.1;
    EXPECT_NEAR(field.values[i], 0.01 * x + 0.003 * y, 1e-10);
  }
  // Contours of a linear field on the moved shape are straight: every point on a contour has its value.
  const auto& contours = std::get<scene::Lines>(layer(0, "contours")->content);
  EXPECT_GE(contours.lines.size(), 4U);
  for (const auto& line : contours.lines) {
    std::vector<double> values;
    for (const geom::Point p : line.points) {
      const double y = p.y / 1.04;
      values.push_back(0.01 * (p.x - 0.03 * y) / 1.1 + 0.003 * y);
    }
    EXPECT_NEAR(*std::min_element(values.begin(), values.end()), *std::max_element(values.begin(), values.end()), 1e-9);
  }
  const scene::Label& greatest = std::get<scene::Labels>(layer(0, "extreme_values")->content).labels[0];
  EXPECT_EQ(greatest.text, "max");
  EXPECT_NEAR(greatest.value.value(), *std::max_element(field.values.begin(), field.values.end()), 1e-12);
  EXPECT_THAT(picture.panels[0].title, HasSubstr("\u00d7\u00a010"));
}

TEST(Results, StressThatIsConstantToRoundingHasOneColourAndNoExtremes) {
  // Pulled along x on rollers: sigma_x is the load, everything else is rounding, at any modulus and size.
  for (const auto& [size, load] : {std::pair{1.0, 1.0}, std::pair{1e3, 3e8}, std::pair{1e-3, 1e-6}}) {
    const std::string square = fmt::format(
        "[input]\n[[input.curve]]\nname = \"a\"\npoints = [[0, 0], [{0}, 0]]\n[[input.curve]]\nname = \"b\"\npoints = "
        "[[{0}, 0], [{0}, {0}]]\n"
        "[[input.curve]]\nname = \"c\"\npoints = [[{0}, {0}], [0, {0}]]\n[[input.curve]]\nname = \"d\"\npoints = [[0, "
        "{0}], [0, 0]]\n",
        size);
    const Analysis analysis =
        *last(
             run(square + fmt::format("[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 7e10\npoisson = "
                                      "0.3\n[[step.support]]\nwhere = \"a\"\ny = 0.0\n"
                                      "[[step.support]]\nwhere = \"d\"\nx = 0.0\n[[step.load]]\nwhere = \"b\"\nx = {}\n"
                                      "[[step]]\noperation = \"mesh\"\nsize = {}\n[[step]]\noperation = \"analyse\"\n",
                                      load, 0.2 * size)))
             .analyses.back();
    for (const FieldName field : {FieldName::StressX, FieldName::StressY, FieldName::StressXY, FieldName::VonMises,
                                  FieldName::Principal2, FieldName::Error}) {
      core::ViewParams params;
      params.field = field;
      params.contours = 5;
      const scene::Panel panel = core::view_panel(analysis, 0, params);
      const auto& drawn = std::get<scene::Mesh>(panel.layers.front().content);
      const bool pulled = field == FieldName::StressX || field == FieldName::VonMises;
      EXPECT_EQ(drawn.scale.low, drawn.scale.high) << panel.title;
      EXPECT_NEAR(drawn.scale.low, pulled ? load : 0.0, 1e-6 * load) << panel.title;
      for (const scene::Layer& layer : panel.layers)
        EXPECT_TRUE(layer.key != "contours" && layer.key != "extremes") << layer.key;
    }
    core::ViewParams across;
    across.field = FieldName::DisplacementX;
    const scene::Panel panel = core::view_panel(analysis, 0, across);
    const scene::Scale& moved_scale = std::get<scene::Mesh>(panel.layers.front().content).scale;
    EXPECT_GT(moved_scale.high, moved_scale.low);
  }
}

TEST(Results, ATipDoesNotSwampTheColoursUnlessAllOfTheRangeIsAskedFor) {
  const std::string crack =
      "[input]\nspecimen = \"single_edge_notch\"\n[[input.point]]\nname = \"anchor\"\npoint = [1, "
      "0]\n[[input.point]]\nname = \"guide\"\npoint = [1, -1.5]\n"
      "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\n[[step.support]]\nwhere = \"anchor\"\nx = "
      "0.0\ny = 0.0\n[[step.support]]\nwhere = \"guide\"\nx = 0.0\n"
      "[[step.load]]\nwhere = \"top\"\ny = 1.0\n[[step.load]]\nwhere = \"bottom\"\ny = -1.0\n"
      "[[step]]\noperation = \"mesh\"\nsize = 0.1\norder = \"2\"\nrosettes = \"yes\"\n[[step]]\noperation = "
      "\"analyse\"\n";
  const Analysis analysis = *last(run(crack)).analyses.back();
  const auto shown = [&](core::ColorRange range) {
    core::ViewParams params;
    params.range = range;
    const scene::Panel panel = core::view_panel(analysis, 0, params);
    return std::get<scene::Mesh>(panel.layers.front().content).scale;
  };
  const scene::Scale field = shown(core::ColorRange::Field), full = shown(core::ColorRange::Full);
  EXPECT_LT(field.high, 0.3 * full.high);
  EXPECT_GT(field.high, 2.0);
  EXPECT_GT(*field.greatest, field.high) << "which the bar then says";
  EXPECT_EQ(*full.greatest, full.high);
}

TEST(Results, FaultsAreNamed) {
  EXPECT_THAT(trouble(moved() + "[[step]]\noperation = \"probe\"\nat = [1, 1]\n"), HasSubstr("there is no analysis"));
  EXPECT_THAT(trouble(moved() + solve + "[[step]]\noperation = \"probe\"\nat = [0.1, 0.1]\n"),
              HasSubstr("'probe': the point does not lie in the material (at 0.1, 0.1)"));
  EXPECT_THAT(trouble(moved() + solve + "[[step]]\noperation = \"line\"\nfrom = [5, 5]\nto = [6, 6]\n"),
              HasSubstr("the line does not lie in the material"));
  EXPECT_THAT(trouble(moved() + solve + "[[step]]\noperation = \"line\"\nfrom = [1, 1]\nto = [1, 1]\n"),
              HasSubstr("the same point"));
  EXPECT_THAT(trouble(moved() + solve +
                      "[[step]]\noperation = \"probe\"\nat = [1, 1]\n[[step]]\noperation = \"probe\"\nat = [1, 1]\n"),
              HasSubstr("give this one another `label`"));
  EXPECT_THAT(trouble(moved() + solve + "[[step]]\noperation = \"view\"\ncase = \"laod\"\n"),
              HasSubstr("there is no load case 'laod'; did you mean 'load'?"));
}

TEST(Results, ColoursCoverTheShareOfTheAreaThatTheLegendSaysAtBothEndsTogether) {
  // Shear round a tip stands out above and below.
  const scenario::Run done =
      run("[input]\nspecimen = \"single_edge_notch\"\n[[input.point]]\nname = \"anchor\"\npoint = [1, "
          "0]\n[[input.point]]\nname = \"guide\"\npoint = [1, -1.5]\n[[step]]\noperation = "
          "\"problem\"\n[[step.material]]\nyoung = 1.0\n"
          "[[step.support]]\nwhere = \"anchor\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"guide\"\nx = "
          "0.0\n[[step.load]]\nwhere = \"top\"\ny = 1.0\n[[step.load]]\nwhere = \"bottom\"\ny = -1.0\n"
          "[[step]]\noperation = \"mesh\"\nsize = 0.1\norder = \"2\"\nrosettes = \"yes\"\n[[step]]\noperation = "
          "\"analyse\"\n");
  core::ViewParams shear;
  shear.field = FieldName::StressXY;
  shear.deformation = 0.0;
  const scene::Panel panel = core::view_panel(*last(done).analyses.back(), 0, shear);
  const auto layer = [&](const char* key) {
    return std::find_if(panel.layers.begin(), panel.layers.end(), [&](const auto& own) { return own.key == key; });
  };
  const auto& colours = std::get<scene::Mesh>(layer("field")->content);
  double all = 0.0, inside = 0.0;
  for (const auto& [a, b, c] : colours.triangles) {
    const double area = std::abs(cross(colours.points[b] - colours.points[a], colours.points[c] - colours.points[a]));
    const double value = (colours.values[a] + colours.values[b] + colours.values[c]) / 3.0;
    all += area;
    if (value >= colours.scale.low && value <= colours.scale.high) inside += area;
  }
  EXPECT_GT(*colours.scale.greatest, colours.scale.high);
  EXPECT_GE(inside, 0.995 * all);
  EXPECT_LT(inside, all);
}

}  // namespace
}  // namespace quebra::analysis
