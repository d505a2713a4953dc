// Kinds of lines, names, outputs: what the sub-commands make of a file of lines, and where they put it.

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "recon/cli/section_commands.h"
#include "recon/core/operations.h"
#include "shared/cli/convert_command.h"
#include "shared/cli/offset_command.h"
#include "tests/support/command_line.h"

namespace recon::cli {
namespace {

using dobra::test::Outcome;
using Json = nlohmann::json;

class SectionKinds : public dobra::test::CommandLine {
 protected:
  SectionKinds()
      : CommandLine(core::program(), {restore_command(), balance_command(), dobra::cli::convert_command(),
                                      dobra::cli::offset_command()}) {}

  /// Two beds and a line F1 of that kind.
  [[nodiscard]] std::string section(const std::string& kind) const {
    return put("section.csv",
               "x,z,name,kind\n0,0,A,\n100,0,A,\n0,-9,B,\n100,-9,B,\n50,9,F1," + kind + "\n55,-19,F1," + kind + "\n");
  }
  /// "horizon A, fault F1": what a section has once it is restored.
  [[nodiscard]] std::string kinds(std::vector<std::string> args) const {
    args.insert(args.begin(), "restore");
    args.insert(args.end(), {"--top", "A", "--crossings", "allow", "--json", "--geometry", "--quiet"});
    const Outcome outcome = call(args);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    if (outcome.code != 0) return {};
    std::string all;
    const Json made = Json::parse(outcome.out);
    for (const Json& line : made["restored"])
      all += line["kind"].get<std::string>() + ' ' + line["name"].get<std::string>() + ", ";
    return all;
  }
};

constexpr const char* with_fault = "horizon A, horizon B, fault F1, ";

TEST_F(SectionKinds, WordsOfBothLanguagesAreKindsAndAWordThatIsNoneIsRefusedWithLineAndSuggestion) {
  for (const char* word : {"fault", "Fault", "FALHA", "Thrust fault"}) EXPECT_EQ(kinds({section(word)}), with_fault);
  EXPECT_EQ(kinds({section("Pino")}), "horizon A, horizon B, pin F1, ");
  EXPECT_EQ(kinds({section("growth")}), "horizon A, horizon B, horizon F1, ");
  for (const std::string command : {"restore", "balance"}) {
    refuses({command, section("Falt")}, 3,
            {"section.csv:6", "feature 3 'F1'", "'Falt'", "did you mean 'fault'", "--kind"});
    refuses({command, section("horizn")}, 3, {"section.csv:6", "did you mean 'horizon'"});
  }
}

TEST_F(SectionKinds, APolygonThatSaysItIsALineIsRefused) {
  const std::string file =
      put("closed.csv", "x,z,name,kind\n0,0,A,\n9,0,A,\n1,1,F,fault\n2,2,F,fault\n3,1,F,fault\n1,1,F,fault\n");
  refuses({"restore", file}, 3, {"closed.csv:4", "feature 2 'F'", "a polygon cannot be of kind 'fault'"});
}

TEST_F(SectionKinds, KindsComeByNamesWhereFilesCarryNone) {
  const std::string file = section("fault");
  for (const char* name : {"a.dxf", "a.asc", "a.geojson", "a.gpkg", "a.csv"}) {
    ASSERT_EQ(call({"convert", file, path(name), "--kind", "*=horizon"}).code, 0) << name;
    EXPECT_EQ(kinds({path(name)}), "horizon A, horizon B, horizon F1, ") << name;
    EXPECT_EQ(kinds({path(name), "--kind", "A=horizon", "--kind", "F*=falha", "--kind", "*=bed"}), with_fault) << name;
  }
  const Outcome told = call({"restore", path("a.dxf"), "--kind", "G*=fault"});
  EXPECT_NE(told.err.find("no name fits 'G*'"), std::string::npos) << told.err;
  refuses({"restore", file, "--kind", "F*=fualt"}, 2, {"--kind", "did you mean 'fault'"});
  refuses({"restore", file, "--kind", "fault"}, 2, {"--kind", "'F*=fault'"});
}

TEST_F(SectionKinds, AScenarioTakesAllLinesOfAFileWithKindsByNames) {
  ASSERT_EQ(call({"convert", section("fault"), path("a.dxf")}).code, 0);
  const auto scenario = [&](const std::string& rules) {
    return put("lines.toml",
               "dobra = 1\nprogram = \"recon\"\n\n[input]\n\n[[input.lines]]\nfile = \"a.dxf\"\nkind = [" + rules +
                   "]\n\n[[input.horizon]]\nname = \"C\"\npoints = [[0, -30], [100, -30]]\n");
  };
  EXPECT_EQ(kinds({scenario("\"F*=falha\"")}), "horizon C, horizon A, horizon B, fault F1, ");
  EXPECT_EQ(kinds({scenario("")}), "horizon C, horizon A, horizon B, horizon F1, ");
  refuses({"restore", scenario("\"F*=fualt\"")}, 3, {"did you mean 'fault'"});
}

TEST_F(SectionKinds, ConvertTellsAnUnknownKindAndKeepsIt) {
  const Outcome outcome = call({"convert", section("Falt"), path("a.geojson")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("section.csv:6: feature 3 'F1': unknown kind 'Falt'; did you mean 'fault'?"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(text("a.geojson").find("\"Falt\""), std::string::npos);
}

TEST_F(SectionKinds, ANorthSouthPlaneIsAsLongAsTheSectionAndJudgedByThat) {
  const auto section = [&](const char* x) {
    return put("ns.csv", std::string("x,y,z\n300000,7800000,0\n") + x + ",7801000,10\n300000,7802000,0\n");
  };
  const Outcome outcome = call({"convert", section("300000"), path("a.csv"), "--columns", "1,2,3"});
  EXPECT_NE(outcome.err.find("length 2000 m"), std::string::npos) << outcome.err;
  // 20 m off 2000 m is more than a thousandth, however far the trace's beginning is.
  refuses({"convert", section("300020"), path("b.csv"), "--columns", "1,2,3", "--trace", "300000,0,300000,1"}, 3,
          {"length 2000 m"});
}

TEST_F(SectionKinds, NamesMayBeNumbers) {
  const std::string file = put("numbers.csv", "x,z,name\n0,0,1\n100,0,1\n0,-9,2\n100,-9,2\n");
  EXPECT_EQ(call({"restore", file, "--top", "1", "--out", path("restored.csv")}).code, 0);
  EXPECT_EQ(text("restored.csv").substr(0, 13), "x,z,name,kind");
  EXPECT_EQ(call({"restore", path("restored.csv"), "--top", "2"}).code, 0);
  EXPECT_EQ(call({"convert", file, path("again.csv")}).code, 0);
  EXPECT_EQ(call({"convert", path("again.csv"), path("again.geojson")}).code, 0);
  EXPECT_EQ(call({"restore", path("again.geojson"), "--top", "1"}).code, 0);
  EXPECT_EQ(call({"restore", put("kinds.csv", "x,y,Nome,kind\n0,0,1,\n9,0,1,\n0,-9,2,\n9,-9,2,\n"), "--top", "1"}).code,
            0);
  // Three numbers without such a header may be places on the map.
  refuses({"restore", put("map.csv", "0,0,1\n100,0,1\n")}, 3, {"--columns 1,2"});
  refuses({"restore", put("map.csv", "x,y,z\n0,0,1\n100,0,1\n")}, 3, {"--columns 1,2"});
}

TEST_F(SectionKinds, EveryPairOfHorizonsThatCrossIsNamedUpToTen) {
  std::string lines = "x,z,name\n";
  for (int i = 0; i < 4; ++i)
    lines += "0," + std::to_string(-10 * i) + ",L" + std::to_string(i) + "\n100," + std::to_string(-10 * i) + ",L" +
             std::to_string(i) + "\n";
  const std::string two = lines + "20,5,X\n60,-15,X\n";  // x = 30 on L0, 50 on L1
  refuses({"restore", put("two.csv", two)}, 3,
          {"horizon 'L0'", "crosses horizon 'X'", "'L1' crosses 'X' at (50, -10)", "(at 30, 0)"});
  std::string many = lines;
  for (int i = 0; i < 3; ++i)
    many += std::to_string(10 * i) + ",5,X" + std::to_string(i) + '\n' + std::to_string(10 * i + 80) + ",-35,X" +
            std::to_string(i) + '\n';
  refuses({"restore", put("many.csv", many)}, 3, {"'L3' crosses 'X0'", ", and more pairs: 2"});
}

TEST_F(SectionKinds, WhereAResultCannotGoIsToldBeforeTheWork) {
  const std::string bad =
      put("bad.csv", "x,z,name\n0,0,A\n100,0,A\n50,9,B\n55,-19,B\n");  // refused once it is worked on
  for (const auto& [out, what] : {std::pair(path("not/there.svg"), "No such file"),
                                  {bad + "/x.svg", "Not a directory"},
                                  {path("not/there.toml"), "No such file"},
                                  {path("not/there.wkt"), "No such file"}}) {
    refuses({"restore", bad, "--out", out}, 4, {what});
  }
  std::filesystem::create_directory(path("dir.svg"));
  refuses({"restore", bad, "--out", path("dir.svg")}, 4, {"dir.svg", "Is a directory"});
  refuses({"restore", bad, "--out", path("x.zip")}, 2, {"x.zip", ".svg", ".toml", ".dxf"});
  refuses({"convert", path("no such file.csv"), path("not/there.svg")}, 4, {"No such file or directory"});
  refuses({"offset", path("no such file.csv"), "--distance", "1", "--out", path("not/there.svg")}, 4,
          {"not", "No such"});
  refuses({"render", put("bad.toml", "dobra = 1\n"), "--out", path("not/there.svg")}, 4, {"not"});
}

TEST_F(SectionKinds, RestoredLinesAreWrittenInFormatsOfLinesWithWhatIsLost) {
  const std::string file = section("fault");
  const Outcome wkt = call({"restore", file, "--out", path("r.wkt")});
  EXPECT_EQ(wkt.code, 0) << wkt.err;
  EXPECT_NE(wkt.err.find("not kept in wkt: 'A' (horizon), 'B' (horizon), 'F1' (fault)"), std::string::npos) << wkt.err;
  EXPECT_EQ(text("r.wkt").substr(0, 10), "LINESTRING");
  const Outcome dxf = call({"restore", file, "--out", path("r.dxf")});
  EXPECT_NE(dxf.err.find("kinds are not kept in dxf: 'A' (horizon), 'B' (horizon), 'F1' (fault)"), std::string::npos)
      << dxf.err;
  const Outcome json = call({"restore", file, "--out", path("r.geojson")});
  EXPECT_EQ(json.err.find("not kept"), std::string::npos) << json.err;
  EXPECT_EQ(kinds({path("r.geojson")}), with_fault);
}

TEST_F(SectionKinds, RingsWithoutClosingPointAreClosedWithOneRemarkThatNamesThem) {
  const auto polygon = [](const std::string& name, const std::string& rings) {
    return R"({"type":"Feature","properties":{"name":")" + name + R"("},"geometry":{"type":"Polygon","coordinates":[)" +
           rings + "]}}";
  };
  const std::string file = put(
      "open.geojson", R"({"type":"FeatureCollection","features":[)" + polygon("A", "[[0,0],[100,0],[100,10],[0,10]]") +
                          ',' + polygon("B", "[[0,-10],[100,-10],[100,0],[0,0],[0,-10]]") + ',' +
                          polygon("C", "[[0,-30],[100,-30],[100,-10],[0,-10]],[[5,-20],[5,-15],[9,-15]]") + "]}");
  const Outcome outcome = call({"convert", file, path("a.csv")});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("feature 1 'A': a ring does not end at the first point; closed from (0, 10) to (0, 0)"),
            std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("feature 3 'C': 2 rings do"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("feature 2"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("closed ring"), std::string::npos) << outcome.err;
  const Outcome restored = call({"restore", file, "--horizons-from-units"});
  EXPECT_NE(restored.err.find("unit 'C': its hole at"), std::string::npos) << restored.err;
  EXPECT_NE(call({"convert", put("open.wkt", "POLYGON ((0 0, 9 0, 9 9))\n"), path("b.csv")})
                .err.find("open.wkt:1: a ring does not end"),
            std::string::npos);
}

TEST_F(SectionKinds, PolygonsOfOneUnitByTheirColumnArePiecesOfIt) {
  std::string features;
  const auto add = [&](const char* unit, double x, double z, double width) {
    features += fmt::format(
        R"({}{{"type":"Feature","properties":{{"id":1,"unit":"{}"}},"geometry":{{"type":"Polygon","coordinates":[[[{},{}],[{},{}],[{},{}],[{},{}],[{},{}]]]}}}})",
        features.empty() ? "" : ",", unit, x, z, x + width, z, x + width, z + 10, x, z + 10, x, z);
  };
  add("J2", 0, 0, 50);
  add("J2", 50, 0, 50);  // a boundary of the map's sheets: the unit is one all the same
  add("J1", 0, -10, 100);
  add("T", 0, -20, 100);
  const std::string file = put("units.geojson", R"({"type":"FeatureCollection","features":[)" + features + "]}");
  const Outcome outcome = call({"restore", file, "--horizons-from-units", "--uncovered", "continue"});
  EXPECT_NE(outcome.err.find("'feature 1', 'feature 2' are taken as pieces of unit 'J2'"), std::string::npos)
      << outcome.err;
  EXPECT_NE(outcome.err.find("horizons made of the edges of units: 2, 'J1', 'T'"), std::string::npos) << outcome.err;
}

TEST_F(SectionKinds, HorizonsOfUnitsCanBeRestoredAsTops) {
  std::string csv = "x,z,name\n";
  const auto add = [&](const std::string& name, std::vector<std::pair<int, int>> points) {
    points.push_back(points.front());
    for (const auto& [x, z] : points) csv += std::to_string(x) + ',' + std::to_string(z) + ',' + name + '\n';
  };
  add("A", {{0, 0}, {50, 10}, {100, 0}, {100, 20}, {0, 20}});
  add("B", {{0, -10}, {50, 0}, {100, -10}, {100, 0}, {50, 10}, {0, 0}});
  add("C", {{0, -30}, {100, -30}, {100, -10}, {50, 0}, {0, -10}});
  const Outcome outcome = call({"restore", put("map.csv", csv), "--horizons-from-units", "--top", "B", "--json",
                                "--quiet", "--out", path("s.toml")});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json ledger = Json::parse(outcome.out)["ledger"];
  EXPECT_EQ(ledger[0]["name"], "B");
  EXPECT_NEAR(ledger[0]["length_after"].get<double>(), 2.0 * std::sqrt(2600.0), 1e-9);
  EXPECT_EQ(ledger[1]["name"], "C");
  EXPECT_NE(text("s.toml").find("horizons_from_units = true"), std::string::npos);
  EXPECT_EQ(call({"restore", path("s.toml"), "--top", "C"}).code, 0);
}

}  // namespace
}  // namespace recon::cli
