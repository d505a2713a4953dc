#include "recon/input/input.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/support/corpus.h"
#include "tests/support/tiff.h"

namespace recon::input {
namespace {

using base::ErrorCode;

/// A folder of its own for each test, removed afterwards.
class Input : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("recon_input_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  [[nodiscard]] base::Result<ReadSection> read(const SectionInput& input) const {
    return read_section(input, {folder_}, {});
  }

  static HorizonInput from_file(std::string name, std::string file) {
    HorizonInput horizon;
    horizon.name = std::move(name);
    horizon.file = std::move(file);
    return horizon;
  }
  static HorizonInput from_points(std::string name, std::vector<geom::Point> points) {
    HorizonInput horizon;
    horizon.name = std::move(name);
    horizon.points = std::move(points);
    return horizon;
  }
  void expect_error(const SectionInput& input, ErrorCode code, const std::string& part) const {
    const auto result = read(input);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, code) << to_string(result.error());
    EXPECT_NE(to_string(result.error()).find(part), std::string::npos) << to_string(result.error());
    EXPECT_EQ(to_string(result.error()).find('\n'), std::string::npos);
  }

  std::filesystem::path folder_;
};

TEST_F(Input, HorizonsComeFromTextCsvGeoJsonAndPoints) {
  write("a.txt", "# x z\n0 5\n10 6\n");
  write("b.csv", "id;depth;x\n1;4;0\n2;4.5;10\n");
  write("c.geojson", R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{"name":"other"},"geometry":{"type":"LineString","coordinates":[[0,9],[1,9]]}},
    {"type":"Feature","properties":{"name":"bed"},"geometry":{"type":"LineString","coordinates":[[0,3],[10,2]]}}]})");
  SectionInput input;
  input.horizons = {from_file("a", "a.txt"), from_file("b", "b.csv"), from_file("c", "c.geojson"),
                    from_points("d", {{0, 1}, {10, 0}})};
  input.horizons[1].columns = {3, 2};
  input.horizons[1].separator = FieldSeparator::Semicolon;
  input.horizons[2].feature = "bed";
  const auto read_back = read(input);
  ASSERT_TRUE(read_back) << to_string(read_back.error());
  const auto& horizons = read_back->section.horizons;
  ASSERT_EQ(horizons.size(), 4u);
  EXPECT_EQ(horizons[0].line.points, (std::vector<geom::Point>{{0, 5}, {10, 6}}));
  EXPECT_EQ(horizons[1].line.points, (std::vector<geom::Point>{{0, 4}, {10, 4.5}}));
  EXPECT_EQ(horizons[2].line.points, (std::vector<geom::Point>{{0, 3}, {10, 2}}));
  EXPECT_EQ(horizons[3].line.points, (std::vector<geom::Point>{{0, 1}, {10, 0}}));
  EXPECT_EQ(horizons[3].id, section::HorizonId(3));
}

TEST_F(Input, HorizonsComeFromGocadMoveAndDrawings) {
  write("a.pl",
        "GOCAD PLine 1\nHEADER {\nname:a\n}\nGOCAD_ORIGINAL_COORDINATE_SYSTEM\nAXIS_UNIT m m m\nZPOSITIVE "
        "Depth\nEND_ORIGINAL_COORDINATE_SYSTEM\nVRTX 1 0 0 5\nVRTX 2 10 0 6\nSEG 1 2\nEND\n");
  write("b.pl", "GOCAD PLine 1\nVRTX 1 0 0 15\nVRTX 2 10 0 16\nSEG 1 2\nEND\n");
  write("c.asc", "0\t0\t-25\tc\t1\n10\t0\t-26\tc\t1\n\n0\t0\t-35\td\t2\n10\t0\t-36\td\t2\n");
  write("e.csv", "0,-47\n10,-46\n3,-45\n7,-45\n");
  SectionInput input;
  input.horizons = {from_file("a", "a.pl"), from_file("b", "b.pl"), from_file("d", "c.asc"), from_file("e", "e.csv")};
  input.horizons[2].feature = "d";
  input.horizons[3].order = PointOrder::AlongCurve;
  expect_error(input, ErrorCode::Unclear, "y_axis = up or down");
  input.horizons[1].y_axis = LineAxis::Down;
  const auto result = read(input);
  ASSERT_TRUE(result) << to_string(result.error());
  const auto& horizons = result->section.horizons;
  EXPECT_EQ(horizons[0].line.points, (std::vector<geom::Point>{{0, -5}, {10, -6}}));
  EXPECT_EQ(horizons[1].line.points, (std::vector<geom::Point>{{0, -15}, {10, -16}}));
  EXPECT_EQ(horizons[2].line.points, (std::vector<geom::Point>{{0, -35}, {10, -36}}));
  EXPECT_EQ(horizons[3].line.points, (std::vector<geom::Point>{{0, -47}, {3, -45}, {7, -45}, {10, -46}}));
  bool told = false;
  for (const std::string& remark : result->remarks) told = told || remark.find("horizon 'e': order: ") == 0;
  EXPECT_TRUE(told);
}

TEST_F(Input, ExaggerationInTheDataIsTakenOutOfFilesAndPoints) {
  write("a.txt", "0 10\n10 20\n");
  SectionInput input;
  input.exaggeration = 2.0;
  input.horizons = {from_file("a", "a.txt"), from_points("b", {{0, -10}, {10, -20}})};
  const auto result = read(input);
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_EQ(result->section.horizons[0].line.points, (std::vector<geom::Point>{{0, 5}, {10, 10}}));
  EXPECT_EQ(result->section.horizons[1].line.points, (std::vector<geom::Point>{{0, -5}, {10, -10}}));
}

TEST_F(Input, YDownAndKilometresBecomeElevationsInMetres) {
  SectionInput input;
  input.y_axis = section::VerticalAxis::Down;
  input.reference = 4.0;
  input.unit = section::LengthUnit::Kilometre;
  input.horizons = {from_points("a", {{0, 1}, {2, 5}})};
  const auto result = read(input);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->section.horizons[0].line.points, (std::vector<geom::Point>{{0, 3000}, {2000, -1000}}));
}

TEST_F(Input, LinesRunFromLeftToRightWhateverTheOrderInTheFile) {
  SectionInput input;
  input.horizons = {from_points("a", {{10, 1}, {5, 2}, {0, 3}})};
  const auto result = read(input);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->section.horizons[0].line.points.front(), (geom::Point{0, 3}));
}

TEST_F(Input, RepeatedPointsAreDroppedWithARemark) {
  write("a.txt", "0 0\n0 0\n5 1\n9 0\n");
  SectionInput input;
  input.horizons = {from_points("p", {{0, -5}, {4, -5}, {4, -5}, {9, -5}}), from_file("f", "a.txt")};
  const auto result = read(input);
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_EQ(result->section.horizons[0].line.points.size(), 3u);
  EXPECT_EQ(result->section.horizons[1].line.points.size(), 3u);
  ASSERT_EQ(result->remarks.size(), 2u);
  EXPECT_NE(result->remarks[0].find("horizon 'p'"), std::string::npos);
  EXPECT_NE(result->remarks[1].find("horizon 'f'"), std::string::npos);
}

TEST_F(Input, HorizonsThatCrossEachOtherAreRemarked) {
  SectionInput input;
  input.horizons = {from_points("a", {{0, 0}, {4, 4}}), from_points("b", {{0, 4}, {4, 0}})};
  const auto result = read(input);
  ASSERT_TRUE(result);
  ASSERT_EQ(result->remarks.size(), 1u);
  EXPECT_EQ(result->remarks[0], "horizons 'a' and 'b' cross at one place, (2, 2)");
}

TEST_F(Input, ALineThatCrossesItselfIsRefusedWithNameAndPlaceOrItsSmallLoopsAreCut) {
  SectionInput input;
  input.horizons = {from_points("a", {{0, 0}, {50.5, 0}, {50.5, 0.2}, {50.25, 0.2}, {50.25, -0.2}, {100, -0.2}})};
  expect_error(input, ErrorCode::BadSection, "horizon 'a'");
  expect_error(input, ErrorCode::BadSection, "at 50.25, 0");
  expect_error(input, ErrorCode::BadSection, "cut_loops");
  input.self_crossings = SelfCrossings::CutLoops;
  const auto result = read(input);
  ASSERT_TRUE(result);
  ASSERT_EQ(result->remarks.size(), 1u);
  EXPECT_NE(result->remarks[0].find("small loops cut out: 1, the first at (50.25, 0)"), std::string::npos)
      << result->remarks[0];
}

TEST_F(Input, WhatCannotBeReadIsNamedWithTheFileOrTheHorizon) {
  SectionInput input;
  expect_error(input, ErrorCode::BadSection, "no horizon");
  input.horizons = {from_file("a", "missing.txt")};
  expect_error(input, ErrorCode::FileNotFound, "missing.txt");
  write("bad.txt", "0 0\n1 x\n");
  input.horizons = {from_file("a", "bad.txt")};
  expect_error(input, ErrorCode::BadFormat, "bad.txt:2");
  write("nan.txt", "0 0\n1 nan\n");
  input.horizons = {from_file("a", "nan.txt")};
  expect_error(input, ErrorCode::NotFinite, "nan.txt:2");
  write("empty.txt", "");
  input.horizons = {from_file("a", "empty.txt")};
  expect_error(input, ErrorCode::EmptyFile, "empty.txt");
  input.horizons = {from_points("short", {{1, 1}, {1, 1}})};
  expect_error(input, ErrorCode::DegenerateCurve, "horizon 'short'");
  input.horizons = {from_points("n", {{1, 1}, {std::nan(""), 1}})};
  expect_error(input, ErrorCode::NotFinite, "horizon 'n'");
  input.horizons = {from_points("a", {{0, 0}, {1, 0}}), from_points("a", {{0, 1}, {1, 1}})};
  expect_error(input, ErrorCode::BadSection, "two horizons have this name");
  input.horizons = {from_points("a", {})};
  expect_error(input, ErrorCode::MissingKey, "needs file");
  input.horizons = {from_points("a", {{0, 0}, {1, 0}})};
  input.horizons[0].file = "bad.txt";
  expect_error(input, ErrorCode::MissingKey, "both");
}

TEST_F(Input, AGeoJsonFileWithSeveralLinesNeedsAName) {
  write("c.geojson", R"({"type":"FeatureCollection","features":[
    {"type":"Feature","properties":{"name":"first"},"geometry":{"type":"LineString","coordinates":[[0,9],[1,9]]}},
    {"type":"Feature","properties":{"name":"second"},"geometry":{"type":"LineString","coordinates":[[0,3],[10,2]]}}]})");
  SectionInput input;
  input.horizons = {from_file("c", "c.geojson")};
  expect_error(input, ErrorCode::BadSection, "2 lines to choose from");
  input.horizons[0].feature = "secnd";
  expect_error(input, ErrorCode::BadSection, "did you mean 'second'?");
}

TEST_F(Input, AHorizonMayBeDrawnAsACurve) {
  SectionInput input;
  input.horizons = {from_points("s", {{0, 0}, {50, 10}, {100, 0}}), from_points("b", {{0, -20}, {50, 0}, {100, -20}}),
                    from_points("h", {{0, -40}, {100, -40}}), from_points("r", {{0, -70}, {50, -50}, {100, -70}})};
  input.horizons[0].curve = geom::DrawnAs::Spline;
  input.horizons[1].curve = geom::DrawnAs::Bezier;
  input.horizons[2].curve = geom::DrawnAs::Hermite;
  input.horizons[2].tangents = {{100, 30}, {100, 30}};
  input.horizons[3].curve = geom::DrawnAs::RationalBezier;
  input.horizons[3].weights = {1, 0.5, 1};
  input.curve_angle = base::Angle::from_degrees(1.0);
  const auto result = read(input);
  ASSERT_TRUE(result) << to_string(result.error());
  const auto& horizons = result->section.horizons;
  for (const section::Horizon& horizon : horizons) EXPECT_GT(horizon.line.points.size(), 10u) << horizon.name;
  EXPECT_LT(geom::distance(horizons[0].line, {50, 10}), 1e-2);
  EXPECT_NEAR(horizons[1].line.box().high.y, -10.0, 1e-2);  // half way to the vertex
  EXPECT_NEAR(horizons[3].line.box().high.y, -70.0 + 20.0 / 3.0, 1e-2);
  input.horizons[3].weights.pop_back();
  expect_error(input, ErrorCode::InvalidOption, "horizon 'r'");
}

TEST_F(Input, ACurveFollowsTheConventionOfTheFiles) {
  SectionInput up, down;
  up.horizons = {from_points("h", {{0, -1000}, {2000, -3000}})};
  up.horizons[0].curve = geom::DrawnAs::Hermite;
  up.horizons[0].tangents = {{3000, 0}, {3000, -500}};
  down = up;
  down.y_axis = section::VerticalAxis::Down;
  down.unit = section::LengthUnit::Kilometre;
  down.horizons[0].points = {{0, 1}, {2, 3}};
  down.horizons[0].tangents = {{3, 0}, {3, 0.5}};
  const auto a = read(up);
  const auto b = read(down);
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->section.horizons[0].line.points.size(), b->section.horizons[0].line.points.size());
  for (std::size_t i = 0; i < a->section.horizons[0].line.points.size(); ++i)
    EXPECT_LT(geom::distance(a->section.horizons[0].line.points[i], b->section.horizons[0].line.points[i]), 1e-9);
}

TEST_F(Input, EndsSnapToFaultsPolygonsShareEdgesAndSliversGo) {
  SectionInput input;
  input.horizons = {from_points("a", {{0, 0}, {49.8, 0}}), from_points("b", {{50.1, -5}, {100, -5}})};
  input.faults = {from_points("F", {{50, 20}, {50, -40}})};
  input.units = {from_points("U", {{0, -20}, {49.9, -20}, {50.1, 0}, {0, 0.1}}),
                 from_points("thin", {{60, -30}, {90, -30}, {90, -30.01}, {60, -30.01}})};
  input.snap_to_faults = 0.5;
  input.share_edges = 0.5;
  input.slivers = 0.2;
  const auto result = read(input);
  ASSERT_TRUE(result) << to_string(result.error());
  const section::Section& section = result->section;
  const geom::Point ends[] = {section.horizons[0].line.points.back(), section.horizons[1].line.points.front()};
  EXPECT_LT(geom::distance(ends[0], {50, 0}), 1e-12);
  EXPECT_LT(geom::distance(ends[1], {50, -5}), 1e-12);
  for (const geom::Point end : ends) {  // the fault has the very point
    const auto& fault = section.lines[0].line.points;
    EXPECT_EQ(std::count(fault.begin(), fault.end(), end), 1);
  }
  ASSERT_EQ(section.units.size(), 1u);
  EXPECT_NEAR(geom::signed_area(section.units[0].contour), 1000.0, 1e-9);
  EXPECT_EQ(section.lines[0].line.points.size(), 5u);  // its own two, and three that others share
  int told = 0;
  for (const std::string& remark : result->remarks) {
    for (const char* const what : {"snap: ", "edge: ", "sliver: "}) told += remark.find(what) == 0 ? 1 : 0;
  }
  EXPECT_EQ(told, 4);
}

TEST_F(Input, LinesInSpaceOfSeveralFilesNeedTheirTrace) {
  write("a.csv", "x,y,h\n1000,2000,-5\n1300,2400,-6\n1600,2800,-5\n");
  write("b.csv", "x,y,h\n1060,2080,-15\n1300,2400,-16\n1540,2720,-15\n");
  SectionInput input;
  input.horizons = {from_file("a", "a.csv"), from_file("b", "b.csv")};
  for (HorizonInput& horizon : input.horizons) horizon.columns = {1, 2, 3};
  expect_error(input, ErrorCode::Unclear, "trace = [x0, y0, x1, y1]");
  input.trace = {1000, 2000, 1600, 2800};
  const auto result = read(input);
  ASSERT_TRUE(result) << to_string(result.error());
  EXPECT_NEAR(result->section.horizons[0].line.points[1].x, 500.0, 1e-9);
  EXPECT_NEAR(result->section.horizons[1].line.points[0].x, 100.0, 1e-9);
  input.trace = {1000, 2000, 1000};
  expect_error(input, ErrorCode::BadValue, "four numbers");
}

TEST_F(Input, APlungingFoldIsReadDownThePlunge) {
  const auto data = dobra::test::data_folder();
  if (!data) GTEST_SKIP() << dobra::test::no_data;
  const std::string folder = data->string() + "/sections/broadhaven_fold/";
  // The profile as it was published: parts of layer 1 one after the other.
  std::ifstream profile(folder + "derived_profile_m/profile.csv");
  std::vector<geom::Point> expected;
  for (std::string row; std::getline(profile, row);) {
    double x = 0.0, z = 0.0;
    int layer = 0, part = 0, number = 0;
    if (std::sscanf(row.c_str(), "%d,%d,%d,%lf,%lf", &layer, &part, &number, &x, &z) == 5 && layer == 1)
      expected.push_back({x, z});
  }
  SectionInput input;
  input.horizons = {from_file("layer1", folder + "layer1.txt")};
  input.horizons[0].columns = {1, 2, 3};
  input.fold_axis = {261, 10};
  input.self_crossings = SelfCrossings::Refuse;
  const auto line = read_line(input.horizons[0], read_settings(input).value(), {});
  ASSERT_TRUE(line) << to_string(line.error());
  ASSERT_EQ(line->line.points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(line->line.points[i].x, expected[i].x, 5.1e-5);
    EXPECT_NEAR(line->line.points[i].y, expected[i].y, 5.1e-5);
  }
}

TEST_F(Input, LinesOfOneNameAreThePiecesOfAHorizonNumberedFromTheLeft) {
  // Right of the fault first, and drawn from right to left; the fault is in one piece.
  write("faulted.csv", "x,z,name\n10,-3,Top\n5,-2,Top\n\n0,0,Top\n4,0,Top\n\n4.5,1,F\n4.5,-3,F\n");
  SectionInput input;
  input.horizons = {from_file("Sand", "faulted.csv"), from_points("Base", {{0, -5}, {10, -5}})};
  input.horizons[0].feature = "Top";
  input.faults = {from_file("F", "faulted.csv")};
  input.faults[0].feature = "F";
  const auto made = read(input);
  ASSERT_TRUE(made) << to_string(made.error());
  const auto& horizons = made->section.horizons;
  ASSERT_EQ(horizons.size(), 3u);
  EXPECT_EQ(horizons[0].name, "Sand (1)");
  EXPECT_EQ(horizons[0].line.points, (std::vector<geom::Point>{{0, 0}, {4, 0}}));
  EXPECT_EQ(horizons[1].name, "Sand (2)");
  EXPECT_EQ(horizons[1].line.points, (std::vector<geom::Point>{{5, -2}, {10, -3}}));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(horizons[i].id, section::HorizonId(i));
  EXPECT_EQ(horizons[1].piece_of, "Sand");
  EXPECT_EQ(whole_name(horizons[1]), "Sand");
  EXPECT_EQ(horizons[2].piece_of, "");
  const auto told = [](const std::string& remark) {
    return remark.find(
               "horizon 'Sand' is in 2 pieces, numbered from the left: 'Sand (1)' from (0, 0) to (4, 0), "
               "'Sand (2)' from (5, -2) to (10, -3)") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(made->remarks.begin(), made->remarks.end(), told), 1);
  const auto open = [](const std::string& remark) {
    return remark.find("ends at (4, 0), 0.5 m from the nearest fault") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(made->remarks.begin(), made->remarks.end(), open), 1);
  input.snap_to_faults = 1.0;
  const auto snapped = read(input);
  ASSERT_TRUE(snapped) << to_string(snapped.error());
  for (const std::string& remark : snapped->remarks)
    EXPECT_EQ(remark.find("run together"), std::string::npos) << remark;
  input.snap_to_faults = 0.0;
  // What must be one line says so; what is near is joined as the user wishes.
  input.faults[0].feature = "Top";
  expect_error(input, ErrorCode::BadSection, "the line is in 2 pieces; join them into one");
  input.faults.clear();
  input.horizons[0].join_gaps = 3.0;
  EXPECT_EQ(read(input)->section.horizons.size(), 2u);
  input.horizons[0].join_gaps = 0.0;
  input.horizons[1].name = "Sand (2)";
  expect_error(input, ErrorCode::BadSection, "a piece of another horizon has this name already");
}

TEST_F(Input, PartsOfOneLineArePiecesTooAndAScenarioMaySayIt) {
  write("parts.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"name":"bed"},
    "geometry":{"type":"MultiLineString","coordinates":[[[6,1],[9,2]],[[0,3],[5,2]]]}}]})");
  SectionInput input;
  input.horizons = {from_file("a", "parts.geojson"), from_points("b left", {{0, 0}, {4, 0}}),
                    from_points("b right", {{5, -1}, {9, -1}})};
  input.horizons[1].piece_of = input.horizons[2].piece_of = "b";
  const auto made = read(input);
  ASSERT_TRUE(made) << to_string(made.error());
  std::vector<std::string> names, wholes;
  for (const section::Horizon& horizon : made->section.horizons) {
    names.push_back(horizon.name);
    wholes.push_back(whole_name(horizon));
  }
  EXPECT_EQ(names, (std::vector<std::string>{"a (1)", "a (2)", "b left", "b right"}));
  EXPECT_EQ(wholes, (std::vector<std::string>{"a", "a", "b", "b"}));
  input.horizons[1].name = "b";
  input.horizons[1].piece_of.clear();
  expect_error(input, ErrorCode::BadSection, "piece_of names 'b', which is a horizon itself");
}

TEST_F(Input, APieceThatEndsOnAnotherHorizonIsNotOpen) {
  SectionInput input;  // a channel whose base cuts the bed
  input.horizons = {from_points("bed left", {{0, 0}, {2, 0}}), from_points("bed right", {{8, 0}, {10, 0}}),
                    from_points("channel", {{0, 2}, {2, 0}, {5, -1}, {8, 0}, {10, 2}})};
  input.horizons[0].piece_of = input.horizons[1].piece_of = "bed";
  const auto closed = read(input);
  ASSERT_TRUE(closed) << to_string(closed.error());
  const auto told = [](const std::string& remark) { return remark.find("run together") != std::string::npos; };
  EXPECT_EQ(std::count_if(closed->remarks.begin(), closed->remarks.end(), told), 0);
  input.horizons[0].points[1].x = 1.0;
  const auto open = read(input);
  EXPECT_EQ(std::count_if(open->remarks.begin(), open->remarks.end(), told), 1);
}

TEST_F(Input, ASingleRowBetweenBlankLinesIsNoPiece) {
  write("rows.csv", "x,z,name\n0,0,Top\n\n4,0,Top\n\n5,-1,Top\n");
  SectionInput input;
  input.horizons = {from_file("Top", "rows.csv")};
  const auto made = read(input);
  ASSERT_TRUE(made) << to_string(made.error());
  ASSERT_EQ(made->section.horizons.size(), 1u);
  EXPECT_EQ(made->section.horizons[0].line.points.size(), 3u);
  write("empty.wkt", "LINESTRING EMPTY\n");
  input.horizons[0] = from_file("Top", "empty.wkt");
  EXPECT_FALSE(read(input));
}

TEST_F(Input, ABackdropNeedsAPlace) {
  SectionInput input;
  input.horizons = {from_points("a", {{0, 0}, {100, 0}})};
  BackdropInput backdrop;
  backdrop.name = "scan";
  backdrop.file = "none.png";
  input.backdrops = {backdrop};
  expect_error(input, ErrorCode::FileNotFound, "backdrop 'scan'");
  write("scan.tif", dobra::test::tiff(1, 2, 1, "\x40\x80"));
  input.backdrops[0].file = "scan.tif";
  expect_error(input, ErrorCode::BadSection,
               "scan.tif: backdrop 'scan': the picture does not say where it lies; give corners = [[x, z], [x, z]], "
               "lower left and upper right, or a world file beside it");
  write("scan.tfw", "50\n3\n3\n-25\n1025\n-112.5\n");
  expect_error(input, ErrorCode::BadFormat, "turn it upright first");
  // With corners nobody asks where the file lies, or in which order its rows are.
  input.backdrops[0].corners = {{0, -10}, {20, 0}};
  for (const char* world : {"50\n3\n3\n-25\n1025\n-112.5\n", "50\n0\n0\n25\n1025\n12.5\n"}) {
    write("scan.tfw", world);
    const auto placed = read(input);
    ASSERT_TRUE(placed) << to_string(placed.error());
    EXPECT_EQ(placed->section.backdrops.at(0).image.box.low, (geom::Point{0, -10}));
    EXPECT_EQ(placed->section.backdrops.at(0).image.pixels->rgba[0], 0x40);
  }
}

TEST_F(Input, ABackdropLiesWhereItsWorldFileSaysAlsoInASectionOfDepths) {
  write("scan.tif", dobra::test::tiff(1, 2, 1, "\x40\x80"));
  write("scan.tfw", "50\n0\n0\n-25\n1025\n-112.5\n");
  SectionInput input;
  input.horizons = {from_points("a", {{0, 0}, {100, 0}})};
  BackdropInput backdrop;
  backdrop.name = "scan";
  backdrop.file = "scan.tif";
  input.backdrops = {backdrop};
  const auto up = read(input);
  ASSERT_TRUE(up) << to_string(up.error());
  const dobra::scene::Image& image = up->section.backdrops.at(0).image;
  EXPECT_EQ(image.box.low, (geom::Point{1000, -150}));
  EXPECT_EQ(image.box.high, (geom::Point{1050, -100}));
  EXPECT_EQ(image.pixels->rgba[0], 0x40);
  input.y_axis = section::VerticalAxis::Down;  // the world file's y is a depth then: of the first row 0 .. 25, of the
                                               // second 25 .. 50
  write("scan.tfw", "50\n0\n0\n25\n1025\n12.5\n");
  const auto down = read(input);
  ASSERT_TRUE(down) << to_string(down.error());
  EXPECT_EQ(down->section.backdrops.at(0).image.box.low, (geom::Point{1000, -50}));
  EXPECT_EQ(down->section.backdrops.at(0).image.box.high, (geom::Point{1050, 0}));
  EXPECT_EQ(down->section.backdrops.at(0).image.pixels->rgba[0], 0x40);
}

}  // namespace
}  // namespace recon::input
