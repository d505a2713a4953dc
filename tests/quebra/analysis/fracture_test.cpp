// The crack step through the table of operations: defaults, tables, remarks.

#include "quebra/analysis/fracture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/quebra_scenarios.h"

namespace quebra::analysis {
namespace {

using namespace test;
using testing::HasSubstr;

std::string named_point(const std::string& name, double x, double y) {
  return "[[input.point]]\nname = \"" + name + "\"\npoint = [" + std::to_string(x) + ", " + std::to_string(y) + "]\n";
}
const std::string plain_analyse = "[[step]]\noperation = \"analyse\"\n";
const std::string crack_step = "[[step]]\noperation = \"crack\"\n";
std::string mesh(const std::string& params) { return "[[step]]\noperation = \"mesh\"\n" + params; }
const std::string rosettes = mesh("order = \"2\"\nrosettes = \"yes\"\n");

/// A strip 1 wide and 3 high with an edge crack, pulled (1) or pressed (-1).
std::string cracked_strip(double a, int sign = 1) {
  const std::string force = "y = " + std::to_string(sign) + "\n", against = "y = " + std::to_string(-sign) + "\n";
  return "[input]\nspecimen = \"single_edge_notch\"\nwidth = 1.0\nheight = 3.0\ncrack_length = " + std::to_string(a) +
         "\n" + named_point("anchor", 1, 0) + named_point("guide", 1, -1.5) +
         "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\n[[step.support]]\nwhere = \"anchor\"\nx = "
         "0.0\ny = 0.0\n[[step.support]]\nwhere = \"guide\"\nx = 0.0\n" +
         "[[step.load]]\nwhere = \"top\"\n" + force + "[[step.load]]\nwhere = \"bottom\"\n" + against;
}

/// A plate 4 by 4, clamped below, pulled above, with an edge crack 1 deep on the left and one `deep` on the right;
/// `more` goes into the input, `loads` into the problem.
std::string two_cracks(const std::string& more, double deep, const std::string& loads = "") {
  const auto curve = [](const std::string& name, double from, double to, double y) {
    return "[[input.crack]]\nname = \"" + name + "\"\npoints = [[" + std::to_string(from) + ", " + std::to_string(y) +
           "], [" + std::to_string(to) + ", " + std::to_string(y) + "]]\n";
  };
  return "[input]\n[[input.curve]]\nname = \"bottom\"\npoints = [[0.0, 0.0], [4.0, 0.0]]\n[[input.curve]]\nname = "
         "\"right\"\npoints = [[4.0, 0.0], [4.0, 4.0]]\n"
         "[[input.curve]]\nname = \"top\"\npoints = [[4.0, 4.0], [0.0, 4.0]]\n[[input.curve]]\nname = \"left\"\npoints "
         "= [[0.0, 4.0], [0.0, 0.0]]\n" +
         curve("edge", 0.0, 1.0, 2.5) + curve("other", 4.0, 4.0 - deep, 1.5) + more +
         "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\npoisson = 0.3\n[[step.support]]\nwhere = "
         "\"bottom\"\nx = 0.0\ny = 0.0\n"
         "[[step.load]]\nwhere = \"top\"\ny = 1.0\n" +
         loads;
}
/// A strip on the right, which a crack 1.5 deep ends on, and its stiffer material.
const std::string stiff = "[[step.material]]\nregion = \"strip\"\nyoung = 2.0\npoisson = 0.3\n";
const std::string interface =
    "[[input.curve]]\nname = \"seam\"\nrole = \"internal\"\npoints = [[2.5, 0.0], [2.5, 4.0]]\n[[input.region]]\nname "
    "= \"strip\"\npoint = [3.9, 0.1]\n";

dobra::scenario::Document document(const std::string& text) {
  return dobra::scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n" + text, "test.toml").value();
}

TEST(Fracture, WhoAsksForKGetsRosettesUnlessTheScenarioSaysOtherwise) {
  const auto asked = [](const std::string& steps, std::size_t step) {
    auto doc = document(cracked_strip(0.5) + steps);
    const std::string done = ask_for_rosettes(doc);
    const auto* value = doc.steps.at(step).params.find("rosettes");
    const std::string has = value == nullptr ? "" : std::get<std::string>(*value);
    EXPECT_EQ(done.empty(), has != "yes" || steps.find("rosettes") != std::string::npos) << steps;
    return doc.steps.at(step).operation + " " + has;
  };
  EXPECT_EQ(asked(mesh("") + plain_analyse + crack_step, 1), "mesh yes");
  EXPECT_EQ(asked(mesh("order = \"2\"\n") + plain_analyse + crack_step, 1), "mesh yes");
  EXPECT_EQ(asked("[[step]]\noperation = \"adapt\"\n" + crack_step, 1), "adapt yes");
  EXPECT_EQ(asked(plain_analyse + crack_step, 1), "mesh yes");  // put before the analysis
  EXPECT_EQ(asked(crack_step, 1), "mesh yes");
  EXPECT_EQ(asked(mesh("rosettes = \"no\"\n") + plain_analyse + crack_step, 1), "mesh no");
  EXPECT_EQ(asked(mesh("order = \"1\"\n") + plain_analyse + crack_step, 1), "mesh ");
  EXPECT_EQ(asked(mesh("quads = \"yes\"\n") + plain_analyse + crack_step, 1), "mesh ");
  EXPECT_EQ(asked(rosettes + plain_analyse + crack_step, 1), "mesh yes");
}

TEST(Fracture, KOfAMeshWithoutRosettesHasNoSpreadButARemarkWithAdvice) {
  for (const std::string order : {"1", "2"}) {
    const auto done = run(cracked_strip(0.5) + mesh("order = \"" + order + "\"\n") + plain_analyse + crack_step);
    const auto values = figures(done);
    EXPECT_TRUE(values.contains("tip.load.crack_end.K_I"));
    EXPECT_EQ(values.count("tip.load.crack_end.spread"), values.count("tip.load.crack_end.closure.K_I")) << order;
    EXPECT_THAT(core::program().remarks_of(done.states.back()),
                testing::Contains(testing::AllOf(HasSubstr("crack tip 'crack_end'"), HasSubstr("rosettes = \"yes\""))))
        << order;
  }
}

TEST(Fracture, TheTableHasEveryFigureOfATip) {
  const auto done = run(cracked_strip(0.5) + rosettes + plain_analyse + crack_step);
  const auto values = figures(done);
  const auto tables = core::program().tables_of(done.states.back());
  const auto tips = std::find_if(tables.begin(), tables.end(), [](const auto& table) { return table.name == "tips"; });
  ASSERT_NE(tips, tables.end());
  ASSERT_EQ(tips->rows.size(), 1U);
  for (const std::string name :
       {"K_I", "K_II", "closure.K_I", "closure.K_II", "correlation.K_I", "correlation.K_II", "spread", "J", "G", "T",
        "contour", "kink.sigma_theta", "kink.s_theta", "kink.g_theta"}) {
    const auto column = std::find_if(tips->columns.begin(), tips->columns.end(),
                                     [&](const auto& title) { return title.starts_with(name + " ["); });
    ASSERT_NE(column, tips->columns.end()) << name;
    EXPECT_EQ(std::get<double>(tips->rows[0][static_cast<std::size_t>(column - tips->columns.begin())]),
              values.at("tip.load.crack_end." + name))
        << name;
  }
}

TEST(Fracture, AClosedCrackHasARemarkAndNoKinkAngles) {
  const auto done = run(cracked_strip(0.5, -1) + rosettes + plain_analyse + crack_step);
  const auto values = figures(done);
  EXPECT_LT(values.at("tip.load.crack_end.K_I"), 0.0);
  EXPECT_FALSE(values.contains("tip.load.crack_end.kink.sigma_theta"));
  EXPECT_THAT(core::program().remarks_of(done.states.back()), testing::Contains(HasSubstr("closed: the lips overlap")));
  const auto tables = core::program().tables_of(done.states.back());
  const auto tips = std::find_if(tables.begin(), tables.end(), [](const auto& table) { return table.name == "tips"; });
  const auto kink = std::find(tips->columns.begin(), tips->columns.end(), "kink.g_theta [deg]");
  ASSERT_NE(kink, tips->columns.end());
  EXPECT_EQ(std::get<std::string>(tips->rows[0][static_cast<std::size_t>(kink - tips->columns.begin())]), "");
}

TEST(Fracture, OneTipWithoutKDoesNotCostTheOthersTheirs) {
  const auto alone = figures(run(two_cracks("", 1.5) + rosettes + plain_analyse + crack_step));
  // One tip on the border of two regions of one material; on an interface; one whose crack is too short for the
  // contour.
  const auto border = figures(run(two_cracks(interface, 1.5) + rosettes + plain_analyse + crack_step));
  for (const char* const name : {"tip.load.edge_end.K_I", "tip.load.other_end.K_I"})
    EXPECT_NEAR(border.at(name) / alone.at(name), 1.0, 1e-2);
  const auto done = run(two_cracks(interface, 1.5, stiff) + rosettes + plain_analyse + crack_step);
  const auto values = figures(done);
  EXPECT_TRUE(values.contains("tip.load.edge_end.K_I"));
  EXPECT_FALSE(values.contains("tip.load.other_end.K_I"));
  EXPECT_TRUE(alone.contains("tip.load.other_end.K_I"));
  const auto& analysed = *last(done).analyses.back();
  ASSERT_EQ(analysed.tips[0].size(), 2U);
  EXPECT_EQ(analysed.tips[0][1].at, (dobra::geom::Point{2.5, 1.5}));
  EXPECT_THAT(analysed.tips[0][1].refused->message, HasSubstr("two materials meet at the tip"));
  EXPECT_THAT(
      core::program().remarks_of(done.states.back()),
      testing::Contains(HasSubstr("crack tip 'other_end' at (2.5, 1.5) has no K: two materials meet at the tip")));
  EXPECT_EQ(core::program().reached(done.states.back()), false);

  const auto outer = run(two_cracks("", 0.3) + rosettes + plain_analyse + crack_step + "contour = 0.4\n");
  EXPECT_TRUE(figures(outer).contains("tip.load.edge_end.K_I"));
  EXPECT_THAT(last(outer).analyses.back()->tips[0][1].refused->message,
              HasSubstr("leaves the straight end of the crack"));
  EXPECT_EQ(core::program().reached(outer.states.back()), false);
  EXPECT_THAT(trouble(two_cracks("", 0.3) + rosettes + plain_analyse + crack_step + "contour = 1.4\n"),
              testing::AllOf(HasSubstr("edge_end"), HasSubstr("leaves the straight end")));
}

TEST(Fracture, ATipWithoutKInEveryLoadCaseHasOneRemark) {
  const auto done =
      run(two_cracks(interface, 1.5, stiff + "[[step.load]]\ncase = \"more\"\nwhere = \"top\"\ny = 2.0\n") + rosettes +
          plain_analyse + crack_step);
  const auto remarks = core::program().remarks_of(done.states.back());
  EXPECT_EQ(std::count_if(remarks.begin(), remarks.end(),
                          [](const std::string& remark) { return remark.find("has no K") != std::string::npos; }),
            1);
  const auto tables = core::program().tables_of(done.states.back());
  const auto tips = std::find_if(tables.begin(), tables.end(), [](const auto& table) { return table.name == "tips"; });
  ASSERT_EQ(tips->rows.size(), 4U);
  EXPECT_EQ(tips->columns.back(), "reason");
  for (const auto& row : tips->rows) {
    const bool refused = std::get<std::string>(row[1]) == "other_end";
    EXPECT_EQ(!std::get<std::string>(row.back()).empty(), refused);
    EXPECT_EQ(std::holds_alternative<double>(row[4]), !refused);
  }
}

TEST(Fracture, TheVtuHasVonMisesAndPrincipalStresses) {
  const auto done = run(cracked_strip(0.5) + rosettes + plain_analyse);
  const auto file = std::filesystem::temp_directory_path() / "dobra_fracture_test.vtu";
  for (const auto& output : core::program().outputs_of(done.states.back())) {
    if (output.file_name != "results.vtu") continue;
    ASSERT_TRUE(output.write(file).ok());
  }
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(file);
  for (const char* name : {"load von_mises", "load s_1", "load s_2"})
    EXPECT_THAT(text, HasSubstr(std::string("Name=\"") + name + "\""));
}

}  // namespace
}  // namespace quebra::analysis
