#include "recon/input/drawing.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "recon/core/operations.h"
#include "recon/input/colors.h"
#include "recon/input/input.h"
#include "recon/input/section_input.h"

namespace recon::input {
namespace {

namespace fs = std::filesystem;
namespace scenario = dobra::scenario;
using dobra::scene::LineEdit;
using dobra::scene::Pick;
using geom::Point;

scenario::Document document_of(const std::string& input, const fs::path& folder = {}) {
  auto document = scenario::parse_document("dobra = 1\nprogram = \"recon\"\n[input]\n" + input, folder / "x.toml");
  EXPECT_TRUE(document) << to_string(document.error());
  document->file = folder / "x.toml";
  return *document;
}

section::Section section_of(const scenario::Document& document) {
  auto read = read_section(scenario::from_table<SectionInput>(document.input), {.folder = document.folder()}, {});
  EXPECT_TRUE(read) << (read ? "" : to_string(read.error()));
  return read ? read->section : section::Section{};
}

/// The document after it was written and read again.
scenario::Document edited(const scenario::Document& document, const std::vector<LineEdit>& edits) {
  auto made = with_lines_edited(document, section_of(document), edits);
  EXPECT_TRUE(made) << (made ? "" : to_string(made.error()));
  if (!made) return document;
  auto again = scenario::parse_document(scenario::document_text(*made), document.file);
  EXPECT_TRUE(again) << (again ? "" : to_string(again.error()));
  again->file = document.file;
  EXPECT_TRUE(scenario::check(again->input, scenario::fields_of<SectionInput>(), "input"));
  return *again;
}

const char* two_beds = R"(
[[input.horizon]]
name = "A"
points = [[0, 0], [100.1, 0.3], [200, 0]]
[[input.horizon]]
name = "B"
points = [[0, -50], [200, -50]]
[[input.fault]]
name = "F"
order = 1
points = [[150, 50], [150, -100]]
)";

TEST(Drawing, AVertexMovesAndTheOtherNumbersStayAsTheyWereWritten) {
  const scenario::Document document =
      document_of("y_axis = \"down\"\nreference = 7.1\nunit = \"ft\"\nexaggeration = 3\n" + std::string(two_beds));
  const section::Section before = section_of(document);
  geom::Polyline line = before.horizons[0].line;
  line.points[1].y += 10.0;
  const scenario::Document after = edited(document, {{{"horizon_0", 0}, {line}}});
  const auto points = std::get<std::vector<scenario::Table>>(*after.input.find("horizon"))[0].find("points");
  const auto& written = std::get<scenario::Points>(*points);
  EXPECT_EQ(written[0], (Point{0, 0}));
  EXPECT_EQ(written[2], (Point{200, 0}));
  const section::Section there = section_of(after);
  ASSERT_EQ(there.horizons[0].line.points.size(), 3U);
  EXPECT_NEAR(there.horizons[0].line.points[1].y, line.points[1].y, 1e-12);
  EXPECT_EQ(there.horizons[1].line, before.horizons[1].line);
}

TEST(Drawing, ASplitHorizonIsTwoPiecesOfOne) {
  const scenario::Document document = document_of(two_beds);
  const scenario::Document after =
      edited(document, {{{"horizon_0", 0}, {{{{0, 0}, {100, 0}}, false}, {{{110, 0}, {200, 0}}, false}}}});
  const section::Section there = section_of(after);
  ASSERT_EQ(there.horizons.size(), 3U);
  EXPECT_EQ(there.horizons[0].name, "A (1)");
  EXPECT_EQ(there.horizons[1].name, "A (2)");
  EXPECT_EQ(whole_name(there.horizons[1]), "A");
  // And one of them again.
  const scenario::Document twice =
      edited(after, {{{"horizon_0", 1}, {{{{110, 0}, {150, 0}}, false}, {{{160, 0}, {200, 0}}, false}}}});
  const section::Section three = section_of(twice);
  ASSERT_EQ(three.horizons.size(), 4U);
  EXPECT_EQ(three.horizons[2].name, "A (3)");
  EXPECT_EQ(whole_name(three.horizons[2]), "A");
}

TEST(Drawing, TheAgeOfAFaultStays) {
  const scenario::Document document = document_of(two_beds);
  const scenario::Document after = edited(document, {{{"line_0", 0}, {{{{160, 50}, {150, -100}}, false}}}});
  const section::Section there = section_of(after);
  ASSERT_EQ(there.lines.size(), 1U);
  EXPECT_EQ(there.lines[0].order, 1);
  EXPECT_EQ(there.lines[0].line.points[0], (Point{160, 50}));
}

TEST(Drawing, WhatIsDeletedIsGone) {
  const scenario::Document document = document_of(two_beds);
  const section::Section there = section_of(edited(document, {{{"line_0", 0}, {}}, {{"horizon_1", 1}, {}}}));
  EXPECT_EQ(there.horizons.size(), 1U);
  EXPECT_TRUE(there.lines.empty());
}

TEST(Drawing, HorizonsKeepTheirColoursWhenOneIsDeleted) {
  const scenario::Document document = document_of(
      "[[input.horizon]]\nname = \"A\"\npoints = [[0, 0], [200, 0]]\n"
      "[[input.horizon]]\nname = \"B\"\npoints = [[0, -50], [200, -50]]\n"
      "[[input.horizon]]\nname = \"C\"\npoints = [[0, -90], [200, -90]]\n"
      "[[input.horizon]]\nname = \"D\"\npoints = [[0, -120], [200, -120]]\ncolour = \"#102030\"\n");
  const auto shown = [](const scenario::Document& of) {
    std::map<std::string, std::pair<dobra::scene::Color, std::optional<dobra::scene::Color>>> colors;
    const scenario::Program& program = core::program();
    const auto input = program.read_input(of.input, {.folder = of.folder()}, {});
    EXPECT_TRUE(input);
    const dobra::scene::Picture picture = program.picture_of(*input);
    for (const dobra::scene::Layer& layer : picture.panels.at(0).layers)
      colors[layer.key.substr(0, layer.key.find('_') + 1) + layer.title] = {layer.style.line, layer.style.fill};
    return colors;
  };
  const auto before = shown(document);
  const scenario::Document canvas = edited(document, {{{"horizon_1", 1}, {}}});
  scenario::Document form = document;
  auto rows = std::get<std::vector<scenario::Table>>(*form.input.find("horizon"));
  rows.erase(rows.begin() + 1);
  form.input.set("horizon", rows);
  form = with_colors_kept(form, section_of(document), horizons_gone(document, form));
  for (const scenario::Document& after : {canvas, form}) {
    const auto now = shown(after);
    for (const char* key : {"horizon_A", "horizon_C", "horizon_D", "name_A", "name_C", "name_D"}) {
      ASSERT_TRUE(now.contains(key) && before.contains(key)) << key;
      EXPECT_EQ(now.at(key), before.at(key)) << key;
    }
    const auto& left = std::get<std::vector<scenario::Table>>(*after.input.find("horizon"));
    EXPECT_EQ(left[0].find("colour"), nullptr);
    EXPECT_EQ(*left[2].find("colour"), scenario::Value("#102030"));
  }
  EXPECT_EQ(before.at("horizon_D").first, (dobra::scene::Color{0x10, 0x20, 0x30, 255}));
}

TEST(Drawing, AWordThatIsNoColourIsRefused) {
  const scenario::Document document =
      document_of("[[input.horizon]]\nname = \"A\"\npoints = [[0, 0], [200, 0]]\ncolour = \"blueish\"\n");
  const auto read = read_section(scenario::from_table<SectionInput>(document.input), {}, {});
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("blueish"), std::string::npos);
}

TEST(Drawing, AFileOfManyLinesIsTakenIntoTheDocumentAndStaysAsItIs) {
  const fs::path folder = fs::temp_directory_path() / "dobra_drawing_test";
  fs::create_directories(folder);
  const std::string text =
      "name,kind,x,z\nA,horizon,0,0\nA,horizon,100,1\nB,horizon,0,-50\nB,horizon,100,-50\n"
      "F,fault,40,20\nF,fault,60,-80\n";
  std::ofstream(folder / "lines.csv") << text;
  const scenario::Document document = document_of("[[input.lines]]\nfile = \"lines.csv\"\n", folder);
  const section::Section before = section_of(document);
  ASSERT_EQ(before.horizons.size(), 2U);
  const scenario::Document after = edited(document, {{{"horizon_1", 1}, {{{{0, -60}, {100, -50}}, false}}}});
  const section::Section there = section_of(after);
  ASSERT_EQ(there.horizons.size(), 2U);
  ASSERT_EQ(there.lines.size(), 1U);
  EXPECT_EQ(there.horizons[0].line, before.horizons[0].line);
  EXPECT_EQ(there.lines[0].line, before.lines[0].line);
  EXPECT_EQ(there.horizons[1].line.points[0], (Point{0, -60}));
  EXPECT_EQ(after.input.find("lines"), nullptr);
  std::ifstream file(folder / "lines.csv");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), text);
  fs::remove_all(folder);
}

TEST(Drawing, AHorizonThatReadingHasJoinedOutOfAFileIsEditedAsTheOneLineThatItIs) {
  const fs::path folder = fs::temp_directory_path() / "dobra_drawing_join_test";
  fs::create_directories(folder);
  std::ofstream(folder / "lines.csv") << "name,kind,x,z\nA,horizon,0,0\nA,horizon,48,1\n\nA,horizon,52,1\n"
                                         "A,horizon,100,0\n\nB,horizon,0,-50\nB,horizon,100,-50\n";
  const scenario::Document document = document_of("[[input.lines]]\nfile = \"lines.csv\"\njoin_gaps = 10\n", folder);
  const section::Section before = section_of(document);
  ASSERT_EQ(before.horizons.size(), 2U);
  EXPECT_EQ(before.horizons[0].name, "A");
  const geom::Polyline moved{{{0, 5}, {48, 1}, {52, 1}, {100, 0}}, false};
  const section::Section there = section_of(edited(document, {{{"horizon_0", 0}, {moved}}}));
  ASSERT_EQ(there.horizons.size(), 2U);
  EXPECT_EQ(there.horizons[0].line, moved);
  EXPECT_EQ(there.horizons[1].line, before.horizons[1].line);
  fs::remove_all(folder);
}

TEST(Drawing, ALineIsAddedUnderANameThatIsFree) {
  const scenario::Document document = document_of(two_beds);
  const auto made = with_line(document, "horizon", "C", {{{0, -90}, {200, -80}}, false});
  ASSERT_TRUE(made);
  EXPECT_EQ(section_of(*made).horizons.back().name, "C");
  EXPECT_FALSE(with_line(document, "horizon", "A", {{{0, -90}, {200, -80}}, false}));
  EXPECT_FALSE(with_line(document, "horizon", "  ", {{{0, -90}, {200, -80}}, false}));
  const auto polygon = with_line(document, "polygon", "U", {{{0, 0}, {9, 0}, {9, 9}}, true});
  ASSERT_TRUE(polygon);
  EXPECT_EQ(section_of(*polygon).units.size(), 1U);
}

TEST(Drawing, WhatTheProgramHasDrawnIsNotEdited) {
  const scenario::Document document = document_of(two_beds);
  EXPECT_FALSE(with_lines_edited(document, section_of(document), std::vector<LineEdit>{{{"grid", 0}, {}}}));
}

}  // namespace
}  // namespace recon::input
