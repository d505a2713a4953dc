#include "shared/cli/offset_command.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "shared/cli/offset_report.h"
#include "shared/io/file.h"
#include "shared/io/formats/curves.h"
#include "shared/io/gis/geojson.h"
#include "shared/io/lines/wkt.h"
#include "tests/support/command_line.h"
#include "tests/support/fake_program.h"

namespace dobra::cli {
namespace {

using Json = nlohmann::json;
using geom::Point;

class OffsetCommand : public test::CommandLine {
 protected:
  OffsetCommand() : CommandLine(fake::program(), {offset_command()}, {"offset"}) {}

  [[nodiscard]] Json json(std::vector<std::string> args) const {
    args.push_back("--json");
    const test::Outcome outcome = call(std::move(args));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Json::parse(outcome.out, nullptr, false);
  }
  [[nodiscard]] std::string segment() const { return put("segment.csv", "x,y\n0,0\n10,0\n"); }
  [[nodiscard]] std::string corner() const { return put("corner.txt", "0 0\n4 0\n4 4\n"); }
  [[nodiscard]] std::string square() const { return put("square.wkt", "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))"); }
  [[nodiscard]] std::string two() const {
    return put(
        "two.geojson",
        R"({"type":"FeatureCollection","features":[)"
        R"({"type":"Feature","properties":{"name":"top"},"geometry":{"type":"LineString","coordinates":[[0,0],[10,0]]}},)"
        R"({"type":"Feature","properties":{"name":"base"},"geometry":{"type":"LineString","coordinates":[[0,-9],[6,-9]]}}]})");
  }
};

TEST_F(OffsetCommand, OFF_a_SegmentLeftToRightIsOffsetBelow) {
  const Json below = json({segment(), "--distance", "1"});
  EXPECT_EQ(below, Json::parse(R"({"curves":[{"distance":1.0,"length":10.0,"dropped":0,"dropped_length":0.0,
    "pieces":[{"closed":false,"points":[[0.0,-1.0],[10.0,-1.0]]}]}],"dropped":0})"));
  const Json above = json({put("back.csv", "10,0\n0,0\n"), "--distance", "1"});
  EXPECT_EQ(above["curves"][0]["pieces"][0]["points"], Json::parse("[[10.0,1.0],[0.0,1.0]]"));
  EXPECT_EQ(json({segment(), "--distance", "1", "--side", "left"})["curves"][0]["pieces"][0]["points"],
            Json::parse("[[0.0,1.0],[10.0,1.0]]"));
}

TEST_F(OffsetCommand, OFF_b_CornerHasLengthTenOutsideAndSixInside) {
  const Json outer = json({corner(), "--distances", "1"})["curves"][0];
  EXPECT_EQ(outer["pieces"][0]["points"], Json::parse("[[0.0,-1.0],[5.0,-1.0],[5.0,4.0]]"));
  EXPECT_NEAR(outer["length"].get<double>(), 10.0, 1e-12);
  const Json inner = json({corner(), "--distances", "1", "--side", "left"})["curves"][0];
  EXPECT_EQ(inner["pieces"][0]["points"], Json::parse("[[0.0,1.0],[3.0,1.0],[3.0,4.0]]"));
  EXPECT_NEAR(inner["length"].get<double>(), 6.0, 1e-12);
}

TEST_F(OffsetCommand, OFF_h_SquareInsetBeyondHalfWidthIsEmptyAndReported) {
  const test::Outcome outcome = call({square(), "--distance", "1", "--count", "5", "--side", "left", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json curves = Json::parse(outcome.out)["curves"];
  ASSERT_EQ(curves.size(), 5U);
  const double areas[] = {64, 36, 16, 4, 0};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(curves[k]["distance"].get<double>(), static_cast<double>(k + 1));
    EXPECT_NEAR(curves[k]["area"].get<double>(), areas[k], 1e-9);
  }
  EXPECT_TRUE(curves[3]["pieces"][0]["closed"].get<bool>());
  EXPECT_TRUE(curves[4]["pieces"].empty());
  EXPECT_EQ(outcome.err, "fake: curve 1: nothing remains at distance 5.0\n");
}

TEST_F(OffsetCommand, OFF_i_LShapeHasTheAreasAndLengths) {
  const std::string shape = put("l.csv", "0 0\n6 0\n6 2\n2 2\n2 6\n0 6\n");
  const Json curves = json({shape, "--closed", "--distances", "0.25,.5,9e-1", "--side", "left"})["curves"];
  const double areas[] = {14.25, 9, 1.64};
  const double lengths[] = {22, 20, 16.8};
  ASSERT_EQ(curves.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(curves[k]["area"].get<double>(), areas[k], 1e-9);
    EXPECT_NEAR(curves[k]["length"].get<double>(), lengths[k], 1e-9);
  }
}

TEST_F(OffsetCommand, DistancesGrowByTheFactor) {
  const Json curves = json({segment(), "--distance", "0.5", "--count", "3", "--factor", "2"})["curves"];
  ASSERT_EQ(curves.size(), 3U);
  EXPECT_EQ(curves[0]["distance"].get<double>(), 0.5);
  EXPECT_EQ(curves[1]["distance"].get<double>(), 1.5);
  EXPECT_EQ(curves[2]["distance"].get<double>(), 3.5);
}

TEST_F(OffsetCommand, JoinsEndsAndTreatmentReachTheLibrary) {
  const auto length = [&](const std::vector<std::string>& more) {
    std::vector<std::string> args = {corner(), "--distance", "1"};
    args.insert(args.end(), more.begin(), more.end());
    return json(args)["curves"][0]["length"].get<double>();
  };
  EXPECT_NEAR(length({"--join", "bisector"}), 10.0, 1e-12);
  EXPECT_NEAR(length({"--join", "bevel"}), 8.0 + std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(length({"--join", "round", "--arc-tolerance", "1e-6"}), 8.0 + std::acos(-1.0) / 2.0, 1e-12);
  EXPECT_LT(length({"--mitre-limit", "1"}), 9.9);
  EXPECT_NEAR(length({"--ends", "extended"}), 12.0, 1e-12);
  // The trench is 18 long untreated, a straight line of 10 treated.
  const std::string trench = put("trench.csv", "10 0\n6 0\n6 -3\n4 -3\n4 0\n0 0\n");
  EXPECT_NEAR(json({trench, "--distance", "1.5", "--untreated"})["curves"][0]["length"].get<double>(), 18.0, 1e-9);
  EXPECT_NEAR(json({trench, "--distance", "1.5"})["curves"][0]["length"].get<double>(), 10.0, 1e-9);
}

TEST_F(OffsetCommand, SeveralCurvesAreReportedOneAfterTheOtherByName) {
  const Json all = json({two(), "--distances", "1,2"})["curves"];
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[1]["curve"], "top");
  EXPECT_EQ(all[1]["distance"].get<double>(), 2.0);
  EXPECT_EQ(all[2]["curve"], "base");
  for (const char* wanted : {"base", "2"}) {
    const Json one = json({two(), "--distances", "1", "--curve", wanted})["curves"];
    ASSERT_EQ(one.size(), 1U);
    EXPECT_FALSE(one[0].contains("curve"));
    EXPECT_EQ(one[0]["length"].get<double>(), 6.0);
  }
}

TEST_F(OffsetCommand, WithoutJsonAndFileATableIsPrinted) {
  const test::Outcome one = call({square(), "--distance", "1", "--side", "left"});
  EXPECT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(one.out,
            "      distance        pieces        points        length          area\n"
            "             1             1             4            32            64\n");
  const test::Outcome several = call({two(), "--distance", "1"});
  EXPECT_NE(several.out.find("\nbase                1             1             2             6             -\n"),
            std::string::npos)
      << several.out;
}

TEST_F(OffsetCommand, WrongUsageNamesTheOption) {
  const std::string file = segment();
  refuses({file}, 2, {"--distance D"});
  refuses({file, "--count", "3"}, 2, {"--distance D"});
  refuses({file, "--distances", "1,2", "--count", "3"}, 2, {"--distances"});
  refuses({file, "--distances", "1,2", "--distance", "3"}, 2, {"--distances"});
  refuses({file, "--distances", "1,2", "--factor", "3"}, 2, {"--distances"});
  refuses({file, "--distance", "1", "--count", "0"}, 2, {"--count"});
  refuses({file, "--distance", "1", "--count", "-2"}, 2, {"--count"});
  refuses({file, "--distance", "1", "--count", "1.5"}, 2, {"--count"});
  refuses({file, "--distance", "1", "--count", "some"}, 2, {"--count"});
  refuses({file, "--distance", "0"}, 2, {"--distance"});
  refuses({file, "--distance", "-1"}, 2, {"--distance"});
  refuses({file, "--distance", "nan"}, 2, {"--distance"});
  refuses({file, "--distance", "inf"}, 2, {"--distance"});
  refuses({file, "--distance", "one"}, 2, {"'one' is not a number"});
  refuses({file, "--distance", "1", "--factor", "0"}, 2, {"--factor"});
  refuses({file, "--distances", "1,,2"}, 2, {"--distances: '' is not a number"});
  for (const char* value : {"nan", "inf", "-inf"})
    refuses({file, "--distance", value}, 2,
            {"--distance", std::string("'") + value + "' is not a finite number; it must not be 0"});
  refuses({file, "--distance", "1e400"}, 2, {"'1e400' is not a number"});
  refuses({file, "--distances", "1,-2.0"}, 2, {"-2.0 must be above 0 for curve 1, an open line"});
  refuses({file, "--distances", ""}, 2, {"--distances"});
  refuses({file, "--distance", "1", "--side", "rihgt"}, 2, {"did you mean 'right'?"});
  refuses({file, "--distance", "1", "--join", "x"}, 2, {"--join"});
  refuses({file, "--distance", "1", "--ends", "x"}, 2, {"--ends"});
  refuses({file, "--distance", "1", "--mitre-limit", "0.5"}, 2, {"--mitre-limit"});
  refuses({file, "--distance", "1", "--mitre-limit", "3", "--join", "round"}, 2, {"--mitre-limit"});
  refuses({file, "--distance", "1", "--arc-tolerance", "0.6"}, 2, {"--arc-tolerance"});
  refuses({two(), "--distance", "1", "--curve", "bse"}, 2, {"did you mean 'base'?"});
  refuses({two(), "--distance", "1", "--curve", "3"}, 2, {"--curve"});
  refuses({file, "--distance", "1", "--out", path("a.xyz")}, 2, {"--out"});
  EXPECT_FALSE(std::filesystem::exists(path("a.xyz")));
  refuses({file, "--distance", "1", "--caps", "flat"}, 2, {"--caps"});
  refuses({file, "--distance", "1", "--side", "both", "--caps", "rund"}, 2, {"did you mean 'round'?"});
  refuses({file, "--distance", "1", "--side", "both", "--ends", "extended"}, 2, {"--ends"});
  refuses({file, "--distance", "1", "--side", "both", "--untreated"}, 2, {"--untreated"});
  refuses({file, "--distance", "1", "--dissolve", "--pieces", "all"}, 2, {"--pieces"});
  refuses({file, "--distance", "1", "--dissolve", "--side", "left"}, 2, {"--dissolve", "curve 1"});
  refuses({square(), "--distance", "-1", "--side", "left"}, 2, {"--distance"});
}

TEST_F(OffsetCommand, BadInputNamesTheFile) {
  refuses({path("none.csv"), "--distance", "1"}, 3, {"none.csv"});
  refuses({put("a.xyz", "0 0\n1 1\n"), "--distance", "1"}, 3, {".geojson"});
  refuses({put("empty.csv", ""), "--distance", "1"}, 3, {"empty.csv"});
  refuses({put("word.csv", "0 0\n1 one\n2 0\n"), "--distance", "1"}, 3, {"word.csv:2"});
  refuses({put("short.dxf", "0\nSECTION\n2\nENTITIES\n"), "--distance", "1"}, 3, {"short.dxf:4"});
  refuses({segment(), "--distance", "1", "--closed"}, 3, {"segment.csv: curve 1: "});
  refuses({segment(), "--distance", "1e200", "--count", "9", "--factor", "1e200"}, 3, {"--count"});
  refuses({segment(), "--distance", "1", "--out", path("no/where.csv")}, 4, {"/no: cannot be written"});
}

TEST_F(OffsetCommand, ExchangeFilesReadBackAsTheSameCurves) {
  const std::string base = square();
  const auto write = [&](const std::string& name) {
    const test::Outcome outcome = call({base, "--distances", "1,2,7", "--side", "left", "--out", path(name)});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, path(name) + '\n');
  };
  for (const char* name : {"a.geojson", "a.wkt", "a.csv"}) {
    write(name);
    const auto read = io::formats::read_curves(path(name));
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    ASSERT_EQ(read->curves.size(), 2U) << name;  // nothing remains at 7
    EXPECT_TRUE(read->curves[0].line.closed);
    EXPECT_NEAR(geom::signed_area(read->curves[0].line), 64.0, 1e-12) << name;
    EXPECT_NEAR(geom::signed_area(read->curves[1].line), 36.0, 1e-12) << name;
  }
  const auto features = io::gis::read_geojson(path("a.geojson"));
  EXPECT_EQ(features->features[0].name, "curve 1 at 1.0");
  EXPECT_EQ(features->features[0].kind, "offset");
}

TEST_F(OffsetCommand, OpenCurvesAreWrittenAsLinesInTheirOrder) {
  for (const char* name : {"b.geojson", "b.wkt", "b.csv"}) {
    ASSERT_EQ(call({corner(), "--distance", "1", "--out", path(name), "--quiet"}).out, "");
    const auto read = io::formats::read_curves(path(name));
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    ASSERT_EQ(read->curves.size(), 1U) << name;
    EXPECT_EQ(read->curves[0].line.points, (std::vector<Point>{{0, -1}, {5, -1}, {5, 4}})) << name;
  }
}

TEST_F(OffsetCommand, BisectorPointsThatAreCutAreTold) {
  const std::string file = put("back.csv", "0,0\n10,0\n0,1e-6\n");
  const test::Outcome outcome = call({file, "--distance", "1", "--join", "bisector"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(
      outcome.err.find(
          "1 corner turns back so sharply that the bisector point is more than 1000 D away, the first at (10, 0)"),
      std::string::npos)
      << outcome.err;
  EXPECT_EQ(call({corner(), "--distance", "1", "--join", "bisector"}).err, "");
}

TEST_F(OffsetCommand, OfAnOpenLineAmongPolygonsADistanceBelowZeroIsLeftOutAndTold) {
  const std::string file =
      put("mixed.wkt", "LINESTRING (20 0, 30 0)\nPOLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))\nLINESTRING (40 0, 50 0)\n");
  const test::Outcome outcome = call({file, "--distances", "-1,2", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json curves = Json::parse(outcome.out)["curves"];
  ASSERT_EQ(curves.size(), 6U);
  EXPECT_TRUE(curves[0]["pieces"].empty());
  EXPECT_EQ(curves[1]["length"], 10.0);
  EXPECT_NEAR(curves[2]["area"].get<double>(), 64, 1e-12);
  EXPECT_TRUE(curves[4]["pieces"].empty());
  for (const char* told : {"curve 1: an open line", "curve 3: an open line", "left out at distance -1"}) {
    EXPECT_NE(outcome.err.find(told), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(outcome.err.find("curve 2"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("nothing remains"), std::string::npos) << outcome.err;
  const test::Outcome dissolved = call({file, "--distance", "-1", "--dissolve", "--json"});
  ASSERT_EQ(dissolved.code, 0) << dissolved.err;
  EXPECT_NEAR(Json::parse(dissolved.out)["curves"][0]["area"].get<double>(), 64, 1e-12);
}

TEST_F(OffsetCommand, JsonOfAnOpenCurveHasNoArea) {
  EXPECT_FALSE(json({segment(), "--distance", "1"})["curves"][0].contains("area"));
  EXPECT_TRUE(json({square(), "--distance", "1"})["curves"][0].contains("area"));
}

TEST_F(OffsetCommand, TheUnitOfADrawingIsKeptAndTold) {
  const auto drawing = [](const std::string& code) {
    return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + code +
           "\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nA\n10\n0\n20\n0\n11\n10\n21\n0\n0\nENDSEC\n0\nEOF\n";
  };
  for (const auto& [code, metres] : {std::pair{"4", "0.001"}, {"2", "0.3048"}, {"6", ""}, {"0", ""}}) {
    const test::Outcome outcome = call({put("in.dxf", drawing(code)), "--distance", "2", "--out", path("out.dxf")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("as asked for"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("and so is that of the distances") != std::string::npos, *metres != 0) << outcome.err;
    const std::string text = *io::read_bytes(path("out.dxf"));
    EXPECT_EQ(text.find(std::string("$INSUNITS\n70\n") + code + "\n") != std::string::npos, *code != '0') << text;
    EXPECT_NE(text.find("20\n-2.0\n"), std::string::npos) << text;  // in units of the drawing
  }
  const test::Outcome other = call({put("in.dxf", drawing("4")), "--distance", "2", "--out", path("out.wkt")});
  EXPECT_NE(other.err.find("the unit of the file (0.001 m) is not kept in .wkt"), std::string::npos) << other.err;
  const test::Outcome odd = call({put("in.dxf", drawing("18")), "--distance", "2", "--out", path("out.dxf")});
  EXPECT_NE(odd.err.find("is not known here, and is not kept"), std::string::npos) << odd.err;
}

// --- what a GIS user expects

TEST_F(OffsetCommand, OFF_c_APolygonWithHolesStaysOnePolygonWithHoles) {
  const std::string holed = put("holed.wkt", "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (3 3, 3 7, 7 7, 7 3, 3 3))");
  const test::Outcome outcome = call({holed, "--distances", "1,-1,2", "--json"});
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(call({holed, "--distances", "1,-1,2", "--out", path("h.wkt")}).code, 0);
  const Json curves = Json::parse(outcome.out)["curves"];
  ASSERT_EQ(curves.size(), 3U);
  const double areas[] = {144 - 4, 64 - 36, 196};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(curves[k]["area"].get<double>(), areas[k], 1e-9);
  EXPECT_EQ(curves[0]["pieces"].size(), 2U);
  EXPECT_EQ(curves[2]["pieces"].size(), 1U);
  const auto read = io::lines::read_wkt(path("h.wkt"));
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->features.size(), 3U);
  EXPECT_EQ(io::lines::polygons_of(read->features[0]), (std::vector<std::pair<std::size_t, std::size_t>>{{0, 2}}));
  // The left side is the same as a distance below 0.
  const Json left = json({holed, "--distance", "1", "--side", "left"})["curves"][0];
  EXPECT_EQ(left["pieces"], curves[1]["pieces"]);
  const Json band = json({holed, "--distance", "1", "--side", "both"})["curves"][0];
  EXPECT_NEAR(band["area"].get<double>(), 144 - 4 - (64 - 36), 1e-9);
}

TEST_F(OffsetCommand, OFF_c_PolygonsOfOneFeatureAreJoinedWhereTheyMeet) {
  const std::string file =
      put("multi.wkt",
          "MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1)), ((6 0, 10 0, 10 4, 6 4, 6 0)))");
  const Json curves = json({file, "--distances", "0.5,1.5,-0.25"})["curves"];
  EXPECT_NEAR(curves[0]["area"].get<double>(), 25 - 1 + 25, 1e-9);
  EXPECT_NEAR(curves[1]["area"].get<double>(), 13 * 7, 1e-9);
  EXPECT_NEAR(curves[2]["area"].get<double>(), 3.5 * 3.5 - 2.5 * 2.5 + 3.5 * 3.5, 1e-9);
}

TEST_F(OffsetCommand, OFF_c_BothSidesOfALineHaveTheCapsThatAreAskedFor) {
  const auto area = [&](const std::vector<std::string>& more) {
    std::vector<std::string> args = {segment(), "--distance", "2", "--side", "both", "--join", "round"};
    args.insert(args.end(), more.begin(), more.end());
    return json(args)["curves"][0]["area"].get<double>();
  };
  EXPECT_NEAR(area({}), 40 + 4 * std::acos(-1.0), 1e-9);
  EXPECT_NEAR(area({"--caps", "flat"}), 40, 1e-9);
  EXPECT_NEAR(area({"--caps", "square"}), 56, 1e-9);
}

TEST_F(OffsetCommand, OFF_c_LinesAndPolygonsOfAFileDissolveToOneArea) {
  const std::string file =
      put("mixed.wkt", "LINESTRING (0 0, 10 0)\nPOLYGON ((4 -3, 6 -3, 6 3, 4 3, 4 -3))\nLINESTRING (20 0, 30 0)");
  const test::Outcome outcome =
      call({file, "--distance", "1", "--dissolve", "--caps", "flat", "--join", "mitre", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json curves = Json::parse(outcome.out)["curves"];
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0]["pieces"].size(), 2U);
  EXPECT_NEAR(curves[0]["area"].get<double>(), (20 + 4 * 8 - 4 * 2) + 20, 1e-9);
}

TEST_F(OffsetCommand, EveryPieceOfAnOpenLineIsKeptOnRequestAndElseTheRestIsTold) {
  // A room above the line, 22 by 20, behind a neck 2 wide.
  const std::string file = put("room.csv", "-20,0\n4,0\n4,4\n-6,4\n-6,24\n16,24\n16,4\n6,4\n6,0\n60,0\n");
  const test::Outcome longest = call({file, "--distance", "2", "--json", "--side", "right", "--join", "round"});
  ASSERT_EQ(longest.code, 0);
  const Json one = Json::parse(longest.out);
  const Json all = json({file, "--distance", "2", "--side", "right", "--join", "round", "--pieces", "all"});
  EXPECT_EQ(one["dropped"], 1);
  EXPECT_EQ(one["curves"][0]["dropped"], one["dropped"]);
  EXPECT_EQ(all["dropped"], 0);
  EXPECT_EQ(all["curves"][0]["pieces"].size(), one["dropped"].get<std::size_t>() + 1);
  EXPECT_NEAR(all["curves"][0]["length"].get<double>(),
              one["curves"][0]["length"].get<double>() + one["curves"][0]["dropped_length"].get<double>(), 1e-9);
  EXPECT_NE(longest.err.find("left out (--pieces all keeps them)"), std::string::npos) << longest.err;
  const test::Outcome table = call({file, "--distance", "2", "--join", "round"});
  EXPECT_NE(table.out.find("left out"), std::string::npos) << table.out;
}

TEST_F(OffsetCommand, OneBadRingOrACollectionIsToldAndTheRestIsDone) {
  const auto works = [&](const std::string& file, const std::string& told, double area) {
    const test::Outcome outcome = call({file, "--distance", "1", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find(told), std::string::npos) << outcome.err;
    const Json curves = Json::parse(outcome.out)["curves"];
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_NEAR(curves[0]["area"].get<double>(), area, 1e-9);
  };
  works(put("ring.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 2, 1 1))"), "part 2", 36);
  works(put("flat.wkt", "POLYGON ((0 0, 4 0, 2 0, 0 0))\nPOLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"), "geometry 1", 36);
  works(put("coll.wkt", "GEOMETRYCOLLECTION (POINT (1 1), LINESTRING (0 0, 1 1));POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"),
        "GEOMETRYCOLLECTION is not read", 36);
  works(put("coll.geojson", R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{},"geometry":{"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[1,1]}]}},
    {"type":"Feature","properties":{},"geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]}}]})"),
        "GEOMETRYCOLLECTION is not read", 36);
  works(put("flat.csv", "0,0\n4,0\n2,0\n0,0\n\n0,0\n4,0\n4,4\n0,4\n0,0\n"), "flat.csv:1", 36);
  refuses({put("none.wkt", "POLYGON ((0 0, 4 0, 2 0, 0 0))"), "--distance", "1"}, 3, {"none.wkt"});
}

TEST_F(OffsetCommand, AClosedLineStringIsTreatedLikeAClosedLineOfAText) {
  const Json text = json({put("c.csv", "0,0\n4,0\n4,4\n0,4\n0,0\n"), "--distance", "1"});
  EXPECT_NEAR(text["curves"][0]["area"].get<double>(), 36, 1e-9);
  EXPECT_EQ(json({put("c.wkt", "LINESTRING (0 0, 0 4, 4 4, 4 0, 0 0)"), "--distance", "1"})["curves"][0]["area"], 36.0);
  EXPECT_EQ(json({put("c.geojson", R"({"type":"LineString","coordinates":[[0,0],[4,0],[4,4],[0,4],[0,0]]})"),
                  "--distance", "1"})["curves"],
            text["curves"]);
}

TEST_F(OffsetCommand, APolygonThatCrossesItselfIsToldAndTakenAsThoseThatDoNot) {
  // It crosses itself at (3, 3): right triangles with legs of 3 and 3, and of 3 and 1, all times the root of 2.
  const test::Outcome outcome =
      call({put("bow.wkt", "POLYGON ((0 0, 6 6, 6 0, 2 4, 0 0))"), "--distance", "-0.25", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("crosses or touches itself; taken as 2 polygons"), std::string::npos) << outcome.err;
  const auto shrunk = [](double a, double b) {
    const double inradius = std::sqrt(0.5) * (a + b - std::hypot(a, b));
    return a * b * std::pow(1 - 0.25 / inradius, 2);
  };
  EXPECT_NEAR(Json::parse(outcome.out)["curves"][0]["area"].get<double>(), shrunk(3, 3) + shrunk(3, 1), 1e-9);
}

TEST_F(OffsetCommand, LoopsOfOneAreaThatRunAgainstEachOtherAreTwoPolygons) {
  for (const char* const bow : {"POLYGON ((0 0, 10 10, 10 0, 0 10, 0 0))", "POLYGON ((0 0, 0 10, 10 0, 10 10, 0 0))"}) {
    const test::Outcome outcome = call({put("bow.wkt", bow), "--distance", "-0.25", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("taken as 2 polygons that do not"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("left out"), std::string::npos) << outcome.err;
    // Two right triangles with hypotenuses of 10.
    const double inradius = 10 / std::sqrt(2.0) - 5;
    const double area = Json::parse(outcome.out)["curves"][0]["area"].get<double>();
    EXPECT_NEAR(area, 2 * 25 * std::pow(1 - 0.25 / inradius, 2), 1e-9);
  }
}

TEST_F(OffsetCommand, IdAttributesAndReferenceSystemAreKept) {
  const std::string file = put("parcels.geojson", R"({"type":"FeatureCollection",
    "crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::31983"}},"features":[
    {"type":"Feature","id":7,"properties":{"name":"plot","owner_surname":"Reis","area":16},
     "geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,4],[0,0]]]}}]})");
  for (const char* name : {"k.geojson", "k.gpkg", "k.shp"}) {
    const test::Outcome outcome = call({file, "--distance", "1", "--out", path(name)});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("owner_surname") != std::string::npos, std::string(name) == "k.shp") << outcome.err;
    const auto read = io::formats::read_any_lines(path(name));
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    ASSERT_EQ(read->features.size(), 1U);
    const io::lines::Feature& kept = read->features[0];
    EXPECT_NEAR(geom::signed_area(kept.parts[0]), 36, 1e-9);
    ASSERT_TRUE(read->system) << name;
    EXPECT_EQ(read->system->code, "EPSG:31983") << name;
    const auto value = [&](std::string key) {
      if (std::string(name) == "k.shp") key.resize(std::min<std::size_t>(key.size(), 10));
      for (const auto& [known, kept_value] : kept.properties) {
        if (known == key) return kept_value;
      }
      ADD_FAILURE() << name << ": no " << key;
      return io::lines::PropertyValue{};
    };
    EXPECT_EQ(std::get<std::string>(value("owner_surname")), "Reis");
    EXPECT_EQ(std::get<std::int64_t>(value("id")), 7);
    EXPECT_EQ(std::get<std::int64_t>(value("source_area")), 16);
    EXPECT_NEAR(std::get<double>(value("area")), 36, 1e-9);
  }
  const test::Outcome lost = call({file, "--distance", "1", "--out", path("k.dxf")});
  EXPECT_NE(lost.err.find("the reference system (SIRGAS 2000 / UTM zone 23S) is not kept in .dxf"), std::string::npos)
      << lost.err;
  EXPECT_EQ(lost.code, 0);
  const auto drawing = io::formats::read_any_lines(path("k.dxf"));
  ASSERT_TRUE(drawing.ok());
  EXPECT_NEAR(std::abs(geom::signed_area(drawing->features[0].parts[0])), 36, 1e-9);
}

TEST_F(OffsetCommand, LinesAndPolygonsDoNotGoIntoOneShapefile) {
  const std::string file = put("m.wkt", "LINESTRING (0 0, 10 0)\nPOLYGON ((4 -3, 6 -3, 6 3, 4 3, 4 -3))");
  refuses({file, "--distance", "1", "--out", path("m.shp")}, 2, {"--out", ".gpkg"});
  EXPECT_EQ(call({file, "--distance", "1", "--out", path("m.gpkg")}).code, 0);
  EXPECT_EQ(
      call({put("s.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"), "--distance", "-3", "--out", path("n.shp")}).code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("n.shp")));  // nothing remains, and the file says so
}

TEST_F(OffsetCommand, OFF_b_SizesWhoseSquaresAreNoNumbersAreRefused) {
  const std::string tips = "-5 -8,2 8,2.160023e200 1.937208e200,-4 -3,-5 -4,8796093022208 281474976710653";
  const auto refused = [&](const std::string& line, const std::string& distance, const std::string& why) {
    refuses({put("wide.wkt", "LINESTRING(" + line + ")"), "--distance", distance, "--side", "left", "--join", "round",
             "--json"},
            3, {why});
  };
  refused(tips, "5.8e197", "beyond 1e150");
  refused("0 0,1.7e308 0,1.7e308 1.7e308", "1e300", "beyond 1e150");
  refused("0 0,-1e151 0", "1e150", "beyond 1e150");
  refused("0 0,4e-160 0", "1e-160", "1e-150");
  refused("0 0,5e-324 0", "1e-300", "1e-150");
  refused("0 0,1 0", "1e30", "1e18 times");
  refused("0 0,1e150 0", "2e150", "between 1e-150 and 1e150");
  refuses({put("nan.csv", "0,0\nnan,1\n"), "--distance", "1"}, 3, {"nan.csv"});
  for (const double size : {1e150, 1e-149}) {
    const Json made = json({put("ok.csv", fmt::format("0,0\n{0},0\n{0},{0}\n0,{0}\n0,0\n", size)), "--distance",
                            fmt::format("{}", size / 4)});
    const double expected = 2.25 * size * size;
    EXPECT_NEAR(made["curves"][0]["area"].get<double>(), expected, 1e-12 * expected);
  }
}

TEST_F(OffsetCommand, AHoleBetweenArmsIsAHoleOfThePolygon) {
  // A ring with a slit 1 wide: at 0.6 outside the slit closes and the inner square of side 8 becomes a hole of 6.8.
  const std::string ring =
      put("ring.csv", "0 0\n12 0\n12 5.5\n10 5.5\n10 2\n2 2\n2 10\n10 10\n10 6.5\n12 6.5\n12 12\n0 12\n");
  const double hole = 6.8 * 6.8;
  const double outer = 13.2 * 13.2;
  const Json curve =
      json({ring, "--closed", "--distance", "0.6", "--join", "bisector", "--out", path("ring.wkt")})["curves"][0];
  EXPECT_EQ(curve["pieces"].size(), 2U);
  EXPECT_NEAR(curve["area"].get<double>(), outer - hole, 0.5);
  const auto read = io::lines::read_wkt(path("ring.wkt"));
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  ASSERT_EQ(read->features.size(), 1U);
  EXPECT_EQ(io::lines::polygons_of(read->features[0]), (std::vector<std::pair<std::size_t, std::size_t>>{{0, 2}}));
  EXPECT_NEAR(geom::signed_area(read->features[0].parts[0]) + geom::signed_area(read->features[0].parts[1]),
              curve["area"].get<double>(), 1e-9);
}

TEST_F(OffsetCommand, VerifyJudgesTheCurvesAndSaysSo) {
  const std::string file = put("l.csv", "0,0\n6,0\n6,2\n2,2\n2,6\n0,6\n");
  const test::Outcome right = call({file, "--closed", "--side", "left", "--distances", "0.25,0.9", "--verify"});
  EXPECT_EQ(right.code, 0);
  EXPECT_NE(right.err.find("verified 12 edges"), std::string::npos) << right.err;
  EXPECT_NE(right.err.find("nothing is wrong"), std::string::npos) << right.err;
  // A curve that is wrong on purpose: the library's own are not.
  const geom::Polyline base{{{0, 0}, {10, 0}}, false};
  offset::OffsetPiece piece;
  piece.points = {{0, -1}, {10, -1.5}};
  piece.edges = {offset::OffsetEdge::line(0)};
  OffsetVerdict verdict;
  ASSERT_TRUE(verify_offset("top", base, {}, {offset::OffsetCurve{1.0, {piece}, 0, 0.0}}, verdict).ok());
  EXPECT_EQ(verdict.edges, 1U);
  ASSERT_GE(verdict.findings.size(), 1U);
  EXPECT_TRUE(verdict.findings[0].starts_with("top: distance 1.0: off its parallel: 0.5 where "))
      << verdict.findings[0];
}

TEST_F(OffsetCommand, VerifySaysWhatItWasNotAskedAbout) {
  const auto said = [&](std::vector<std::string> args) {
    args.insert(args.end(), {"--distance", "1", "--verify"});
    const test::Outcome outcome = call(args);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("nothing is wrong with them"), std::string::npos) << outcome.err;
    const std::size_t at = outcome.err.find("not judged: ");
    return at == std::string::npos ? std::string() : outcome.err.substr(at);
  };
  EXPECT_EQ(said({square()}), "");
  EXPECT_EQ(said({put("back.csv", "0,0\n10,0\n0,1e-6\n"), "--join", "bisector"}),
            "not judged: 1 bisector point cut across\n");
  EXPECT_EQ(said({put("bow.wkt", "POLYGON ((0 0, 6 6, 6 0, 2 4, 0 0))"), "--join", "round"}),
            "not judged: 1 polygon that crosses or touches itself, but what it was taken as; what was joined of "
            "several curves\n");
  // A bulb with a narrow neck: the inside of it is a second piece.
  const std::string bulb = put("bulb.csv", "-10,0\n-0.5,0\n-0.5,5\n-5,5\n-5,15\n5,15\n5,5\n0.5,5\n0.5,0\n10,0\n");
  EXPECT_TRUE(said({bulb, "--side", "left"}).empty() != said({bulb, "--side", "right"}).empty());
  EXPECT_NE((said({bulb, "--side", "left"}) + said({bulb, "--side", "right"})).find("not judged: 1 piece left out ("),
            std::string::npos);
  EXPECT_EQ(said({corner(), "--untreated"}), "not judged: whether untreated curves keep their distance or cross\n");
}

TEST_F(OffsetCommand, PicturesAreWrittenAndShowBaseAndDistances) {
  for (const auto& [name, start] : {std::pair{"p.svg", "<?xml"}, {"p.pdf", "%PDF"}, {"p.png", "\x89PNG"}}) {
    ASSERT_EQ(call({two(), "--distances", "0.5,1", "--out", path(name)}).code, 0) << name;
    const auto bytes = io::read_bytes(path(name));
    ASSERT_TRUE(bytes.ok());
    EXPECT_TRUE(bytes->starts_with(start)) << name;
  }
  const std::string svg = *io::read_bytes(path("p.svg"));
  for (const char* text : {"D = 0.5", "D = 1", "base curves", "x [m]"}) {
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  }
}

TEST_F(OffsetCommand, ALongLegendShowsTheFirstAndTheLastDistance) {
  for (const std::size_t count : {12U, 13U, 24U, 25U, 400U}) {
    OffsetFamily family{.name = "base", .bases = {{{{0, 0}, {1, 0}}, false}}};
    for (std::size_t k = 0; k < count; ++k) family.curves.emplace_back().distance = static_cast<double>(k + 1);
    const scene::Picture picture = offset_picture({family});
    const auto& layers = picture.panels.at(0).layers;
    ASSERT_EQ(layers.size(), count + 1);
    EXPECT_EQ(layers.front().in_legend, scene::InLegend::Yes);
    EXPECT_EQ(layers[count - 1].in_legend, scene::InLegend::Yes);
    const auto shown = std::count_if(layers.begin(), layers.end() - 1,
                                     [](const scene::Layer& layer) { return layer.in_legend == scene::InLegend::Yes; });
    EXPECT_LE(shown, 13);
    EXPECT_GE(shown, 6);
  }
}

}  // namespace
}  // namespace dobra::cli
