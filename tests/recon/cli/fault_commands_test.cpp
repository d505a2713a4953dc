// recon faults: its JSON, table, files and refusals.

#include "recon/cli/fault_commands.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "recon/cli/section_commands.h"
#include "recon/core/operations.h"
#include "tests/support/command_line.h"

namespace recon::cli {
namespace {

using FaultsOut = nlohmann::json;

class FaultCommands : public dobra::test::CommandLine {
 protected:
  FaultCommands() : CommandLine(core::program(), {faults_command(), restore_command()}) {}

  [[nodiscard]] FaultsOut faults_in(const std::string& file, std::vector<std::string> more = {}) const {
    std::vector<std::string> args{"faults", file, "--json", "--quiet"};
    args.insert(args.end(), more.begin(), more.end());
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? FaultsOut::parse(outcome.out) : FaultsOut();
  }
};

/// A normal fault of 45 degrees, 100 m down; bed C has no part in the hanging wall.
const std::string normal =
    "x,z,name,kind\n0,0,A,\n500,0,A,\n\n600,-100,A,\n1200,-100,A,\n\n0,-300,B,\n800,-300,B,\n\n900,-400,B,\n"
    "1200,-400,B,\n\n0,-150,C,\n650,-150,C,\n\n400,100,F,fault\n1200,-700,F,fault\n";

TEST_F(FaultCommands, JsonHasTheKeysThatScriptsRelyOn) {
  const FaultsOut made = faults_in(put("n.csv", normal));
  ASSERT_EQ(made["faults"].size(), 1U);
  const FaultsOut& fault = made["faults"][0];
  EXPECT_EQ(fault["name"], "F");
  EXPECT_EQ(fault["hanging_wall"], "right");
  EXPECT_EQ(fault["sense"], "normal");
  EXPECT_EQ(fault["ends"]["lower"]["kind"], "border");
  ASSERT_EQ(fault["cutoffs"].size(), 3U);
  const FaultsOut& a = fault["cutoffs"][0];
  EXPECT_EQ(a["horizon"], "A");
  EXPECT_EQ(a["hanging_wall"], FaultsOut({600.0, -100.0}));
  EXPECT_EQ(a["footwall"], FaultsOut({500.0, 0.0}));
  EXPECT_NEAR(a["separation"], 100.0 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(a["throw"], 100.0, 1e-9);
  EXPECT_NEAR(a["heave"], 100.0, 1e-9);
  const FaultsOut& c = fault["cutoffs"][1];
  EXPECT_EQ(c["horizon"], "C");
  EXPECT_TRUE(c["hanging_wall"].is_null());
  EXPECT_TRUE(c["separation"].is_null() && c["throw"].is_null() && c["heave"].is_null());
  ASSERT_EQ(made["blocks"].size(), 2U);
  EXPECT_EQ(made["blocks"][0]["name"], "block 1");
  EXPECT_NEAR(made["blocks"][0]["area"], 195000.0, 1e-6);
  EXPECT_EQ(made["blocks"][1]["faults"], FaultsOut::array({"F"}));
}

TEST_F(FaultCommands, AnUprightFaultIsListedWithoutAWall) {
  const FaultsOut made =
      faults_in(put("u.csv",
                    "x,z,name,kind\n0,0,A,\n500,0,A,\n\n500,-40,A,\n900,-40,A,\n\n0,-900,B,\n900,-900,B,\n\n"
                    "500,100,F,fault\n500,-1000,F,fault\n"));
  EXPECT_TRUE(made["faults"][0]["hanging_wall"].is_null());
  EXPECT_TRUE(made["faults"][0]["cutoffs"].empty());
  EXPECT_EQ(made["blocks"].size(), 2U);
  bool told = false;
  for (const auto& remark : made["remarks"])
    told = told || remark.get<std::string>().find("stands upright") != std::string::npos;
  EXPECT_TRUE(told);
}

TEST_F(FaultCommands, LinesThatItWritesTellTheSame) {
  const std::string file = put("n.csv", normal);
  const FaultsOut made = faults_in(file);
  for (const char* out : {"again.csv", "again.geojson", "again.toml"}) {
    ASSERT_EQ(call({"faults", file, "--out", path(out), "--quiet"}).code, 0) << out;
    const FaultsOut again = faults_in(path(out));
    EXPECT_EQ(again["faults"][0]["cutoffs"].dump(), made["faults"][0]["cutoffs"].dump()) << out;
    EXPECT_EQ(again["blocks"].dump(), made["blocks"].dump()) << out;
  }
  EXPECT_EQ(call({"faults", file, "--out", path("picture.svg"), "--quiet"}).code, 0);
  EXPECT_NE(text("picture.svg").find("block 2"), std::string::npos);
  EXPECT_NE(text("picture.svg").find("Displacement along faults"), std::string::npos);
}

TEST_F(FaultCommands, RefusesWithThePlace) {
  const auto none = call({"faults", put("none.csv", "x,z,name\n0,0,A\n9,0,A\n")});
  EXPECT_EQ(none.code, 3);
  EXPECT_NE(none.err.find("the section has no fault"), std::string::npos) << none.err;
  EXPECT_EQ(call({"faults", put("n.csv", normal), "--tolerance=-1"}).code, 3);
  EXPECT_EQ(call({"faults", put("n.csv", normal), "--out", path("x.abc")}).code, 2);
  const auto block = call({"faults", put("b.toml",
                                         "dobra = 1\nprogram = \"recon\"\n[[input.horizon]]\nname = \"A\"\n"
                                         "points = [[0, 0], [900, 0]]\n[[input.horizon]]\nname = \"B\"\n"
                                         "points = [[0, -300], [900, -300]]\n[[input.fault]]\nname = \"F\"\n"
                                         "points = [[200, 50], [700, -350]]\n[[input.block]]\nname = \"x\"\n"
                                         "point = [100, 500]\n")});
  EXPECT_EQ(block.code, 3);
  EXPECT_NE(block.err.find("block 'x'"), std::string::npos) << block.err;
}

TEST_F(FaultCommands, GapsAreNotJoinedAcrossAFaultThatStillDisplacesTheBed) {
  const std::string file = put("n.csv", normal);
  const FaultsOut cutoffs = faults_in(file, {"--join-gaps", "400"})["faults"][0]["cutoffs"];
  EXPECT_EQ(cutoffs, faults_in(file)["faults"][0]["cutoffs"]);
  const auto told = call({"faults", file, "--join-gaps", "400"});
  EXPECT_NE(told.err.find("fault 'F' lies between them and still displaces the bed by 141.4 m"), std::string::npos)
      << told.err;
}

TEST_F(FaultCommands, AFaultThatCrossesItselfIsRefusedWithThePlace) {
  std::string loop = normal;
  loop.replace(loop.find("1200,-700,F"), 0, "700,-200,F,fault\n760,-200,F,fault\n690,-240,F,fault\n710,-150,F,fault\n");
  const auto refused = call({"faults", put("loop.csv", loop)});
  EXPECT_EQ(refused.code, 3);
  EXPECT_NE(refused.err.find("fault 'F': the fault crosses itself"), std::string::npos) << refused.err;
}

TEST_F(FaultCommands, AScenarioHasItsFiguresAsQuantities) {
  const std::string file =
      put("q.toml",
          "dobra = 1\nprogram = \"recon\"\n[[input.lines]]\nfile = \"n.csv\"\n[[step]]\noperation = \"faults\"\n"
          "[[expect]]\nquantity = \"fault.F.A.throw\"\nvalue = 100.0\ntolerance = 1e-9\n"
          "[[expect]]\nquantity = \"block.block 1.area\"\nvalue = 195000.0\ntolerance = 1e-6\n");
  EXPECT_TRUE(std::filesystem::exists(put("n.csv", normal)));
  const auto outcome = call({"run", file, "--out", path("out")});
  EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
}

}  // namespace
}  // namespace recon::cli
