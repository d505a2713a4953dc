#include "shared/io/formats/line_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "shared/io/file.h"
#include "shared/io/lines/section_plane.h"
#include "tests/shared/io/io_examples.h"
#include "tests/support/corpus.h"

namespace dobra::io::formats {
namespace {

using base::ErrorCode;
using geom::Point;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal(const base::Result<LineWork>& read) { return read.ok() ? "read" : base::to_string(read.error()); }

/// A section with everything in it; no coordinate is a short decimal.
LineWork example() {
  LineWork work;
  work.features = {
      {.parts = {{{{1.0 / 3.0, -2.5}, {10, 1e-3}, {20.7, 2}}, false}}, .name = "top", .kind = "horizon"},
      {.parts = {{{{0, -5}, {8, -4}}, false}, {{{9, -4}, {21, -6}}, false}}, .name = "base", .kind = "horizon"},
      {.parts = {{{{8.5, 3}, {9.5, -9}}, false}}, .name = "F1", .kind = "fault"},
      {.type = lines::FeatureType::Polygons,
       .parts = {{{{0, -5}, {8, -4}, {8, 0}, {0, 0}}, true}, {{{1, -2}, {1, -1}, {2, -1}}, true}},
       .name = "sand, upper",
       .kind = "unit"}};
  return work;
}

const Format* named(const char* name) { return format_named(name, Use::WriteLines); }

LineOptions chosen(const Format* format) {
  LineOptions options{.format = format};
  if (format == named("text")) options.text.columns = {"1", "2"};
  return options;
}

std::vector<const Format*> text_formats() {
  std::vector<const Format*> found;
  for (const Format& format : all_formats()) {
    if (format.lines && format.lines->text != nullptr) found.push_back(&format);
  }
  return found;
}

TEST(LineFiles, EveryFormatThatIsTextReadsBackToTheSameText) {
  for (const Format* const format : text_formats()) {
    std::vector<std::string> remarks;
    const LineWork given = example();
    const auto text = lines_text(given, {.format = format}, remarks);
    ASSERT_TRUE(text.ok()) << base::to_string(text.error());
    const auto read = parse_any_lines(*text, "f", chosen(format));
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    EXPECT_EQ(read->features[0].parts, given.features[0].parts) << format->name;
    EXPECT_EQ(*lines_text(*read, {.format = format}, remarks), *text);
    if (format == named("wkt")) continue;
    EXPECT_EQ(read->features[0].name, "top");
    EXPECT_EQ(read->features[0].kind, "horizon");
  }
}

TEST(LineFiles, NamesAndKindsThatWktAndDxfLoseAreNamedUpToTen) {
  LineWork work;
  const auto add = [&](const std::string& name, const std::string& kind) {
    work.features.push_back(lines::Feature{.parts = {{{{0, 0}, {1, 0}}, false}}, .name = name, .kind = kind});
  };
  const auto told = [&](const Format* format) {
    std::vector<std::string> remarks;
    EXPECT_TRUE(lines_text(work, {.format = format}, remarks));
    return remarks.empty() ? std::string("nothing") : remarks.front();
  };
  add("", "");
  EXPECT_EQ(told(named("wkt")), "nothing");
  add("A", "");
  EXPECT_EQ(told(named("dxf")), "nothing");
  EXPECT_EQ(told(named("wkt")), "names and kinds are not kept in wkt: 'A'");
  add("B", "horizon");
  add("", "fault");
  add("falha", "fault");  // a layer that reads back as its kind
  EXPECT_EQ(told(named("wkt")).substr(37), "'A', 'B' (horizon), one without a name (fault), 'falha' (fault)");
  EXPECT_NE(told(named("dxf")).find("dxf: 'B' (horizon), one without a name (fault); on"), std::string::npos);
  for (int i = 0; i < 8; ++i) add("C", "pin");
  EXPECT_EQ(told(named("dxf")).find("in all"), std::string::npos);  // ten
  add("D", "pin");
  EXPECT_NE(told(named("dxf")).find("'C' (pin), ... (11 in all)"), std::string::npos) << told(named("dxf"));
  EXPECT_EQ(told(named("geojson")), "nothing");
  work.features = {};
  add("a:b", "");
  EXPECT_NE(told(named("dxf")).find("'a:b' becomes 'a_b'"), std::string::npos) << told(named("dxf"));
}

TEST(LineFiles, NamesThatAFormatCannotHoldAreTold) {
  LineWork work;
  work.features = {lines::Feature{.parts = {{{{0, 0}, {1, 0}}, false}}, .name = "Top {A}"},
                   lines::Feature{.parts = {{{{0, 1}, {1, 1}}, false}}, .name = "Top\tB"}};
  const auto told = [&](const Format* format) {
    std::vector<std::string> remarks;
    EXPECT_TRUE(lines_text(work, {.format = format}, remarks));
    return remarks;
  };
  EXPECT_THAT(told(named("gocad")), testing::ElementsAre(testing::HasSubstr("1 names hold what gocad cannot")));
  EXPECT_THAT(told(named("gocad")), testing::ElementsAre(testing::HasSubstr("'Top {A}' becomes 'Top  A'")));
  EXPECT_THAT(told(named("move")), testing::ElementsAre(testing::HasSubstr("becomes 'Top B'")));
  EXPECT_THAT(told(named("geojson")), testing::ElementsAre());
}

TEST(LineFiles, GeoPackageAndShapefileGiveTheSameValues) {
  const test::TemporaryFolder folder;
  LineWork given = example();
  given.features[0].properties = {{"age", 12.5}, {"order", std::int64_t{3}}, {"note", std::string("\xC3\xA1gua")}};
  std::vector<std::string> remarks;
  ASSERT_TRUE(write_any_lines(folder.file("a.gpkg"), given, {}, remarks).ok());
  const auto read = read_any_lines(folder.file("a.gpkg"));
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_EQ(read->features, given.features);
  EXPECT_EQ(read->format, named("geopackage"));

  const auto mixed = write_any_lines(folder.file("a.shp"), given, {}, remarks);
  ASSERT_FALSE(mixed.ok());
  EXPECT_THAT(mixed.error().message, HasSubstr("--only lines"));
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.shp")));
  LineWork lines = given;
  lines.features.pop_back();
  ASSERT_TRUE(write_any_lines(folder.file("a.shp"), lines, {}, remarks).ok());
  for (const char* part : {"a.shp", "a.shx", "a.dbf"}) EXPECT_TRUE(std::filesystem::exists(folder.file(part))) << part;
  const auto shapes = read_any_lines(folder.file("a.shp"));
  ASSERT_TRUE(shapes.ok()) << base::to_string(shapes.error());
  EXPECT_EQ(shapes->features, lines.features);
  LineWork polygons = given;
  polygons.features = {given.features.back()};
  ASSERT_TRUE(write_any_lines(folder.file("p.shp"), polygons, {}, remarks).ok());
  const auto areas = read_any_lines(folder.file("p.shp"));
  ASSERT_TRUE(areas.ok()) << base::to_string(areas.error());
  ASSERT_EQ(areas->features[0].parts.size(), 2U);
  EXPECT_EQ(geom::signed_area(areas->features[0].parts[0]), geom::signed_area(given.features.back().parts[0]));
  // Nothing is left beside the files.
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path();
  }
}

TEST(LineFiles, ASectionGoesOnItsTraceAndBackInEveryFormatWithHeights) {
  const test::TemporaryFolder folder;
  LineWork given = example();
  given.trace = *lines::trace_between({512345.25, 7412345.5}, {513345.25, 7413845.5});
  for (const char* name : {"a.asc", "a.pl", "a.geojson", "a.dxf", "a.csv", "a.gpkg"}) {
    std::vector<std::string> remarks;
    ASSERT_TRUE(write_any_lines(folder.file(name), given, {.coordinates = Coordinates::Map}, remarks).ok()) << name;
    LineOptions options{.trace = given.trace};
    if (name == std::string("a.csv")) options.text.columns = {"x", "y", "z"};
    const auto read = read_any_lines(folder.file(name), options);
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    ASSERT_TRUE(read->trace.has_value());
    EXPECT_LT(read->trace->largest_misfit, 1e-8);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point wanted = given.features[0].parts[0].points[k];
      EXPECT_NEAR(read->features[0].parts[0].points[k].x, wanted.x, 5e-9) << name;
      EXPECT_EQ(read->features[0].parts[0].points[k].y, wanted.y) << name;
    }
    double area = 0.0;
    for (const lines::Feature& feature : read->features) {
      for (const geom::Polyline& part : feature.parts) area += std::abs(geom::signed_area(part));
    }
    EXPECT_NEAR(area, 36.5, 1e-6) << name;  // contour 36, hole 0.5
    // Without a trace the plane is found; its beginning is the first point along it.
    options.trace.reset();
    const auto fitted = read_any_lines(folder.file(name), options);
    ASSERT_TRUE(fitted.ok()) << base::to_string(fitted.error());
    EXPECT_NEAR(fitted->trace->east, given.trace->east, 1e-9);
    EXPECT_NEAR(fitted->features[0].parts[0].points[0].x, 1.0 / 3.0, 1e-6);
  }
}

TEST(LineFiles, WhatAFileLeavesOpenIsAskedWithTheOption) {
  const std::string pline = "GOCAD PLine 1\nVRTX 1 0 0 100\nVRTX 2 5 0 300\nSEG 1 2\nEND\n";
  EXPECT_THAT(refusal(parse_any_lines(pline, "a.pl", {})), HasSubstr("--y-axis"));
  EXPECT_EQ(parse_any_lines(pline, "a.pl", {}).error().code, ErrorCode::Unclear);
  EXPECT_EQ(base::exit_code(ErrorCode::Unclear), 3);
  const auto down = parse_any_lines(pline, "a.pl", {.y_direction = lines::YDirection::Down});
  ASSERT_TRUE(down.ok()) << base::to_string(down.error());
  EXPECT_THAT(down->features[0].parts[0].points, ElementsAre(Point{0, -100}, Point{5, -300}));

  EXPECT_THAT(refusal(parse_any_lines("0 1 2\n3 4 5\n", "a.txt", {})), HasSubstr("3 columns; say which"));
  EXPECT_THAT(refusal(parse_any_lines("x,y,z\n0,1,2\n3,4,5\n", "a.csv", {})),
              HasSubstr("3 columns: x, y, z; say which"));
  LineOptions two;
  two.text.columns = {"1", "3"};
  EXPECT_THAT(parse_any_lines("0 1 2\n3 4 5\n", "a.txt", two)->features[0].parts[0].points,
              ElementsAre(Point{0, 2}, Point{3, 5}));

  const std::string mixed =
      R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[0,0,1],[1,0,2]]}},
      {"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[0,0],[1,1]]}}]})";
  EXPECT_THAT(refusal(parse_any_lines(mixed, "a.geojson", {})), HasSubstr("--coordinates section"));
  EXPECT_EQ(parse_any_lines(mixed, "a.geojson", {.coordinates = Coordinates::Section})->features.size(), 1U + 1U);

  const auto drawing = [](const std::string& unit) {
    return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + unit +
           "\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nA\n10\n1\n20\n2\n11\n3\n21\n4\n0\nENDSEC\n0\nEOF\n";
  };
  EXPECT_THAT(refusal(parse_any_lines(drawing("13"), "a.dxf", {})), AllOf(HasSubstr("= '13'"), HasSubstr("--unit")));
  // Microns are asked about; what is known is taken and told, and an option goes before it.
  for (const auto& [code, unit] : {std::pair{"1", 0.0254}, {"4", 0.001}, {"5", 0.01}, {"10", 0.9144}}) {
    const auto told = parse_any_lines(drawing(code), "a.dxf", {});
    ASSERT_TRUE(told.ok()) << base::to_string(told.error());
    EXPECT_EQ(told->features[0].parts[0].points[1], (Point{3 * unit, 4 * unit})) << code;
    EXPECT_THAT(told->remarks.at(0), HasSubstr("as the file says")) << code;
  }
  EXPECT_EQ(parse_any_lines(drawing("1"), "a.dxf", {.unit = 1000.0})->features[0].parts[0].points[0],
            (Point{1000, 2000}));
  const auto feet = parse_any_lines(drawing("2"), "a.dxf", {});
  EXPECT_EQ(feet->unit, 0.3048);
  EXPECT_THAT(feet->remarks, ElementsAre("a.dxf: its unit is 0.3048 m, as the file says"));
}

TEST(LineFiles, LinesOffThePlaneAreRefusedWithTheMisfit) {
  const std::string text = "0\t0\t1\ta\n100\t0\t2\ta\n50\t3\t-4\ta\n";
  EXPECT_THAT(refusal(parse_any_lines(text, "a.asc", {})), AllOf(HasSubstr("do not stand on one vertical plane"),
                                                                 HasSubstr("2 m off"), HasSubstr("--plane-tolerance")));
  const auto wide = parse_any_lines(text, "a.asc", {.plane_tolerance = 0.03});
  ASSERT_TRUE(wide.ok()) << base::to_string(wide.error());
  EXPECT_NEAR(wide->trace->largest_misfit, 2.0, 1e-9);
  EXPECT_THAT(wide->remarks.at(0), HasSubstr("runs towards 90.0000 degrees"));
}

TEST(LineFiles, UnitsDepthsAndExaggerationBecomeMetresUp) {
  LineOptions options{.y_direction = lines::YDirection::Down, .y_reference = 4.0, .unit = 1000.0, .exaggeration = 2.0};
  options.text.columns = {"1", "2"};
  const auto read = parse_any_lines("0 1\n2 5\n\n0 0\n4 0\n4 4\n0 0\n", "a.txt", options);
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_THAT(read->features[0].parts[0].points, ElementsAre(Point{0, 1500}, Point{2000, -500}));
  EXPECT_EQ(read->features[1].type, lines::FeatureType::Polygons);
  EXPECT_EQ(geom::signed_area(read->features[1].parts[0]), 4e6);  // anticlockwise, though the axis was turned
  for (const LineOptions& bad :
       {LineOptions{.plane_tolerance = 0.0}, LineOptions{.unit = -1.0}, LineOptions{.exaggeration = NAN}}) {
    EXPECT_EQ(parse_any_lines("0 1\n2 5\n", "a.txt", bad).error().code, ErrorCode::InvalidOption);
  }
  LineOptions huge{.unit = 1e300};
  EXPECT_EQ(parse_any_lines("0 1e300\n2 5\n", "a.txt", huge).error().code, ErrorCode::NotFinite);
}

TEST(LineFiles, AnElevationOfALwpolylineIsAHeight) {
  const auto contour = [](const std::string& height) {
    return "0\nLWPOLYLINE\n8\nC\n90\n2\n70\n0\n38\n" + height + "\n10\n0\n20\n0\n10\n50\n20\n0\n";
  };
  const std::string text = "0\nSECTION\n2\nENTITIES\n" + contour("100") + contour("250") + "0\nENDSEC\n0\nEOF\n";
  const auto read = parse_any_lines(text, "a.dxf", {});
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  EXPECT_THAT(read->features[0].parts[0].points, ElementsAre(Point{0, 100}, Point{50, 100}));
  EXPECT_THAT(read->features[1].parts[0].points, ElementsAre(Point{0, 250}, Point{50, 250}));
}

TEST(LineFiles, UnorderedRowsOfSeveralLinesAreGatheredByName) {
  LineOptions options{.repair = {.order = PointOrder::AlongTheCurve}};
  options.text.columns = {"X", "Z"};
  options.text.name_columns = {"formation"};
  const auto read =
      parse_any_lines("X;Y;Z;formation\n5;0;1;A\n0;0;9;B\n0;0;1;A\n9;0;2;A\n4;0;8;B\n2;0;9;B\n", "h.csv", options);
  ASSERT_TRUE(read.ok()) << base::to_string(read.error());
  ASSERT_EQ(read->features.size(), 2U);
  EXPECT_THAT(read->features[0].parts[0].points, ElementsAre(Point{0, 1}, Point{5, 1}, Point{9, 2}));
  EXPECT_THAT(read->features[1].parts[0].points, ElementsAre(Point{0, 9}, Point{2, 9}, Point{4, 8}));
  EXPECT_EQ(read->repairs.size(), 2U);
}

TEST(LineFiles, BadFilesAreNamed) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(read_any_lines(folder.file("none.gpkg")).error().code, ErrorCode::FileNotFound);
  for (const char* name : {"bad.gpkg", "bad.shp"}) {
    std::ofstream(folder.file(name)) << "nothing of the kind";
    const auto read = read_any_lines(folder.file(name));
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, ErrorCode::BadFormat);
    EXPECT_EQ(read.error().place->file, folder.file(name));
    EXPECT_EQ(read.error().message.find('\n'), std::string::npos);
  }
  ASSERT_TRUE(write_file(folder.file("a.xyz"), "0 0\n").ok());
  EXPECT_EQ(read_any_lines(folder.file("a.xyz")).error().code, ErrorCode::UnknownFormat);
  std::vector<std::string> remarks;
  for (const char* name : {"a.csv", "a.gpkg", "a.shp", "a.pl"}) {
    LineWork work;
    work.features = {example().features[0]};
    EXPECT_EQ(write_any_lines(folder.file("no/such/folder/") + name, work, {}, remarks).error().code,
              ErrorCode::CannotWrite)
        << name;
    work.features[0].parts[0].points[1].x = NAN;
    EXPECT_EQ(write_any_lines(folder.file(name), work, {}, remarks).error().code, ErrorCode::NotFinite) << name;
    EXPECT_FALSE(std::filesystem::exists(folder.file(name)));
  }
}

/// What docs/user/import.md says of the sections in DOBRA_TEST_DATA.
struct Known {
  const char* file;
  std::vector<std::string> columns;
  std::vector<std::string> names;
  lines::YDirection direction;
  double reference;
  double unit;
  std::size_t lines;
  std::size_t points;
  geom::Box box;
};

TEST(LineFiles, EverySectionOfTheCorpusIsReadWithTheOptionsOfTheManual) {
  const auto folder = test::data_folder();
  if (!folder) GTEST_SKIP() << test::no_data;
  const std::vector<Known> table = {
      // Counted from the files in Python, not by the readers under test.
      {"ragan_isogon_fold/layer1.txt",
       {"1", "2"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       114,
       {{107.7, 6.83}, {183.14, 67.31}}},
      {"ragan_isogon_fold/layer2.txt",
       {"1", "2"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       188,
       {{74.56, 28.71}, {202.25, 120.71}}},
      {"ragan_isogon_fold/layer3.txt",
       {"1", "2"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       228,
       {{48.81, 53.6}, {213.8, 152.92}}},
      {"ragan_isogon_fold/layer4.txt",
       {"1", "2"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       278,
       {{24.94, 99.42}, {224.11, 214.39}}},
      {"catskill_fpf/bed1.txt",
       {"1", "2"},
       {},
       lines::YDirection::Down,
       400.0,
       1.0,
       1,
       402,
       {{76.5187, 118.97269999999997}, {425.4581, 210.317}}},
      {"catskill_fpf/bed2.txt",
       {"1", "2"},
       {},
       lines::YDirection::Down,
       400.0,
       1.0,
       1,
       399,
       {{58.8477, 139.7493}, {430.4305, 235.8404}}},
      {"catskill_fpf/bed3.txt",
       {"1", "2"},
       {},
       lines::YDirection::Down,
       400.0,
       1.0,
       1,
       402,
       {{58.5322, 163.2842}, {434.0676, 268.0885}}},
      {"catskill_fpf/bed4.txt",
       {"1", "2"},
       {},
       lines::YDirection::Down,
       400.0,
       1.0,
       1,
       402,
       {{62.9528, 193.2389}, {439.3798, 309.4406}}},
      {"catskill_fpf/bed5.txt",
       {"1", "2"},
       {},
       lines::YDirection::Down,
       400.0,
       1.0,
       1,
       434,
       {{43.4479, 229.8081}, {447.4662, 365.0647}}},
      {"catskill_fpf/bed6.txt",
       {"1", "2"},
       {},
       lines::YDirection::Down,
       400.0,
       1.0,
       1,
       402,
       {{80.6175, 249.5979}, {451.313, 385.4104}}},
      {"subandean_area_balance/subandean.txt",
       {"1", "2"},
       {},
       lines::YDirection::Up,
       0.0,
       1000.0,
       1,
       30,
       {{-93403.83988, -11033.8383}, {-12808.84707, 2974.33902}}},
      {"broadhaven_fold/derived_profile_m/profile.csv",
       {"x_m", "z_m"},
       {"layer", "part"},
       lines::YDirection::Up,
       0.0,
       1.0,
       39,
       1458,
       {{4.4641, 4.9394}, {44.3196, 22.8092}}},
      {"broadhaven_fold/layer1.txt",
       {"1", "3"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       134,
       {{8.6736, 7.5989}, {27.5073, 18.7659}}},
      {"broadhaven_fold/layer2.txt",
       {"1", "3"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       218,
       {{8.8688, 9.1282}, {24.3103, 20.0084}}},
      {"broadhaven_fold/layer3.txt",
       {"1", "3"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       127,
       {{8.7535, 9.9983}, {23.8271, 21.0242}}},
      {"broadhaven_fold/layer4.txt",
       {"1", "3"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       101,
       {{8.4805, 11.0564}, {23.619, 21.8144}}},
      {"broadhaven_fold/layer5.txt",
       {"1", "3"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       89,
       {{8.2591, 12.392}, {22.2885, 22.9133}}},
      {"broadhaven_fold/layer6.txt",
       {"1", "3"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       228,
       {{8.2636, 12.7336}, {22.0451, 23.232}}},
      {"broadhaven_fold/layer7.txt",
       {"1", "3"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       303,
       {{8.4317, 13.1519}, {21.8963, 23.5632}}},
      {"broadhaven_fold/layer8.txt",
       {"1", "3"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       174,
       {{8.2345, 13.9471}, {18.954, 23.8443}}},
      {"broadhaven_fold/layer9.txt",
       {"1", "3"},
       {},
       lines::YDirection::Up,
       0.0,
       1.0,
       1,
       84,
       {{6.4833, 15.6222}, {20.8635, 25.3797}}},
  };
  std::size_t files = 0;
  for (const Known& known : table) {
    const std::string path = (*folder / "sections" / known.file).string();
    LineOptions options{.y_direction = known.direction, .y_reference = known.reference, .unit = known.unit};
    options.text.columns = known.columns;
    options.text.name_columns = known.names;
    const auto read = read_any_lines(path, options);
    ASSERT_TRUE(read.ok()) << base::to_string(read.error());
    std::size_t points = 0;
    geom::Box box;
    for (const lines::Feature& feature : read->features) {
      for (const geom::Polyline& part : feature.parts) points += part.points.size(), box.add(part.box());
    }
    EXPECT_EQ(read->features.size(), known.lines) << known.file;
    EXPECT_EQ(points, known.points) << known.file;
    EXPECT_NEAR(box.low.x, known.box.low.x, 1e-9 * known.unit) << known.file;
    EXPECT_NEAR(box.low.y, known.box.low.y, 1e-9 * known.unit) << known.file;
    EXPECT_NEAR(box.high.x, known.box.high.x, 1e-9 * known.unit) << known.file;
    EXPECT_NEAR(box.high.y, known.box.high.y, 1e-9 * known.unit) << known.file;
    ++files;
  }
  // No file of the corpus is left out.
  std::size_t there = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*folder / "sections")) {
    const bool data =
        entry.path().extension() == ".csv" ||
        (entry.path().extension() == ".txt" && entry.path().filename() != "LICENSE-nfcd-structuralGeology.txt");
    there += entry.is_regular_file() && data ? 1 : 0;
  }
  EXPECT_EQ(files, there);
}

TEST(LineFiles, LinesOfThePlungingFoldAreRefusedAsASectionUnlessProjected) {
  const auto folder = test::data_folder();
  if (!folder) GTEST_SKIP() << test::no_data;
  LineOptions options;
  EXPECT_EQ(read_any_lines((*folder / "sections/broadhaven_fold/layer1.txt").string()).error().code,
            ErrorCode::Unclear);
  options.text.columns = {"1", "2", "3"};
  const auto read = read_any_lines((*folder / "sections/broadhaven_fold/layer1.txt").string(), options);
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().message, HasSubstr("do not stand on one vertical plane"));
}

}  // namespace
}  // namespace dobra::io::formats
