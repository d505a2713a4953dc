// One definition of shortening for `balance` and `restore`: S = l0 - l1 over what two beds share.
#include "recon/balance/shortening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "recon/balance/area_depth.h"
#include "recon/core/grid_step.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "recon/section/section_faces.h"
#include "recon/unfold/restore.h"
#include "tests/recon/shapes.h"

namespace recon::balance {
namespace {

unfold::Restoration restored(const section::Section& section, unfold::RestoreMethod method) {
  model::Model model;
  model.section = section;
  unfold::GridParams grid;
  grid.count = 1;
  grid.uncovered = unfold::Uncovered::Continue;
  unfold::RestoreParams params;
  params.method = method;
  auto made = core::run_grid(model, grid, {}, {});
  EXPECT_TRUE(made) << to_string(made.error());
  made = core::run_target(*made, {}, {}, {});
  EXPECT_TRUE(made) << to_string(made.error());
  made = core::run_restore(*made, params, {}, {});
  EXPECT_TRUE(made) << to_string(made.error());
  return *made->restoration;
}

/// The greatest difference in percent, the same by `balance` and by every method of `restore`.
double agreed_percent(const section::Section& section) {
  const auto balance = area_depth(section, {});
  EXPECT_TRUE(balance);
  const double percent = balance->consistency.worst.percent;
  EXPECT_EQ(balance->verdict, percent <= 2.0 ? BalanceVerdict::Balanced : BalanceVerdict::NotBalanced);
  for (const unfold::RestoreMethod method :
       {unfold::RestoreMethod::Flexural, unfold::RestoreMethod::LineLength, unfold::RestoreMethod::Constant}) {
    const unfold::Restoration made = restored(section, method);
    EXPECT_DOUBLE_EQ(made.balance.consistency.worst.percent, percent);
    for (std::size_t i = 0; i < made.lengths.size(); ++i)
      EXPECT_DOUBLE_EQ(made.lengths[i].shortening, balance->beds[i].shortening);
    EXPECT_TRUE(balance->verdict == BalanceVerdict::Balanced || made.balance.verdict == BalanceVerdict::NotBalanced);
  }
  return percent;
}

geom::Polyline tent(double width, double length, double z, double side = 1.0) {
  const double height = std::sqrt(0.25 * (length * length - width * width));
  return {{{0, z}, {0.5 * width, z + side * height}, {width, z}}, false};
}

TEST(Shortening, BedsOf1000And1050MetresOverOneWidthAreNotBalanced) {
  const section::Section section = test::section_of({{{{0, 0}, {1000, 0}}, false}, tent(1000, 1050, -400)});
  EXPECT_NEAR(agreed_percent(section), 100.0 * 50.0 / 1050.0, 1e-9);
}

TEST(Shortening, ABedThatIsTooLongIsFoundBelowTwoThatAgree) {
  const section::Section section =
      test::section_of({{{{0, 0}, {1000, 0}}, false}, {{{0, -50}, {1000, -50}}, false}, tent(1000, 1030, -300)});
  EXPECT_NEAR(agreed_percent(section), 100.0 * 30.0 / 1030.0, 1e-9);
}

TEST(Shortening, AShortBedIsJudgedByWhatItShares) {
  geom::Polyline base = tent(200, 220, -200);
  for (geom::Point& p : base.points) p.x += 900.0;
  const section::Section section = test::section_of({{{{0, 0}, {2000, 0}}, false}, base});
  EXPECT_NEAR(agreed_percent(section), 100.0 * 20.0 / 220.0, 1e-9);
}

TEST(Shortening, ABedFoldedUnderAFlatOneOnATiltedRegionalIsNotBalanced) {
  section::Section section = test::section_of({{{{0, 0}, {1000, 0}}, false}, tent(1000, 1050, -400)});
  const double cosine = std::cos(0.2), sine = std::sin(0.2);
  for (section::Horizon& horizon : section.horizons)
    for (geom::Point& p : horizon.line.points) p = {cosine * p.x - sine * p.y, sine * p.x + cosine * p.y};
  EXPECT_NEAR(agreed_percent(section), 100.0 * 50.0 / 1050.0, 1e-9);
}

TEST(Shortening, BedsOfEqualLengthAndWidthAgreeHoweverTheyAreFolded) {
  const section::Section section = test::section_of({tent(1000, 1090, 0), tent(1000, 1090, -100, -1.0)});
  EXPECT_NEAR(agreed_percent(section), 0.0, 1e-9);
  const auto balance = area_depth(section, {});
  for (const BedBalance& bed : balance->beds) EXPECT_NEAR(bed.shortening, 90.0, 1e-9);
}

/// A fold train with flat flanks, and parallels below it.
geom::Polyline fold() { return {{{0, 0}, {800, 0}, {1200, 150}, {1500, 150}, {1900, 0}, {3000, 0}}, false}; }

TEST(Shortening, ASoundFoldWithBedsOfUnequalExtentIsBalanced) {
  const geom::Polyline top = fold();
  geom::Polyline left = test::parallel(top, 100.0);
  geom::Polyline right = test::parallel(top, 200.0);
  geom::Polyline limb = test::parallel(top, 300.0);
  left.points = {left.points[0], left.points[1], left.points[2], geom::midpoint(left.points[2], left.points[3])};
  right.points = {geom::midpoint(right.points[1], right.points[2]), right.points[2], right.points[3], right.points[4],
                  right.points[5]};
  limb.points = {geom::midpoint(limb.points[0], limb.points[1]), limb.points[1],
                 geom::midpoint(limb.points[1], limb.points[2])};
  const section::Section section = test::section_of({top, left, right, limb});
  EXPECT_LT(agreed_percent(section), 1.0);
  EXPECT_EQ(restored(section, unfold::RestoreMethod::Flexural).balance.verdict, BalanceVerdict::Balanced);
}

TEST(Shortening, FlatBedsOfAnyExtentAgreeExactly) {
  const section::Section section = test::section_of({{{{0, 0}, {2000, 0}}, false},
                                                     {{{800, -200}, {2000, -200}}, false},
                                                     {{{0, -300}, {1000, -300}}, false},
                                                     {{{1200, -400}, {1300, -400}}, false}});
  EXPECT_NEAR(agreed_percent(section), 0.0, 1e-12);
  EXPECT_EQ(restored(section, unfold::RestoreMethod::Flexural).balance.verdict, BalanceVerdict::Balanced);
}

TEST(Shortening, APieceCutOutOfABedChangesNoVerdict) {
  const geom::Polyline top = fold();
  const geom::Polyline bed = test::parallel(top, 150.0);
  section::Section section = test::section_of({top, bed, bed});
  section.horizons[1].line.points = {bed.points[0], bed.points[1],
                                     geom::interpolate(bed.points[1], bed.points[2], 0.3)};
  section.horizons[2].line.points = {geom::interpolate(bed.points[3], bed.points[4], 0.5), bed.points[4],
                                     bed.points[5]};
  section.horizons[1].piece_of = section.horizons[2].piece_of = "bed";
  EXPECT_LT(agreed_percent(section), 1.0);
  EXPECT_EQ(consistency_of(section.horizons).compared, 1u);
}

TEST(Shortening, NothingIsJudgedWhereNoTwoBedsShareAPart) {
  const geom::Polyline one = fold();
  geom::Polyline aside = one;  // a bed after the other, no part beside it
  for (geom::Point& p : aside.points) p = p + geom::Vector{1e5, -2e3};
  section::Section grown = test::section_of({one, test::parallel(one, 150.0)});
  grown.horizons[1].role = section::BedRole::Growth;
  for (const section::Section& section : {test::section_of({one}), test::section_of({one, aside}), grown}) {
    const AreaDepth balance = area_depth(section, {}).value();
    EXPECT_EQ(balance.consistency.compared, 0u);
    EXPECT_EQ(balance.verdict, BalanceVerdict::NotJudged);
    EXPECT_EQ(balance.remarks.front().rfind("nothing to judge: no two beds", 0), 0u) << balance.remarks.front();
  }
  for (const section::Section& section : {test::section_of({one}), grown}) {
    const unfold::Restoration made = restored(section, unfold::RestoreMethod::Flexural);
    EXPECT_EQ(made.balance.verdict, BalanceVerdict::NotJudged);
    EXPECT_EQ(made.remarks.back().rfind("nothing to judge: ", 0), 0u) << made.remarks.back();
  }
  // Shear takes the one bed from 1200 m to 1000 m: what is beyond the tolerance stays a no.
  const unfold::Restoration sheared = restored(test::section_of({tent(1000, 1200, 0)}), unfold::RestoreMethod::Shear);
  EXPECT_EQ(sheared.balance.verdict, BalanceVerdict::NotBalanced);
}

TEST(Shortening, WhatOnlyALineBetweenEndsOfBedsClosesIsNotJudged) {
  // The straight line from the top's right end to that of the short bed runs above the top.
  const geom::Polyline top{
      {{0, 0}, {500, -150}, {1300, 30}, {1900, 150}, {2600, 450}, {2900, 350}, {3400, 150}, {3800, 350}}, false};
  geom::Polyline bed = test::parallel(top, 130.0);
  bed.points = {bed.points[0], bed.points[1], bed.points[2], bed.points[3],
                geom::interpolate(bed.points[3], bed.points[4], 0.15)};
  section::Section section = test::section_of({top, bed});
  section.faces = std::make_shared<const section::SectionFaces>(faces_of(section).value());
  const auto above_top = [](const unfold::Restoration& made) {
    return *std::find_if(made.ledger.units.begin(), made.ledger.units.end(),
                         [](const UnitRow& row) { return row.name == "above top"; });
  };
  const unfold::Restoration open = restored(section, unfold::RestoreMethod::Flexural);
  EXPECT_EQ(above_top(open).role, section::BedRole::Outside);
  EXPECT_GT(std::abs(above_top(open).change_percent), 2.0);
  EXPECT_EQ(open.balance.verdict, BalanceVerdict::Balanced)
      << open.balance.worst_unit << " " << open.balance.greatest_area_change_percent;
  // Within a border that somebody drew it is rock.
  section.border = geom::Polyline{{{0, 0}, {0, -700}, {3800, -700}, {3800, 350}, {3800, 700}, {0, 700}}, true};
  section.faces = std::make_shared<const section::SectionFaces>(faces_of(section).value());
  EXPECT_EQ(above_top(restored(section, unfold::RestoreMethod::Flexural)).role, section::BedRole::Judged);
}

TEST(Shortening, GrowthIsListedAndNotJudged) {
  section::Section section =
      test::section_of({{{{0, 0}, {1000, 0}}, false}, tent(1000, 1050, -400), tent(1000, 1050, -600)});
  section.horizons[0].role = section::BedRole::Growth;
  EXPECT_LT(agreed_percent(section), 1e-9);
  const Consistency consistency = consistency_of(section.horizons);
  EXPECT_EQ(consistency.not_judged, std::vector<std::string>{"top"});
  EXPECT_EQ(consistency.compared, 1u);
  EXPECT_NE(consistency_text(consistency).find("not judged, as growth: 'top'"), std::string::npos);
  // A growth unit may gain what it likes.
  const unfold::Restoration made = restored(section, unfold::RestoreMethod::Flexural);
  ASSERT_EQ(made.ledger.units.size(), 2u);
  EXPECT_EQ(made.ledger.units[0].role, section::BedRole::Growth);
  EXPECT_EQ(made.balance.worst_unit, made.ledger.units[1].name);
}

}  // namespace
}  // namespace recon::balance
