// The bundled examples and, where the test data are there, the real sections: run as the command line runs them, and
// judged by their own expectations.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "recon/core/operations.h"
#include "recon/model/model.h"
#include "shared/io/file.h"
#include "shared/scenario/runner.h"
#include "tests/support/corpus.h"

namespace recon::core {
namespace {

namespace scenario = dobra::scenario;

/// Runs the document and expects every expectation to be met; returns the run.
scenario::Run expect_met(const scenario::Document& document) {
  const auto checked = scenario::check(document, program());
  EXPECT_TRUE(checked) << to_string(checked.error());
  scenario::Run run = scenario::Runner(program()).run(document);
  EXPECT_TRUE(run.complete()) << to_string(*run.error);
  if (!run.complete()) return run;
  EXPECT_FALSE(document.expects.empty());
  for (const scenario::Verdict& verdict : scenario::judge(document, program(), run))
    EXPECT_TRUE(verdict.met) << verdict.message;
  return run;
}

double figure(const scenario::Run& run, const std::string& name) {
  for (const scenario::Quantity& q : program().quantities_of(run.states.back())) {
    if (q.name == name) return q.value;
  }
  ADD_FAILURE() << "no quantity " << name;
  return std::nan("");
}

scenario::Document bundled(const std::string& name) {
  auto document = scenario::read_document(std::filesystem::path(DOBRA_SOURCE_DIR) / "resources/examples/recon" / name);
  EXPECT_TRUE(document) << to_string(document.error());
  return std::move(*document);
}

TEST(Examples, FoldMeetsItsExpectations) { expect_met(bundled("fold.toml")); }

TEST(Examples, REC_c_CosineMeetsItsExpectations) { expect_met(bundled("cosine.toml")); }

TEST(Examples, ChainMeetsItsExpectations) { expect_met(bundled("chain.toml")); }

TEST(Examples, ABlockCutToANewSectionMeetsItsExpectations) { expect_met(bundled("fault_block.toml")); }

TEST(Examples, ListricFaultsMeetTheirExpectations) { expect_met(bundled("listric.toml")); }

TEST(Examples, SectionsInSpaceGiveAFifthOneThatIsRestored) {
  const scenario::Run run = expect_met(bundled("space.toml"));
  ASSERT_TRUE(run.complete());
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  EXPECT_EQ(model.section.horizons.size(), 3u);
  EXPECT_TRUE(model.restoration);
  const auto space = program().space_of(run.states.back());
  ASSERT_TRUE(space);
  EXPECT_EQ(space->layers.size(), 9u);  // four curtains, three surfaces, the new section before and after
}

TEST(Examples, BlocksMovedBackAreJoinedAndUnfoldedInOneScenario) {
  scenario::Document document = bundled("listric.toml");
  document.expects.clear();
  const std::string steps = R"(dobra = 1
program = "recon"
[[step]]
operation = "join"
tolerance = 3
[[step]]
operation = "grid"
top = "Top"
[[step]]
operation = "target"
[[step]]
operation = "restore"
method = "flexural"
)";
  const scenario::Document more = scenario::parse_document(steps, "steps.toml").value();
  document.steps.insert(document.steps.end(), more.steps.begin(), more.steps.end());
  const scenario::Run run = scenario::Runner(program()).run(document);
  ASSERT_TRUE(run.complete()) << to_string(*run.error);
  // Five beds over two faults, each joined twice; the moves leave gaps of rounded picks.
  EXPECT_EQ(figure(run, "join.joined"), 10.0);
  EXPECT_LT(figure(run, "join.widest_gap"), 3.0);
  EXPECT_NEAR(figure(run, "horizon.Top.length_before"), 11320.0, 3.0);
  EXPECT_NEAR(figure(run, "horizon.Top.length_after"), figure(run, "horizon.Top.length_before"), 1e-6);
  EXPECT_EQ(figure(run, "balanced"), 1.0);
}

TEST(Examples, ThrustMeetsItsExpectations) { expect_met(bundled("thrust.toml")); }

TEST(Examples, TheFirstOneOfThePageOfScenariosMeetsItsExpectations) {
  const std::filesystem::path page = std::filesystem::path(DOBRA_SOURCE_DIR) / "docs/scenario_format.md";
  const std::string text = dobra::io::read_text(page.string()).value();
  const std::string opening = "```toml\n";
  const std::size_t begin = text.find(opening) + opening.size();
  const auto document = scenario::parse_document(text.substr(begin, text.find("```", begin) - begin), page);
  ASSERT_TRUE(document) << to_string(document.error());
  expect_met(*document);
}

TEST(Examples, TheSameRunGivesTheSameReport) {
  const scenario::Document document = bundled("fold.toml");
  const std::string first = scenario::report_json(document, program(), scenario::Runner(program()).run(document));
  EXPECT_EQ(first, scenario::report_json(document, program(), scenario::Runner(program()).run(document)));
}

/// A scenario of tests/scenarios whose file names are relative to a folder of the test data; nothing if there are no
/// test data.
std::optional<scenario::Document> real_section(const std::string& name, const std::string& folder) {
  const auto data = dobra::test::data_folder();
  if (!data) return std::nullopt;
  auto document = scenario::read_document(std::filesystem::path(DOBRA_SOURCE_DIR) / "tests/scenarios" / name);
  EXPECT_TRUE(document) << to_string(document.error());
  document->file = *data / "sections" / folder / name;
  return std::move(*document);
}

TEST(RealSections, RaganIsogonFoldIsRestoredToADatum) {
  const auto document = real_section("ragan.toml", "ragan_isogon_fold");
  if (!document) GTEST_SKIP() << dobra::test::no_data;
  const scenario::Run run = expect_met(*document);
  ASSERT_TRUE(run.complete());
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  for (const maps::MappedLine& line : model.restoration->lines) {
    for (std::size_t i = 0; i < line.names.size(); ++i) {
      EXPECT_NEAR(model.target->target_pin.y - line.after.points[i].y, line.names[i].depth, 1e-9);
    }
  }
}

TEST(RealSections, CatskillFoldIsRestoredToADatum) {
  const auto document = real_section("catskill.toml", "catskill_fpf");
  if (!document) GTEST_SKIP() << dobra::test::no_data;
  const scenario::Run run = expect_met(*document);
  ASSERT_TRUE(run.complete());
  EXPECT_EQ(figure(run, "points_outside"), 0.0);
  const auto remarks = program().remarks_of(run.states.front());
  ASSERT_FALSE(remarks.empty());
  EXPECT_NE(remarks.front().find("horizon 'bed1'"), std::string::npos) << remarks.front();
}

TEST(RealSections, ASimplifiedTopTearsTheCatskillBedsLess) {
  const auto document = real_section("catskill.toml", "catskill_fpf");
  if (!document) GTEST_SKIP() << dobra::test::no_data;
  const auto simplified = scenario::with_value(*document, program(), "steps.1.simplify=3.0");
  ASSERT_TRUE(simplified) << to_string(simplified.error());
  const scenario::Run traced = scenario::Runner(program()).run(*document);
  const scenario::Run smooth = scenario::Runner(program()).run(*simplified);
  ASSERT_TRUE(traced.complete() && smooth.complete());
  EXPECT_LT(figure(smooth, "tears"), 0.5 * figure(traced, "tears"));
  EXPECT_LE(figure(smooth, "top.depth_max"), 3.0);
  EXPECT_GE(figure(smooth, "top.depth_min"), -3.0);
}

/// Length of every horizon and the area of every unit after flexural slip about a pin, against before.
void expect_lengths_kept(const scenario::Run& run) {
  ASSERT_TRUE(run.complete()) << to_string(*run.error);
  const auto& model = scenario::model_of<model::Model>(run.states.back());
  for (const balance::LineLength& row : model.restoration->lengths)
    EXPECT_NEAR(row.length_after, row.length_before, 1e-9 * row.length_before) << row.name;
}

TEST(RealSections, TheCatskillFoldUnfoldsByFlexuralSlipWithEveryBedItsLength) {
  auto document = real_section("catskill.toml", "catskill_fpf");
  if (!document) GTEST_SKIP() << dobra::test::no_data;
  auto flexural = scenario::with_value(*document, program(), "steps.3.method=flexural");
  ASSERT_TRUE(flexural) << to_string(flexural.error());
  flexural = scenario::with_value(*flexural, program(), "steps.2.pin=430");
  ASSERT_TRUE(flexural) << to_string(flexural.error());
  expect_lengths_kept(scenario::Runner(program()).run(*flexural));
}

/// The longest part of every layer of the profile.
std::map<int, geom::Polyline> broadhaven_layers(const std::filesystem::path& profile) {
  std::ifstream file(profile);
  std::string line;
  std::getline(file, line);
  std::map<std::pair<int, int>, geom::Polyline> parts;
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::stringstream cells(line);
    int layer = 0, part = 0, number = 0;
    geom::Point p;
    cells >> layer >> part >> number >> p.x >> p.y;
    parts[{layer, part}].points.push_back(p);
  }
  std::map<int, geom::Polyline> longest;
  for (auto& [key, part] : parts) {
    geom::Polyline& known = longest[key.first];
    if (geom::length(part) > geom::length(known)) known = part;
  }
  return longest;
}

/// Two layers of it by flexural slip, about the left end of the upper one.
scenario::Document broadhaven(const std::map<int, geom::Polyline>& layers, int upper, int lower) {
  scenario::Document document;
  document.program = "recon";
  std::vector<scenario::Table> rows;
  for (const int layer : {upper, lower}) {
    scenario::Table row;
    row.set("name", "layer" + std::to_string(layer));
    row.set("points", layers.at(layer).points);
    rows.push_back(std::move(row));
  }
  document.input.set("self_crossings", std::string("cut_loops"));
  document.input.set("horizon", std::move(rows));
  scenario::Table grid;
  grid.set("count", std::int64_t{2});
  grid.set("distance", 0.5);
  grid.set("uncovered", std::string("continue"));  // the layers reach differently far
  scenario::Table restore;
  restore.set("method", std::string("flexural"));
  document.steps = {{"grid", "", grid, "", {}}, {"target", "", {}, "", {}}, {"restore", "", restore, "", {}}};
  return document;
}

TEST(RealSections, TheBroadhavenFoldUnfoldsByFlexuralSlipWithTopAndBaseTheirLengthsOrIsRefused) {
  const auto data = dobra::test::data_folder();
  if (!data) GTEST_SKIP() << dobra::test::no_data;
  const auto profile = *data / "sections/broadhaven_fold/derived_profile_m/profile.csv";
  const std::map<int, geom::Polyline> layers = broadhaven_layers(profile);
  ASSERT_EQ(layers.size(), 9u);
  for (int layer = 1; layer < 9; ++layer) {
    SCOPED_TRACE("layers " + std::to_string(layer) + " and " + std::to_string(layer + 1));
    const scenario::Run run = scenario::Runner(program()).run(broadhaven(layers, layer, layer + 1));
    if (layer < 7) {
      expect_lengths_kept(run);
      continue;
    }
    // Of these the longest parts lie on the two limbs, one beyond the other: nothing tells how far apart they were.
    ASSERT_FALSE(run.complete());
    EXPECT_EQ(run.error->code, base::ErrorCode::CannotRestore);
    EXPECT_TRUE(run.error->place && run.error->place->x) << to_string(*run.error);
  }
}

}  // namespace
}  // namespace recon::core
