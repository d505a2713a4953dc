// The chain of stages: a second grid on the restored section, points and lines carried along it, ledgers between
// states. Expectations are closed forms (a circle unrolled and rolled up again) or the identity of going there and
// back.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "recon/core/carry_step.h"
#include "recon/core/grid_step.h"
#include "recon/core/operations.h"
#include "recon/core/report.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "recon/model/chain.h"
#include "shared/geom/contour.h"
#include "tests/recon/shapes.h"

namespace recon::core {
namespace {

using testing::Contains;
using testing::HasSubstr;

base::Result<model::Model> turn(const model::Model& model, const unfold::TargetParams& target,
                                const unfold::RestoreParams& restore = {}, const unfold::GridParams& grid = {}) {
  DOBRA_TRY(const model::Model with_grid, run_grid(model, grid, {}, {}));
  DOBRA_TRY(const model::Model with_target, run_target(with_grid, target, {}, {}));
  return run_restore(with_target, restore, {}, {});
}

/// The section of the input, unrolled to z = 0 and then rolled onto the given line.
base::Result<model::Model> there_and_onto(const section::Section& section, const geom::Polyline& line,
                                          const unfold::RestoreParams& restore = {}) {
  model::Model model;
  model.section = section;
  unfold::TargetParams flat;
  flat.target_pin = geom::Point{section.horizons.front().line.points.front().x, 0.0};
  flat.pin = section.horizons.front().line.points.front().x;
  DOBRA_TRY(const model::Model first, turn(model, flat, restore));
  unfold::TargetParams back;
  back.shape = unfold::TargetShape::Line;
  back.points = line.points;
  back.pin = first.restoration->section.horizons.front().line.points.front().x;
  back.target_pin = line.points.front();
  return turn(first, back, restore);
}

section::Section fold() {
  const geom::Polyline top = test::cosine();
  section::Section section = test::section_of({top, test::parallel(top, 0.3), test::parallel(top, 0.6)});
  section.lines.push_back({section::LineId(0), section::LineKind::Fault, "F", {{{2.0, 0.1}, {2.6, -0.6}}, false}, {}});
  section.markers.push_back({section::MarkerId(0), "pick", {{5.0, -0.6}}, {}});
  return section;
}

TEST(Chain, FlattenedAndFoldedAgainEverythingIsWhereItWas) {
  const section::Section section = fold();
  for (const unfold::RestoreMethod method :
       {unfold::RestoreMethod::Constant, unfold::RestoreMethod::Flexural, unfold::RestoreMethod::Variable}) {
    SCOPED_TRACE(static_cast<int>(method));
    unfold::RestoreParams restore;
    restore.method = method;
    const auto model = there_and_onto(section, section.horizons.front().line, restore);
    ASSERT_TRUE(model) << to_string(model.error());
    ASSERT_EQ(model->earlier.size(), 1U);
    const section::Section& last = model->restoration->section;
    ASSERT_EQ(last.horizons.size(), section.horizons.size());
    for (std::size_t h = 0; h < section.horizons.size(); ++h) {
      EXPECT_EQ(last.horizons[h].name, section.horizons[h].name);
      EXPECT_EQ(last.horizons[h].id, section.horizons[h].id);
      for (const geom::Point p : last.horizons[h].line.points)
        EXPECT_LT(geom::distance(section.horizons[h].line, p), 1e-4) << h;  // chords of a curve that is bent and back
      EXPECT_LT(geom::distance(last.horizons[h].line.points.front(), section.horizons[h].line.points.front()), 1e-9);
      EXPECT_LT(geom::distance(last.horizons[h].line.points.back(), section.horizons[h].line.points.back()), 1e-9);
    }
    // Between the beds flexural slip back is another map than its inverse: each bed keeps the length that it then has.
    const double near = method == unfold::RestoreMethod::Flexural ? 1e-4 : 1e-9;
    EXPECT_LT(geom::distance(last.markers[0].points[0], {5.0, -0.6}), near);
    EXPECT_LT(geom::distance(last.lines[0].line.points[0], {2.0, 0.1}), near);
    const auto chain = restored_stages(*model);
    for (const geom::Point p : {geom::Point{5.0, -0.6}, geom::Point{3.1, 0.75}, geom::Point{9.4, 0.7}}) {
      EXPECT_LT(carry(chain, 0, 2, p).misses, 1e-9);
      EXPECT_LT(geom::distance(carry(chain, 2, 0, carry(chain, 0, 2, p).at).at, p), 1e-9);
    }
  }
}

/// A block of layers under a quarter circle; unrolled, then rolled onto a circle of another radius: r -> r2 - (r1 - r),
/// the angle by the ratio of the radii (of the polygons that stand for the circles: to their chords).
TEST(Chain, PointsGoThroughTwoRestorationsAsTheClosedFormSays) {
  const geom::Polyline top = test::arc(10.0);
  geom::Polyline wide;
  for (const geom::Point p : top.points) wide.points.push_back({2.0 * p.x, 2.0 * p.y});
  const section::Section section = test::section_of({top, test::parallel(top, 1.0), test::parallel(top, 2.0)});
  const auto model = there_and_onto(section, wide);
  ASSERT_TRUE(model) << to_string(model.error());
  const auto chain = restored_stages(*model);
  ASSERT_EQ(chain.size(), 2U);
  for (const double turned : {5.0, 30.0, 61.0, 88.0}) {
    const double a = (135.0 - turned) * std::numbers::pi / 180.0;
    const double b = (135.0 - 0.5 * turned) * std::numbers::pi / 180.0;
    for (const double depth : {0.2, 1.3}) {
      const geom::Point p{(10.0 - depth) * std::cos(a), (10.0 - depth) * std::sin(a)};
      const model::CarriedPoint carried = carry(chain, 0, 2, p);
      const geom::Point expected{(20.0 - depth) * std::cos(b), (20.0 - depth) * std::sin(b)};
      EXPECT_LT(geom::distance(carried.at, expected), 5e-3);  // 64 chords of 90 degrees
      EXPECT_LT(carried.misses, 1e-9);
      EXPECT_LT(geom::distance(carry(chain, 2, 0, carried.at).at, p), 1e-9);
      EXPECT_LT(geom::distance(carry(chain, 1, 2, carry(chain, 0, 1, p).at).at, carried.at), 1e-12);
      EXPECT_LT(geom::distance(carry(chain, 2, 1, carried.at).at, carry(chain, 0, 1, p).at), 1e-9);
    }
  }
}

TEST(Chain, LinesAndPolygonsComeBack) {
  const section::Section section = fold();
  const auto model = there_and_onto(section, test::arc(20.0));
  ASSERT_TRUE(model) << to_string(model.error());
  const auto chain = restored_stages(*model);
  const geom::Polyline triangle{{{3.0, 0.6}, {3.4, 0.6}, {3.2, 0.8}}, true};
  const geom::Polyline there = carry(chain, 0, 2, triangle);
  EXPECT_TRUE(there.closed);
  const geom::Polyline back = carry(chain, 2, 0, there);
  for (const geom::Point p : triangle.points) EXPECT_LT(geom::distance(back, p), 1e-9);
  EXPECT_NEAR(geom::signed_area(back), geom::signed_area(triangle), 1e-6);
}

TEST(Chain, TheLedgerComparesAnyTwoStates) {
  const section::Section section = fold();
  const auto model = there_and_onto(section, section.horizons.front().line);
  ASSERT_TRUE(model) << to_string(model.error());
  const auto chain = restored_stages(*model);
  const model::Comparison first = compare(chain, 0, 1);
  const model::Comparison second = compare(chain, 1, 2);
  const model::Comparison whole = compare(chain, 0, 2);
  ASSERT_EQ(whole.beds.size(), 3U);
  ASSERT_EQ(whole.units.size(), 2U);
  EXPECT_GT(std::abs(first.beds[2].change_percent()), 0.1);  // constant thickness does not keep the length of a bed
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(first.beds[i].after, second.beds[i].before, 1e-9);
    EXPECT_NEAR(whole.beds[i].change_percent(), 0.0, 1e-4);
  }
  for (const model::Compared& unit : whole.units) EXPECT_NEAR(unit.change_percent(), 0.0, 1e-4);
}

TEST(Chain, ATargetOrRestorationAfterARestorationDoesTheSameStageAgain) {
  model::Model model;
  model.section = fold();
  const auto first = turn(model, {});
  ASSERT_TRUE(first) << to_string(first.error());
  unfold::RestoreParams flexural;
  flexural.method = unfold::RestoreMethod::Flexural;
  const auto again = run_restore(*first, flexural, {}, {});
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_TRUE(again->earlier.empty());
  const auto once = turn(model, {}, flexural);
  ASSERT_TRUE(once);
  for (std::size_t h = 0; h < 3; ++h)
    EXPECT_EQ(again->restoration->section.horizons[h].line, once->restoration->section.horizons[h].line);
}

TEST(Chain, AGridFromTheInputBeginsAnew) {
  model::Model model;
  model.section = fold();
  const auto first = turn(model, {});
  ASSERT_TRUE(first) << to_string(first.error());
  unfold::GridParams from_input;
  from_input.from = unfold::GridFrom::Input;
  const auto second = turn(*first, {}, {}, from_input);
  ASSERT_TRUE(second) << to_string(second.error());
  EXPECT_TRUE(second->earlier.empty());
  for (std::size_t h = 0; h < 3; ++h)
    EXPECT_EQ(second->restoration->section.horizons[h].line, first->restoration->section.horizons[h].line);
  const auto third = turn(*turn(*first, {}), {}, {}, from_input);  // also from the second turn on
  ASSERT_TRUE(third);
  EXPECT_TRUE(third->earlier.empty());
}

TEST(Chain, TheSectionOfTheNextStageHasItsBedsFromLeftToRightWhateverTheTarget) {
  model::Model model;
  model.section = fold();
  unfold::TargetParams reversed;
  reversed.shape = unfold::TargetShape::Line;
  reversed.direction = unfold::TargetDirection::AsGiven;
  reversed.points = {{30.0, 5.0}, {0.0, 5.0}};
  reversed.target_pin = geom::Point{20.0, 5.0};
  const auto first = turn(model, reversed);
  ASSERT_TRUE(first) << to_string(first.error());
  const auto next = run_grid(*first, {}, {}, {});
  ASSERT_TRUE(next) << to_string(next.error());
  for (const section::Horizon& horizon : next->section.horizons)
    EXPECT_LT(horizon.line.points.front().x, horizon.line.points.back().x);
}

TEST(Chain, AHorizonThatCrossesItselfAfterARestorationIsRefusedWithItsPlace) {
  model::Model model;
  const geom::Polyline top{{{0, 0}, {10, 0}}, false};
  model.section = test::section_of({top, {{{0, -4}, {10, -4}}, false}});
  unfold::TargetParams cusp;  // a target whose parallel at depth 4 turns back on itself
  cusp.shape = unfold::TargetShape::Line;
  for (int i = 0; i <= 20; ++i) {
    const double a = std::numbers::pi * (1.0 + i / 20.0);
    cusp.points.push_back({3.2 * std::cos(a), 3.2 * std::sin(a)});
  }
  cusp.target_pin = cusp.points.front();
  cusp.pin = 0.0;
  model::Model stage = model;
  const auto first = turn(model, cusp);
  ASSERT_TRUE(first) << to_string(first.error());
  const geom::Polyline crossed{{{0, 0}, {4, 0}, {4, 2}, {2, -2}}, false};
  stage = *first;
  stage.restoration->section.horizons[1].line = crossed;
  const auto next = run_grid(stage, {}, {}, {});
  ASSERT_FALSE(next);
  EXPECT_THAT(next.error().message, HasSubstr("crosses itself after the restoration"));
  EXPECT_THAT(to_string(next.error()), HasSubstr("bed1"));
  unfold::GridParams from_input;
  from_input.from = unfold::GridFrom::Input;
  EXPECT_TRUE(run_grid(stage, from_input, {}, {}));
}

TEST(Chain, WhatIsCarriedIsListedAndDoubtIsTold) {
  model::Model model;
  model.section = fold();
  const auto first = turn(model, {});
  ASSERT_TRUE(first) << to_string(first.error());
  model::CarryParams carry;
  carry.points = {{3.0, 0.5}, {9.0, 0.4}};
  const auto lines = run_carry(*first, carry, {}, {});
  ASSERT_TRUE(lines) << to_string(lines.error());
  ASSERT_EQ(lines->findings.all<model::CarriedLines>().at(0)->lines.size(), 1U);
  EXPECT_TRUE(lines->findings.all<model::CarriedLines>().at(0)->remarks.empty());
  carry.points = {{2.0 * std::numbers::pi, -50.0}};  // far below the centres of the synclines
  const auto point = run_carry(*first, carry, {}, {});
  ASSERT_TRUE(point) << to_string(point.error());
  carry.points = {};
  EXPECT_FALSE(run_carry(*first, carry, {}, {}));
  carry.points = {{1.0, 0.0}};
  carry.to = 2;
  const auto beyond = run_carry(*first, carry, {}, {});
  ASSERT_FALSE(beyond);
  EXPECT_THAT(beyond.error().message, HasSubstr("state from 0 to 1"));
  EXPECT_FALSE(run_carry(model, carry, {}, {}));
}

TEST(Chain, PolygonsGoAlong) {
  section::Section section = fold();
  const geom::Polyline upper = section.horizons[0].line;
  const geom::Polyline lower = section.horizons[1].line;
  section.units.push_back({section::UnitId(0), "U", contour_between(upper, lower), {}});
  section.units.push_back({section::UnitId(1), "box", {{{3.0, 0.5}, {3.3, 0.5}, {3.3, 0.7}, {3.0, 0.7}}, true}, {}});
  const double area = geom::signed_area(section.units[1].contour);
  const auto model = there_and_onto(section, section.horizons.front().line);
  ASSERT_TRUE(model) << to_string(model.error());
  const section::Section& last = model->restoration->section;
  ASSERT_EQ(last.units.size(), 2U);
  for (const geom::Point p : {geom::Point{3.0, 0.5}, geom::Point{3.3, 0.7}})
    EXPECT_LT(geom::distance(last.units[1].contour, p), 1e-9);
  EXPECT_NEAR(geom::signed_area(last.units[1].contour), area, 1e-6);
}

TEST(Chain, EveryCarryIsKeptUntilItsStateIsRestoredAnew) {
  model::Model model;
  model.section = fold();
  const auto first = turn(model, {});
  ASSERT_TRUE(first) << to_string(first.error());
  model::CarryParams one;
  one.points = {{3.0, 0.5}, {9.0, 0.4}};
  one.as = model::CarryAs::Points;
  const auto once = run_carry(*first, one, {}, {});
  ASSERT_TRUE(once) << to_string(once.error());
  EXPECT_EQ(once->findings.all<model::CarriedLines>().at(0)->lines.size(), 2U);
  const auto twice = run_carry(*once, one, {}, {});
  ASSERT_TRUE(twice);
  EXPECT_EQ(twice->findings.all<model::CarriedLines>().size(), 2U);
  const auto second = turn(*twice, {});
  ASSERT_TRUE(second) << to_string(second.error());
  EXPECT_EQ(second->findings.all<model::CarriedLines>().size(), 2U);
  const auto third = run_carry(*second, one, {}, {});
  ASSERT_TRUE(third);
  EXPECT_EQ(third->findings.all<model::CarriedLines>().size(), 3U);
  const auto again = run_restore(*third, {}, {}, {});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->findings.all<model::CarriedLines>().size(), 2U);  // the third went to the state that is new now
  EXPECT_EQ(run_restore(*once, {}, {}, {})->findings.all<model::CarriedLines>().size(), 0U);
  one.points = {{-400.0, 0.0}};
  EXPECT_THAT(run_carry(*first, one, {}, {})->findings.all<model::CarriedLines>().at(0)->remarks,
              Contains(HasSubstr("outside the section")));
}

/// Each stage keeps within the tolerance what the chain as a whole does not.
TEST(Chain, TheVerdictSinceTheInputIsNoWhereTheStagesAddUp) {
  model::Model model;
  model.section = fold();
  unfold::RestoreParams part;  // constant thickness, which changes bed2 by 0.39 % on the whole way
  part.tolerance = 0.3;
  part.percent = 50.0;
  const auto half = turn(model, {}, part);
  ASSERT_TRUE(half) << to_string(half.error());
  part.percent = 100.0;
  const auto whole = turn(*half, {}, part);
  ASSERT_TRUE(whole) << to_string(whole.error());
  EXPECT_EQ(half->restoration->balance.verdict, balance::BalanceVerdict::Balanced);
  const auto chain = restored_stages(*whole);
  const model::Comparison all = compare(chain, 0, 2);
  const model::ChainVerdict verdict = judge(all, 0.3);
  ASSERT_NE(verdict.bed, nullptr);
  EXPECT_EQ(verdict.bed->name, "bed2");
  EXPECT_NEAR(std::abs(verdict.bed->change_percent()), 0.386712, 1e-3);
  EXPECT_FALSE(verdict.balanced);
  EXPECT_TRUE(judge(all, 5.0).balanced);
  EXPECT_THAT(program().remarks_of(dobra::scenario::make_state(*whole)),
              Contains(HasSubstr("since the input: not balanced")));
  EXPECT_EQ(verdict_since_input(restored_stages(*half)), "");
}

TEST(Chain, TablesOfTheSecondStageTellWhatChangedSinceTheInput) {
  const section::Section section = fold();
  const auto model = there_and_onto(section, section.horizons.front().line);
  ASSERT_TRUE(model) << to_string(model.error());
  std::vector<std::string> names;
  for (const auto& table : program().tables_of(dobra::scenario::make_state(*model))) names.push_back(table.name);
  EXPECT_THAT(names, Contains("stages"));
  std::vector<std::string> quantities;
  for (const auto& quantity : program().quantities_of(dobra::scenario::make_state(*model)))
    quantities.push_back(quantity.name);
  EXPECT_THAT(quantities, Contains("since_input.horizon.bed1.change_percent"));
}

}  // namespace
}  // namespace recon::core
