// `recon block` and `recon cut`: refusals first, then empty results, then figures that are known otherwise.

#include "recon/cli/block_commands.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "recon/cli/section_commands.h"
#include "recon/cli/solid_command.h"
#include "recon/cli/space_commands.h"
#include "recon/core/operations.h"
#include "shared/io/file.h"
#include "tests/support/command_line.h"
#include "tests/support/corpus.h"

namespace recon::cli {
namespace {

using dobra::test::Outcome;
using Json = nlohmann::json;
using testing::HasSubstr;

class BlockCommands : public dobra::test::CommandLine {
 protected:
  BlockCommands()
      : CommandLine(core::program(), {block_command(), cut_command(), solid_command(), restore_command()}) {}

  /// Two layers of 100 m by 10 m that dip by 45 degrees to the right, and a fault.
  std::string lines() const {
    return put("section.csv",
               "x,z,name,kind\n0,0,top,horizon\n100,-100,top,horizon\n0,-10,middle,horizon\n100,-110,middle,horizon\n"
               "0,-20,base,horizon\n100,-120,base,horizon\n20,0,F,fault\n40,-100,F,fault\n");
  }
  [[nodiscard]] std::string scenario(const std::string& input = "along_strike = 50\n") const {
    lines();
    return put("section.toml", "dobra = 1\nprogram = \"recon\"\n[input]\n" + input +
                                   "[[input.lines]]\nfile = \"section.csv\"\nunit = \"m\"\n");
  }
  Json told(const std::vector<std::string>& args, int code = 0) const {
    std::vector<std::string> all = args;
    all.emplace_back("--json");
    const Outcome outcome = call(all);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    return Json::parse(outcome.out);
  }
};

TEST_F(BlockCommands, SeveralSectionsAreLofted) {
  lines();
  const std::string several =
      put("several.toml",
          "dobra = 1\nprogram = \"recon\"\n[[input.section]]\nfile = \"section.csv\"\ntrace = [0, 0, "
          "100, 0]\n[[input.section]]\nname = \"far\"\nfile = \"section.csv\"\ntrace = [0, 9, 100, 9]\n");
  for (const char* const command : {"block", "solid"}) {
    const Json made = told({command, several, "--out", path("block.obj")});
    EXPECT_NEAR(made["volume"].get<double>(), 2000.0 * 9, 1e-9) << command;
    EXPECT_TRUE(std::filesystem::exists(path("block.obj"))) << command;
  }
  EXPECT_NEAR(told({"block", several})["along_strike"].get<double>(), 9.0, 1e-12);
}

TEST_F(BlockCommands, ABlockOfSeveralSectionsIsCutToUnits) {
  lines();
  const std::string several =
      put("several.toml",
          "dobra = 1\nprogram = \"recon\"\n[[input.section]]\nfile = \"section.csv\"\ntrace = [0, 0, "
          "100, 0]\n[[input.section]]\nname = \"far\"\nfile = \"section.csv\"\ntrace = [0, 9, 100, 9]\n");
  const Json made = told({"cut", several, "--through", "block", "--trace", "0,3,100,6", "--out", path("cut.toml")});
  const double length = std::hypot(100.0, 3.0);
  EXPECT_NEAR(made["area"].get<double>(), length * 20.0, 1e-8);
  EXPECT_EQ(made["units"].size(), 2U);
  EXPECT_EQ(made["horizons"], (std::vector<std::string>{"top", "middle", "base"}));
  const Json again = told({"block", path("cut.toml"), "--along-strike", "7"});
  EXPECT_NEAR(again["volume"].get<double>(), 7.0 * length * 20.0, 1e-7);
  const Outcome wrong = call({"cut", several, "--through", "air", "--trace", "0,3,100,6"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(call({"cut", several, "--through", "block", "--trace", "0,3,100,6", "--simplify", "1"}).err,
              HasSubstr("this one is cut as a block"));
}

TEST_F(BlockCommands, RefusalsSayWhatIsMissing) {
  EXPECT_EQ(told({"block", lines()}, 3)["findings"][0]["code"], "missing_key");
  EXPECT_EQ(call({"block", lines(), "--along-strike", "-3"}).code, 2);
  EXPECT_EQ(call({"block", lines(), "--along-strike", "3", "--out", "block.txt"}).code, 2);
  EXPECT_EQ(call({"block", path("none.csv"), "--along-strike", "3"}).code, 3);
  const std::string several =
      put("several.toml",
          "dobra = 1\nprogram = \"recon\"\n[[input.section]]\nfile = \"section.csv\"\ntrace = [0, 0, "
          "100, 0]\n[[input.section]]\nname = \"far\"\nfile = \"section.csv\"\ntrace = [0, 9, 100, 9]\n");
  EXPECT_THAT(call({"block", several, "--along-strike", "5"}).err, HasSubstr("each with a trace of its own"));
  const std::string bent =
      put("bent.toml",
          "dobra = 1\nprogram = \"recon\"\n[[input.section]]\nfile = \"section.csv\"\ntrace = [0, 0, "
          "100, 0]\n[[input.section]]\nname = \"far\"\nfile = \"section.csv\"\ntrace = [0, 9, 50, 9, 100, 19]\n");
  EXPECT_THAT(call({"block", bent}).err, testing::AllOf(HasSubstr("bends here"), HasSubstr("(at 50, 9")));
  EXPECT_EQ(call({"cut", lines(), "--trace", "0,0,1,1"}).code, 2);
  EXPECT_EQ(call({"cut", scenario(), "--trace", "0,0,1"}).code, 2);
  EXPECT_EQ(call({"cut", scenario()}).code, 2);
  EXPECT_EQ(call({"cut", scenario(), "--trace", "4,4,4,4"}).code, 3);
  EXPECT_EQ(call({"cut", scenario(""), "--trace", "0,0,1,1"}).code, 3);
  EXPECT_EQ(call({"cut", scenario(), "--trace", "0,0,1,1", "--out", path("section.csv")}).code, 2);
}

TEST_F(BlockCommands, BlockHasTheVolumesOfItsUnitsAndWritesTheirFaces) {
  const Json json = told({"block", lines(), "--along-strike", "50", "--out", path("block.obj")});
  EXPECT_EQ(json["volume"], 2000.0 * 50.0);
  EXPECT_EQ(json["area"], 2000.0);
  ASSERT_EQ(json["units"].size(), 2U);
  EXPECT_EQ(json["units"][0]["name"], "top - middle");
  EXPECT_EQ(json["units"][0]["volume"], 50000.0);
  EXPECT_EQ(json["vertices"], 12);
  EXPECT_EQ(json["edges"], 20);
  EXPECT_EQ(json["faces"], 11);
  EXPECT_TRUE(json["findings"].empty()) << json["findings"];
  const std::string text = dobra::io::read_text(path("block.obj")).value();
  EXPECT_THAT(text, HasSubstr("g top_-_middle horizon_top\n"));
  EXPECT_THAT(text, HasSubstr("g middle_-_base horizon_middle\n"));
  EXPECT_THAT(text, HasSubstr("g middle_-_base start\n"));
  for (const char* name : {"block.stl", "block.ply", "block.off"})
    EXPECT_EQ(call({"block", lines(), "--along-strike", "50", "--out", path(name)}).code, 0) << name;
}

TEST_F(BlockCommands, WhatReadingRemarksIsSaidOnce) {
  const std::string two =
      put("two.csv",
          "x,z,name,kind\n0,0,top,horizon\n40,0,top,horizon\n0,-20,base,horizon\n50,-20,base,horizon\n"
          "40,-5,top,horizon\n100,-5,top,horizon\n50,-25,base,horizon\n100,-25,base,horizon\n"
          "40,10,F,fault\n40,-5,F,fault\n50,-20,F,fault\n50,-40,F,fault\n");
  const Outcome outcome = call({"block", two, "--along-strike", "5"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string remark = "horizon 'top' is in 2 pieces";
  const std::size_t first = outcome.err.find(remark);
  ASSERT_NE(first, std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find(remark, first + 1), std::string::npos) << outcome.err;
}

TEST_F(BlockCommands, AGapAcrossTheWholeSectionIsToldWithItsPlace) {
  // 1 to 2 m between two beds, open at both sides: (1 + 2) / 2 by 10 m.
  const std::string strip = put("strip.toml",
                                "dobra = 1\nprogram = \"recon\"\n[[input.polygon]]\nname = \"A\"\npoints = "
                                "[[0, 0], [10, 0], [10, 5], [0, 5]]\n[[input.polygon]]\nname = \"B\"\npoints = "
                                "[[0, -6], [10, -6], [10, -1], [0, -2]]\n");
  const Json json = told({"block", strip, "--along-strike", "10"});
  EXPECT_EQ(json["volume"], 950.0);
  std::vector<Json> gaps;
  for (const Json& finding : json["findings"]) {
    if (finding["code"] == "gap") gaps.push_back(finding);
  }
  ASSERT_EQ(gaps.size(), 1U) << json["findings"];
  EXPECT_EQ(gaps[0]["place"]["point"], (std::vector<double>{5.0, -0.75, 0.0}));
  const auto message = gaps[0]["message"].get<std::string>();
  EXPECT_THAT(message, HasSubstr("gap of 15 m2, 10 m wide"));
  EXPECT_THAT(message, HasSubstr("draw a unit there"));
  EXPECT_THAT(call({"block", strip, "--along-strike", "10"}).err, HasSubstr("each other (at 5, -0.75)"));
}

TEST_F(BlockCommands, AnUprightGapIsToldOnceWithItsPlace) {
  const std::string strip = put("upright.toml",
                                "dobra = 1\nprogram = \"recon\"\n[[input.polygon]]\nname = \"A\"\npoints = "
                                "[[0, 0], [50, 0], [50, 40], [0, 40]]\n[[input.polygon]]\nname = \"B\"\npoints = "
                                "[[60, 0], [100, 0], [100, 40], [60, 40]]\n");
  const Json json = told({"block", strip, "--along-strike", "10"});
  EXPECT_EQ(json["volume"], 36000.0);
  ASSERT_EQ(json["findings"].size(), 1U) << json["findings"];
  EXPECT_EQ(json["findings"][0]["code"], "gap");
  EXPECT_EQ(json["findings"][0]["place"]["point"], (std::vector<double>{55.0, 20.0, 0.0}));
  EXPECT_THAT(json["findings"][0]["message"].get<std::string>(), HasSubstr("gap of 400 m2, 40 m high"));
}

TEST_F(BlockCommands, NumbersInNamesThatMakeNoPiecesAreToldWithWhatToWrite) {
  const auto section = [&](const std::string& of_first, const std::string& of_second) {
    const auto row = [](const char* kind, const char* name, const std::string& more, const char* points) {
      return std::string("[[input.") + kind + "]]\nname = \"" + name + "\"\n" + more + "points = " + points + "\n";
    };
    return put("numbered.toml",
               "dobra = 1\nprogram = \"recon\"\n" + row("horizon", "A (1)", of_first, "[[0, 0], [39.5, 0]]") +
                   row("horizon", "A (2)", of_second, "[[40, -4], [100, -4]]") +
                   row("horizon", "B", "", "[[0, -20], [100, -20]]") + row("fault", "F", "", "[[40, 10], [40, -40]]"));
  };
  const std::string words = "give each of them piece_of = \"A\"";
  const std::string whole = "piece_of = \"A\"\n";
  const auto remarks = [&](const std::string& file) {
    std::vector<Json> found;
    const Json json = told({"block", file, "--along-strike", "5"});
    for (const Json& finding : json["findings"]) {
      if (finding["message"].get<std::string>().find(words) != std::string::npos) found.push_back(finding);
    }
    return found;
  };
  const auto alone = remarks(section("", ""));
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_THAT(alone[0]["message"].get<std::string>(), HasSubstr("'A (1)', 'A (2)': numbers in names make no pieces"));
  EXPECT_EQ(alone[0]["place"]["point"], (std::vector<double>{0.0, 0.0, 0.0}));
  const auto one = remarks(section(whole, ""));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0]["message"].get<std::string>().find("'A (2)': "), 0U);
  EXPECT_TRUE(remarks(section(whole, whole)).empty());
  // As pieces, the end beside the fault is told, and once.
  const Json json = told({"block", section(whole, whole), "--along-strike", "5"});
  ASSERT_EQ(json["findings"].size(), 1U) << json["findings"];
  EXPECT_EQ(json["findings"][0]["code"], "open_end");
}

TEST_F(BlockCommands, TwistedBedsBetweenTwoSectionsHaveTheVolumeOfTheRuledSurface) {
  // The top from 0, 0 to 30, -10: the mean of its corners is 5 m, over 10 m down to the base.
  (void)put("a.csv", "x,z,name,kind\n0,0,top,horizon\n100,0,top,horizon\n0,-10,base,horizon\n100,-10,base,horizon\n");
  (void)put("b.csv",
            "x,z,name,kind\n0,30,top,horizon\n100,-10,top,horizon\n0,-10,base,horizon\n100,-10.5,base,horizon\n");
  const std::string several = put("twisted.toml",
                                  "dobra = 1\nprogram = \"recon\"\n[[input.section]]\nfile = \"a.csv\"\ntrace = [0, 0, "
                                  "100, 0]\n[[input.section]]\nfile = \"b.csv\"\ntrace = [0, 60, 100, 60]\n");
  EXPECT_NEAR(told({"block", several})["volume"].get<double>(), 100.0 * 60.0 * (15.0 + 0.125), 1e-8);
  EXPECT_NEAR(told({"solid", several})["volume"].get<double>(), 100.0 * 60.0 * (15.0 + 0.125), 1e-8);
  // Half-way the cut goes through the middle of each cell, on the ruled surface: heights 15 and -5.
  const Json half = told({"cut", several, "--through", "block", "--trace", "0,30,100,30", "--out", path("half.toml")});
  EXPECT_NEAR(half["area"].get<double>(), 100.0 * (5.0 + 10.125), 1e-8);
}

TEST_F(BlockCommands, BlanksInListsOfNumbersAreTaken) {
  const Json plain = told({"cut", scenario(), "--trace", "0,0,50,50"});
  EXPECT_EQ(told({"cut", scenario(), "--trace", "0, 0 , 50,  50 "})["area"], plain["area"]);
  told({"solid", scenario(), "--out", path("part.stl")});
  const auto moved = [&](const char* matrix) {
    return std::vector<std::string>{"solid", scenario(), "--unite", path("part.stl"), "--place", matrix};
  };
  EXPECT_EQ(told(moved("1, 0, 0, 1000, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1"))["volume"], 200000.0);
  EXPECT_THAT(call(moved("1, 0, x")).err, HasSubstr("'x' is not a finite number"));
  EXPECT_THAT(call(moved("1, 0, 0")).err, HasSubstr("the 16 numbers of a matrix"));
  EXPECT_THAT(call({"cut", scenario(), "--trace", "0,0,50,50,80,60"}).err, HasSubstr("give four numbers"));
}

TEST_F(BlockCommands, ACutAlongStrikeThroughAFaultOpensAgainOrIsNotWritten) {
  const std::string block = put(
      "fault.toml",
      "dobra = 1\nprogram = \"recon\"\n[input]\nalong_strike = 64\n[[input.horizon]]\nname = \"A (1)\"\npiece_of = "
      "\"A\"\npoints = [[0, 0], [40, 0]]\n[[input.horizon]]\nname = \"A (2)\"\npiece_of = \"A\"\npoints = [[50, -4], "
      "[100, -4]]\n[[input.horizon]]\nname = \"B (1)\"\npiece_of = \"B\"\npoints = [[0, -20], [60, "
      "-20]]\n[[input.horizon]]\nname = \"B (2)\"\npiece_of = \"B\"\npoints = [[70, -24], [100, "
      "-24]]\n[[input.fault]]\nname = \"F\"\npoints = [[30, 8], [40, 0], [50, -4], [60, -20], [70, -24], [75, -30]]\n");
  const Json cut = told({"cut", block, "--trace", "45,0,45,64", "--out", path("along.toml")});
  EXPECT_NEAR(cut["area"].get<double>(), 18.0 * 64.0, 1e-9);
  const Json again = told({"block", path("along.toml"), "--along-strike", "5"});
  EXPECT_NEAR(again["volume"].get<double>(), 18.0 * 64.0 * 5.0, 1e-8);
  EXPECT_TRUE(again["findings"].empty()) << again["findings"];
  // Between the two beds' ends at the fault and its other wall there is the fault alone over nothing.
  for (const char* const x : {"40", "50", "60", "65", "70"}) {
    const std::string name = path(std::string("at") + x + ".toml");
    const std::string trace = std::string(x) + ",0," + x + ",64";
    const Outcome made = call({"cut", block, "--trace", trace, "--out", name});
    if (std::filesystem::exists(name)) {
      EXPECT_EQ(made.code, 0) << x << made.err;
      EXPECT_EQ(call({"block", name, "--along-strike", "5"}).code, 0) << x;
    } else {
      EXPECT_EQ(made.code, 4) << x;
      EXPECT_THAT(made.err, HasSubstr("no file is written")) << x;
    }
  }
}

TEST_F(BlockCommands, HelpAndAdviceNameWhatTheCommandHas) {
  EXPECT_THAT(call({"cut", "--help"}).out, HasSubstr("without further corners"));
  EXPECT_THAT(call({"block", scenario("")}).err, HasSubstr("--along-strike"));
  const Outcome solid = call({"solid", scenario("")});
  EXPECT_EQ(solid.code, 3);
  EXPECT_THAT(solid.err, testing::AllOf(HasSubstr("along_strike"), testing::Not(HasSubstr("--along-strike"))));
}

TEST_F(BlockCommands, SolidTakesTheBlockOfASectionAsOneOrAUnitOfIt) {
  const Json all = told({"solid", scenario(), "--out", path("part.stl")});
  EXPECT_EQ(all["volume"], 100000.0);
  EXPECT_EQ(all["shells"], 1);
  EXPECT_EQ(all["genus"], 0);
  EXPECT_TRUE(std::filesystem::exists(path("part.stl")));
  const Json again = told({"solid", path("part.stl")});
  EXPECT_EQ(again["volume"], 100000.0);
  const Json one = told({"solid", scenario(), "--part", "middle - base"});
  EXPECT_EQ(one["volume"], 50000.0);
  const Json without = told({"solid", scenario(), "--subtract", path("part.stl")});
  EXPECT_EQ(without["volume"], 0.0);
  EXPECT_EQ(call({"solid", scenario(), "--part", "none"}).code, 3);
  EXPECT_EQ(call({"solid", scenario(""), "--json"}).code, 3);
}

TEST_F(BlockCommands, ABlockMayStandAskewOnTheMap) {
  const std::string askew = scenario("along_strike = 50\ntrace = [678123.4, 7391234.5, 678201.7, 7391300.1]\n");
  EXPECT_EQ(told({"block", askew, "--out", path("block.obj")})["volume"], 100000.0);
  const std::string text = dobra::io::read_text(path("block.obj")).value();
  EXPECT_THAT(text, HasSubstr("v 678123.4"));
  const Json cut = told({"cut", askew, "--trace", "678123.4,7391234.5,678201.7,7391300.1"});
  EXPECT_NEAR(cut["area"].get<double>(), 2000.0, 1e-5);
  const Json solid = told({"solid", askew});
  EXPECT_EQ(solid["volume"], 100000.0);
  EXPECT_EQ(solid["findings"][0]["code"], "block_coordinates");
}

TEST_F(BlockCommands, APlaneThatMissesIsToldAndWritesNothing) {
  const Json json = told({"cut", scenario(), "--trace", "0,60,100,60", "--out", path("cut.toml")});
  EXPECT_EQ(json["area"], 0.0);
  EXPECT_TRUE(json["units"].empty());
  EXPECT_EQ(json["findings"][0]["code"], "cut_misses");
  EXPECT_FALSE(std::filesystem::exists(path("cut.toml")));
}

TEST_F(BlockCommands, CutWritesASectionThatReconOpensAndRestores) {
  const Json json = told({"cut", scenario(), "--trace", "0,0,50,50", "--out", path("cut.toml")});
  EXPECT_NEAR(json["area"].get<double>(), 50.0 * std::sqrt(2.0) * 20.0, 1e-9);
  EXPECT_EQ(json["horizons"], (std::vector<std::string>{"top", "middle", "base"}));
  EXPECT_EQ(json["faults"], (std::vector<std::string>{"F"}));
  EXPECT_TRUE(json["findings"].empty()) << json["findings"];
  const Json again = told({"block", path("cut.toml"), "--along-strike", "7"});
  EXPECT_NEAR(again["volume"].get<double>(), 7.0 * json["area"].get<double>(), 1e-8);
  // The bed goes down by 50 m over 70.7 m.
  const Json flat = told({"restore", path("cut.toml"), "--top", "top", "--method", "line_length"});
  EXPECT_NEAR(flat["ledger"][0]["length_after"].get<double>(), std::sqrt(5000.0 + 2500.0), 1e-9);
}

TEST_F(BlockCommands, ItsOwnTraceGivesTheSectionBackThroughTheFile) {
  const std::string first = path("first.toml");
  told({"cut", scenario(), "--trace", "0,0,100,0", "--out", first});
  told({"cut", first, "--along-strike", "20", "--trace", "0,0,100,0", "--out", path("second.toml")});
  EXPECT_EQ(dobra::io::read_text(first).value(), dobra::io::read_text(path("second.toml")).value());
}

TEST_F(BlockCommands, AScenarioCutsItsBlockWhenItIsRead) {
  const std::string by_command = path("cut.toml");
  told({"cut", scenario(), "--trace", "10,5,60,30", "--out", by_command});
  const Json there = told({"restore", by_command, "--top", "top"});
  const Json here = told({"restore", scenario("along_strike = 50\ncut = [10, 5, 60, 30]\n"), "--top", "top"});
  EXPECT_EQ(here["ledger"], there["ledger"]);
  EXPECT_EQ(call({"restore", scenario("cut = [10, 5, 60, 30]\n"), "--top", "top"}).code, 3);
  EXPECT_EQ(call({"restore", scenario("along_strike = 50\ncut = [10, 5, 60]\n"), "--top", "top"}).code, 3);
  const Outcome missed = call({"restore", scenario("along_strike = 50\ncut = [0, 70, 100, 70]\n"), "--top", "top"});
  EXPECT_EQ(missed.code, 3);
  EXPECT_THAT(missed.err, HasSubstr("misses the block"));
}

TEST_F(BlockCommands, RealSectionsComeBackFromTheirBlocks) {
  const auto data = dobra::test::data_folder();
  if (!data) GTEST_SKIP() << dobra::test::no_data;
  for (const char* folder : {"catskill_fpf", "ragan_isogon_fold"}) {
    std::string text = "dobra = 1\nprogram = \"recon\"\n[input]\nalong_strike = 3000\nself_crossings = \"cut_loops\"\n";
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(*data / "sections" / folder)) files.push_back(entry);
    std::sort(files.begin(), files.end());
    for (const auto& file : files)
      text += "[[input.horizon]]\nname = \"" + file.stem().string() + "\"\nfile = \"" + file.string() + "\"\n";
    const std::string section = put("real.toml", text);
    const Json block = told({"block", section});
    EXPECT_EQ(block["volume"], 3000.0 * block["area"].get<double>()) << folder;
    const Json cut = told({"cut", section, "--trace", "0,0,1000,0", "--out", path("own.toml")});
    EXPECT_NEAR(cut["area"].get<double>(), block["area"].get<double>(), 1e-12 * block["area"].get<double>());
    for (const Json& finding : cut["findings"]) {
      const std::string code = finding["code"];
      EXPECT_TRUE(code == "section_remark" || code == "slanted_side") << finding;
    }
    EXPECT_EQ(told({"block", path("own.toml"), "--along-strike", "3000"})["units"], block["units"]) << folder;
  }
}

}  // namespace
}  // namespace recon::cli
