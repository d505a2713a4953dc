// Beds of unequal extent: what is missing of a bed moves nothing of what remains.
#include "recon/unfold/full_bed.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "recon/core/grid_step.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "recon/unfold/restore.h"
#include "tests/recon/shapes.h"

namespace recon::unfold {
namespace {

base::Result<Restoration> restored(const section::Section& section, RestoreMethod method,
                                   std::optional<double> pin = {}, double percent = 100.0) {
  model::Model model;
  model.section = section;
  GridParams grid;
  grid.count = 1;
  grid.top = "top";
  grid.uncovered = Uncovered::Continue;
  TargetParams target;
  target.pin = pin;
  RestoreParams params;
  params.method = method;
  params.percent = percent;
  DOBRA_TRY(model, core::run_grid(model, grid, {}, {}));
  DOBRA_TRY(model, core::run_target(model, target, {}, {}));
  DOBRA_TRY(model, core::run_restore(model, params, {}, {}));
  return *model.restoration;
}

constexpr std::array bed_methods{RestoreMethod::Flexural, RestoreMethod::LineLength};

/// Between two arc lengths.
geom::Polyline cut(const geom::Polyline& line, double from, double to) {
  const std::vector<double> arc = geom::arc_lengths(line);
  geom::Polyline part;
  part.points.push_back(geom::point_at(line, arc, from));
  for (std::size_t i = 0; i < arc.size(); ++i)
    if (arc[i] > from && arc[i] < to) part.points.push_back(line.points[i]);
  part.points.push_back(geom::point_at(line, arc, to));
  return part;
}

/// Where the points of a restored whole line are that a part of it has: looked up by arc length.
geom::Point image_on(const maps::MappedLine& whole, geom::Point p) {
  for (std::size_t i = 0; i + 1 < whole.before.points.size(); ++i) {
    const geom::Segment segment{whole.before.points[i], whole.before.points[i + 1]};
    if (geom::distance(segment, p) > 1e-9) continue;
    const double part = geom::distance(segment.from, p) / geom::distance(segment.from, segment.to);
    return geom::interpolate(whole.after.points[i], whole.after.points[i + 1], part);
  }
  ADD_FAILURE() << "not on the line";
  return {};
}

void expect_same(const Restoration& all, std::size_t horizon, const maps::MappedLine& part, double size,
                 const std::string& what) {
  for (const std::size_t i : part.given) {
    EXPECT_LE(geom::distance(part.after.points[i], image_on(all.lines[horizon], part.before.points[i])), 1e-9 * size)
        << what << " at " << part.before.points[i];
  }
}

TEST(FullBed, AHalfBedStaysUnderItsHalfOfTheTop) {
  section::Section section = test::section_of({{{{0, 0}, {2000, 0}}, false}, {{{800, -200}, {2000, -200}}, false}});
  for (const RestoreMethod method : bed_methods) {
    for (const std::optional<double> pin : {std::optional<double>{}, {0.0}, {500.0}, {800.0}, {1300.0}, {2000.0}}) {
      const auto flat = restored(section, method, pin);
      ASSERT_TRUE(flat) << to_string(flat.error());
      const std::vector<geom::Point> base = test::given_images(flat->lines[1]);
      EXPECT_LT(geom::distance(base.front(), {800, -200}), 1e-9) << method_name(method);
      EXPECT_LT(geom::distance(base.back(), {2000, -200}), 1e-9) << method_name(method);
      // What lies between the two is not sheared.
      EXPECT_LT(geom::distance(flat->map.forward(geom::Point{1500, -100}).at, {1500, -100}), 1e-9);
      EXPECT_LT(geom::distance(flat->map.forward(geom::Point{900, -150}).at, {900, -150}), 1e-9);
      EXPECT_EQ(flat->balance.verdict, balance::BalanceVerdict::Balanced);
    }
  }
}

TEST(FullBed, TheEndOfABedGoesToTheIntegralAlongTheBedAboveIt) {
  // A kink of 40 degrees at x = 1000; the base begins behind it: X = s - 2 h tan 20.
  const double turn = 40.0 * std::numbers::pi / 180.0;
  const geom::Vector limb{std::cos(turn), -std::sin(turn)};
  const geom::Vector down{-std::sin(turn), -std::cos(turn)};
  const geom::Point kink{1000, 0};
  const double h = 150.0;
  section::Section section =
      test::section_of({{{{0, 0}, kink, kink + 1500.0 * limb}, false},
                        {{kink + 700.0 * limb + h * down, kink + 1500.0 * limb + h * down}, false}});
  for (const RestoreMethod method : bed_methods) {
    const auto flat = restored(section, method, 0.0);
    ASSERT_TRUE(flat) << to_string(flat.error());
    const double x = 1700.0 - 2.0 * h * std::tan(0.5 * turn);
    const std::vector<geom::Point> base = test::given_images(flat->lines[1]);
    EXPECT_LT(geom::distance(base.front(), {x, -h}), 1e-9);
    EXPECT_LT(geom::distance(base.back(), {x + 800.0, -h}), 1e-9);
  }
}

/// A fold of straight pieces, with three parallels far from where they would close.
std::vector<geom::Polyline> random_fold(std::mt19937& random, double& size) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  geom::Polyline top{{{0, 0}}, false};
  for (int i = 0; i < 9; ++i) {
    const double dip = (unit(random) - 0.5) * 1.2;
    const double length = 300.0 + 500.0 * unit(random);
    top.points.push_back(top.points.back() + length * geom::Vector{std::cos(dip), std::sin(dip)});
  }
  size = top.box().diagonal();
  return {top, test::parallel(top, 60.0), test::parallel(top, 130.0), test::parallel(top, -50.0)};
}

TEST(FullBed, CuttingAnyPartOffABedOfAParallelFoldMovesNothingOfWhatRemains) {
  const char* cases = std::getenv("DOBRA_RANDOM_CASES");
  const unsigned most = cases != nullptr ? static_cast<unsigned>(std::stoul(cases)) : 40;
  for (unsigned seed = 1; seed <= most; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    double size = 0.0;
    const std::vector<geom::Polyline> lines = random_fold(random, size);
    section::Section section = test::section_of(lines);
    const section::Section whole = section;
    // At an end of the top, at one of its corners, or anywhere.
    const geom::Polyline& top = lines.front();
    const double pin = seed % 5 == 0   ? top.points.front().x
                       : seed % 5 == 1 ? top.points.back().x
                       : seed % 5 == 2 ? top.points[4].x
                                       : (0.1 + 0.8 * unit(random)) * top.points.back().x;
    std::vector<std::vector<std::size_t>> kept{{0}, {}, {}, {}};
    for (std::size_t bed = 1; bed < lines.size(); ++bed) {
      const double length = geom::length(lines[bed]);
      double from = 0.7 * unit(random), to = from + (1.0 - from) * (0.2 + 0.8 * unit(random));
      if (unit(random) < 0.3) from = 0.0;
      if (unit(random) < 0.3) to = 1.0;
      section.horizons[bed].line = cut(lines[bed], from * length, to * length);
      kept[bed].push_back(bed);
      if (unit(random) < 0.6) continue;
      const double a = from + (to - from) * (0.1 + 0.4 * unit(random)), b = a + (to - a) * (0.1 + 0.6 * unit(random));
      section.horizons[bed].line = cut(lines[bed], from * length, a * length);
      section::Horizon second = section.horizons[bed];
      second.line = cut(lines[bed], b * length, to * length);
      second.id = section::HorizonId(section.horizons.size());
      second.piece_of = section.horizons[bed].piece_of = second.name;
      section.horizons[bed].name += " (1)";
      second.name += " (2)";
      kept[bed].push_back(section.horizons.size());
      section.horizons.push_back(second);
    }
    for (const RestoreMethod method : bed_methods) {
      for (const double percent : {100.0, 40.0}) {
        if (percent < 100.0 && method == RestoreMethod::LineLength) continue;  // bends about the pin of each line
        const auto all = restored(whole, method, pin, percent);
        const auto part = restored(section, method, pin, percent);
        const std::string what = fmt::format("seed {} {} {}", seed, method_name(method), percent);
        ASSERT_TRUE(all) << what << to_string(all.error());
        ASSERT_TRUE(part) << what << to_string(part.error());
        for (std::size_t bed = 0; bed < kept.size(); ++bed) {
          for (const std::size_t k : kept[bed]) expect_same(*all, bed, part->lines[k], size, what);
        }
      }
    }
  }
}

/// An anticline with a gap over its crest: the bed is eroded there, and the pin stands in the gap.
TEST(FullBed, PiecesOnBothSidesOfAPinInTheirGapAreLaidOutEachAtItsOwnDepth) {
  const geom::Polyline top{{{0, 0}, {1000, 0}, {1400, 300}, {1800, 0}, {3000, 0}}, false};
  const geom::Polyline bed = test::parallel(top, 200.0);
  const geom::Polyline deeper = test::parallel(top, 260.0);
  section::Section section = test::section_of({top, bed, bed});
  section.horizons[1].line.points = {bed.points[0], bed.points[1]};
  section.horizons[2].line.points = {deeper.points[3], deeper.points[4]};
  section.horizons[1].name = "bed (1)";
  section.horizons[2].name = "bed (2)";
  section.horizons[1].piece_of = section.horizons[2].piece_of = "bed";
  // X = s - 2 h tan(t/2) over each kink between the pin (the crest) and the end.
  const double turn = std::atan2(300, 400);
  const double limb = 500.0;
  const auto flat = restored(section, RestoreMethod::Flexural, 1400.0);
  ASSERT_TRUE(flat) << to_string(flat.error());
  const double crest = std::tan(turn), foot = std::tan(0.5 * turn);  // half of the crest's turn 2 t lies on each side
  const double left = 1400.0 - (limb - 200.0 * crest + 200.0 * foot);
  const double right = 1400.0 + (limb - 260.0 * crest + 260.0 * foot);
  EXPECT_LT(geom::distance(flat->lines[1].after.points.back(), {left, 300.0 - 200.0}), 1e-9);
  EXPECT_LT(geom::distance(flat->lines[2].after.points.front(), {right, 300.0 - 260.0}), 1e-9);
  EXPECT_EQ(flat->remarks.front().find("horizon 'bed' does not reach the pin"), 0u) << flat->remarks.front();
}

TEST(FullBed, ABedThatPinchesOutOnTheTopEndsWhereItDoes) {
  // The top itself stands for what is missing: the integral of 1 - kappa 0.
  const geom::Polyline top{{{0, 0}, {1000, 0}, {1400, 300}, {3000, 300}}, false};
  section::Section section = test::section_of({top, {{{1800, 300}, {2000, 250}, {3000, 250}}, false}});
  for (const RestoreMethod method : bed_methods) {
    const auto flat = restored(section, method, 0.0);
    ASSERT_TRUE(flat) << to_string(flat.error());
    EXPECT_LT(geom::distance(flat->lines[1].after.points.front(), {1900, 0}), 1e-9) << method_name(method);
    EXPECT_NEAR(flat->lengths[1].length_after, flat->lengths[1].length_before, 1e-9);
  }
}

TEST(FullBed, OverturnedBedsAreCutLikeOthers) {
  // Both limbs of the second fold dip the same way. The third parallel begins on the overturned limb.
  const geom::Polyline top{{{0, 0}, {2000, 0}, {3500, 900}, {3000, -900}, {5000, -1200}, {8000, -1200}}, false};
  const geom::Polyline bed = test::parallel(top, 100.0);
  for (const double from : {0.2, 0.45, 0.7}) {
    for (const double pin : {1000.0, 6000.0}) {
      section::Section section = test::section_of({top, bed, test::parallel(top, 160.0)});
      const auto all = restored(section, RestoreMethod::Flexural, pin);
      section.horizons[1].line = cut(bed, from * geom::length(bed), 0.9 * geom::length(bed));
      const auto part = restored(section, RestoreMethod::Flexural, pin);
      ASSERT_TRUE(all && part) << to_string((all ? part : all).error());
      for (const std::size_t h : {0u, 1u, 2u})
        expect_same(*all, h, part->lines[h], 1e4, fmt::format("{} {}", from, pin));
    }
  }
}

TEST(FullBed, ABentTargetMovesNothingOfWhatRemainsEither) {
  std::mt19937 random(77);
  double size = 0.0;
  const std::vector<geom::Polyline> lines = random_fold(random, size);
  section::Section section = test::section_of(lines);
  model::Model model;
  model.section = section;
  GridParams grid;
  grid.count = 1;
  TargetParams target;
  target.shape = TargetShape::Line;
  target.points = {{-4000, 100}, {1200, 0}, {2500, 300}, {9000, 0}};
  target.pin = 1500.0;
  target.target_pin = geom::Point{1200, 0};
  RestoreParams params;
  params.method = RestoreMethod::Flexural;
  const auto run = [&] {
    return core::run_restore(*core::run_target(*core::run_grid(model, grid, {}, {}), target, {}, {}), params, {}, {});
  };
  const auto all = run();
  model.section.horizons[2].line = cut(lines[2], 0.55 * geom::length(lines[2]), 0.8 * geom::length(lines[2]));
  const auto part = run();
  ASSERT_TRUE(all && part);
  for (const std::size_t h : {0u, 1u, 2u, 3u})
    expect_same(*all->restoration, h, part->restoration->lines[h], size, "bent");
  for (const balance::UnitRow& row : part->restoration->ledger.units)
    EXPECT_NEAR(row.area_after, row.area_before, 0.01 * row.area_before) << row.name;
}

TEST(DefaultPin, StandsAtTheLeftmostPlaceWhereAllBedsAre) {
  const auto place = [](const std::vector<geom::Polyline>& lines) {
    model::Model model;
    model.section = test::section_of(lines);
    GridParams grid;
    grid.count = 1;
    grid.top = "top";
    const auto made = core::run_target(*core::run_grid(model, grid, {}, {}), {}, {}, {});
    EXPECT_TRUE(made) << to_string(made.error());
    return *made->target;
  };
  const geom::Polyline top{{{0, 0}, {2000, 0}}, false};
  const Target left = place({top, {{{0, -100}, {2000, -100}}, false}});
  EXPECT_EQ(left.source_pin, (geom::Point{0, 0}));
  EXPECT_TRUE(left.remarks.empty());
  const Target all = place({top, {{{0, -100}, {1500, -100}}, false}, {{{800, -200}, {2000, -200}}, false}});
  EXPECT_EQ(all.source_pin, (geom::Point{800, 0}));
  // No place has both: the first that has as many as any, which is said.
  const Target most = place({top,
                             {{{0, -100}, {500, -100}}, false},
                             {{{700, -150}, {2000, -150}}, false},
                             {{{900, -200}, {2000, -200}}, false}});
  EXPECT_EQ(most.source_pin, (geom::Point{900, 0}));
  ASSERT_EQ(most.remarks.size(), 1u);
  EXPECT_NE(most.remarks.front().find("1 of them are not: 'bed1'"), std::string::npos) << most.remarks.front();
  // Above the top, which is then travelled from the right.
  const Target above = place({top, {{{300, 100}, {2000, 100}}, false}, {{{600, 200}, {2000, 200}}, false}});
  EXPECT_NEAR(above.source_pin.x, 600.0, 1e-9);
}

TEST(FullBed, AGrowthBedIsNoModelForAGapInAnOlderBed) {
  // An older bed that dips by 30 degrees, with a gap, under a growth bed that dips by 6, under an older bed again.
  const double dip = std::tan(std::numbers::pi / 6.0);
  const auto line = [](double z, double slope, double from, double to) {
    return geom::Polyline{{{from, z - slope * from}, {to, z - slope * to}}, false};
  };
  section::Section section =
      test::section_of({line(0, dip, 0, 2000), line(-1000, 0.1, 0, 2000), line(-1300, dip, 0, 800),
                        line(-1300, dip, 1200, 2000), line(-1300, dip, 0, 2000)});
  section.horizons[1].role = section::BedRole::Growth;
  for (const std::size_t i : {2u, 3u}) section.horizons[i].piece_of = "bed";
  const auto with = [&](std::vector<std::size_t> kept) {
    section::Section some;
    for (const std::size_t i : kept) some.horizons.push_back(section.horizons[i]);
    some.horizons.front().name = "top";
    for (std::size_t i = 0; i < kept.size(); ++i) some.horizons[i].id = section::HorizonId(i);
    return some;
  };
  for (const RestoreMethod method : bed_methods) {
    // Under the older top the pieces go where the whole bed goes, whatever lies between.
    const auto whole = restored(with({0, 4}), method, 0.0);
    const auto cut = restored(with({0, 1, 2, 3}), method, 0.0);
    ASSERT_TRUE(whole && cut) << to_string(cut.error());
    for (const std::size_t i : {2u, 3u}) expect_same(*whole, 1, cut->lines[i], 2000.0, method_name(method));
    // Under a growth bed alone nothing says how long the gap is.
    const auto alone = restored(with({1, 2, 3}), method, 0.0);
    ASSERT_FALSE(alone);
    EXPECT_NE(to_string(alone.error()).find("growth bed"), std::string::npos) << to_string(alone.error());
  }
}

TEST(FullBed, ATopThatGoesOnStraightIsTold) {
  section::Section section = test::section_of({{{{0, 0}, {1000, 0}}, false}, {{{-40, -100}, {1030, -100}}, false}});
  const auto made = restored(section, RestoreMethod::Flexural, 500.0);
  ASSERT_TRUE(made);
  const auto tells = [&](const std::string& what) {
    return std::any_of(made->remarks.begin(), made->remarks.end(),
                       [&](const std::string& remark) { return remark.find(what) != std::string::npos; });
  };
  EXPECT_TRUE(tells("goes on straight for 40 m from its end at (0, 0)"));
  EXPECT_TRUE(tells("goes on straight for 30 m from its end at (1000, 0)"));
}

}  // namespace
}  // namespace recon::unfold
