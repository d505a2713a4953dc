#include "recon/maps/area_change.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "recon/core/grid_step.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "shared/geom/contour.h"
#include "tests/recon/shapes.h"

namespace recon::maps {
namespace {

using std::numbers::pi;

model::Model restored(const std::vector<geom::Polyline>& lines, const unfold::RestoreParams& params,
                      const std::vector<geom::Point>& target = {}) {
  model::Model model;
  model.section = test::section_of(lines);
  unfold::GridParams grid;
  grid.uncovered = unfold::Uncovered::Continue;
  unfold::TargetParams goal;
  if (!target.empty()) goal.shape = unfold::TargetShape::Line;
  goal.points = target;
  goal.pin = 0.5 * (lines[0].points.front().x + lines[0].points.back().x);
  auto with_grid = core::run_grid(model, grid, {}, {});
  auto with_target = core::run_target(*with_grid, goal, {}, {});
  auto made = core::run_restore(*with_target, params, {}, {});
  EXPECT_TRUE(made) << to_string(made.error());
  return std::move(*made);
}

unfold::RestoreParams by(unfold::RestoreMethod method) {
  unfold::RestoreParams params;
  params.method = method;
  params.outside = unfold::Doubt::Nearest;
  return params;
}

TEST(AreaChange, OfConcentricBedsIsTheRatioOfTheirRadii) {
  // All chords touch a circle of radius r; a parallel at depth d touches one of r - d: det F = r / (r - d) down there.
  const double r = 10.0 * std::cos(pi / 256.0);
  for (const double depth : {0.5, 2.0, 6.0}) {
    const model::Model model =
        restored({test::arc(), test::parallel(test::arc(), depth)}, by(unfold::RestoreMethod::Constant));
    const balance::Range range = *model.restoration->ledger.units[0].dilatation;
    EXPECT_NEAR(range.greatest, r / (r - depth) - 1.0, 1e-9);
    EXPECT_NEAR(range.least, 0.0, 1e-9);
    const geom::Point at = model.restoration->ledger.units[0].greatest_at;
    EXPECT_NEAR(std::hypot(at.x, at.y), r - depth, 0.02 * depth);
  }
}

TEST(AreaChange, OfAWedgeByProportionalThicknessIsThatOfItsEnds) {
  // A wedge of 100 to 300 m over 1000 m, made as thick as its mean everywhere: det F = 200 / thickness, whatever the
  // place along and down: least at the thick end, greatest at the thin one.
  const geom::Polyline top{{{0, 0}, {1000, 0}}, false};
  const geom::Polyline base{{{0, -100}, {1000, -300}}, false};
  const model::Model model = restored({top, base}, by(unfold::RestoreMethod::Proportional));
  const balance::Range range = *model.restoration->ledger.units[0].dilatation;
  EXPECT_NEAR(range.greatest, 1.0, 1e-9);
  EXPECT_NEAR(range.least, -1.0 / 3.0, 1e-9);
}

TEST(AreaChange, OfShearAndParallelSlipIsNone) {
  unfold::RestoreParams slip = by(unfold::RestoreMethod::Flexural);
  slip.beds = unfold::SlipBeds::Parallel;
  for (const unfold::RestoreParams& params : {by(unfold::RestoreMethod::Shear), slip}) {
    const model::Model model = restored({test::cosine(), test::parallel(test::cosine(), 0.4)}, params);
    EXPECT_EQ(model.restoration->ledger.units[0].dilatation->least, 0.0);
    EXPECT_EQ(model.restoration->ledger.units[0].dilatation->greatest, 0.0);
  }
}

/// Beds over a wave, not parallel, each with its own roughness; shallow enough that no column closes.
std::vector<geom::Polyline> beds(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<geom::Polyline> lines(3);
  const double height = 60.0 + 60.0 * unit(random);
  for (std::size_t bed = 0; bed < 3; ++bed) {
    for (int i = 0; i <= 24; ++i) {
      const double x = 100.0 * i + (i % 24 == 0 ? 0.0 : 30.0 * (unit(random) - 0.5));
      lines[bed].points.push_back(
          {x, height * std::sin(x / 350.0) - 90.0 * static_cast<double>(bed) * (1.0 + 0.2 * unit(random))});
    }
  }
  return lines;
}

/// det F - 1 by the areas of a small triangle and of its image; nothing across the side of a cell.
std::optional<double> change_at(const SectionMap& map, geom::Point p) {
  constexpr double h = 1e-4;
  const auto by = [&](double x, double y) {
    const geom::Point a = map.forward(p).at;
    return geom::cross(map.forward({p.x + x, p.y}).at - a, map.forward({p.x, p.y + y}).at - a) / (x * y) - 1.0;
  };
  const double change = by(h, h);
  for (const double other : {by(-h, h), by(h, -h), by(-h, -h)}) {
    if (!(std::abs(other - change) < 1e-4)) return std::nullopt;
  }
  return change;
}

/// On n by n places of a unit.
balance::Range sampled(const SectionMap& map, const MappedLine& upper, const MappedLine& lower, int n) {
  const std::vector<double> top = geom::arc_lengths(upper.before);
  const std::vector<double> base = geom::arc_lengths(lower.before);
  balance::Range range{1e9, 0.0, -1e9};
  for (int i = 0; i < n; ++i) {
    const double part = (i + 0.37) / n;
    const geom::Point from = geom::point_at(upper.before, top, part * top.back());
    const geom::Point to = geom::point_at(lower.before, base, part * base.back());
    for (int k = 0; k < n; ++k) {
      const auto change = change_at(map, geom::interpolate(from, to, (k + 0.43) / n));
      if (!change) continue;
      range.least = std::min(range.least, *change);
      range.greatest = std::max(range.greatest, *change);
    }
  }
  return range;
}

/// How near the map comes to a value beside a place.
double missed_at(const SectionMap& map, geom::Point at, double value) {
  double missed = 1e9;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2.0 * pi * (i + 0.3) / 64.0;
    const auto change = change_at(map, at + 0.02 * geom::Vector{std::cos(angle), std::sin(angle)});
    if (change) missed = std::min(missed, std::abs(*change - value));
  }
  return missed;
}

TEST(AreaChange, NoSampleIsBeyondItAndItIsAttained) {
  for (const unfold::RestoreMethod method : {unfold::RestoreMethod::Constant, unfold::RestoreMethod::Variable,
                                             unfold::RestoreMethod::Flexural, unfold::RestoreMethod::LineLength}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const model::Model model = restored(beds(seed), by(method));
      const unfold::Restoration& made = *model.restoration;
      for (std::size_t i = 0; i + 1 < made.lines.size(); ++i) {
        const balance::UnitRow& row = made.ledger.units[i];
        const std::string which = std::string(method_name(method)) + ' ' + std::to_string(seed) + ' ' + row.name;
        double gap = 1e9;
        for (const int n : {10, 40}) {
          const balance::Range range = sampled(made.map, made.lines[i], made.lines[i + 1], n);
          const double low = range.least - row.dilatation->least;
          const double high = row.dilatation->greatest - range.greatest;
          EXPECT_GT(low, -1e-4) << which;
          EXPECT_GT(high, -1e-4) << which;
          EXPECT_LT(low + high, gap) << which;  // more samples come nearer
          gap = low + high;
        }
        EXPECT_LT(missed_at(made.map, row.least_at, row.dilatation->least), 1e-3) << which;
        EXPECT_LT(missed_at(made.map, row.greatest_at, row.dilatation->greatest), 1e-3) << which;
      }
    }
  }
}

TEST(AreaChange, OfAPolygonIsThatOfWhatLiesInIt) {
  // The wedge above, with a polygon over its middle: 200 / thickness at its own ends.
  model::Model model = restored({{{{0, 0}, {1000, 0}}, false}, {{{0, -100}, {1000, -300}}, false}},
                                by(unfold::RestoreMethod::Proportional));
  const geom::Polyline hole{{{400, -100}, {400, -60}, {500, -60}, {500, -100}}, true};  // clockwise
  const geom::Polyline outer{{{250, -120}, {750, -120}, {750, -20}, {250, -20}}, true};
  const auto change = area_change_in(std::vector{outer, hole}, model.restoration->map);
  ASSERT_TRUE(change);
  EXPECT_NEAR(change->greatest, 1.0 / 3.0, 1e-9);
  EXPECT_NEAR(change->least, -0.2, 1e-9);
  EXPECT_NEAR(change->greatest_at.x, 250.0, 1e-6);
  EXPECT_NEAR(change->least_at.x, 750.0, 1e-6);
}

TEST(AreaChange, BetweenHorizonsIsThatAlongTheWholeContour) {
  // What the map knows of a horizon's cells against a trace of the contour; also of beds that end early.
  for (const unfold::RestoreMethod method : {unfold::RestoreMethod::Constant, unfold::RestoreMethod::Variable,
                                             unfold::RestoreMethod::Flexural, unfold::RestoreMethod::LineLength}) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
      std::vector<geom::Polyline> lines = beds(seed);
      if (seed > 2) lines[1].points.erase(lines[1].points.begin(), lines[1].points.begin() + 5);
      if (seed == 4) lines[2].points.resize(17);
      const model::Model model = restored(lines, by(method));
      const unfold::Restoration& made = *model.restoration;
      for (std::size_t i = 0; i + 1 < made.lines.size(); ++i) {
        const geom::Polyline contour = contour_between(made.lines[i].before, made.lines[i + 1].before);
        const auto traced = area_change_in(std::span(&contour, 1), made.map);
        const auto known = area_change_between(made.lines[i], made.lines[i + 1], made.map);
        const std::string which = std::string(method_name(method)) + ' ' + std::to_string(seed);
        ASSERT_TRUE(traced && known) << which;
        EXPECT_NEAR(known->least, traced->least, 1e-6) << which;
        EXPECT_NEAR(known->greatest, traced->greatest, 1e-6) << which;
      }
    }
  }
}

TEST(AreaChange, ItsMeanIsTheQuotientOfTheAreas) {
  // Trapezes of 64 chords, but 63 of whose corners lean, become a rectangle of their upper length.
  const double r = 10.0 * std::cos(pi / 256.0);
  for (const double depth : {0.5, 2.0, 6.0}) {
    const model::Model model =
        restored({test::arc(), test::parallel(test::arc(), depth)}, by(unfold::RestoreMethod::Constant));
    const double mean = model.restoration->ledger.units[0].dilatation->mean;
    EXPECT_NEAR(mean, 1.0 / (1.0 - depth * 63.0 / 64.0 / (2.0 * r)) - 1.0, 1e-9);
  }
}

}  // namespace
}  // namespace recon::maps
