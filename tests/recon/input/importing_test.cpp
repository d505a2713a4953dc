// Files brought into a section. What the document then holds is asked of the reader of documents, and compared with
// what stands in the files as this test wrote them.

#include "recon/input/importing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "recon/core/operations.h"
#include "recon/input/import.h"
#include "recon/input/input.h"
#include "recon/input/section_input.h"
#include "shared/io/formats/line_files.h"
#include "shared/scenario/entries.h"
#include "shared/scenario/lines/import_rules.h"
#include "tests/support/corpus.h"

namespace recon::input {
namespace {

namespace fs = std::filesystem;
namespace scenario = dobra::scenario;
using scenario::ImportFile;
using scenario::ImportLook;
using scenario::ImportReading;
using scenario::ImportRule;
using scenario::ImportShape;

class ImportingTest : public testing::Test {
 protected:
  ImportingTest() {
    std::string name = (fs::temp_directory_path() / "dobra_importing_XXXXXX").string();
    folder = mkdtemp(name.data());
    document.program = "recon";
    document.file = folder / "section.toml";
  }
  ~ImportingTest() override { fs::remove_all(folder); }

  fs::path write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }
  ImportLook look(const fs::path& file, const ImportReading& reading = {}) const {
    return importing().look(document, file, reading);
  }
  /// As the dialog proposes it.
  ImportFile proposed(const fs::path& file, const ImportLook& seen, const std::vector<ImportRule>& rules = {}) const {
    return {file, {}, rules, scenario::lines::choices_by(rules, seen, importing().kinds)};
  }
  base::Result<scenario::Imported> take(const ImportLook& seen, const ImportFile& file) const {
    return importing().take_in(document, seen, file);
  }
  /// What is written, read again.
  static scenario::Document again(const base::Result<scenario::Imported>& made) {
    EXPECT_TRUE(made) << (made ? "" : to_string(made.error()));
    if (!made) return {};
    auto read = scenario::parse_document(scenario::document_text(made->document), made->document.file);
    EXPECT_TRUE(read) << (read ? "" : to_string(read.error()));
    read->file = made->document.file;
    EXPECT_TRUE(scenario::check(*read, core::program()));
    return *read;
  }
  static section::Section section_of(const scenario::Document& document) {
    auto read = read_section(scenario::from_table<SectionInput>(document.input), {.folder = document.folder()}, {});
    EXPECT_TRUE(read) << (read ? "" : to_string(read.error()));
    return read ? read->section : section::Section{};
  }
  static std::map<std::string, std::string> kinds_of(const section::Section& section) {
    std::map<std::string, std::string> kinds;
    for (const auto& horizon : section.horizons) kinds[horizon.name] = "horizon";
    for (const auto& line : section.lines) kinds[line.name] = kind_name(line.kind);
    for (const auto& unit : section.units) kinds[unit.name] = "unit";
    for (const auto& marker : section.markers) kinds[marker.name] = "marker";
    return kinds;
  }

  fs::path folder;
  scenario::Document document;
};

const char* five_lines = R"(x,z,name
0,0,Top Sand
100,10,Top Sand
0,-50,Base
100,-40,Base
60,30,Falha F3
40,-80,Falha F3
0,30,Topo
100,35,Topo
10,5,X*1
90,15,X*1
)";

TEST_F(ImportingTest, KindsAreGuessedByNamesAndToldAsGuesses) {
  const fs::path file = write("data/lines.csv", five_lines);
  const ImportLook seen = look(file);
  ASSERT_FALSE(seen.error) << to_string(*seen.error);
  ASSERT_EQ(seen.lines.size(), 5U);
  std::map<std::string, std::string> kinds;
  for (const auto& line : seen.lines) kinds[line.name] = line.kind;
  EXPECT_EQ(kinds["Top Sand"], "horizon");
  EXPECT_EQ(kinds["Falha F3"], "fault");
  EXPECT_EQ(kinds["Topo"], "topography");
  EXPECT_EQ(seen.lines[0].told_by, scenario::ToldBy::Shape);
  EXPECT_EQ(seen.lines[2].told_by, scenario::ToldBy::Name);
  ASSERT_TRUE(seen.table);
  EXPECT_EQ(seen.table->header, (std::vector<std::string>{"x", "z", "name"}));
  EXPECT_EQ(seen.table->names, 3U);
  const scenario::Document made = again(take(seen, proposed(file, seen)));
  const scenario::Entries lines = scenario::entries_of(made.input, "lines");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(scenario::text_in(lines[0], "file"), "data/lines.csv");
  const auto read = kinds_of(section_of(made));
  EXPECT_EQ(read.at("Top Sand"), "horizon");
  EXPECT_EQ(read.at("Falha F3"), "fault");
  EXPECT_EQ(read.at("Topo"), "topography");
}

TEST_F(ImportingTest, PatternsStandInTheDocumentAndSingleChoicesGoBeforeThem) {
  const fs::path file = write("lines.csv", five_lines);
  const ImportLook seen = look(file);
  ImportFile wanted = proposed(file, seen, {{"*a*", "fault"}, {"never", "pin"}});
  EXPECT_EQ(wanted.choices[0].kind, "fault");  // "Top Sand"
  wanted.choices[0].kind = "eroded";
  const scenario::Document made = again(take(seen, wanted));
  const auto* rules =
      std::get_if<std::vector<std::string>>(scenario::entries_of(made.input, "lines").at(0).find("kind"));
  ASSERT_NE(rules, nullptr);
  EXPECT_EQ(*rules, (std::vector<std::string>{"Top Sand=eroded", "Topo=topography", "*a*=fault"}));
  const section::Section section = section_of(made);
  const auto kinds = kinds_of(section);
  EXPECT_EQ(kinds.at("Base"), "fault");
  EXPECT_EQ(kinds.at("Falha F3"), "fault");
  EXPECT_EQ(kinds.at("X*1"), "horizon");
}

/// A star in a name is a pattern where it stands alone: it must not take other lines along.
TEST_F(ImportingTest, ANameThatIsAPatternForAnotherLineIsRefused) {
  const fs::path file = write("stars.csv", "x,z,name\n0,0,X*\n9,1,X*\n0,5,XY\n9,6,XY\n0,9,Z\n9,9,Z\n");
  const ImportLook seen = look(file);
  ImportFile wanted = proposed(file, seen);
  wanted.choices[0].kind = "fault";
  const auto made = take(seen, wanted);
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().message.find("'XY'"), std::string::npos) << made.error().message;
  wanted.choices[1].kind = "fault";
  EXPECT_TRUE(take(seen, wanted));
}

TEST_F(ImportingTest, NamesThatAreThereAlreadyAreChangedAndTold) {
  const fs::path file = write("lines.csv", five_lines);
  const ImportLook seen = look(file);
  auto once = take(seen, proposed(file, seen));
  ASSERT_TRUE(once);
  document = once->document;
  const auto twice = take(look(file), proposed(file, seen));
  ASSERT_TRUE(twice) << to_string(twice.error());
  EXPECT_EQ(twice->notes.size(), 5U);
  EXPECT_EQ(twice->notes.at(0), "'Top Sand' is there already; this one becomes 'Top Sand (2)'");
  const scenario::Document made = again(twice);
  const auto input = scenario::from_table<SectionInput>(made.input);
  ASSERT_EQ(input.horizons.size(), 3U);
  EXPECT_EQ(input.horizons[0].name, "Top Sand (2)");
  EXPECT_EQ(input.horizons[0].feature, "Top Sand");
  const auto settings = read_settings(input).value();
  const auto piece = read_pieces(input.horizons[0], settings, {.folder = folder});
  ASSERT_TRUE(piece) << to_string(piece.error());
  EXPECT_EQ(piece->pieces.at(0).points, (std::vector<geom::Point>{{0, 0}, {100, 10}}));
}

TEST_F(ImportingTest, LinesThatAreNotTickedStayOut) {
  const fs::path file = write("lines.csv", five_lines);
  const ImportLook seen = look(file);
  ImportFile wanted = proposed(file, seen);
  for (auto& choice : wanted.choices) choice.taken = false;
  EXPECT_NE(take(seen, wanted).error().message.find("tick"), std::string::npos);
  wanted.choices[0].taken = wanted.choices[2].taken = true;
  const auto kinds = kinds_of(section_of(again(take(seen, wanted))));
  EXPECT_EQ(kinds, (std::map<std::string, std::string>{{"Top Sand", "horizon"}, {"Falha F3", "fault"}}));
}

TEST_F(ImportingTest, AFileOfOneLineIsCalledAsTheFile) {
  const fs::path file = write("Camada 1.txt", "# digitised\n3 1 99\n4 2 98\n5 1 97\n");
  ImportReading reading{
      .x = 1, .height = 3, .names = 0, .separator = {}, .y_axis = "down", .unit = "km", .corners = {}};
  const ImportLook seen = look(file, reading);
  ASSERT_FALSE(seen.error) << to_string(*seen.error);
  ImportFile wanted = proposed(file, seen);
  wanted.reading = reading;
  const section::Section section = section_of(again(take(seen, wanted)));
  ASSERT_EQ(section.horizons.size(), 1U);
  EXPECT_EQ(section.horizons[0].name, "Camada 1");
  ASSERT_EQ(section.horizons[0].line.points.size(), 3U);
  EXPECT_DOUBLE_EQ(section.horizons[0].line.points[1].x, 4000.0);
  EXPECT_DOUBLE_EQ(section.horizons[0].line.points[1].y, -98000.0);
}

/// One way of reading: what [[input.lines]] reads of a file of several lines, [[input.horizon]] reads of each.
TEST_F(ImportingTest, AHorizonOutOfAFileOfSeveralLinesIsReadAsAllOfThemAre) {
  for (const char* const text :
       {"camada,x,prof\nTop,0,10\nTop,100,12\nBase,0,50\nBase,100,52\n",
        "layer;z_km;x_km\nTop;-0,010;0\nTop;-0,012;0,1\nBase;-0,05;0\nBase;-0,052;0,1\n",
        "x (ft) depth (ft) name\n0 32.80839895013123 Top\n328.0839895013123 39.37007874015748 Top\n0 "
        "164.04199475065616 Base\n328.0839895013123 170.60367454068241 Base\n"}) {
    write("several.csv", text);
    SectionInput all, each;
    all.lines.emplace_back().file = "several.csv";
    for (const char* const name : {"Top", "Base"}) {
      HorizonInput& horizon = each.horizons.emplace_back();
      horizon.name = horizon.feature = name;
      horizon.file = "several.csv";
    }
    const auto whole = read_section(all, {.folder = folder}, {});
    const auto apart = read_section(each, {.folder = folder}, {});
    ASSERT_TRUE(whole) << text << to_string(whole.error());
    ASSERT_TRUE(apart) << text << to_string(apart.error());
    ASSERT_EQ(apart->section.horizons.size(), 2U) << text;
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(apart->section.horizons[i].line, whole->section.horizons[i].line) << text;
    EXPECT_NEAR(apart->section.horizons[0].line.points[1].x, 100.0, 1e-9) << text;
    EXPECT_NEAR(apart->section.horizons[0].line.points[1].y, -12.0, 1e-9) << text;
  }
}

TEST_F(ImportingTest, ALineWithoutANameInAFileOfDepthsIsTakenAsItIsSeen) {
  for (const char* const text :
       {"x,depth\n0,10\n100,12\n", "prof (m);dist (m)\n10;0\n12;100\n", "x_km,tvdss_m\n0,10\n0.1,12\n"}) {
    const fs::path file = write("bed.csv", text);
    const ImportLook seen = look(file);
    ASSERT_FALSE(seen.error) << to_string(*seen.error);
    const section::Section read = section_of(again(take(seen, proposed(file, seen))));
    ASSERT_EQ(read.horizons.size(), 1U) << text;
    EXPECT_EQ(read.horizons[0].line.points, (std::vector<geom::Point>{{0, -10}, {100, -12}})) << text;
  }
}

TEST_F(ImportingTest, PlacesOnTheMapAreLaidIntoTheirPlane) {
  // Along the direction (3, 4): x of the section is the distance from the first point.
  const fs::path file = write("map.csv", "x,y,height\n300,400,5\n330,440,6\n360,480,4\n");
  ImportReading reading;
  reading.x = 1;
  reading.map_y = 2;
  reading.height = 3;
  const ImportLook seen = look(file, reading);
  ASSERT_FALSE(seen.error) << to_string(*seen.error);
  ImportFile wanted = proposed(file, seen);
  wanted.reading = reading;
  const section::Section read = section_of(again(take(seen, wanted)));
  ASSERT_EQ(read.horizons.size(), 1U);
  const auto& points = read.horizons[0].line.points;
  ASSERT_EQ(points.size(), 3U);
  EXPECT_NEAR(std::abs(points[2].x - points[0].x), 100.0, 1e-9);
  EXPECT_NEAR(points[1].y, 6.0, 1e-12);
  // x alone.
  reading.map_y = 0;
  const ImportLook alone = look(file, reading);
  ASSERT_FALSE(alone.error) << to_string(*alone.error);
  EXPECT_EQ(alone.lines[0].parts[0].points[2], (geom::Point{360, 4}));
}

/// Three columns of numbers: which are x and height is asked, and the first rows are shown all the same.
TEST_F(ImportingTest, WhatAFileLeavesOpenIsAskedWithItsRowsInSight) {
  const fs::path file = write("three.txt", "3 1 99\n4 2 98\n5 1 97\n");
  const ImportLook seen = look(file);
  ASSERT_TRUE(seen.error);
  EXPECT_EQ(seen.error->code, base::ErrorCode::Unclear);
  ASSERT_TRUE(seen.table);
  EXPECT_EQ(seen.table->rows.at(1), (std::vector<std::string>{"4", "2", "98"}));
  EXPECT_EQ(take(seen, proposed(file, seen)).error().code, base::ErrorCode::Unclear);
}

TEST_F(ImportingTest, WhatIsNoFileOfLinesIsSaidAndTakenNowhere) {
  std::string garbage;
  for (int i = 0; i < 5000; ++i) garbage += static_cast<char>((i * 7919) % 256);
  const std::pair<fs::path, const char*> cases[] = {{write("empty.csv", ""), "empty"},
                                                    {write("blank.csv", "\n\n"), "empty"},
                                                    {write("noise.csv", garbage), "not a text file"},
                                                    {write("noise.dxf", garbage), ""},
                                                    {write("noise.geojson", garbage), ""},
                                                    {write("noise.png", garbage), ""},
                                                    {write("what.xyzzy", "1 2\n3 4\n"), "ending"},
                                                    {write("one.csv", "x,z\n1,2\n"), "two distinct points"},
                                                    {folder / "missing.csv", "no such file"},
                                                    {folder, ""}};
  for (const auto& [file, words] : cases) {
    const ImportLook seen = look(file);
    ASSERT_TRUE(seen.error) << file;
    EXPECT_TRUE(seen.lines.empty()) << file;
    EXPECT_NE(to_string(*seen.error).find(words), std::string::npos) << to_string(*seen.error);
    EXPECT_FALSE(take(seen, proposed(file, seen))) << file;
  }
}

TEST_F(ImportingTest, ThousandsOfLinesAreOneEntryAndNameless) {
  std::string text;
  for (int i = 0; i < 3000; ++i) text += fmt::format("{0} {1}\n{2} {1}\n\n", 0, i, 100);
  const fs::path file = write("many.txt", text);
  const ImportLook seen = look(file);
  ASSERT_EQ(seen.lines.size(), 1U);
  EXPECT_EQ(seen.lines[0].parts.size(), 3000U);
  const scenario::Document made = again(take(seen, proposed(file, seen)));
  EXPECT_EQ(section_of(made).horizons.size(), 3000U);
  ImportFile faults = proposed(file, seen);
  faults.choices[0].kind = "fault";
  const scenario::Document changed = again(take(seen, faults));
  const auto* rules =
      std::get_if<std::vector<std::string>>(scenario::entries_of(changed.input, "lines").at(0).find("kind"));
  ASSERT_NE(rules, nullptr);
  EXPECT_EQ(*rules, std::vector<std::string>{"*=fault"});
}

TEST_F(ImportingTest, PicturesSayWhereTheyLieOrAreAsked) {
  // Two by two pixels, plain PPM is no format of ours: a BMP in the clothes of a PNG is refused, a PNG is not.
  const fs::path source = fs::path(DOBRA_SOURCE_DIR) / "docs";
  fs::path picture;
  for (const auto& entry : fs::recursive_directory_iterator(source)) {
    if (entry.path().extension() == ".png") picture = entry.path();
  }
  if (picture.empty()) GTEST_SKIP() << "no picture in docs";
  fs::copy_file(picture, folder / "scan.png");
  ImportLook seen = look(folder / "scan.png");
  ASSERT_FALSE(seen.error) << to_string(*seen.error);
  ASSERT_TRUE(seen.picture);
  EXPECT_FALSE(seen.placed);
  EXPECT_NE(take(seen, proposed(folder / "scan.png", seen)).error().message.find("corner"), std::string::npos);
  ImportReading reading;
  reading.corners = {0, -500, 1000, 100};
  seen = look(folder / "scan.png", reading);
  ImportFile wanted = proposed(folder / "scan.png", seen);
  wanted.reading = reading;
  document.input.set("horizon", scenario::Entries{[] {
                       scenario::Table table;
                       table.set("name", std::string("A"));
                       table.set("points", std::vector<geom::Point>{{0, 0}, {1000, 0}});
                       return table;
                     }()});
  const section::Section section = section_of(again(take(seen, wanted)));
  ASSERT_EQ(section.backdrops.size(), 1U);
  EXPECT_EQ(section.backdrops[0].name, "scan");
  EXPECT_EQ(section.backdrops[0].image.box.low, (geom::Point{0, -500}));
  EXPECT_EQ(section.backdrops[0].image.box.high, (geom::Point{1000, 100}));
}

/// Written in every format that can be written, and brought in again.
TEST_F(ImportingTest, EveryEndingOfLinesIsBroughtIn) {
  using namespace dobra::io;
  formats::LineWork work;
  for (const auto& [name, height] : {std::pair("Top", 0.0), {"Base", -40.0}}) {
    lines::Feature feature;
    feature.name = name;
    feature.kind = "horizon";
    feature.parts.push_back({{{0, height}, {50, height + 5}, {100, height}}, false});
    work.features.push_back(feature);
  }
  std::set<std::string> seen_endings;
  for (const std::string& ending : formats::endings_for(formats::Use::WriteLines)) {
    if (!formats::is_for(*formats::format_of("a" + ending, formats::Use::WriteLines), formats::Use::ReadLines))
      continue;
    const fs::path file = folder / ("lines" + ending);
    std::vector<std::string> remarks;
    ASSERT_TRUE(formats::write_any_lines(file.string(), work, {}, remarks)) << ending;
    const ImportLook seen = look(file);
    ASSERT_FALSE(seen.error) << ending << ": " << to_string(*seen.error);
    const section::Section section = section_of(again(take(seen, proposed(file, seen))));
    ASSERT_EQ(section.horizons.size(), 2U) << ending;
    EXPECT_EQ(section.horizons[0].line.points.size(), 3U) << ending;
    EXPECT_NEAR(section.horizons[0].line.points[1].y, section.horizons[1].line.points[1].y + 40.0, 1e-9) << ending;
    seen_endings.insert(ending);
  }
  EXPECT_GE(seen_endings.size(), 8U);
}

/// Whatever of the corpus is read at once comes in as it is previewed; the rest says why not.
TEST_F(ImportingTest, TheCorpusComesInAsItIsShown) {
  const auto data = dobra::test::data_folder();
  if (!data) GTEST_SKIP() << dobra::test::no_data;
  std::size_t taken = 0, refused = 0;
  for (const auto& entry : fs::recursive_directory_iterator(*data)) {
    if (!entry.is_regular_file()) continue;
    const ImportLook seen = look(entry.path());
    const auto made = take(seen, proposed(entry.path(), seen));
    if (seen.error) {
      EXPECT_FALSE(to_string(*seen.error).empty());
      EXPECT_FALSE(made);
      ++refused;
      continue;
    }
    ASSERT_TRUE(made) << entry.path() << ": " << to_string(made.error());
    const auto read = scenario::from_table<SectionInput>(again(made).input);
    std::vector<std::string> remarks;
    const auto all = with_lines_of_files(read, read_settings(read).value(), {.folder = folder}, remarks);
    ASSERT_TRUE(all) << entry.path();
    std::size_t parts = 0;
    for (const auto& line : seen.lines) parts += line.parts.size();
    EXPECT_EQ(all->horizons.size() + all->faults.size() + all->units.size() + all->markers.size(), parts)
        << entry.path();
    ++taken;
  }
  EXPECT_GE(taken, 15U);
  EXPECT_GE(refused, 1U);
}

}  // namespace
}  // namespace recon::input
