// recon move: its JSON, lists, files that chain, and exit codes.

#include "recon/cli/move_commands.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "recon/cli/fault_commands.h"
#include "recon/core/operations.h"
#include "tests/support/command_line.h"

namespace recon::cli {
namespace {

using MoveOut = nlohmann::json;

class MoveCommands : public dobra::test::CommandLine {
 protected:
  MoveCommands() : CommandLine(core::program(), {move_command(), faults_command()}) {}

  [[nodiscard]] MoveOut moved(const std::string& file, std::vector<std::string> more) const {
    std::vector<std::string> args{"move", file, "--fault", "F", "--json", "--geometry", "--quiet"};
    args.insert(args.end(), more.begin(), more.end());
    const auto outcome = call(args);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? MoveOut::parse(outcome.out) : MoveOut();
  }
};

/// A normal fault of 45 degrees to +x, 100 m down and 100 m level.
const std::string moved_down_100 =
    "x,z,name,kind\n0,0,A,\n500,0,A,\n\n600,-100,A,\n1200,-100,A,\n\n0,-300,B,\n800,-300,B,\n\n900,-400,B,\n"
    "1200,-400,B,\n\n400,100,F,fault\n1200,-700,F,fault\n";

TEST_F(MoveCommands, JsonHasTheKeysThatScriptsRelyOn) {
  const MoveOut made = moved(put("n.csv", moved_down_100), {"--method", "shear", "--close", "A,B"});
  EXPECT_NEAR(made["slip"], 100.0 * std::sqrt(2.0), 1e-9);
  EXPECT_EQ(made["method"], "shear");
  ASSERT_EQ(made["misfit"].size(), 2U);
  for (const auto& misfit : made["misfit"]) {
    EXPECT_NEAR(misfit["along"], 0.0, 1e-9);
    EXPECT_FALSE(std::signbit(misfit["gap"].get<double>()) || std::signbit(misfit["overlap"].get<double>()));
  }
  ASSERT_EQ(made["moved"].size(), 2U);
  EXPECT_EQ(made["moved"][0]["kind"], "horizon");
  EXPECT_EQ(made["moved"][0]["name"], "A (2)");
  EXPECT_NEAR(made["moved"][0]["points"][0][0], 500.0, 1e-9);
  ASSERT_EQ(made["pieces"].size(), 5U);
  EXPECT_EQ(made["pieces"][0]["piece_of"], "A");
  EXPECT_EQ(made["gap_area"], 0.0);
}

TEST_F(MoveCommands, AListMayHaveCommasInQuotesOrBeGivenPieceByPiece) {
  const auto feature = [](const std::string& properties, const std::string& points) {
    return "{\"type\": \"Feature\", \"properties\": {" + properties +
           "}, \"geometry\": {\"type\": \"LineString\", \"coordinates\": " + points + "}}";
  };
  const std::string file =
      put("c.geojson",
          "{\"type\": \"FeatureCollection\", \"features\": [" +
              feature("\"name\": \"A, upper (1)\", \"piece_of\": \"A, upper\"", "[[0, 0], [500, 0]]") + "," +
              feature("\"name\": \"A, upper (2)\", \"piece_of\": \"A, upper\"", "[[600, -100], [1200, -100]]") + "," +
              feature("\"name\": \"B\"", "[[0, -900], [1200, -900]]") + "," +
              feature("\"name\": \"F\", \"kind\": \"fault\"", "[[400, 100], [1450, -950]]") + "]}");
  EXPECT_NEAR(moved(file, {"--method", "rigid", "--close", "\"A, upper\""})["slip"], 141.4213562373095, 1e-9);
  const std::string plain = put("n.csv", moved_down_100);
  EXPECT_EQ(moved(plain, {"--method", "rigid", "--close", "A", "--close", "B"}).dump(),
            moved(plain, {"--method", "rigid", "--close", "A,B"}).dump());
}

TEST_F(MoveCommands, WhatItWritesChains) {
  const std::string file = put("n.csv", moved_down_100);
  for (const char* out : {"forward.csv", "forward.geojson"}) {
    ASSERT_EQ(call({"move", file, "--fault", "F", "--method", "fault_parallel_flow", "--slip=-50", "--direction",
                    "forward", "--out", path(out), "--quiet"})
                  .code,
              0);
    const auto listed = call({"faults", path(out), "--json", "--quiet"});
    ASSERT_EQ(listed.code, 0) << listed.err;
    const MoveOut cutoffs = MoveOut::parse(listed.out)["faults"][0]["cutoffs"];
    EXPECT_NEAR(cutoffs[0]["separation"], 50.0 + 100.0 * std::sqrt(2.0), 1e-6) << out;
    EXPECT_NEAR(moved(path(out), {"--method", "flexural_slip", "--close", "B"})["slip"], 50.0 + 100.0 * std::sqrt(2.0),
                1e-6)
        << out;
  }
  ASSERT_EQ(
      call({"move", file, "--fault", "F", "--method", "rigid", "--close", "A", "--out", path("m.toml"), "--quiet"})
          .code,
      0);
  EXPECT_EQ(call({"run", path("m.toml"), "--out", path("made")}).code, 0);
}

TEST_F(MoveCommands, PiecesComeBackByTheirNamesFromAFormatThatNumbersLinesOfOneName) {
  const std::string file = put("n.csv", moved_down_100);
  ASSERT_EQ(call({"move", file, "--fault", "F", "--method", "fault_parallel_flow", "--slip=-50", "--direction",
                  "forward", "--out", path("forward.dxf"), "--quiet"})
                .code,
            0);
  const auto listed = call({"faults", path("forward.dxf"), "--kind", "F=fault", "--json"});
  ASSERT_EQ(listed.code, 0) << listed.err;
  EXPECT_NE(listed.err.find("'A (1)' to 'A (2)' are taken for the pieces of horizon 'A'"), std::string::npos)
      << listed.err;
  const MoveOut cutoffs = MoveOut::parse(listed.out)["faults"][0]["cutoffs"];
  ASSERT_EQ(cutoffs.size(), 2U);
  for (const auto& cutoff : cutoffs) EXPECT_NEAR(cutoff["separation"], 50.0 + 100.0 * std::sqrt(2.0), 1e-6);
  const MoveOut back = moved(path("forward.dxf"), {"--kind", "F=fault", "--method", "rigid", "--close", "A"});
  EXPECT_EQ(back["pieces"][0]["name"], "A (1)");
  EXPECT_EQ(back["pieces"][0]["piece_of"], "A");
  EXPECT_NEAR(back["slip"], 50.0 + 100.0 * std::sqrt(2.0), 1e-6);
}

TEST_F(MoveCommands, SmallLoopsOfThePenAreCutOnRequestAndElseRefusedWithTheOption) {
  std::string looped = moved_down_100;
  looped.insert(looped.find("500,0,A"), "200,0,A,\n203,1,A,\n203,-1,A,\n201,1,A,\n");
  const std::string file = put("loop.csv", looped);
  const auto refused = call({"move", file, "--fault", "F", "--method", "rigid", "--close", "A"});
  EXPECT_EQ(refused.code, 3);
  EXPECT_NE(refused.err.find("--self-crossings cut_loops"), std::string::npos) << refused.err;
  const MoveOut made = moved(file, {"--self-crossings", "cut_loops", "--method", "rigid", "--close", "A"});
  EXPECT_NEAR(made["slip"], 100.0 * std::sqrt(2.0), 1e-9);
  EXPECT_EQ(call({"faults", file, "--self-crossings", "cut_loops"}).code, 0);
}

TEST_F(MoveCommands, ExitCodesTellUsageInputAndWhatCannotBeDone) {
  const std::string file = put("n.csv", moved_down_100);
  EXPECT_EQ(call({"move", file, "--fault", "F", "--method", "shear", "--slip", "0"}).code, 3);
  EXPECT_EQ(call({"move", file, "--fault", "G", "--method", "shear", "--slip", "1"}).code, 3);
  EXPECT_EQ(call({"move", file, "--fault", "F", "--method", "slide", "--slip", "1"}).code, 2);
  const auto along = call({"move", file, "--fault", "F", "--method", "shear", "--slip", "1", "--angle=-45"});
  EXPECT_EQ(along.code, 4);
  EXPECT_NE(along.err.find("(at "), std::string::npos) << along.err;
  EXPECT_EQ(call({"move", file, "--fault", "F", "--method", "fault_bend_fold", "--close", "A"}).code, 4);
}

}  // namespace
}  // namespace recon::cli
