// The crack step through the table of operations: defaults, tables, remarks.

#include "quebra/core/fracture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/quebra_scenarios.h"

namespace quebra::core {
namespace {

using namespace test;
using testing::HasSubstr;

std::string point(const std::string& name, double x, double y) {
  return "[[input.point]]\nname = \"" + name + "\"\npoint = [" + std::to_string(x) + ", " + std::to_string(y) + "]\n";
}
const std::string analyse = "[[step]]\noperation = \"analyse\"\n";
const std::string crack = "[[step]]\noperation = \"crack\"\n";
std::string mesh(const std::string& params) { return "[[step]]\noperation = \"mesh\"\n" + params; }
const std::string rosettes = mesh("order = \"2\"\nrosettes = \"yes\"\n");

/// A strip 1 wide and 3 high with an edge crack, pulled (1) or pressed (-1).
std::string strip(double a, int sign = 1) {
  const std::string force = "y = " + std::to_string(sign) + "\n", against = "y = " + std::to_string(-sign) + "\n";
  return "[input]\nspecimen = \"single_edge_notch\"\nwidth = 1.0\nheight = 3.0\ncrack_length = " + std::to_string(a) + "\n" + point("anchor", 1, 0) + point("guide", 1, -1.5) +
         "[[step]]\noperation = \"problem\"\n[[step.material]]\nyoung = 1.0\n[[step.support]]\nwhere = \"anchor\"\nx = 0.0\ny = 0.0\n[[step.support]]\nwhere = \"guide\"\nx = 0.0\n" +
         "[[step.load]]\nwhere = \"top\"\n" + force + "[[step.load]]\nwhere = \"bottom\"\n" + against;
}

dobra::scenario::Document document(const std::string& text) {
  return dobra::scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n" + text, "test.toml").value();
}

TEST(Fracture, WhoAsksForKGetsRosettesUnlessTheScenarioSaysOtherwise) {
  const auto asked = [](const std::string& steps, std::size_t step) {
    auto doc = document(strip(0.5) + steps);
    const std::string done = ask_for_rosettes(doc);
    const auto* value = doc.steps.at(step).params.find("rosettes");
    const std::string has = value == nullptr ? "" : std::get<std::string>(*value);
    EXPECT_EQ(done.empty(), has != "yes" || steps.find("rosettes") != std::string::npos) << steps;
    return doc.steps.at(step).operation + " " + has;
  };
  EXPECT_EQ(asked(mesh("") + analyse + crack, 1), "mesh yes");
  EXPECT_EQ(asked(mesh("order = \"2\"\n") + analyse + crack, 1), "mesh yes");
  EXPECT_EQ(asked("[[step]]\noperation = \"adapt\"\n" + crack, 1), "adapt yes");
  EXPECT_EQ(asked(analyse + crack, 1), "mesh yes");  // put before the analysis
  EXPECT_EQ(asked(crack, 1), "mesh yes");
  EXPECT_EQ(asked(mesh("rosettes = \"no\"\n") + analyse + crack, 1), "mesh no");
  EXPECT_EQ(asked(mesh("order = \"1\"\n") + analyse + crack, 1), "mesh ");
  EXPECT_EQ(asked(mesh("quads = \"yes\"\n") + analyse + crack, 1), "mesh ");
  EXPECT_EQ(asked(rosettes + analyse + crack, 1), "mesh yes");
}

TEST(Fracture, KOfAMeshWithoutRosettesHasNoSpreadButARemarkWithAdvice) {
  for (const std::string order : {"1", "2"}) {
    const auto done = run(strip(0.5) + mesh("order = \"" + order + "\"\n") + analyse + crack);
    const auto values = figures(done);
    EXPECT_TRUE(values.contains("tip.load.crack_end.K_I"));
    EXPECT_EQ(values.count("tip.load.crack_end.spread"), values.count("tip.load.crack_end.closure.K_I")) << order;
    EXPECT_THAT(program().remarks_of(done.states.back()), testing::Contains(testing::AllOf(HasSubstr("crack tip 'crack_end'"), HasSubstr("rosettes = \"yes\"")))) << order;
  }
}

TEST(Fracture, TheTableHasEveryFigureOfATip) {
  const auto done = run(strip(0.5) + rosettes + analyse + crack);
  const auto values = figures(done);
  const auto tables = program().tables_of(done.states.back());
  const auto tips = std::find_if(tables.begin(), tables.end(), [](const auto& table) { return table.name == "tips"; });
  ASSERT_NE(tips, tables.end());
  ASSERT_EQ(tips->rows.size(), 1U);
  for (const std::string name : {"K_I", "K_II", "closure.K_I", "closure.K_II", "correlation.K_I", "correlation.K_II", "spread", "J", "G", "T", "contour", "kink.sigma_theta",
                                 "kink.s_theta", "kink.g_theta"}) {
    const auto column = std::find_if(tips->columns.begin(), tips->columns.end(), [&](const auto& title) { return title.starts_with(name + " ["); });
    ASSERT_NE(column, tips->columns.end()) << name;
    EXPECT_EQ(std::get<double>(tips->rows[0][static_cast<std::size_t>(column - tips->columns.begin())]), values.at("tip.load.crack_end." + name)) << name;
  }
}

TEST(Fracture, AClosedCrackHasARemarkAndNoKinkAngles) {
  const auto done = run(strip(0.5, -1) + rosettes + analyse + crack);
  const auto values = figures(done);
  EXPECT_LT(values.at("tip.load.crack_end.K_I"), 0.0);
  EXPECT_FALSE(values.contains("tip.load.crack_end.kink.sigma_theta"));
  EXPECT_THAT(program().remarks_of(done.states.back()), testing::Contains(HasSubstr("closed: the lips overlap")));
  const auto tables = program().tables_of(done.states.back());
  const auto tips = std::find_if(tables.begin(), tables.end(), [](const auto& table) { return table.name == "tips"; });
  EXPECT_EQ(std::get<std::string>(tips->rows[0].back()), "");
}

TEST(Fracture, TheVtuHasVonMisesAndPrincipalStresses) {
  const auto done = run(strip(0.5) + rosettes + analyse);
  const auto file = std::filesystem::temp_directory_path() / "dobra_fracture_test.vtu";
  for (const auto& output : program().outputs_of(done.states.back())) {
    if (output.file_name != "results.vtu") continue;
    ASSERT_TRUE(output.write(file).ok());
  }
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(file);
  for (const char* name : {"load von_mises", "load s_1", "load s_2"}) EXPECT_THAT(text, HasSubstr(std::string("Name=\"") + name + "\""));
}

}  // namespace
}  // namespace quebra::core
