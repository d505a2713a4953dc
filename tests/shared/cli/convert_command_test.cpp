#include "shared/cli/convert_command.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "shared/cli/line_picture.h"
#include "tests/support/command_line.h"
#include "tests/support/fake_program.h"

namespace dobra::cli {
namespace {

using Json = nlohmann::json;
using geom::Point;

class ConvertCommand : public test::CommandLine {
 protected:
  ConvertCommand() : CommandLine(fake::program(), {convert_command()}, {"convert"}) {}

  [[nodiscard]] std::string section() const {
    return put("section.csv",
               "x,z,name,kind\n0,-10,top,horizon\n95,-12,top,horizon\n\n101,-30,F,fault\n99,10,F,fault\n\n"
               "0,-10,U,unit\n50,-10,U,unit\n50,0,U,unit\n0,-10,U,unit\n");
  }
};

TEST_F(ConvertCommand, OneFormatBecomesAnotherByTheEndings) {
  const test::Outcome made = call({section(), path("a.gpkg")});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.out, path("a.gpkg") + '\n');
  for (const char* name : {"a.pl", "a.asc", "a.dxf", "a.geojson", "b.csv"}) {
    EXPECT_EQ(call({path("a.gpkg"), path(name)}).code, 0) << name;
  }
  // Lines come before polygons in a GeoPackage, as they do here: the same text is back.
  EXPECT_EQ(call({path("a.pl"), path("c.csv")}).code, 0);
  EXPECT_EQ(text("b.csv"), text("c.csv"));
  EXPECT_EQ(call({section(), path("lines.txt"), "--only", "lines", "--to", "move"}).code, 0);
  EXPECT_EQ(text("lines.txt").substr(0, 32), "0.0\t0.0\t-10.0\ttop\t1\thorizon\n95.0");
}

TEST_F(ConvertCommand, TheReportSaysWhatWasReadRepairedAndWritten) {
  const test::Outcome outcome = call({section(), path("a.geojson"), "--snap", "6", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json report = Json::parse(outcome.out, nullptr, false);
  EXPECT_EQ(report["read"]["format"], "text");
  EXPECT_EQ(report["read"]["features"].size(), 3U);
  EXPECT_EQ(report["read"]["features"][0],
            Json({{"name", "top"}, {"kind", "horizon"}, {"type", "lines"}, {"parts", 1}, {"points", 2}}));
  EXPECT_FALSE(report["read"].contains("trace"));
  ASSERT_EQ(report["repairs"].size(), 1U);
  EXPECT_EQ(report["repairs"][0]["repair"], "snap");
  EXPECT_NEAR(report["repairs"][0]["moved"].get<double>(), 5.1, 0.1);
  EXPECT_EQ(report["written"]["format"], "geojson");
  EXPECT_NE(outcome.err.find("snap: horizon 'top'"), std::string::npos) << outcome.err;
}

TEST_F(ConvertCommand, OptionsTurnDepthsFeetAndExaggerationIntoMetresUp) {
  const std::string file = put("depths.txt", "0 100\n10 300\n");
  ASSERT_EQ(
      call({file, path("a.csv"), "--y-axis", "down", "--unit", "ft", "--exaggeration", "2", "--reference", "500"}).code,
      0);
  EXPECT_EQ(text("a.csv"), "x,z\n0.0,60.96\n3.048,30.48\n");
}

TEST_F(ConvertCommand, LinesInSpaceGoIntoTheirPlaneAndBackOntoTheMap) {
  const std::string file = put("space.asc", "1000\t2000\t-5\ttop\t1\n1300\t2400\t-6\ttop\t1\n1600\t2800\t-9\ttop\t1\n");
  ASSERT_EQ(call({file, path("plane.csv"), "--trace", "1000,2000,1600,2800"}).code, 0);
  EXPECT_EQ(text("plane.csv"), "x,z,name\n0.0,-5.0,top\n500.0,-6.0,top\n1000.0,-9.0,top\n");
  ASSERT_EQ(call({file, path("map.csv"), "--trace", "1000,2000,1600,2800", "--to-coordinates", "map"}).code, 0);
  EXPECT_EQ(text("map.csv"), "x,y,z,name\n1000.0,2000.0,-5.0,top\n1300.0,2400.0,-6.0,top\n1600.0,2800.0,-9.0,top\n");
}

TEST_F(ConvertCommand, ATableOfColoursIsTakenForPicturesAndItsFaultsAreTold) {
  const std::string table = put("colours.csv", "name,colour,lithology\nU,#010203,limestone\nV,#0a0b0c,\n");
  const test::Outcome made = call({section(), path("a.svg"), "--colours", table});
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_NE(made.err.find("nothing of the name 'V'"), std::string::npos) << made.err;
  EXPECT_NE(made.err.find("does not name 'top'"), std::string::npos) << made.err;
  EXPECT_NE(text("a.svg").find("rgb(0.392157%,0.784314%,1.176471%)"), std::string::npos);
  EXPECT_NE(text("a.svg").find("U (limestone)"), std::string::npos);
  EXPECT_NE(text("a.svg").find(">section<"), std::string::npos);  // its title
  refuses({section(), path("b.svg"), "--colours", put("bad.csv", "name,colour\nU,#1\n")}, 3, {"bad.csv:2: 'U': '#1'"});
  refuses({section(), path("b.csv"), "--colours", table}, 2, {"--colours is for .svg, .pdf and .png"});
  for (const char* const scale : {"", "1:500"}) {
    std::vector<std::string> words{section(), path("e.svg"), "--orientation", " WSW -ENE"};
    if (*scale != '\0') words.insert(words.end(), {"--scale", scale});
    EXPECT_EQ(call(words).code, 0);
    for (const char* const end : {">WSW<", ">ENE<"}) EXPECT_NE(text("e.svg").find(end), std::string::npos) << end;
  }
  for (const char* const ends : {"west", "W -", " - E", "-"})
    refuses({section(), path("b.svg"), "--orientation", ends}, 2, {"--orientation: '", "needs two ends"});
  refuses({section(), path("b.csv"), "--orientation", "W - E"}, 2, {"--orientation is for .svg, .pdf and .png"});
}

TEST_F(ConvertCommand, PicturesGiveEachUnitItsColourAndPiecesOneEntry) {
  io::formats::LineWork work;
  const auto add = [&](const std::string& name, io::lines::FeatureType type,
                       const std::string& kind) -> io::lines::Feature& {
    const double x = 100.0 * static_cast<double>(work.features.size());
    io::lines::Feature feature;
    feature.type = type;
    feature.name = name;
    feature.kind = kind;
    const bool area = type == io::lines::FeatureType::Polygons;
    feature.parts = {{{{x, 0.0}, {x + 90.0, 0.0}, {x + 90.0, 50.0}}, area}};
    return work.features.emplace_back(feature);
  };
  for (int i = 0; i < 31; ++i) {
    for (const char* const piece : {"_1", "_2"})
      add("K" + std::to_string(i) + "p" + piece, io::lines::FeatureType::Polygons, "");
  }
  for (int i = 0; i < 9; ++i) {
    add("bed" + std::to_string(i), io::lines::FeatureType::Lines, i % 2 == 0 ? "horizon" : "");
    add("F" + std::to_string(i), io::lines::FeatureType::Lines, "fault");
  }
  add("anything", io::lines::FeatureType::Polygons, "").properties = {{"unit", std::string("K3p")}};
  const scene::Picture picture = line_picture(work);
  std::set<std::string> fills;
  std::set<std::string> beds;
  std::map<std::string, std::size_t> pieces;
  const auto key = [](scene::Color c) { return fmt::format("{} {} {}", c.red, c.green, c.blue); };
  for (const scene::Layer& layer : picture.panels[0].layers) {
    if (const auto* regions = std::get_if<scene::Regions>(&layer.content)) {
      EXPECT_TRUE(fills.insert(key(*layer.style.fill)).second) << layer.title;
      pieces[layer.title] = regions->regions.size();
    }
    if (std::holds_alternative<scene::Lines>(layer.content) && layer.title.starts_with("bed")) {
      EXPECT_TRUE(beds.insert(key(layer.style.line)).second) << layer.title;
    }
    if (layer.title.starts_with("F")) {
      EXPECT_EQ(scene::legend_name(layer), "Faults");
    }
  }
  EXPECT_EQ(fills.size(), 31U);
  EXPECT_EQ(beds.size(), 9U);
  EXPECT_EQ(pieces["K3p"], 3U);  // with the one that says so itself
  EXPECT_EQ(pieces["K4p"], 2U);
  EXPECT_EQ(picture.panels[0].left_end, "");
  work.trace = io::lines::Trace{.x = 0.0, .y = 0.0, .east = 0.0, .north = 1.0};
  EXPECT_EQ(line_picture(work).panels[0].left_end, "S");
  EXPECT_EQ(line_picture(work).panels[0].right_end, "N");
}

TEST_F(ConvertCommand, PicturesAndDrawingsAreToATrueScale) {
  ASSERT_EQ(call({section(), path("a.dxf"), "--scale", "1:500", "--only", "lines"}).code, 0);
  ASSERT_EQ(call({path("a.dxf"), path("paper.csv")}).code, 0);
  EXPECT_NE(text("paper.csv").find("\n190.0,-24.0,top"), std::string::npos);  // millimetres: 95 m at 1:500
  // A square of 100 m at 1:500 is 0.2 m: 566.93 points, with the border of the plot and its axes round it.
  const std::string square = put("square.csv", "x,z\n0,0\n100,0\n100,100\n0,100\n0,0\n");
  for (const char* name : {"a.svg", "a.pdf", "a.png"}) {
    EXPECT_EQ(call({square, path(name), "--scale", "1:500"}).code, 0);
  }
  const std::string svg = text("a.svg");
  // The path of the square: "M x y L x y ..."; its first side is horizontal.
  double longest = 0.0;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) {
    double x0 = 0.0;
    double y0 = 0.0;
    double x1 = 0.0;
    double y1 = 0.0;
    const std::size_t d = svg.find(" d=\"M ", at);
    if (d == std::string::npos) break;
    if (std::sscanf(svg.c_str() + d, " d=\"M %lf %lf L %lf %lf", &x0, &y0, &x1, &y1) != 4) continue;
    const bool of_square = svg.substr(at, d - at).find("95.68") != std::string::npos;  // its fill
    if (of_square) longest = std::max(longest, std::abs(x1 - x0) + std::abs(y1 - y0));
  }
  EXPECT_NEAR(longest, 0.2 * 72.0 / 0.0254, 0.01);
  refuses({square, path("b.svg"), "--scale", "1:0.1"}, 4, {"--scale 1:5"});
}

TEST_F(ConvertCommand, WrongUsageAndBadInputAreToldInOneLine) {
  const std::string file = section();
  refuses({file, path("a.xyz")}, 2, {".gpkg .svg .pdf .png; or give --to NAME"});
  refuses({file, path("a.csv"), "--y-axis", "dwn"}, 2, {"did you mean 'down'?"});
  refuses({file, path("a.csv"), "--unit", "rod"}, 2, {"--unit"});
  refuses({file, path("a.csv"), "--from", "gocat"}, 2, {"did you mean 'gocad'?"});
  refuses({file, path("a.csv"), "--trace", "1,2,3"}, 2, {"--trace"});
  refuses({file, path("a.csv"), "--scale", "1:100"}, 2, {"--scale is for"});
  refuses({file, path("a.svg"), "--scale", "100"}, 2, {"give a scale such as 1:10000"});
  refuses({file, path("a.csv"), "--only", "dots"}, 2, {"--only"});
  refuses({file, path("a.csv"), "--snap", "-1"}, 2, {"give 0 m (none) or more"});
  refuses({path("none.csv"), path("a.csv")}, 3, {"there is no such file"});
  refuses({put("three.txt", "0 1 2\n3 4 5\n"), path("a.csv")}, 3, {"--columns 1,2"});
  refuses({put("bad.csv", "0,1\n2,x\n"), path("a.csv")}, 3, {"bad.csv:2:3"});
  refuses({file, path("a.shp")}, 2, {"--only lines"});
}

}  // namespace
}  // namespace dobra::cli
