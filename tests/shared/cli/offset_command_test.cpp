#include "shared/cli/offset_command.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "shared/cli/offset_report.h"
#include "shared/io/file.h"
#include "shared/io/geojson.h"
#include "shared/io/text_points.h"
#include "shared/io/wkt.h"
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
  EXPECT_EQ(below, Json::parse(R"({"curves":[{"distance":1.0,"length":10.0,"area":null,
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
  // Check OFF-k of the requirements: the trench is 18 long untreated, a straight line of 10 treated.
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
  refuses({file, "--distances", "1,-2"}, 2, {"--distances: -2 must be above 0"});
  refuses({file, "--distances", ""}, 2, {"--distances"});
  refuses({file, "--distance", "1", "--side", "rihgt"}, 2, {"did you mean 'right'?"});
  refuses({file, "--distance", "1", "--join", "x"}, 2, {"--join"});
  refuses({file, "--distance", "1", "--ends", "x"}, 2, {"--ends"});
  refuses({file, "--distance", "1", "--mitre-limit", "0.5"}, 2, {"--mitre-limit"});
  refuses({file, "--distance", "1", "--mitre-limit", "3", "--join", "round"}, 2, {"--mitre-limit"});
  refuses({file, "--distance", "1", "--arc-tolerance", "0.6"}, 2, {"--arc-tolerance"});
  refuses({two(), "--distance", "1", "--curve", "bse"}, 2, {"did you mean 'base'?"});
  refuses({two(), "--distance", "1", "--curve", "3"}, 2, {"--curve"});
  refuses({file, "--distance", "1", "--out", path("a.shp")}, 2, {"--out"});
  EXPECT_FALSE(std::filesystem::exists(path("a.shp")));
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
    const auto read = io::read_curves(path(name));
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    ASSERT_EQ(read->curves.size(), 2U) << name;  // nothing remains at 7
    EXPECT_TRUE(read->curves[0].line.closed);
    EXPECT_NEAR(geom::signed_area(read->curves[0].line), 64.0, 1e-12) << name;
    EXPECT_NEAR(geom::signed_area(read->curves[1].line), 36.0, 1e-12) << name;
  }
  const auto features = io::read_geojson(path("a.geojson"));
  EXPECT_EQ(features->features[0].name, "curve 1 at 1.0");
  EXPECT_EQ(features->features[0].kind, "offset");
}

TEST_F(OffsetCommand, OpenCurvesAreWrittenAsLinesInTheirOrder) {
  for (const char* name : {"b.geojson", "b.wkt", "b.csv"}) {
    ASSERT_EQ(call({corner(), "--distance", "1", "--out", path(name), "--quiet"}).out, "");
    const auto read = io::read_curves(path(name));
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    ASSERT_EQ(read->curves.size(), 1U) << name;
    EXPECT_EQ(read->curves[0].line.points, (std::vector<Point>{{0, -1}, {5, -1}, {5, 4}})) << name;
  }
}

TEST_F(OffsetCommand, RingsOfOnePolygonAreBasesOfTheirOwnAndANoteSaysSo) {
  const std::string holed = put("holed.wkt", "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (3 3, 3 6, 6 6, 6 3, 3 3))");
  const test::Outcome outcome = call({holed, "--distance", "2", "--side", "left"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("each ring is a base of its own"), std::string::npos) << outcome.err;
  EXPECT_EQ(call({square(), "--distance", "2", "--side", "left"}).err, "");
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
  const auto read = io::read_wkt(path("ring.wkt"));
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  ASSERT_EQ(read->features.size(), 1U);
  EXPECT_EQ(io::polygons_of(read->features[0]), (std::vector<std::pair<std::size_t, std::size_t>>{{0, 2}}));
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
  const io::NamedCurve base{"top", {{{0, 0}, {10, 0}}, false}};
  offset::OffsetPiece piece;
  piece.points = {{0, -1}, {10, -1.5}};
  piece.edges = {offset::OffsetEdge::line(0)};
  OffsetVerdict verdict;
  ASSERT_TRUE(verify_offset(base, {}, {offset::OffsetCurve{1.0, {piece}, 0}}, verdict).ok());
  EXPECT_EQ(verdict.edges, 1U);
  ASSERT_GE(verdict.findings.size(), 1U);
  EXPECT_TRUE(verdict.findings[0].starts_with("top: distance 1.0: off its parallel: 0.5 where "))
      << verdict.findings[0];
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
    OffsetFamily family{{"base", {{{0, 0}, {1, 0}}, false}}, offset::Treatment::Treated, {}};
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
