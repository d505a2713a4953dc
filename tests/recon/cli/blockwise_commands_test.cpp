// recon restore --block and --jigsaw: JSON, files, scenarios and refusals.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "recon/cli/fault_commands.h"
#include "recon/cli/section_commands.h"
#include "recon/core/operations.h"
#include "tests/support/command_line.h"

namespace recon::cli {
namespace {

using BlockOut = nlohmann::json;

class BlockwiseCommands : public dobra::test::CommandLine {
 protected:
  BlockwiseCommands() : CommandLine(core::program(), {faults_command(), restore_command()}) {}

  [[nodiscard]] BlockOut restored(std::vector<std::string> args) const {
    args.insert(args.begin(), "restore");
    args.insert(args.end(), {"--json", "--quiet"});
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? BlockOut::parse(outcome.out) : BlockOut();
  }
};

/// A normal fault of 45 degrees, 100 m down to +x; beds A and B.
const std::string down_100 =
    "x,z,name,kind\n0,0,A,\n500,0,A,\n\n600,-100,A,\n1200,-100,A,\n\n0,-300,B,\n800,-300,B,\n\n900,-400,B,\n"
    "1200,-400,B,\n\n400,100,F,fault\n1200,-700,F,fault\n";

TEST_F(BlockwiseCommands, JigsawPrintsTheKeysThatScriptsRelyOn) {
  const std::string file = put("n.csv", down_100);
  for (const char* fit : {"walls", "top"}) {
    const BlockOut made = restored({file, "--jigsaw", "--fit", fit, "--geometry"});
    ASSERT_EQ(made["blocks"].size(), 2U);
    EXPECT_EQ(made["blocks"][0]["name"], "block 1");
    EXPECT_NEAR(made["blocks"][0]["shift"].get<double>(), 0.0, 1e-9);
    EXPECT_NEAR(made["blocks"][1]["shift"].get<double>(), -100.0, 1e-6);
    ASSERT_EQ(made["faults"].size(), 1U);
    const BlockOut& fault = made["faults"][0];
    EXPECT_EQ(fault["name"], "F");
    EXPECT_NEAR(fault["gap_area"].get<double>(), 0.0, 1e-3);
    EXPECT_NEAR(fault["overlap_area"].get<double>(), 0.0, 1e-3);
    EXPECT_NEAR(fault["dip_restored"].get<double>(), 45.0, 1e-6);
    EXPECT_NEAR(fault["shortening"].get<double>(), -100.0, 1e-6);
    EXPECT_NEAR(made["width_before"].get<double>(), 1200.0, 1e-9);
    EXPECT_NEAR(made["width_after"].get<double>(), 1100.0, 1e-6);
    EXPECT_EQ(made["verdict"], "balanced");
    EXPECT_EQ(made["restored"].size(), 5U);
  }
}

TEST_F(BlockwiseCommands, OneBlockIsRestoredAndTheRestKeepsItsPlace) {
  const std::string file = put("n.csv", down_100);
  const BlockOut made = restored({file, "--block", "block 2", "--top", "A", "--elevation", "-50", "--geometry"});
  EXPECT_TRUE(made["blocks"][0]["shift"].is_null());
  EXPECT_EQ(made["blocks"][1]["shift"], 0.0);
  EXPECT_EQ(made.count("faults"), 0U);
  EXPECT_EQ(made["restored"][0]["points"], BlockOut::parse("[[0.0,0.0],[500.0,0.0]]"));
  EXPECT_NEAR(made["restored"][1]["points"][0][1].get<double>(), -50.0, 1e-9);
  EXPECT_NEAR(made["restored"][1]["points"][0][0].get<double>(), 600.0, 1e-9);
  EXPECT_EQ(made["restored"][4]["points"], BlockOut::parse("[[400.0,100.0],[1200.0,-700.0]]"));
}

TEST_F(BlockwiseCommands, ItsFilesGoOnAsSectionAndAsScenario) {
  const std::string file = put("n.csv", down_100);
  const std::string folder = std::filesystem::path(file).parent_path().string();
  for (const char* name : {"/j.csv", "/j.toml", "/j.svg"})
    EXPECT_EQ(call({"restore", file, "--jigsaw", "--fit", "top", "--quiet", "--out", folder + name}).code, 0) << name;
  const auto faults = call({"faults", folder + "/j.csv", "--json", "--quiet"});
  ASSERT_EQ(faults.code, 0) << faults.err;
  const BlockOut found = BlockOut::parse(faults.out);
  for (const BlockOut& cutoff : found["faults"][0]["cutoffs"])
    EXPECT_NEAR(cutoff["separation"].get<double>(), 0.0, 1e-5) << cutoff;
  EXPECT_EQ(call({"run", folder + "/j.toml", "--out", folder + "/out"}).code, 0);
}

TEST_F(BlockwiseCommands, AScenarioHasTheSameKeysAndGoesOnBehindIt) {
  const std::string file = put("n.csv", down_100);
  const std::string text =
      "dobra = 1\nprogram = \"recon\"\n\n[input]\n[[input.lines]]\nfile = \"n.csv\"\n\n[[step]]\noperation = "
      "\"restore\"\njigsaw = true\nfit = "
      "\"walls\"\ntop = \"A\"\n\n[[step]]\noperation = \"faults\"\n\n[[step]]\noperation = \"carry\"\npoints = [[700, "
      "-200]]\n\n[[expect]]\nquantity = \"fault.F.A.separation\"\nvalue = 0\ntolerance = 1e-4\n\n[[expect]]\nquantity "
      "= "
      "\"block.block 2.shift\"\nvalue = -100\ntolerance = 1e-6\n";
  const std::string out = std::filesystem::path(file).parent_path().string() + "/run";
  const auto outcome = call({"run", put("s.toml", text), "--out", out});
  EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
}

TEST_F(BlockwiseCommands, ATargetLineAndRigidBlocksAreOptionsToo) {
  const std::string file = put("n.csv", down_100);
  const std::string line = put("line.csv", "x,z\n-3000,50\n3000,50\n");
  const auto laid =
      call({"restore", file, "--jigsaw", "--fit", "top", "--target", line, "--json", "--geometry", "--quiet"});
  ASSERT_EQ(laid.code, 0) << laid.err;
  const BlockOut on_line = BlockOut::parse(laid.out);
  EXPECT_NEAR(on_line["blocks"][1]["shift"].get<double>(), -100.0, 1e-6);
  EXPECT_NEAR(on_line["restored"][0]["points"][0][1].get<double>(), 50.0, 1e-6);
  const auto turned = call({"restore", file, "--jigsaw", "--constraint", "rotation", "--json", "--quiet"});
  ASSERT_EQ(turned.code, 0) << turned.err;
  const BlockOut rigid = BlockOut::parse(turned.out);
  EXPECT_EQ(rigid["constraint"], "rotation");
  EXPECT_EQ(rigid.count("method"), 0U);
  EXPECT_NEAR(rigid["blocks"][1]["turn"].get<double>(), 0.0, 1e-9);
  EXPECT_NEAR(rigid["blocks"][1]["raise"].get<double>(), 100.0, 1e-6);
  EXPECT_EQ(call({"restore", file, "--constraint", "rotation", "--quiet"}).code, 3);
}

TEST_F(BlockwiseCommands, WhatDoesNotGoTogetherIsRefused) {
  const std::string file = put("n.csv", down_100);
  const auto code = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"restore", file, "--quiet"});
    return call(more).code;
  };
  EXPECT_EQ(code({"--jigsaw", "--block", "block 1"}), 3);
  EXPECT_EQ(code({"--jigsaw", "--draws", "10"}), 2);
  EXPECT_EQ(code({"--jigsaw", "--target", "line.csv"}), 3);
  EXPECT_EQ(code({"--jigsaw", "--percent", "50"}), 3);
  EXPECT_EQ(code({"--block", "blok 2"}), 3);
  EXPECT_EQ(code({"--fit", "top"}), 3);
  EXPECT_EQ(code({"--jigsaw", "--pin", "560"}), 3);  // in the gap between both pieces of the top
}

}  // namespace
}  // namespace recon::cli
