// Every unit of a section has a row of the ledger, a fill in the picture and a say in the verdict.

#include "recon/balance/face_ledger.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

#include "recon/core/grid_step.h"
#include "recon/core/operations.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "tests/recon/shapes.h"

namespace recon::balance {
namespace {

using Areas = std::map<std::string, double>;

void add_piece(const std::string& name, const std::string& whole, std::vector<geom::Point> points,
               section::Section& section) {
  section::Horizon horizon{section::HorizonId(section.horizons.size()), name, {std::move(points), false}, {}};
  horizon.piece_of = whole;
  section.horizons.push_back(std::move(horizon));
}

void add_line(section::LineKind kind, std::vector<geom::Point> points, section::Section& section) {
  section.lines.push_back({section::LineId(section.lines.size()), kind, "F", {std::move(points), false}, {}});
}

/// Beds at 0, -200 and -500 m, cut by a fault through (900, 200) and (1450, -900), and 100 m lower behind it.
section::Section faulted(bool named_apart) {
  section::Section section;
  const char* names[] = {"A", "B", "C"};
  const double levels[] = {0.0, -200.0, -500.0};
  for (int i = 0; i < 3; ++i) {
    const std::string whole = named_apart ? "" : names[i];
    const auto fault_at = [](double z) { return 1000.0 - 0.5 * z; };
    const double z = levels[i];
    add_piece(names[i] + std::string(" (1)"), whole, {{0, z}, {fault_at(z), z}}, section);
    add_piece(names[i] + std::string(" (2)"), whole, {{fault_at(z - 100), z - 100}, {3000, z - 100}}, section);
  }
  add_line(section::LineKind::Fault, {{900, 200}, {1450, -900}}, section);
  return section;
}

/// Beds 100 and 200 m thick under a crest, of which topography has cut the middle out.
section::Section eroded() {
  section::Section section;
  add_piece("A (1)", "A", {{0, 0}, {1000, 50}}, section);
  add_piece("A (2)", "A", {{2000, 50}, {3000, 0}}, section);
  add_piece("B (1)", "B", {{0, -100}, {1200, 50}}, section);
  add_piece("B (2)", "B", {{1800, 50}, {3000, -100}}, section);
  add_piece("C", "", {{0, -300}, {1500, -100}, {3000, -300}}, section);
  add_line(section::LineKind::Topography, {{0, 50}, {3000, 50}}, section);
  return section;
}

model::Model restored(section::Section section) {
  section.faces = std::make_shared<const section::SectionFaces>(faces_of(section).value());
  model::Model model;
  model.section = std::move(section);
  unfold::GridParams grid;
  grid.top = model.section.horizons.back().name;
  grid.count = 1;
  grid.side = section::LayerSide::Above;
  grid.uncovered = unfold::Uncovered::Continue;
  unfold::RestoreParams params;
  params.method = unfold::RestoreMethod::Shear;
  auto made = core::run_grid(model, grid, {}, {});
  EXPECT_TRUE(made) << to_string(made.error());
  made = core::run_target(*made, {}, {}, {});
  EXPECT_TRUE(made) << to_string(made.error());
  made = core::run_restore(*made, params, {}, {});
  EXPECT_TRUE(made) << to_string(made.error());
  return *made;
}

double sum_of_rows(const Ledger& ledger) {
  double sum = 0.0;
  for (const UnitRow& row : ledger.units) sum += row.area_before;
  return sum;
}

/// Area that a panel fills as units.
double filled(const dobra::scene::Panel& panel) {
  double sum = 0.0;
  for (const dobra::scene::Layer& layer : panel.layers) {
    if (layer.key.rfind("unit_", 0) != 0) continue;
    for (const auto& region : std::get<dobra::scene::Regions>(layer.content).regions) sum += area_of(region.contours);
  }
  return sum;
}

void expect_rows(const section::Section& section, const Areas& areas, double all) {
  const model::Model model = restored(section);
  const Ledger& ledger = model.restoration->ledger;
  for (const auto& [name, area] : areas) {
    const auto row = std::find_if(ledger.units.begin(), ledger.units.end(),
                                  [&, &unit = name](const UnitRow& r) { return r.name == unit; });
    ASSERT_NE(row, ledger.units.end()) << name;
    EXPECT_NEAR(row->area_before, area, 1e-6) << name;
    EXPECT_NEAR(row->area_after, area, 1e-6) << name;  // shear keeps areas
  }
  EXPECT_NEAR(sum_of_rows(ledger), all, 1e-6);
  EXPECT_FALSE(missing_area(model.section, ledger));
  EXPECT_FALSE(model.restoration->balance.worst_unit.empty());
  const dobra::scene::Picture picture = core::program().picture_of(dobra::scenario::make_state(model));
  ASSERT_EQ(picture.panels.size(), 2u);
  EXPECT_NEAR(filled(picture.panels[0]), all, 1e-6);
  EXPECT_NEAR(filled(picture.panels[1]), all, 1e-6);
}

TEST(FaceLedger, UnitsWithRoofAndFloorInPiecesHaveTheirRowsAndFills) {
  const Areas blocks{
      {"A (1) - B (1)", 210000}, {"A (2) - B (2)", 380000}, {"B (1) - C (1)", 352500}, {"B (2) - C (2)", 532500}};
  expect_rows(faulted(false), blocks, 1475000);
}

TEST(FaceLedger, BlocksOfDifferentHorizonsHaveTheirRowsAndFills) {
  const Areas blocks{
      {"A (1) - B (1)", 210000}, {"A (2) - B (2)", 380000}, {"B (1) - C (1)", 352500}, {"B (2) - C (2)", 532500}};
  expect_rows(faulted(true), blocks, 1475000);
}

TEST(FaceLedger, BlocksWithinABorderHaveTheirRowsAndFills) {
  section::Section section = faulted(false);
  section.border = geom::Polyline{{{0, -700}, {3000, -700}, {3000, 100}, {0, 100}}, true};
  expect_rows(section, {{"A (1) - B (1)", 210000}, {"B (2) - C (2)", 532500}}, 3000.0 * 800.0);
}

TEST(FaceLedger, BedsOfAnErodedCrestHaveTheirRowsAndFills) {
  // A quadrilateral (0, 0), (1000, 50), (1200, 50), (0, -100) on either side, 65000 m2 by the shoelace; all: from the
  // topography at 50 m down to C, -200 m in the mean.
  expect_rows(eroded(), {{"A (1) - B (1)", 65000}, {"A (2) - B (2)", 65000}}, 3000.0 * 250.0);
}

TEST(FaceLedger, TheColumnHasABedInPiecesOnce) {
  // 100 m over 300 m2 and 200 m over 100 m2 are 125 m; a bed without a thickness is left out.
  const section::Section section = faulted(false);
  const std::vector<LedgerUnit> units{{"", {}, 0, 2}, {"", {}, 2, 4}, {"", {}, 1, 3}};
  std::vector<UnitRow> rows(3);
  rows[0].thickness_after = Range{90, 100, 110};
  rows[0].area_before = 300;
  rows[2].thickness_after = Range{200, 200, 200};
  rows[2].area_before = 100;
  const std::vector<RestoredBed> beds = restored_beds(section, units, rows);
  ASSERT_EQ(beds.size(), 1u);
  EXPECT_EQ(beds[0].name, "A - B");
  EXPECT_DOUBLE_EQ(beds[0].thickness, 125.0);
}

TEST(FaceLedger, AreaThatIsInNoRowIsToldWithItsPlace) {
  const model::Model model = restored(faulted(false));
  Ledger ledger = model.restoration->ledger;
  std::erase_if(ledger.units, [](const UnitRow& row) { return row.name == "B (1) - C (1)"; });
  const auto told = missing_area(model.section, ledger);
  ASSERT_TRUE(told);
  for (const char* words : {"1.1225e+06 m2", "1.475e+06 m2", "'B (1) - C (1)' of 352500 m2 at ("})
    EXPECT_NE(told->find(words), std::string::npos) << *told;
  ledger = model.restoration->ledger;
  ledger.units.front().area_before *= 0.999;
  EXPECT_TRUE(missing_area(model.section, ledger));
  ledger = model.restoration->ledger;
  ledger.units.push_back(ledger.units.front());
  EXPECT_NE(missing_area(model.section, ledger)->find("twice"), std::string::npos);
}

}  // namespace
}  // namespace recon::balance
