#include "recon/cli/section_commands.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "recon/core/operations.h"
#include "tests/support/command_line.h"
#include "tests/support/tiff.h"

namespace recon::cli {
namespace {

using dobra::test::Outcome;
using Json = nlohmann::json;

class SectionCommands : public dobra::test::CommandLine {
 protected:
  SectionCommands() : CommandLine(core::program(), {restore_command(), balance_command()}) {}

  /// Two horizons of 100 m, and whatever else.
  [[nodiscard]] std::string section(const std::string& more = "") const {
    return put("section.csv",
               "x,z,name,kind\n0,0,top,horizon\n50,10,top,horizon\n100,0,top,horizon\n"
               "0,-20,base,horizon\n50,-10,base,horizon\n100,-20,base,horizon\n" +
                   more);
  }
  [[nodiscard]] Json restored(std::vector<std::string> args) const {
    args.insert(args.begin(), "restore");
    args.emplace_back("--json");
    const Outcome outcome = call(args);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? Json::parse(outcome.out) : Json();
  }
};

TEST_F(SectionCommands, RestoreAndBalanceTellWhatTheyFound) {
  const Json flat = restored({section(), "--top", "top"});
  EXPECT_NEAR(flat["ledger"][0]["length_after"].get<double>(), 2.0 * std::sqrt(2600.0), 1e-9);
  const Outcome balance = call({"balance", section(), "--json"});
  EXPECT_EQ(balance.code, 0) << balance.err;
  EXPECT_EQ(Json::parse(balance.out)["verdict"], "balanced");
  EXPECT_NE(call({"restore", section()}).out.find("top"), std::string::npos);
}

TEST_F(SectionCommands, ABedThatDoesNotReachThePinStaysWhereItIs) {
  const std::string file = put("half.csv", "x,z,name\n0,0,top\n2000,0,top\n800,-200,base\n2000,-200,base\n");
  for (const std::string method : {"flexural", "line_length", "proportional"}) {
    for (const std::vector<std::string>& pin : {std::vector<std::string>{}, {"--pin", "0"}, {"--pin", "2000"}}) {
      std::vector<std::string> args{file, "--top", "top", "--method", method, "--geometry"};
      args.insert(args.end(), pin.begin(), pin.end());
      const Json flat = restored(args);
      EXPECT_EQ(flat["verdict"], "balanced");
      const Json& base = flat["restored"][1]["points"];
      EXPECT_NEAR(base.front()[0].get<double>(), 800.0, 1e-9) << method;
      EXPECT_NEAR(base.back()[0].get<double>(), 2000.0, 1e-9) << method;
    }
  }
}

TEST_F(SectionCommands, RestoreAndBalanceAgreeOnShortening) {
  const std::string file =
      put("tent.csv", "x,z,name\n0,0,top\n1000,0,top\n0,-400,base\n500,-239.9219,base\n1000,-400,base\n");
  const Json balance = Json::parse(call({"balance", file, "--json"}).out);
  EXPECT_EQ(balance["verdict"], "not balanced");
  EXPECT_NEAR(balance["inconsistency_percent"].get<double>(), 100.0 * 50.0 / 1050.0, 1e-4);
  for (const std::string method : {"flexural", "line_length", "constant"}) {
    const Json flat = restored({file, "--method", method});
    EXPECT_EQ(flat["verdict"], "not balanced") << method;
    EXPECT_EQ(flat["inconsistency_percent"], balance["inconsistency_percent"]);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(flat["ledger"][i]["shortening"], balance["ledger"][i]["shortening"]);
  }
}

TEST_F(SectionCommands, GrowthInTheKindColumnIsListedAndNotJudged) {
  const std::string file = put("growth.csv",
                               "x,z,name,kind\n0,0,top,growth\n1000,0,top,growth\n0,-400,base,horizon\n"
                               "500,-239.9219,base,horizon\n1000,-400,base,horizon\n");
  EXPECT_EQ(Json::parse(call({"balance", file, "--json"}).out)["verdict"], "not judged");
  const Json flat = restored({file, "--method", "flexural", "--top", "top"});
  EXPECT_EQ(flat["ledger"][0]["kind"], "growth");
  EXPECT_EQ(flat["verdict"], "not judged");
  EXPECT_NE(flat["remarks"].back().get<std::string>().find("not judged, as growth: 'top'"), std::string::npos);
}

TEST_F(SectionCommands, HorizonsThatCrossAreRefusedWithThePlaceAndBothNames) {
  const std::string file = section("0,-30,low,horizon\n100,30,low,horizon\n");
  for (const std::string command : {"restore", "balance"}) {
    refuses({command, file}, 3, {"horizon 'top'", "crosses horizon 'low'", "--crossings allow", "(at 62.5, 7.5)"});
    EXPECT_EQ(call({command, file, "--crossings", "allow"}).code, 0);
  }
  EXPECT_EQ(call({"restore", file, "--crossings", "perhaps"}).code, 2);
}

TEST_F(SectionCommands, HorizonsThatOnlyTouchAreNoCrossing) {
  const std::string file = section("0,-10,onlap,horizon\n50,-10,onlap,horizon\n");  // ends on the base
  EXPECT_EQ(call({"restore", file}).code, 0);
}

TEST_F(SectionCommands, ATopThatDoesNotCoverTheSectionIsRefusedWithThePlaceAndHowFar) {
  const std::string file = section("-40,-40,deep,horizon\n100,-40,deep,horizon\n");
  refuses({"restore", file, "--top", "top"}, 3,
          {"horizon 'deep'", "top 'top' does not cover", "40 m", "40 %", "--uncovered continue", "(at -40, -40)"});
  const Json gone_on = restored({file, "--top", "top", "--uncovered", "continue"});
  EXPECT_EQ(gone_on["ledger"].size(), 3u);
  EXPECT_EQ(call({"restore", file, "--top", "deep"}).code, 0);
}

TEST_F(SectionCommands, APinOutsideIsRefusedWithWhereItMayStand) {
  refuses({"restore", section(), "--pin", "130"}, 3, {"pin", "x = 130", "from 0 to 100"});
  refuses({"restore", section("150,10,P,pin\n150,-30,P,pin\n")}, 3,
          {"pin line 'P'", "outside the section", "(at 150, 10)"});
}

TEST_F(SectionCommands, MixedUnitsAreRefusedWithTheLine) {
  refuses({"restore", put("mixed.csv",
                          "x,z,name,kind\n0,0,top,horizon\n12000,100,top,horizon\n"
                          "0,-1,base,horizon\n12,-1.2,base,horizon\n")},
          3, {"horizon 'base'", "kilometres", "(at 0, -1)"});
  refuses({"restore", put("mixed.csv",
                          "x,z,name,kind\n0,0,top,horizon\n12000,100,top,horizon\n"
                          "6,0.1,F,fault\n7,-11,F,fault\n")},
          3, {"fault 'F'", "kilometres", "(at 6, 0.1)"});
  refuses({"restore", section(), "--target", put("target.csv", "0,0\n0.1,0\n")}, 3, {"target", "kilometres"});
}

TEST_F(SectionCommands, APolygonThatDoesNotCloseIsRefusedWithThePlace) {
  const std::string file = section("0,0,U,unit\n10,0,U,unit\n20,0,U,unit\n30,0,U,unit\n30,-5,U,unit\n");
  for (const std::string command : {"restore", "balance"})
    refuses({command, file}, 3, {"unit 'U'", "does not close", "(at 30, -5)"});
}

TEST_F(SectionCommands, TheScenarioThatIsWrittenGivesTheSameLedger) {
  const std::string file = section("40,20,F,fault\n60,-40,F,fault\n");
  const Json first = restored({file, "--method", "flexural", "--pin", "20", "--out", path("again.toml")});
  const Outcome run = call({"run", path("again.toml"), "--out", path("out"), "--quiet", "--pictures", "svg"});
  EXPECT_EQ(run.code, 0) << run.err;
  const std::string report = text("out/report.json");
  const Json again = Json::parse(report);
  EXPECT_NE(report.find("horizon.top.length_after"), std::string::npos);
  EXPECT_EQ(again["steps"].size(), 3u);
}

TEST_F(SectionCommands, APictureIsWrittenWithTheLedger) {
  EXPECT_EQ(call({"restore", section(), "--out", path("sheet.svg")}).code, 0);
  const std::string svg = text("sheet.svg");
  for (const char* const word : {"top", "base", "Verdict", "Restored section"})
    EXPECT_NE(svg.find(word), std::string::npos);
  refuses({"restore", section(), "--out", path("sheet.xyz")}, 2, {".xyz"});
}

TEST_F(SectionCommands, ErrorBarsComeOnRequest) {
  const Json json = restored({section(), "--draws", "50", "--pick-error", "0.5", "--seed", "7"});
  EXPECT_EQ(json["error_bars"]["draws"], 50);
  EXPECT_FALSE(json["error_bars"]["quantities"].empty());
}

TEST_F(SectionCommands, ABackdropIsDrawnBehindTheDeformedSectionOnly) {
  ASSERT_FALSE(
      put("scan.tif", dobra::test::tiff(2, 2, 3, std::string("\xFF\0\0\0\xFF\0\0\0\xFF\x10\x20\x30", 12))).empty());
  const std::string head =
      "dobra = 1\nprogram = \"recon\"\n[input]\ny_axis = \"down\"\n"
      "[[input.horizon]]\nname = \"top\"\npoints = [[0, 0], [50, -10], [100, 0]]\n"
      "[[input.horizon]]\nname = \"base\"\npoints = [[0, 20], [50, 10], [100, 20]]\n"
      "[[input.backdrop]]\nname = \"scan\"\nfile = \"scan.tif\"\n";
  const std::string placed = put("placed.toml", head + "corners = [[-10, 40], [110, -20]]\n");
  ASSERT_EQ(call({"restore", placed, "--out", path("sheet.svg")}).code, 0);
  const std::string svg = text("sheet.svg");
  const std::size_t image = svg.find("<image");
  ASSERT_NE(image, std::string::npos);
  EXPECT_EQ(svg.find("<image", image + 1), std::string::npos);
  refuses({"restore", put("nowhere.toml", head)}, 3, {"scan.tif", "backdrop 'scan'", "corners"});
}

TEST_F(SectionCommands, TopographyCutsWhatIsErodedAndADatumIsATarget) {
  const std::string scenario = put("eroded.toml",
                                   "dobra = 1\nprogram = \"recon\"\n"
                                   "[[input.horizon]]\nname = \"top\"\npoints = [[0, 0], [50, 10], [100, 0]]\n"
                                   "[[input.horizon]]\nname = \"base\"\npoints = [[0, -20], [50, -10], [100, -20]]\n"
                                   "[[input.topography]]\nname = \"today\"\npoints = [[-10, 5], [40, 5], [110, 20]]\n"
                                   "[[input.datum]]\nname = \"sea\"\npoints = [[-50, 3], [200, 3]]\n");
  const Json base = restored({scenario, "--top", "base", "--geometry"});
  bool told = false;
  for (const auto& remark : base["remarks"])
    told = told || remark.get<std::string>().find("lie above the topography 'today'") != std::string::npos;
  EXPECT_TRUE(told);
  for (const auto& entry : base["restored"]) EXPECT_NE(entry["kind"], "eroded");
  ASSERT_EQ(call({"restore", scenario, "--top", "base", "--out", path("sheet.svg")}).code, 0);
  EXPECT_NE(text("sheet.svg").find("top (eroded)"), std::string::npos);
}

}  // namespace
}  // namespace recon::cli
