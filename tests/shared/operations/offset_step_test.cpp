// `offset` as an operation: what it adds to a state of any program, and its construction stopped half way.

#include "shared/operations/offset_step.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "shared/io/gis/geojson.h"
#include "shared/offset/offset.h"

namespace dobra::operations {
namespace {

using testing::HasSubstr;

struct Model {
  std::vector<io::lines::Feature> lines;
  std::vector<std::shared_ptr<const Offsets>> offsets;
};

struct Keeper {
  static std::vector<io::lines::Feature> lines_of(const Model& model) { return model.lines; }
  static std::size_t state_of(const Model&) { return 0; }
  static AllOffsets all(const Model& model) {
    AllOffsets all;
    for (const auto& one : model.offsets) all.push_back(one.get());
    return all;
  }
  static void add(Model& model, Offsets made) {
    model.offsets.push_back(std::make_shared<const Offsets>(std::move(made)));
  }
};

io::lines::Feature line(const std::string& name, std::vector<geom::Point> points, bool closed = false) {
  return {.type = closed ? io::lines::FeatureType::Polygons : io::lines::FeatureType::Lines,
          .parts = {{std::move(points), closed}},
          .name = name};
}

class OffsetStep : public testing::Test {
 protected:
  OffsetStep() : operation_(offset_operation<Model, Keeper>()) {}

  base::Result<scenario::State> run(const Model& model, const scenario::Table& params,
                                    const scenario::Context& context = {}) const {
    DOBRA_TRY_VOID(scenario::check(params, operation_.fields, "step 1 (offset)"));
    return operation_.run(scenario::make_state(model), params, context, {});
  }
  [[nodiscard]] scenario::Program program() const {
    scenario::Program made;
    made.operations = {operation_};
    made.results.draw = [](const scenario::State&, scene::Picture& picture) {
      picture.panels.push_back({.key = "all"});
    };
    return made;
  }
  [[nodiscard]] std::optional<double> quantity(const scenario::State& state, const std::string& name) const {
    for (const scenario::Quantity& one : program().quantities_of(state)) {
      if (one.name == name) return one.value;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::vector<std::string> layers(const scenario::State& state) const {
    std::vector<std::string> keys;
    const scene::Picture picture = program().picture_of(state);
    for (const scene::Layer& layer : picture.panels.at(0).layers) keys.push_back(layer.key);
    return keys;
  }
  [[nodiscard]] std::string refused(const Model& model, const scenario::Table& params) const {
    const auto made = run(model, params);
    EXPECT_FALSE(made);
    return made ? std::string() : base::to_string(made.error());
  }

  const scenario::Operation operation_;
  const Model corner_{{line("corner", {{0, 0}, {4, 0}, {4, 4}}), line("flat", {{0, 9}, {10, 9}})}, {}};
};

scenario::Table params(std::vector<std::pair<std::string, scenario::Value>> values) {
  scenario::Table table;
  for (auto& [key, value] : values) table.set(key, std::move(value));
  return table;
}

TEST_F(OffsetStep, LinesOfTheModelGiveNumbersATableLayersAndAFile) {
  const auto state = run(corner_, params({{"distances", std::vector<double>{1.0, 2.0}}}));
  ASSERT_TRUE(state) << base::to_string(state.error());
  EXPECT_EQ(quantity(*state, "offset.1.curves"), 4.0);
  // Outside of the corner D is added to both legs; the flat line keeps its length.
  EXPECT_NEAR(*quantity(*state, "offset.1.length"), (8.0 + 2.0) + (8.0 + 4.0) + 20.0, 1e-12);
  EXPECT_EQ(quantity(*state, "offset.1.area"), std::nullopt);
  const auto tables = program().tables_of(*state);
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].rows.size(), 4U);
  EXPECT_EQ(layers(*state), (std::vector<std::string>{"offset_1_1", "offset_1_2"}));
  const auto outputs = program().outputs_of(*state);
  ASSERT_EQ(outputs.size(), 1U);
  const auto file = std::filesystem::path(testing::TempDir()) / "dobra_offset_step.geojson";
  ASSERT_TRUE(outputs[0].write(file));
  const auto read = io::gis::read_geojson(file.string());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->features.size(), 4U);
  EXPECT_EQ(read->features[0].parts[0].points, (std::vector<geom::Point>{{0, -1}, {5, -1}, {5, 4}}));
  std::filesystem::remove(file);
  EXPECT_FALSE(operation_.at_work(*state));
  EXPECT_EQ(program().reached(*state), std::nullopt);
}

TEST_F(OffsetStep, FurtherStepsAddTheirs) {
  auto state = run(corner_, params({{"distance", 1.0}, {"curve", std::string("flat")}}));
  ASSERT_TRUE(state);
  state = operation_.run(
      *state, params({{"distance", 2.0}, {"side", std::string("both")}, {"join", std::string("round")}}), {}, {});
  ASSERT_TRUE(state) << base::to_string(state.error());
  EXPECT_EQ(quantity(*state, "offset.1.length"), 10.0);
  EXPECT_EQ(quantity(*state, "offset.2.curves"), 2.0);
  EXPECT_TRUE(quantity(*state, "offset.2.area"));
  EXPECT_EQ(layers(*state), (std::vector<std::string>{"offset_1_1", "offset_2_1"}));
}

TEST_F(OffsetStep, MistakesAreToldInTheWordsOfTheScenario) {
  EXPECT_THAT(refused(corner_, params({})), HasSubstr("give distance = D (with count = N, factor = F), or distances"));
  EXPECT_THAT(refused(corner_, params({{"distance", 0.0}})), HasSubstr("'distance' must be other than 0 m"));
  EXPECT_THAT(refused(corner_, params({{"distance", -1.0}})), HasSubstr("-1.0 m must be above 0 for corner"));
  EXPECT_THAT(refused(corner_, params({{"distance", 1.0}, {"distances", std::vector<double>{1.0}}})),
              HasSubstr("distances excludes distance"));
  EXPECT_THAT(refused(corner_, params({{"distance", 1.0}, {"caps", std::string("flat")}})),
              HasSubstr("caps belongs to side = both"));
  EXPECT_THAT(refused(corner_, params({{"distance", 1.0}, {"curve", std::string("flt")}})),
              HasSubstr("did you mean 'flat'?"));
  EXPECT_THAT(refused({}, params({{"distance", 1.0}})), HasSubstr("there is no line and no polygon in the model"));
  const auto bad = run(corner_, params({{"distance", -1.0}}));
  EXPECT_EQ(bad.error().code, base::ErrorCode::BadValue);
}

TEST_F(OffsetStep, WhatIsVerifiedReachesWhatItIsFor) {
  const auto state = run(corner_, params({{"distance", 1.0}, {"verify", true}}));
  ASSERT_TRUE(state);
  EXPECT_EQ(program().reached(*state), true);
  EXPECT_EQ(quantity(*state, "offset.1.findings"), 0.0);
  EXPECT_THAT(program().remarks_of(*state), testing::Contains(HasSubstr("nothing is wrong with them")));
}

TEST_F(OffsetStep, AFileIsReadInItsUnitAndSilentOnesInThatOfTheScenario) {
  const auto folder = std::filesystem::path(testing::TempDir());
  std::ofstream(folder / "dobra_step.csv") << "x,y\n0,0\n10,0\n";
  const auto millimetres = scenario::UnitSystem::make("mm, N, MPa").value();
  const auto state = run({}, params({{"file", std::string("dobra_step.csv")}, {"distance", 0.001}}),
                         {folder, millimetres, millimetres});
  ASSERT_TRUE(state) << base::to_string(state.error());
  EXPECT_NEAR(*quantity(*state, "offset.1.length"), 0.01, 1e-15);
  EXPECT_EQ(layers(*state), (std::vector<std::string>{"offset_1_base", "offset_1_1"}));
  EXPECT_EQ(program().picture_of(*state).panels[0].layers[1].title, "D = 1 mm");
  std::filesystem::remove(folder / "dobra_step.csv");
}

// --- the construction, stopped

/// A fold whose inner curve closes a region: two limbs nearer to each other than 2 D.
geom::Polyline trench() { return {{{0, 0}, {4, 0}, {4, -3}, {5, -3}, {5, 0}, {9, 0}}, false}; }

TEST_F(OffsetStep, TheConstructionIsSeenAfterEveryStepAndEndsWithTheCurves) {
  const Model model{{line("trench", trench().points)}, {}};
  std::size_t steps = 0;
  std::size_t deleted = 0;
  scenario::State state;
  for (steps = 1; steps < 50; ++steps) {
    const auto made = run(
        model,
        params({{"distance", 1.0}, {"side", std::string("left")}, {"stop_after", static_cast<std::int64_t>(steps)}}));
    ASSERT_TRUE(made) << base::to_string(made.error());
    state = *made;
    if (!operation_.at_work(state)) break;
    EXPECT_EQ(quantity(state, "offset.1.work.steps"), static_cast<double>(steps));
    deleted += static_cast<std::size_t>(*quantity(state, "offset.1.work.deleted"));
    EXPECT_THAT(layers(state), testing::Contains("offset_1_so_far"));
    EXPECT_THAT(layers(state), testing::Contains("offset_1_raw_edge"));
    EXPECT_TRUE(program().outputs_of(state).empty());
    EXPECT_THAT(program().remarks_of(state), testing::Contains(HasSubstr(fmt::format("after {} steps", steps))));
    const auto& stage = *scenario::model_of<Model>(state).offsets.back()->stage;
    // The raw edge of a step lies at the distance from its base segment, on the left.
    const geom::Point from = stage.base_segment.points.front();
    const geom::Vector along = stage.base_segment.points.back() - from;
    EXPECT_NEAR(geom::cross(along, stage.raw_edge.points.front() - from) / geom::length(along), 1.0, 1e-12);
    for (const geom::Polyline& edge : stage.so_far) EXPECT_GT(edge.points.front().y, -4.0);
  }
  EXPECT_EQ(steps, trench().points.size() - 1);  // one raw edge a segment
  EXPECT_GT(deleted, 0U);
  EXPECT_EQ(layers(state), (std::vector<std::string>{"offset_1_1"}));
  const auto engine = offset::offset(trench(), std::vector{1.0}, {.side = offset::Side::LeftOfTravel});
  double expected = 0.0;
  const auto& points = engine->front().pieces.at(0).points;
  for (std::size_t i = 1; i < points.size(); ++i) expected += geom::distance(points[i - 1], points[i]);
  EXPECT_NEAR(*quantity(state, "offset.1.length"), expected, 1e-12);
}

TEST_F(OffsetStep, StepsGoOnFromCurveToCurveAndFromDistanceToDistance) {
  const auto at = [&](std::int64_t steps) {
    const auto state = run(corner_, params({{"distances", std::vector<double>{1.0, 2.0}}, {"stop_after", steps}}));
    EXPECT_TRUE(state);
    return scenario::model_of<Model>(*state).offsets.back();
  };
  EXPECT_EQ(at(1)->stage->distance, 1.0);
  EXPECT_EQ(at(3)->stage->distance, 2.0);  // the corner has two segments
  EXPECT_EQ(at(3)->families.at(0).curves.at(0).lines.size(), 1U);
  EXPECT_EQ(at(5)->stage->curve, "flat");
  EXPECT_EQ(at(6)->stage, std::nullopt);
  EXPECT_EQ(at(1000)->stage, std::nullopt);
}

TEST_F(OffsetStep, WhatHasNoStagesIsRefused) {
  for (const auto& [key, value] : std::vector<std::pair<std::string, scenario::Value>>{
           {"dissolve", true}, {"untreated", true}, {"verify", true}, {"side", std::string("both")}})
    EXPECT_THAT(refused(corner_, params({{"distance", 1.0}, {"stop_after", std::int64_t{1}}, {key, value}})),
                HasSubstr("leave out " + key));
}

}  // namespace
}  // namespace dobra::operations
