#include "recon/input/topography.h"

#include <gtest/gtest.h>

#include <map>

#include "recon/core/grid_step.h"
#include "recon/core/operations.h"
#include "recon/core/report.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "recon/section/section_faces.h"
#include "tests/recon/shapes.h"

namespace recon::input {
namespace {

using test::item;

/// An anticline of 100 m whose crest was eroded at z = 5.
SectionInput eroded() {
  SectionInput input;
  input.horizons = {item("A", {{0, 0}, {50, 10}, {100, 0}}), item("B", {{0, -10}, {50, 0}, {100, -10}})};
  input.topographies = {item("today", {{0, 5}, {100, 5}})};
  return input;
}

double area_of_units(const section::SectionFaces& faces) {
  double sum = 0.0;
  for (const section::RockUnit& unit : faces.units) sum += unit.area;
  return sum;
}

TEST(Topography, WhatLiesAboveIsErodedAndTheHorizonFallsIntoItsParts) {
  const auto read = read_section(eroded(), {}, {});
  ASSERT_TRUE(read) << to_string(read.error());
  const section::Section& section = read->section;
  ASSERT_EQ(section.horizons.size(), 3u);
  EXPECT_EQ(section.horizons[0].name, "A (1)");
  EXPECT_EQ(section.horizons[0].piece_of, "A");
  EXPECT_EQ(section.horizons[0].id, section::HorizonId(0));
  EXPECT_EQ(section.horizons[0].line.points.back(), (geom::Point{25, 5}));
  EXPECT_EQ(section.horizons[1].name, "A (2)");
  EXPECT_EQ(section.horizons[1].id, section::HorizonId(2));
  EXPECT_EQ(section.horizons[1].line.points.front(), (geom::Point{75, 5}));
  EXPECT_EQ(section.horizons[2].name, "B");
  const section::SectionLine& gone = section.lines.back();
  EXPECT_EQ(gone.kind, section::LineKind::Eroded);
  EXPECT_EQ(gone.name, "A");
  EXPECT_EQ(gone.line.points, (std::vector<geom::Point>{{25, 5}, {50, 10}, {75, 5}}));
  ASSERT_FALSE(read->remarks.empty());
  EXPECT_EQ(read->remarks[0].find("horizon 'A': 50.9902 m of 101.98 m lie above the topography 'today'"), 0u)
      << read->remarks[0];
}

TEST(Topography, EveryPartAndTheirSumHaveANameOfTheirOwn) {
  SectionInput input = eroded();
  model::Model model;
  model.section = read_section(input, {}, {})->section;
  unfold::GridParams grid;
  grid.top = "A";
  const auto whole = core::run_grid(model, grid, {}, {});
  ASSERT_FALSE(whole);
  EXPECT_NE(to_string(whole.error()).find("name the piece, such as 'A (1)'"), std::string::npos);
  grid.top = "B";
  const auto target = core::run_target(core::run_grid(model, grid, {}, {}).value(), {}, {}, {});
  ASSERT_TRUE(target) << to_string(target.error());
  const auto restored = core::run_restore(*target, {}, {}, {});
  ASSERT_TRUE(restored) << to_string(restored.error());
  std::map<std::string, double> found;
  for (const auto& quantity : core::program().quantities_of(dobra::scenario::make_state(*restored))) {
    EXPECT_TRUE(found.emplace(quantity.name, quantity.value).second) << quantity.name << " is there twice";
  }
  EXPECT_NEAR(found.at("horizon.A.length_before"),
              found.at("horizon.A (1).length_before") + found.at("horizon.A (2).length_before"), 1e-9);
  input.horizons[1].name = "A (2)";
  const auto taken = read_section(input, {}, {});
  ASSERT_FALSE(taken);
  EXPECT_NE(to_string(taken.error()).find("has this name already"), std::string::npos);
}

TEST(Topography, TheAreasBelowItAddUp) {
  const auto read = read_section(eroded(), {}, {});
  ASSERT_TRUE(read);
  const section::SectionFaces& faces = *read->section.faces;
  EXPECT_NEAR(area_of_units(faces), faces.area, 1e-12 * faces.area);
  SectionInput bordered = eroded();
  bordered.borders = {item("border", {{10, -30}, {90, -30}, {90, 30}, {10, 30}})};
  const auto within = read_section(bordered, {}, {});
  ASSERT_TRUE(within) << to_string(within.error());
  EXPECT_NEAR(within->section.faces->area, 80.0 * 35.0, 1e-9);
  EXPECT_NEAR(area_of_units(*within->section.faces), 80.0 * 35.0, 1e-9);
}

TEST(Topography, OnRequestTheWholeHorizonIsRestored) {
  SectionInput input = eroded();
  input.above_topography = AboveTopography::Restore;
  const auto read = read_section(input, {}, {});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->section.horizons.size(), 2u);
  EXPECT_EQ(read->section.horizons[0].line.points.size(), 3u);
}

TEST(Topography, ItMayBeTheTop) {
  SectionInput input;
  input.horizons = {item("B", {{0, -10}, {50, 0}, {100, -10}})};
  input.topographies = {item("today", {{0, 2}, {50, 6}, {100, 2}})};
  const auto read = read_section(input, {}, {});
  ASSERT_TRUE(read);
  model::Model model;
  model.section = read->section;
  unfold::GridParams grid;
  grid.top = "today";
  const auto with_grid = core::run_grid(model, grid, {}, {});
  ASSERT_TRUE(with_grid) << to_string(with_grid.error());
  const auto with_target = core::run_target(*with_grid, {}, {}, {});
  ASSERT_TRUE(with_target);
  const auto restored = core::run_restore(*with_target, {}, {}, {});
  ASSERT_TRUE(restored) << to_string(restored.error());
  ASSERT_EQ(restored->restoration->lengths.size(), 2u);
  EXPECT_EQ(restored->restoration->lengths[1].name, "today");
  EXPECT_NEAR(restored->restoration->lengths[1].change_percent, 0.0, 1e-12);
  ASSERT_EQ(restored->restoration->ledger.units.size(), 1u);
  EXPECT_EQ(restored->restoration->ledger.units[0].name, "today - B");
}

TEST(Topography, ADatumIsATargetAndStaysWhereItIs) {
  SectionInput input;
  input.horizons = {item("A", {{0, 0}, {50, 10}, {100, 0}}), item("B", {{0, -10}, {50, 0}, {100, -10}})};
  input.datums = {item("sea level", {{-50, 20}, {200, 20}})};
  const auto read = read_section(input, {}, {});
  ASSERT_TRUE(read);
  model::Model model;
  model.section = read->section;
  unfold::TargetParams target;
  target.shape = unfold::TargetShape::Datum;
  const auto with_target = core::run_target(core::run_grid(model, {}, {}, {}).value(), target, {}, {});
  ASSERT_TRUE(with_target) << to_string(with_target.error());
  const auto restored = core::run_restore(*with_target, {}, {}, {});
  ASSERT_TRUE(restored);
  for (const geom::Point p : restored->restoration->section.horizons[0].line.points) EXPECT_NEAR(p.y, 20.0, 1e-9);
  EXPECT_EQ(restored->restoration->section.lines[0].line.points, input.datums[0].points);
  target.datum = "see level";
  const auto wrong = core::run_target(core::run_grid(model, {}, {}, {}).value(), target, {}, {});
  ASSERT_FALSE(wrong);
  EXPECT_NE(to_string(wrong.error()).find("did you mean 'sea level'"), std::string::npos);
}

TEST(Topography, FacesCutByFaultsAndTruncatedBedsCountInTheLedger) {
  SectionInput input;
  input.horizons = {item("A", {{0, 0}, {100, 0}}), item("B", {{0, -20}, {50, 0}}), item("C", {{0, -60}, {100, -60}})};
  const auto read = read_section(input, {}, {});
  ASSERT_TRUE(read) << to_string(read.error());
  model::Model model;
  model.section = read->section;
  const auto restored =
      core::run_restore(core::run_target(core::run_grid(model, {}, {}, {}).value(), {}, {}, {}).value(), {}, {}, {});
  ASSERT_TRUE(restored) << to_string(restored.error());
  double before = 0.0, after = 0.0;
  for (const balance::UnitRow& row : restored->restoration->ledger.units) {
    before += row.area_before;
    after += row.area_after;
  }
  EXPECT_NEAR(before, 6000.0, 1e-9);  // a straight top: nothing changes
  EXPECT_NEAR(after, 6000.0, 1e-9);
}

}  // namespace
}  // namespace recon::input
