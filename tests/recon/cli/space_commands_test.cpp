// recon surface and recon cut: JSON that scripts rely on, files that chain, refusals with their place.

#include "recon/cli/space_commands.h"

#include <fmt/format.h>
#include <map>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "recon/cli/section_commands.h"
#include "recon/core/operations.h"
#include "shared/io/meshes/tsurf.h"
#include "tests/support/command_line.h"

namespace recon::cli {
namespace {

using SpaceOut = nlohmann::json;

class SpaceCommands : public dobra::test::CommandLine {
 protected:
  SpaceCommands() : CommandLine(core::program(), {surface_command(), cut_command(), restore_command()}) {}

  /// A section along y with two horizons, 100 m apart along the vertical; the trace is that of the document.
  [[nodiscard]] std::string lines(double y, const std::function<double(double, double)>& top,
                                  double shift = 0.0) const {
    std::string text = "x,z,name,kind\n";
    for (const auto& [name, depth] : {std::pair("A", 0.0), {"B", -100.0}}) {
      for (int i = 0; i <= 50; ++i) {
        const double x = 20.0 * i;
        text += fmt::format("{},{},{},horizon\n", x, top(x, y) + depth + shift, name);
      }
      text += "\n";
    }
    return text;
  }
  /// Four sections side by side, 200 m apart.
  [[nodiscard]] std::string row(const std::function<double(double, double)>& top) const {
    std::string text = "dobra = 1\nprogram = \"recon\"\n[input]\n";
    for (int k = 0; k < 4; ++k) {
      const double y = 200.0 * k;
      (void)put(fmt::format("s{}.csv", k), lines(y, top));
      text +=
          fmt::format("[[input.section]]\nname = \"S{0}\"\nfile = \"s{0}.csv\"\ntrace = [0, {1}, 1000, {1}]\n", k, y);
    }
    return put("space.toml", text);
  }
  [[nodiscard]] SpaceOut json(std::vector<std::string> args) const {
    const auto outcome = call(std::move(args));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? SpaceOut::parse(outcome.out) : SpaceOut();
  }
};

double slope(double x, double y) { return 0.2 * x + 0.1 * y; }

TEST_F(SpaceCommands, SurfacesAreMeasuredAndWritten) {
  const std::string file = row(slope);
  const SpaceOut made = json({"surface", file, "--json", "--quiet", "--out", path("horizons.ts")});
  ASSERT_EQ(made["surfaces"].size(), 2U);
  for (const auto& surface : made["surfaces"]) {
    EXPECT_EQ(surface["kind"], "horizon");
    EXPECT_NEAR(surface["area"], 600'000.0 * std::sqrt(1.05), 1e-5);
    EXPECT_NEAR(surface["dip_mean"], std::atan(std::sqrt(0.05)) * 57.29577951308232, 1e-9);
    EXPECT_TRUE(surface["misties"].is_array());
  }
  EXPECT_EQ(made["surfaces"][0]["name"], "A");
  ASSERT_EQ(made["volumes"].size(), 1U);
  EXPECT_NEAR(made["volumes"][0]["volume"], 6e7, 1e-3);
  EXPECT_TRUE(made["findings"].is_array());
  const auto read = dobra::io::meshes::parse_tsurfs(text("horizons.ts"), "horizons.ts");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_EQ(read->size(), 2U);
  EXPECT_EQ((*read)[1].name, "B");
  EXPECT_EQ((*read)[1].kind, "horizon");
  for (const char* other : {"h.obj", "h.vtp", "h.vtu"}) {
    EXPECT_EQ(call({"surface", file, "--out", path(other)}).code, 0) << other;
    EXPECT_GT(text(other).size(), 1000U) << other;
  }
  refuses({"surface", file, "--out", path("h.docx")}, 2, {".docx", ".ts"});
}

TEST_F(SpaceCommands, ACutIsASectionThatIsRestored) {
  const std::string file = row([](double x, double y) { return 40.0 * std::sin(0.0062832 * x) + 0.05 * y; });
  const SpaceOut cut =
      json({"cut", file, "--trace", "100,50,900,550", "--json", "--quiet", "--out", path("section.toml")});
  EXPECT_NEAR(cut["length"], std::hypot(800.0, 500.0), 1e-9);
  ASSERT_EQ(cut["lines"].size(), 2U);
  EXPECT_NEAR(cut["lines"][0]["points"].back()[0], std::hypot(800.0, 500.0), 1e-6);
  const auto restored = call({"restore", path("section.toml"), "--method", "constant", "--json"});
  EXPECT_EQ(restored.code, 0) << restored.err;
  // At a section's own trace its lines come back.
  const SpaceOut own = json({"cut", file, "--trace", "0,200,1000,200", "--json", "--quiet"});
  ASSERT_EQ(own["lines"][0]["points"].size(), 51U);
  for (int i = 0; i <= 50; ++i) {
    EXPECT_NEAR(own["lines"][0]["points"][i][0], 20.0 * i, 1e-9);
    EXPECT_NEAR(own["lines"][0]["points"][i][1], 40.0 * std::sin(0.0062832 * 20.0 * i) + 10.0, 1e-9);
  }
}

TEST_F(SpaceCommands, VolumesBesideFaultsAreThoseOfTheBlocks) {
  // A bed 200 m thick, 2000 by 800 m; a thrust that repeats 450 m of it.
  std::string document = "dobra = 1\nprogram = \"recon\"\n[input]\n";
  (void)put("thrust.csv",
            "x,z,name,kind\n0,900,F,fault\n1800,-300,F,fault\n\n"
            "0,0,A,horizon\n1350,0,A,horizon\n\n900,300,A,horizon\n2000,300,A,horizon\n\n"
            "0,-200,B,horizon\n1650,-200,B,horizon\n\n1200,100,B,horizon\n2000,100,B,horizon\n");
  for (const int y : {0, 300, 800})
    document +=
        fmt::format("[[input.section]]\nname = \"S{0}\"\nfile = \"thrust.csv\"\ntrace = [0, {0}, 2000, {0}]\n", y);
  const SpaceOut made = json({"surface", put("thrust.toml", document), "--json", "--quiet"});
  ASSERT_EQ(made["volumes"].size(), 1U);
  EXPECT_NEAR(made["volumes"][0]["volume"].get<double>() / (200.0 * 2450.0 * 800.0), 1.0, 1e-9);
  EXPECT_NEAR(made["volumes"][0]["map_area"], 1.6e6, 1e-3);
  EXPECT_EQ(made["volumes"][0]["unsure"], 0.0);
}

TEST_F(SpaceCommands, MistiesAboveTheToleranceAreRefusedAndPrintedAsAFinding) {
  (void)put("a.csv", lines(0.0, slope));
  (void)put("b.csv", "x,z,name,kind\n0,7,A,horizon\n500,7,A,horizon\n");
  const std::string file = put("cross.toml",
                               "dobra = 1\nprogram = \"recon\"\n[input]\n[[input.section]]\nname = \"long\"\nfile = "
                               "\"a.csv\"\ntrace = [0, 0, 1000, 0]\n[[input.section]]\nname = \"across\"\nfile = "
                               "\"b.csv\"\ntrace = [100, -250, 100, 250]\n");
  const auto outcome = call({"surface", file, "--json", "--mistie-tolerance", "5"});
  EXPECT_EQ(outcome.code, 3) << outcome.err;
  const SpaceOut refused = SpaceOut::parse(outcome.out);
  EXPECT_FALSE(refused.contains("surfaces"));
  ASSERT_EQ(refused["findings"].size(), 1U);
  EXPECT_NEAR(refused["findings"][0]["place"]["point"][0], 100.0, 1e-9);
  EXPECT_NE(outcome.err.find("13 m apart where 'long' and 'across' cross"), std::string::npos) << outcome.err;
}

TEST_F(SpaceCommands, MistiesThatAreSharedOutArePrinted) {
  std::string document = "dobra = 1\nprogram = \"recon\"\n[input]\n";
  const auto add = [&](const char* name, double z, const char* trace) {
    (void)put(fmt::format("{}.csv", name), fmt::format("x,z,name,kind\n0,{0},A,horizon\n1200,{0},A,horizon\n", z));
    document += fmt::format("[[input.section]]\nname = \"{0}\"\nfile = \"{0}.csv\"\ntrace = {1}\n", name, trace);
  };
  add("south", 4.0, "[-100, 0, 1100, 0]");
  add("north", 0.0, "[-100, 1000, 1100, 1000]");
  add("west", 0.0, "[0, -100, 0, 1100]");
  add("east", 0.0, "[1000, -100, 1000, 1100]");
  const std::string file = put("net.toml", document);
  const auto printed = call({"surface", file, "--quiet"});
  EXPECT_EQ(printed.code, 0) << printed.err;
  EXPECT_NE(printed.out.find("mis-tie of A at (1000, 0): 'south' is 4 m above 'east'; shared out"), std::string::npos)
      << printed.out;
  EXPECT_EQ(printed.out.find("'north'"), std::string::npos) << printed.out;
  // A cut has the findings of its surfaces: lines that go on beyond the last crossing.
  const SpaceOut cut = json({"cut", file, "--trace", "100,100,900,800", "--json", "--quiet"});
  EXPECT_TRUE(std::any_of(cut["findings"].begin(), cut["findings"].end(),
                          [](const SpaceOut& f) { return f["code"] == "beyond_cells"; }));
}

TEST_F(SpaceCommands, RemarksOfReadingAreFindingsWithTheirSectionAndPlace) {
  (void)put("a.csv", lines(0.0, slope));
  (void)put("pieces.csv",
            "x,z,name,kind\n0,50,A,horizon\n400,130,A,horizon\n\n600,170,A,horizon\n1000,250,A,horizon\n");
  const std::string file = put("d.toml",
                               "dobra = 1\nprogram = \"recon\"\n[input]\n[[input.section]]\nname = \"short\"\nfile = "
                               "\"a.csv\"\ntrace = [0, 0, 0, 700]\n[[input.section]]\nname = \"parted\"\nfile = "
                               "\"pieces.csv\"\ntrace = [500, 0, 500, 1000]\n");
  const auto of = [](const SpaceOut& all, const char* code) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const SpaceOut& f) { return f["code"] == code; });
    return found == all.end() ? SpaceOut() : *found;
  };
  for (const bool cut : {false, true}) {
    std::vector<std::string> args{cut ? "cut" : "surface", file, "--json", "--quiet"};
    if (cut) args.insert(args.end(), {"--trace", "0,200,500,300"});
    const SpaceOut findings = json(args)["findings"];
    // 1000 m of line over 700 m of trace, which runs north from the origin.
    const SpaceOut beyond = of(findings, "beyond_trace");
    ASSERT_FALSE(beyond.is_null()) << findings;
    EXPECT_EQ(beyond["place"]["item"], "section 'short'");
    EXPECT_EQ(beyond["place"]["point"], (std::vector<double>{0.0, 700.0, 0.0}));
    EXPECT_NE(beyond["message"].get<std::string>().find("300 m beyond"), std::string::npos) << beyond;
    const SpaceOut remark = of(findings, "section_remark");
    ASSERT_FALSE(remark.is_null()) << findings;
    EXPECT_EQ(remark["place"]["item"], "section 'parted'");
    EXPECT_EQ(remark["place"]["file"], path("pieces.csv"));
    EXPECT_NE(remark["message"].get<std::string>().find("2 pieces"), std::string::npos) << remark;
  }
  EXPECT_NE(call({"surface", file}).err.find("straight on (at 0, 700)"), std::string::npos);
}

/// Data in millimetres end some hundredths beside a trace whose length has more digits.
TEST_F(SpaceCommands, WhatFilesRoundIsNotBeyondATrace) {
  const auto told = [&](const char* end) {
    for (const char* name : {"a", "b"})
      (void)put(
          std::string(name) + ".csv",
          fmt::format("x,z,name,kind\n0.000,50.000,A,horizon\n500.000,60.000,A,horizon\n{},80.000,A,horizon\n", end));
    // sqrt(700^2 + 700^2) = 989.94949...
    const std::string file = put("d.toml",
                                 "dobra = 1\nprogram = \"recon\"\n[input]\n[[input.section]]\nname = \"one\"\nfile = "
                                 "\"a.csv\"\ntrace = [0, 0, 700, 700]\n[[input.section]]\nname = \"two\"\nfile = "
                                 "\"b.csv\"\ntrace = [700, -700, 1400, 0]\n");
    const SpaceOut findings = json({"surface", file, "--json", "--quiet"})["findings"];
    return std::count_if(findings.begin(), findings.end(),
                         [](const SpaceOut& f) { return f["code"] == "beyond_trace"; });
  };
  EXPECT_EQ(told("989.950"), 0);
  EXPECT_EQ(told("990.050"), 2);
}

/// Two planes that cross along x = 500: 500 m by 200 m by 1000 m, halved, on either side.
TEST_F(SpaceCommands, ASinglePieceATopographyAndHorizonsThatCrossAreTold) {
  const std::string planes = "0,100,A,horizon\n1000,-100,A,horizon\n\n0,-100,B,horizon\n1000,100,B,horizon\n";
  (void)put("a.csv", "x,z,name,kind\n" + planes + "\n0,300,T,topography\n1000,300,T,topography\n");
  (void)put("b.csv",
            "x,z,name,kind\n0,100,A (1),horizon\n1000,-100,A (1),horizon\n\n0,-100,B,horizon\n"
            "1000,100,B,horizon\n");
  const std::string file = put("d.toml",
                               "dobra = 1\nprogram = \"recon\"\n[input]\n[[input.section]]\nname = \"one\"\nfile = "
                               "\"a.csv\"\ntrace = [0, 0, 1000, 0]\n[[input.section]]\nname = \"two\"\nfile = "
                               "\"b.csv\"\ntrace = [0, 1000, 1000, 1000]\n");
  const SpaceOut told = json({"surface", file, "--json", "--quiet"});
  EXPECT_EQ(told["surfaces"].size(), 2U) << told;
  std::map<std::string, SpaceOut> findings;
  for (const SpaceOut& f : told["findings"]) findings[f["code"]] = f;
  ASSERT_EQ(findings.count("topography_left_out") + findings.count("piece_joined") + findings.count("cross"), 3U)
      << told;
  EXPECT_EQ(findings["topography_left_out"]["place"]["item"], "section 'one'");
  EXPECT_EQ(findings["piece_joined"]["place"]["item"], "section 'two'");
  EXPECT_NEAR(told["volumes"][0]["volume"].get<double>(), 0.0, 1e-3);
  EXPECT_NEAR(told["volumes"][0]["below"].get<double>(), 5e7, 1e-3);
  EXPECT_NE(call({"surface", file}).out.find("(5e+07 above, 5e+07 below)"), std::string::npos);
}

TEST_F(SpaceCommands, WhatCannotBeCutSaysWhy) {
  const std::string file = row(slope);
  refuses({"cut", file, "--trace", "0,5000,1000,5000"}, 3, {"no horizon lies under the trace"});
  refuses({"cut", file, "--trace", "0,100"}, 2, {"--trace: 2 numbers"});
  refuses({"cut", file, "--trace", "0,100,west,5"}, 2, {"--trace"});
  refuses({"cut", file, "--trace", "5,5,5,5"}, 2, {"--trace", "in one place"});
  const std::string one = put("one.toml",
                              "dobra = 1\nprogram = \"recon\"\n[[input.horizon]]\nname = \"A\"\npoints = [[0, 0], [9, "
                              "1]]\n");
  refuses({"cut", one, "--trace", "0,0,1,1"}, 3, {"along"});
  refuses({"surface", one}, 4, {"[[input.section]]"});
  // Steps of one section are refused where there are several.
  EXPECT_NE(call({"restore", file}).err.find("several sections in space"), std::string::npos);
}

TEST_F(SpaceCommands, SectionsThatCannotStandAreRefusedWithTheirName) {
  (void)put("a.csv", lines(0.0, slope));
  const auto document = [&](const std::string& second) {
    return put("d.toml",
               "dobra = 1\nprogram = \"recon\"\n[input]\n[[input.section]]\nname = \"first\"\nfile = "
               "\"a.csv\"\ntrace = [0, 0, 1000, 0]\n" +
                   second);
  };
  refuses({"surface", document("")}, 3, {"one [[input.section]] alone"});
  refuses({"surface", document("[[input.section]]\nfile = \"none.csv\"\ntrace = [0, 9, 10, 9]\n")}, 3, {"none.csv"});
  refuses({"surface", document("[[input.section]]\nname = \"second\"\nfile = \"a.csv\"\n")}, 3,
          {"second", "where the section stands"});
  refuses({"surface", document("[[input.section]]\nname = \"first\"\nfile = \"a.csv\"\ntrace = [0, 9, 10, 9]\n")}, 3,
          {"'first'", "name already"});
  const std::string flat = document("[[input.section]]\nname = \"second\"\nfile = \"a.csv\"\ntrace = [0, 9, 0, 9]\n");
  refuses({"surface", flat}, 3, {"d.toml:8", "second", "in one place"});
  // The table of the second section begins in line 8.
  const auto outcome = call({"surface", flat, "--json"});
  const SpaceOut place = SpaceOut::parse(outcome.out)["findings"][0]["place"];
  EXPECT_EQ(place["file"], flat);
  EXPECT_EQ(place["line"], 8);
  EXPECT_EQ(place["item"], "section 'second'");
}

}  // namespace
}  // namespace recon::cli
