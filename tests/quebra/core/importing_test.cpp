// Files brought into a drawing, and their curves edited in the window. The domain of the document tells what it holds.

#include "quebra/core/importing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>

#include "quebra/core/drawing.h"
#include "quebra/core/operations.h"
#include "shared/scenario/condition.h"
#include "shared/scenario/entries.h"
#include "shared/scenario/lines/import_rules.h"
#include "shared/scenario/runner.h"
#include "tests/support/corpus.h"

namespace quebra::core {
namespace {

namespace fs = std::filesystem;
using namespace dobra;
using scenario::ImportFile;
using scenario::ImportLook;
using scenario::ImportRule;

class QuebraImport : public testing::Test {
 protected:
  QuebraImport() {
    std::string name = (fs::temp_directory_path() / "dobra_quebra_XXXXXX").string();
    folder = mkdtemp(name.data());
    document = document_of("[input]\n");
  }
  ~QuebraImport() override { fs::remove_all(folder); }

  scenario::Document document_of(const std::string& text) const {
    auto made = scenario::parse_document("dobra = 1\nprogram = \"quebra\"\n" + text, folder / "x.toml");
    EXPECT_TRUE(made) << (made ? "" : to_string(made.error()));
    made->file = folder / "x.toml";
    return *made;
  }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }
  ImportLook look(const fs::path& file) const { return importing().look(document, file, {}); }
  ImportFile proposed(const fs::path& file, const ImportLook& seen, const std::vector<ImportRule>& rules = {}) const {
    return {file, {}, rules, scenario::lines::choices_by(rules, seen, importing().kinds)};
  }
  base::Result<scenario::Imported> take(const ImportLook& seen, const ImportFile& file) const {
    return importing().take_in(document, seen, file);
  }
  static scenario::Document again(const scenario::Document& made) {
    auto read = scenario::parse_document(scenario::document_text(made), made.file);
    EXPECT_TRUE(read) << (read ? "" : to_string(read.error()));
    read->file = made.file;
    return *read;
  }
  static scenario::Document again(const base::Result<scenario::Imported>& made) {
    EXPECT_TRUE(made) << (made ? "" : to_string(made.error()));
    return made ? again(made->document) : scenario::Document{};
  }
  static base::Result<model::Model> try_model(const scenario::Document& document) {
    scenario::Runner runner(program());
    const scenario::Run run = runner.run(document);
    if (run.states.empty()) return *run.error;
    return scenario::model_of<model::Model>(run.states.front());
  }
  static model::Model model_of(const scenario::Document& document) {
    auto model = try_model(document);
    EXPECT_TRUE(model) << (model ? "" : to_string(model.error()));
    return model ? *model : model::Model{};
  }
  static std::map<std::string, sketch::Role> roles_of(const model::Model& model) {
    std::map<std::string, sketch::Role> roles;
    for (const auto& curve : model.domain.curves) roles[curve.name] = curve.role;
    return roles;
  }

  fs::path folder;
  scenario::Document document;
};

/// A plate with a hole, a seam from side to side and two cracks.
const char* plate_csv = R"(x,y,name
0,0,plate
10,0,plate
10,6,plate
0,6,plate
0,0,plate
4,2,bore
5,2,bore
5,3,bore
4,3,bore
4,2,bore
0,5,seam
10,5,seam
7,1,crack a
8,1.5,crack a
7,3,line b
8,3.5,line b
)";

TEST_F(QuebraImport, CracksAreGuessedByNameAndChosenByPattern) {
  const fs::path file = write("plate.csv", plate_csv);
  const ImportLook seen = look(file);
  ASSERT_FALSE(seen.error) << to_string(*seen.error);
  ASSERT_EQ(seen.lines.size(), 5U);
  EXPECT_EQ(seen.lines[3].kind, "crack");
  EXPECT_EQ(seen.lines[3].told_by, scenario::ToldBy::Name);
  EXPECT_EQ(seen.lines[4].kind, "found");
  const scenario::Document made = again(take(seen, proposed(file, seen, {{"line ?", "crack"}, {"bo*", "hole"}})));
  EXPECT_EQ(scenario::text_in(made.input, "file"), "plate.csv");
  const auto roles = roles_of(model_of(made));
  EXPECT_EQ(roles.at("plate"), sketch::Role::Boundary);
  EXPECT_EQ(roles.at("bore"), sketch::Role::Hole);
  EXPECT_EQ(roles.at("seam"), sketch::Role::Internal);
  EXPECT_EQ(roles.at("crack a"), sketch::Role::Crack);
  EXPECT_EQ(roles.at("line b"), sketch::Role::Crack);
  EXPECT_TRUE(scenario::check(made, program()));
}

TEST_F(QuebraImport, CurvesThatAreNotTickedStayOut) {
  const fs::path file = write("plate.csv", plate_csv);
  const ImportLook seen = look(file);
  ImportFile wanted = proposed(file, seen);
  wanted.choices[1].taken = wanted.choices[4].taken = false;
  const auto roles = roles_of(model_of(again(take(seen, wanted))));
  EXPECT_EQ(roles.size(), 3U);
  EXPECT_FALSE(roles.contains("bore"));
}

TEST_F(QuebraImport, ASecondFileBecomesCurvesOfTheScenarioUnderFreeNames) {
  const fs::path file = write("plate.csv", plate_csv);
  ImportLook seen = look(file);
  document = again(take(seen, proposed(file, seen)));
  const fs::path more =
      write("more.csv", "x,y,name\n1,1,bore\n2,1,bore\n2,2,bore\n1,1,bore\n1,4,crack a\n2,4,crack a\n");
  seen = look(more);
  const auto made = take(seen, proposed(more, seen));
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_EQ(made->notes.size(), 3U);  // why, and two names
  const auto roles = roles_of(model_of(again(made)));
  EXPECT_EQ(roles.at("bore (2)"), sketch::Role::Boundary);
  EXPECT_EQ(roles.at("crack a (2)"), sketch::Role::Crack);
  EXPECT_EQ(roles.size(), 7U);
}

TEST_F(QuebraImport, WhatIsNoDrawingIsSaid) {
  for (const auto& [name, text] : {std::pair("empty.svg", ""), {"noise.geo", "\x01\x02zz"}, {"what.xyzzy", "1 2\n"}}) {
    const fs::path file = write(name, text);
    const ImportLook seen = look(file);
    ASSERT_TRUE(seen.error) << name;
    EXPECT_FALSE(take(seen, proposed(file, seen))) << name;
  }
}

TEST_F(QuebraImport, ACrackWithoutLengthIsRefusedInTheWordsOfDrawings) {
  const std::string outline = "0,0,plate,outline\n9,0,plate,outline\n9,9,plate,outline\n0,0,plate,outline\n";
  const ImportLook seen = look(write("c.csv", "x,y,name,kind\n" + outline + "4,4,c1,crack\n4,4,c1,crack\n"));
  ASSERT_TRUE(seen.error);
  EXPECT_NE(seen.error->message.find("two distinct points"), std::string::npos) << seen.error->message;
  EXPECT_NE(seen.error->message.find("'crack'"), std::string::npos) << seen.error->message;
  EXPECT_EQ(seen.error->message.find("unknown"), std::string::npos) << seen.error->message;
  EXPECT_EQ(seen.error->place->line, 6U);
  const ImportLook misspelt = look(write("d.csv", "x,y,name,kind\n" + outline + "4,4,c1,fissura\n5,4,c1,crack\n"));
  ASSERT_TRUE(misspelt.error);
  EXPECT_NE(misspelt.error->message.find("outline, hole, internal, crack"), std::string::npos)
      << misspelt.error->message;
  EXPECT_EQ(misspelt.error->message.find("horizon"), std::string::npos) << misspelt.error->message;
}

TEST_F(QuebraImport, AKindThatIsNoneIsRefusedWithTheWordsThatAre) {
  write("plate.csv", plate_csv);
  const auto model = try_model(document_of("[input]\nfile = \"plate.csv\"\nkind = [\"c*=crak\"]\n"));
  ASSERT_FALSE(model);
  EXPECT_NE(model.error().message.find("crack"), std::string::npos) << model.error().message;
  EXPECT_FALSE(try_model(document_of("[input]\nkind = [\"c*=crack\"]\n")));
  EXPECT_FALSE(try_model(document_of("[input]\nfile = \"plate.csv\"\nkind = [\"*=none\"]\n")));
}

// --- curves of files, edited
// -------------------------------------------------------------------------------------------

double material_of(const model::Model& model) {
  double sum = 0.0;
  for (const domain::Face& face : model.domain.faces) sum += face.area;
  return sum;
}

scene::LineEdit edit_of(const model::Model& model, const std::string& name, std::vector<geom::Polyline> becomes) {
  for (std::uint32_t i = 0; i < model.domain.curves.size(); ++i) {
    const sketch::Curve& curve = model.domain.curves[i];
    if (curve.name != name) continue;
    const char* layer = curve.role == sketch::Role::Crack      ? "cracks"
                        : curve.role == sketch::Role::Internal ? "internal"
                                                               : "boundary";
    return {{layer, i}, std::move(becomes)};
  }
  ADD_FAILURE() << "no curve " << name;
  return {};
}

TEST_F(QuebraImport, ACurveOfAFileIsTakenIntoTheDocumentByItsFirstEdit) {
  const fs::path file = write("plate.csv", plate_csv);
  document = document_of("[input]\nfile = \"plate.csv\"\nkind = [\"crack*=crack\"]\n");
  const model::Model before = model_of(document);
  const auto made =
      with_curves_edited(document, before,
                         std::vector{edit_of(before, "plate", {{{{0, 0}, {12, 0}, {10, 6}, {0, 6}}, true}}),
                                     edit_of(before, "line b", {})});
  ASSERT_TRUE(made) << to_string(made.error());
  const scenario::Document after = again(*made);
  EXPECT_EQ(after.input.find("file"), nullptr);
  const model::Model model = model_of(after);
  EXPECT_NEAR(material_of(model), 0.5 * (12.0 + 10.0) * 6.0 - 1.0, 1e-12);
  auto roles = roles_of(before);
  roles.erase("line b");
  EXPECT_EQ(roles_of(model), roles);
  std::ifstream in(file, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), plate_csv);
}

/// Arcs, splines, groups, sizes, names of regions and of points: all that a file gives is there when it is taken in.
TEST_F(QuebraImport, ADrawingTakenInIsTheSameDomain) {
  write("a.geo", R"(lc = 0.5;
Point(1) = {0, 0, 0, lc}; Point(2) = {4, 0, 0, lc}; Point(3) = {4, 3, 0, 0.2}; Point(4) = {0, 3, 0, lc};
Point(5) = {2, 1.5, 0, lc}; Point(6) = {2.5, 1.5, 0, lc}; Point(7) = {1.5, 1.5, 0, lc};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Circle(5) = {6, 5, 7}; Circle(6) = {7, 5, 6};
Curve Loop(1) = {1, 2, 3, 4}; Curve Loop(2) = {5, 6};
Plane Surface(1) = {1, 2};
Physical Curve("left") = {4}; Physical Surface("rock") = {1};
)");
  write("b.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" width="100" height="80" viewBox="0 0 100 80">
<path id="outline" d="M 5 5 L 95 5 L 95 75 C 60 60 40 60 5 75 Z"/>
<circle id="bore" cx="50" cy="30" r="8"/></svg>)");
  write("c.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  for (const char* name : {"a.geo", "b.svg", "c.poly"}) {
    SCOPED_TRACE(name);
    document = document_of("[input]\nfile = \"" + std::string(name) + "\"\n");
    const model::Model before = model_of(document);
    ASSERT_FALSE(before.domain.curves.empty());
    // One curve is put where it is: nothing changes but where it is written.
    const sketch::Curve& first = before.domain.curves.front();
    const auto made =
        with_curves_edited(document, before, std::vector{edit_of(before, first.name, {trace(first).line})});
    ASSERT_TRUE(made) << to_string(made.error());
    const model::Model after = model_of(again(*made));
    ASSERT_EQ(after.domain.curves.size(), before.domain.curves.size());
    for (std::size_t i = 0; i < before.domain.curves.size(); ++i) {
      const sketch::Curve& a = before.domain.curves[i];
      const sketch::Curve& b = after.domain.curves[i];
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.role, b.role) << a.name;
      EXPECT_EQ(a.groups, b.groups) << a.name;
      EXPECT_EQ(a.shape.index(), b.shape.index()) << a.name;
      for (const double t : {0.0, 0.3, 0.7}) {
        EXPECT_NEAR(geom::distance(point(a, t * length(a)), point(b, t * length(b))), 0.0, 1e-12 * length(a)) << a.name;
      }
    }
    EXPECT_NEAR(material_of(after), material_of(before), 1e-12 * material_of(before));
    EXPECT_EQ(after.domain.region_names, before.domain.region_names);
    ASSERT_EQ(after.domain.points.size(), before.domain.points.size());
    for (std::size_t i = 0; i < before.domain.points.size(); ++i) {
      EXPECT_EQ(after.domain.points[i].at, before.domain.points[i].at);
      EXPECT_EQ(after.domain.points[i].size, before.domain.points[i].size);
    }
  }
}

/// A chain of two cubics is the curve of its vertices: by de Casteljau, and at both ends and the joint.
TEST_F(QuebraImport, ABezierOfTheScenarioPassesWhereItsVerticesSay) {
  const model::Model model = model_of(document_of(R"([[input.curve]]
name = "wave"
kind = "bezier"
points = [[0, 0], [1, 2], [3, 2], [4, 0], [5, -2], [7, -2], [8, 0]]
[[input.curve]]
name = "foot"
points = [[8, 0], [8, -4], [0, -4], [0, 0]]
)"));
  const auto wave = std::find_if(model.domain.curves.begin(), model.domain.curves.end(),
                                 [](const sketch::Curve& curve) { return curve.name == "wave"; });
  ASSERT_NE(wave, model.domain.curves.end());
  const double half = 0.5 * length(*wave);  // the second cubic is the first one turned
  EXPECT_NEAR(geom::distance(point(*wave, half), {4, 0}), 0.0, 1e-9);
  EXPECT_NEAR(geom::distance(point(*wave, 0.5 * half), {2, 1.5}), 0.0, 1e-9);  // (0 + 3*2 + 3*2 + 0) / 8
  const auto few =
      try_model(document_of("[[input.curve]]\nname = \"w\"\nkind = \"bezier\"\n"
                            "points = [[0, 0], [1, 2], [3, 2], [4, 0], [5, 1]]\n"));
  ASSERT_FALSE(few);
  EXPECT_NE(few.error().message.find("3 more"), std::string::npos) << few.error().message;
  const scenario::Document set = document_of(
      "[[input.curve]]\nname = \"w\"\nkind = \"bezier\"\n"
      "points = [[0, 0], [1, 2], [3, 2], [4, 0]]\n");
  EXPECT_TRUE(scenario::without_effect(set.input, program().input_fields).empty());
}

TEST_F(QuebraImport, NamedPointsAndRegionsMoveAndGo) {
  document = document_of(R"([[input.curve]]
name = "plate"
kind = "polygon"
points = [[0, 0], [10, 0], [10, 6], [0, 6]]
[[input.curve]]
name = "seam"
role = "internal"
points = [[0, 3], [10, 3]]
[[input.region]]
name = "below"
point = [1, 1]
[[input.region]]
name = "above"
point = [1, 5]
[[input.point]]
name = "load"
point = [10, 6]
)");
  const model::Model before = model_of(document);
  ASSERT_EQ(before.domain.regions.size(), 2U);
  const auto moved = with_curves_edited(document, before,
                                        std::vector{scene::LineEdit{{"points", 0}, {{{{0, 6}}, false}}},
                                                    scene::LineEdit{{"regions", 1}, {{{{9.5, 5.5}}, false}}}});
  ASSERT_TRUE(moved) << to_string(moved.error());
  const model::Model after = model_of(again(*moved));
  EXPECT_EQ(after.domain.points.at(0).at, (geom::Point{0, 6}));
  EXPECT_EQ(after.domain.regions.at(1).at, (geom::Point{9.5, 5.5}));
  EXPECT_EQ(after.domain.regions.at(0).at, (geom::Point{1, 1}));
  const auto gone = with_curves_edited(
      document, before, std::vector{scene::LineEdit{{"points", 0}, {}}, scene::LineEdit{{"regions", 0}, {}}});
  ASSERT_TRUE(gone);
  const model::Model left = model_of(again(*gone));
  EXPECT_TRUE(left.domain.points.empty());
  ASSERT_EQ(left.domain.regions.size(), 1U);
  EXPECT_EQ(left.domain.regions[0].name, "above");
  EXPECT_FALSE(with_curves_edited(document, before, std::vector{scene::LineEdit{{"points", 7}, {}}}));
}

/// Every drawing of the corpus that makes a domain: taken in, it is the same.
TEST_F(QuebraImport, TheCorpusTakenInIsTheSameDomain) {
  const auto data = dobra::test::data_folder();
  if (!data) GTEST_SKIP() << dobra::test::no_data;
  std::size_t taken = 0;
  for (const auto& entry : fs::directory_iterator(*data / "contours")) {
    document = document_of("[input]\n");
    const ImportLook seen = look(entry.path());
    if (seen.error) {
      EXPECT_FALSE(take(seen, proposed(entry.path(), seen)));
      continue;
    }
    const scenario::Document read = again(take(seen, proposed(entry.path(), seen)));
    const auto before = try_model(read);
    if (!before) continue;
    const sketch::Curve& first = before->domain.curves.front();
    const auto made = with_curves_edited(read, *before, std::vector{edit_of(*before, first.name, {trace(first).line})});
    ASSERT_TRUE(made) << entry.path() << to_string(made.error());
    const auto after = try_model(again(*made));
    ASSERT_TRUE(after) << entry.path() << to_string(after.error());
    EXPECT_EQ(after->domain.curves.size(), before->domain.curves.size()) << entry.path();
    EXPECT_NEAR(material_of(*after), material_of(*before), 1e-9 * material_of(*before)) << entry.path();
    ++taken;
  }
  EXPECT_GE(taken, 4U);
}

}  // namespace
}  // namespace quebra::core
