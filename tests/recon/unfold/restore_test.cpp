#include "recon/unfold/restore.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "recon/core/grid_step.h"
#include "recon/core/operations.h"
#include "recon/core/report.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "tests/recon/shapes.h"

namespace recon::unfold {
namespace {

/// Grid, flat target at the top's left end, restoration.
base::Result<model::Model> restored(const section::Section& section, double distance = 0.2,
                                    const TargetParams& target = {}) {
  model::Model model;
  model.section = section;
  GridParams grid;
  grid.count = 5;
  grid.distance = distance;
  DOBRA_TRY(const model::Model with_grid, core::run_grid(model, grid, {}, {}));
  DOBRA_TRY(const model::Model with_target, core::run_target(with_grid, target, {}, {}));
  return core::run_restore(with_target, {}, {}, {});
}

TEST(Restore, REC_a_TheTopAsTargetLeavesTheSectionAsItIs) {
  const geom::Polyline top = test::cosine();
  const section::Section section = test::section_of({top, test::parallel(top, 0.3), test::parallel(top, 0.8)});
  TargetParams target;
  target.shape = TargetShape::Line;
  target.points = top.points;
  const auto model = restored(section, 0.2, target);
  ASSERT_TRUE(model) << to_string(model.error());
  for (const maps::MappedLine& line : model->restoration->lines) {
    EXPECT_LT(test::greatest_distance(line.before.points, line.after.points), 1e-9);
  }
  EXPECT_EQ(model->restoration->balance.verdict, balance::BalanceVerdict::Balanced);
}

TEST(Restore, REC_b_AMovedTopAsTargetMovesTheSection) {
  const geom::Polyline top = test::cosine();
  TargetParams target;
  target.shape = TargetShape::Line;
  for (const geom::Point p : top.points)
    target.points.push_back({0.8 * p.x - 0.6 * p.y + 3, 0.6 * p.x + 0.8 * p.y - 9});
  target.target_pin = target.points.front();
  const auto model = restored(test::section_of({top, test::parallel(top, 0.7)}), 0.2, target);
  ASSERT_TRUE(model) << to_string(model.error());
  for (const maps::MappedLine& line : model->restoration->lines) {
    for (std::size_t i = 0; i < line.before.points.size(); ++i) {
      const geom::Point p = line.before.points[i];
      EXPECT_LT(geom::distance(line.after.points[i], {0.8 * p.x - 0.6 * p.y + 3, 0.6 * p.x + 0.8 * p.y - 9}), 1e-9);
    }
  }
}

TEST(Restore, REC_c_TheFlattenedCosineHasItsLengthAndEveryPointItsDepth) {
  const geom::Polyline top = test::cosine();
  const auto model = restored(test::section_of({top, test::parallel(top, 0.5), test::parallel(top, 0.95)}));
  ASSERT_TRUE(model) << to_string(model.error());
  const balance::LineLength& row = model->restoration->lengths[0];
  EXPECT_NEAR(row.length_after, 15.278866948, 1e-9);
  EXPECT_NEAR(row.shortening_percent, 17.7533, 5e-5);
  for (std::size_t h = 0; h < 3; ++h) {
    const double depth = std::array{0.0, 0.5, 0.95}[h];
    for (const geom::Point p : model->restoration->section.horizons[h].line.points)
      EXPECT_NEAR(p.y, -1.0 - depth, 1e-9);
  }
}

TEST(Restore, REC_d_ConcentricBedsComeOutFlatAtTheirDepthAndTooLong) {
  const geom::Polyline top = test::arc();
  const auto model =
      restored(test::section_of({top, test::parallel(top, 0.5), test::parallel(top, 1.0), test::parallel(top, 2.0)}));
  ASSERT_TRUE(model) << to_string(model.error());
  const double datum = top.points.front().y;
  const std::array depths{0.0, 0.5, 1.0, 2.0};
  for (std::size_t h = 0; h < 4; ++h) {
    for (const geom::Point p : model->restoration->section.horizons[h].line.points)
      EXPECT_NEAR(p.y - datum, -depths[h], 1e-9);
    EXPECT_NEAR(model->restoration->lengths[h].length_after, 15.707569, 1e-6);
    EXPECT_NEAR(model->restoration->lengths[h].depth_mean, depths[h], 1e-9);
  }
  EXPECT_NEAR(model->restoration->lengths[2].length_before, 14.161239, 1e-6);
  EXPECT_NEAR(model->restoration->lengths[2].change_percent, 10.9, 0.05);
}

TEST(Restore, REC_h_TheConcentricFoldIsNotBalancedAndAFlatSectionIs) {
  const geom::Polyline top = test::arc();
  const auto fold = restored(test::section_of({top, test::parallel(top, 1.0)}));
  ASSERT_TRUE(fold);
  EXPECT_NE(fold->restoration->balance.verdict, balance::BalanceVerdict::Balanced);
  EXPECT_EQ(fold->restoration->balance.worst, "bed1");
  const auto flat = restored(test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -1}, {10, -1}}, false}}));
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->restoration->balance.verdict, balance::BalanceVerdict::Balanced);
}

TEST(Restore, LayersAboveTheTopAreRestoredAlike) {
  const geom::Polyline top = test::arc();
  const geom::Polyline above = test::parallel(top, -1.0);
  const auto model = restored(test::section_of({top, above}));
  ASSERT_TRUE(model) << to_string(model.error());
  EXPECT_EQ(model->source->side, section::LayerSide::Above);
  EXPECT_EQ(model->target->source_pin, top.points.front());
  const geom::Polyline& line = model->restoration->section.horizons[1].line;
  for (const geom::Point p : line.points) EXPECT_NEAR(p.y, top.points.front().y + 1.0, 1e-9);
  EXPECT_NEAR(line.points.front().x, top.points.front().x, 1e-9);
  EXPECT_NEAR(line.points.back().x, top.points.front().x + 15.707569, 1e-6);
}

TEST(Restore, PointsAboveTheTopKeepTheirHeightToo) {
  const geom::Polyline top = test::arc();
  const auto model =
      restored(test::section_of({top, test::parallel(top, 1.0), test::parallel(top, 2.0), test::parallel(top, -0.5)}));
  ASSERT_TRUE(model);
  EXPECT_EQ(model->source->side, section::LayerSide::Below);
  EXPECT_NEAR(model->restoration->lengths[3].depth_min, -0.5, 1e-9);
  EXPECT_NEAR(model->restoration->lengths[3].depth_max, -0.5, 1e-9);
}

TEST(Restore, APinInTheMiddleStaysInPlace) {
  TargetParams target;
  target.pin = 5.0;
  const geom::Polyline top = test::cosine();
  const auto model = restored(test::section_of({top}), 0.2, target);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->target->source_pin.x, 5.0);
  EXPECT_LT(geom::distance(model->target->map.map(model->target->source_pin), model->target->source_pin), 1e-12);
}

TEST(Restore, ACancelledRestorationSaysSo) {
  const geom::Polyline top = test::cosine();
  const auto model = restored(test::section_of({top, test::parallel(top, 0.3)}));
  ASSERT_TRUE(model) << to_string(model.error());
  const base::CancelToken token;
  token.cancel();
  const auto result = core::run_restore(*model, {}, {}, base::Progress(token, nullptr));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, base::ErrorCode::Cancelled);
}

/// A flat top over a bed that a fault with a throw of 1 cuts at x = 5.
section::Section faulted() {
  section::Section section =
      test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -2}, {5, -2}}, false}, {{{5, -3}, {10, -3}}, false}});
  section.horizons[1].name = "bed (1)";
  section.horizons[2].name = "bed (2)";
  section.horizons[1].piece_of = section.horizons[2].piece_of = "bed";
  section.lines.push_back({section::LineId(0), section::LineKind::Fault, "F", {{{5, -1}, {5, -4}}, false}, {}});
  return section;
}

model::Model ready(const section::Section& section) {
  model::Model model;
  model.section = section;
  GridParams grid;
  grid.count = 1;
  return core::run_target(core::run_grid(model, grid, {}, {}).value(), {}, {}, {}).value();
}

TEST(Restore, ThePiecesOfAFaultedHorizonAreRestoredEachAndAddUp) {
  section::Section section = faulted();
  section.horizons[0].line.points = {{0, 0}, {5, 1}, {10, 0}};  // unfolding it lengthens what lies on the inside
  RestoreParams constant;
  const auto run = core::run_restore(ready(section), constant, {}, {});
  ASSERT_TRUE(run) << to_string(run.error());
  const Restoration& restoration = *run->restoration;
  ASSERT_EQ(restoration.lengths.size(), 3u);
  const std::vector<balance::LineLength> totals = totals_of(restoration.lengths);
  ASSERT_EQ(totals.size(), 1u);
  const balance::LineLength& left = restoration.lengths[1];
  const balance::LineLength& right = restoration.lengths[2];
  EXPECT_EQ(totals[0].name, "bed");
  EXPECT_DOUBLE_EQ(totals[0].length_before, 10.0);
  EXPECT_DOUBLE_EQ(totals[0].length_after, left.length_after + right.length_after);
  EXPECT_DOUBLE_EQ(totals[0].shortening, left.shortening + right.shortening);
  EXPECT_DOUBLE_EQ(totals[0].depth_mean, 0.5 * (left.depth_mean + right.depth_mean));
  EXPECT_EQ(whole_beds(restoration.lengths).size(), 2u);
  // The same numbers in the tables; beds agree as wholes, not piece by piece.
  const auto quantities = core::program().quantities_of(dobra::scenario::make_state(*run));
  const auto found = std::find_if(quantities.begin(), quantities.end(),
                                  [](const auto& q) { return q.name == "horizon.bed.length_after"; });
  ASSERT_NE(found, quantities.end());
  EXPECT_DOUBLE_EQ(found->value, totals[0].length_after);
  // The top's two limbs, less what the fault leaves out of them, against two flat pieces.
  EXPECT_NEAR(restoration.balance.consistency.worst.percent, 100.0 * (1.0 - 10.0 / std::sqrt(104.0)), 0.1);
}

TEST(Restore, MethodsThatTakeWholeBedsGoOnOverTheGapBetweenPieces) {
  const model::Model model = ready(faulted());
  for (const RestoreMethod method : {RestoreMethod::Flexural, RestoreMethod::Proportional}) {
    RestoreParams params;
    params.method = method;
    const auto made = core::run_restore(model, params, {}, {});
    ASSERT_TRUE(made) << to_string(made.error());
    if (method == RestoreMethod::Proportional) continue;  // one thickness for both
    for (const maps::MappedLine& line : made->restoration->lines)
      EXPECT_LT(test::greatest_distance(line.before.points, line.after.points), 1e-9);
  }
  // Line length brings a bed to one depth, that of the pin.
  RestoreParams params;
  params.method = RestoreMethod::LineLength;
  const auto made = core::run_restore(model, params, {}, {});
  ASSERT_TRUE(made) << to_string(made.error());
  EXPECT_LT(geom::distance(made->restoration->lines[2].after.points.front(), {5, -2}), 1e-9);
  EXPECT_LT(geom::distance(made->restoration->lines[2].after.points.back(), {10, -2}), 1e-9);
}

TEST(Restore, PiecesAboveEachOtherAreRefusedByName) {
  section::Section section = faulted();
  section.horizons[2].line.points = {{4, -3}, {10, -3}};  // a reverse fault
  RestoreParams params;
  params.method = RestoreMethod::Flexural;
  const auto refused = core::run_restore(ready(section), params, {}, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::CannotRestore);
  EXPECT_EQ(refused.error().place->item, "horizon 'bed (2)'");
  EXPECT_NE(refused.error().message.find("'bed (1)', a piece of the same horizon, by 1 m"), std::string::npos);
  params.beds = SlipBeds::Parallel;
  EXPECT_TRUE(core::run_restore(ready(section), params, {}, {}));
  model::Model start;
  start.section = faulted();
  GridParams grid;
  grid.top = "bed";
  const auto no_top = core::run_grid(start, grid, {}, {});
  ASSERT_FALSE(no_top);
  EXPECT_NE(no_top.error().message.find("name the piece, such as 'bed (1)'"), std::string::npos);
}

TEST(Restore, NoTwoPointsOfARestoredLineAreCloserThanRounding) {
  // Vertices of parallels lie on the rungs to rounding: a cut there makes a second point.
  const geom::Polyline top = test::cosine();
  for (const double depth : {0.1, 0.3, 0.7, 0.85}) {
    section::Section section = test::section_of({top, test::parallel(top, depth), test::parallel(top, 0.95)});
    geom::Polyline ring = test::parallel(top, 0.5 * depth);
    for (std::size_t i = top.points.size(); i-- > 0;) ring.points.push_back(section.horizons[1].line.points[i]);
    ring.closed = true;
    section.units.push_back({section::UnitId(0), "U", ring, {}});
    section.lines.push_back({section::LineId(0), section::LineKind::Fault, "F", test::parallel(top, 0.2), {}});
    const auto model = restored(section);
    ASSERT_TRUE(model) << to_string(model.error());
    const section::Section& after = model->restoration->section;
    for (const geom::Polyline& line : {after.horizons[0].line, after.horizons[1].line, after.horizons[2].line,
                                       after.units[0].contour, after.lines[0].line}) {
      for (std::size_t i = 0; i < line.segment_count(); ++i) EXPECT_GT(line.segment(i).length(), 1e-11) << depth;
    }
  }
}

TEST(Restore, ATornUnitIsToldWithThePlaceAndTheWidth) {
  const double pi = std::numbers::pi;
  section::Section section = test::section_of({test::cosine()});
  const auto unit = [&](double x) {  // at a crest it lies across the medial axis, in a trough beside it
    return section::Unit{section::UnitId(section.units.size()),
                         "U" + std::to_string(section.units.size()),
                         {{{x - 1, -2.2}, {x + 1, -2.2}, {x + 1, -2.0}, {x - 1, -2.0}}, true},
                         {}};
  };
  section.units.push_back(unit(pi));
  section.units.push_back(unit(2.0 * pi));
  section.units.push_back(unit(3.0 * pi));
  const auto model = restored(section);
  ASSERT_TRUE(model) << to_string(model.error());
  const std::vector<std::string>& remarks = model->restoration->remarks;
  const auto told = [&](const std::string& name) {
    return std::any_of(remarks.begin(), remarks.end(), [&](const std::string& remark) {
      return remark.find("unit '" + name + "' crosses the medial axis") == 0 &&
             remark.find("most at (") != std::string::npos;
    });
  };
  EXPECT_TRUE(told("U0"));
  EXPECT_FALSE(told("U1"));
  EXPECT_TRUE(told("U2"));
}

TEST(Restore, BedsAreOrderedByTheirDepthWhereBothAre) {
  // A wedge, and below it a short bed at its shallow end: the mean depth of that is less than that of the wedge.
  const geom::Polyline top{{{0, 0}, {1000, 0}}, false};
  const geom::Polyline wedge{{{0, -100}, {1000, -900}}, false};
  const auto below = [](double from, double to) {
    return geom::Polyline{{{from, -150 - 0.8 * from}, {to, -150 - 0.8 * to}}, false};
  };
  geom::Polyline dense = wedge;  // many points where it is deep
  for (int i = 1; i < 100; ++i) dense.points.insert(dense.points.end() - 1, {900.0 + i, -100 - 0.8 * (900.0 + i)});
  const auto names_of = [&](const std::vector<geom::Polyline>& lines) {
    const section::Section section = test::section_of(lines);
    const auto model = restored(section);
    EXPECT_TRUE(model) << to_string(model.error());
    std::vector<std::string> names;
    for (const section::HorizonId id : model->restoration->order) names.push_back(find_horizon(section, id)->name);
    return names;
  };
  const std::vector<std::string> as_given{"top", "bed1", "bed2"};
  EXPECT_EQ(names_of({top, wedge, below(0, 200)}), as_given);
  EXPECT_EQ(names_of({top, wedge, below(100, 300)}), as_given);
  EXPECT_EQ(names_of({top, dense, below(0, 1000)}), as_given);
  EXPECT_EQ(names_of({top, below(0, 200), wedge}), (std::vector<std::string>{"top", "bed2", "bed1"}));
  // Where two have nothing in common their mean depth says it.
  EXPECT_EQ(names_of({top, {{{0, -300}, {300, -300}}, false}, {{{500, -200}, {900, -200}}, false}}),
            (std::vector<std::string>{"top", "bed2", "bed1"}));
}

}  // namespace
}  // namespace recon::unfold
