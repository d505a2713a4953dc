#include "quebra/cli/analysis_commands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "quebra/core/operations.h"
#include "tests/support/command_line.h"
#include "tests/support/quebra_scenarios.h"

namespace quebra::cli {
namespace {

using Json = nlohmann::json;

class AnalysisCommands : public dobra::test::CommandLine {
 protected:
  AnalysisCommands() : CommandLine(core::program(), analysis_commands()) {}
  [[nodiscard]] std::string l_shape() const {
    return put("l.toml", "dobra = 1\nprogram = \"quebra\"\n" + core::test::sheared_l);
  }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
};

TEST_F(AnalysisCommands, ALoopThatMissesItsTargetEndsWithOne) {
  const auto missed = call({"adapt", l_shape(), "--target", "1%", "--max-cycles", "1", "--json"});
  EXPECT_EQ(missed.code, 1) << missed.err;
  EXPECT_EQ(Json::parse(missed.out)["reached"], false);
  EXPECT_FALSE(Json::parse(missed.out)["remarks"].empty());
  const auto met = call({"adapt", l_shape(), "--target", "20%", "--json"});
  EXPECT_EQ(met.code, 0) << met.err;
  EXPECT_EQ(Json::parse(met.out)["reached"], true);
}

TEST_F(AnalysisCommands, OptionsOfMeshesAreThoseOfTheLoopToo) {
  const auto elements = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"adapt", l_shape(), "--target", "60%", "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const auto done = call(words);
    EXPECT_EQ(done.code, 0) << done.err;
    return Json::parse(done.out)["quantities"]["elements"]["value"].get<double>();
  };
  const double few = elements({});
  EXPECT_GT(elements({"--size", "8"}), 2.0 * few);
  EXPECT_GT(elements({"--size-formula", "4 + 0.1 * x"}), 2.0 * few);
  refuses({"adapt", l_shape(), "--size-formula", "x - 50"}, 3, {"size_formula", "greater than 0"});
  refuses({"adapt", l_shape(), "--engine", "magic"}, 2, {"--engine"});
}

TEST_F(AnalysisCommands, TheCurveAndAnyCycleAreDrawn) {
  const auto drawn = call({"adapt", l_shape(), "--target", "10%", "--curve", path("curve.svg"), "--picture", path("first.svg"), "--cycle", "1"});
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_NE(text("curve.svg").find("</svg>"), std::string::npos);
  EXPECT_NE(text("first.svg").find("</svg>"), std::string::npos);
  refuses({"adapt", l_shape(), "--cycle", "1"}, 2, {"--cycle", "give --picture FILE"});
  refuses({"adapt", l_shape(), "--curve", path("curve.xyz")}, 2, {"curve.xyz", ".svg, .pdf or .png"});
  refuses({"adapt", l_shape(), "--target", "20%", "--picture", path("none.svg"), "--cycle", "9"}, 3, {"there is no cycle 9"});
  EXPECT_FALSE(exists("none.svg"));
}

TEST_F(AnalysisCommands, ALineAndAProbeAreRead) {
  const std::string scenario = l_shape();
  const auto read = call({"adapt", scenario, "--target", "20%", "--line", "10,60,40,60", "--samples", "4", "--out", path("line.csv"), "--probe", "10,60", "--json"});
  ASSERT_EQ(read.code, 0) << read.err;
  const Json json = Json::parse(read.out);
  ASSERT_EQ(json["line_command"].size(), 4u);
  EXPECT_EQ(json["line_command"][0]["u_x [m]"], json["quantities"]["probe.1.load.u_x"]["value"]);
  const std::string lines = text("line.csv");
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 5);
  refuses({"adapt", scenario, "--out", path("line2.csv")}, 2, {"--line"});
  refuses({"adapt", scenario, "--probe", "10"}, 2, {"--probe 10", "x,y"});
}

}  // namespace
}  // namespace quebra::cli
