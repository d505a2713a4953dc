// Area-depth-strain, area balance with errors, Monte Carlo.

#include "recon/balance/balance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>

#include "recon/balance/area_balance.h"
#include "recon/balance/area_depth.h"
#include "recon/core/grid_step.h"
#include "recon/core/monte_carlo_step.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "recon/unfold/picks.h"
#include "shared/base/counter_random.h"
#include "shared/base/parallel.h"
#include "tests/recon/shapes.h"
#include "tests/support/corpus.h"

namespace recon::balance {
namespace {

/// A detachment fold: every horizon has the excess area D (h - h_d), as a half sine over its width.
section::Section detachment_fold(double displacement, double detachment) {
  std::vector<geom::Polyline> lines;
  for (const double level : {2000.0, 1500.0, 1000.0, 500.0}) {
    const double area = displacement * (level - detachment);
    const double width = 4000.0;
    const double height = area * std::numbers::pi / (2.0 * width);
    geom::Polyline line;
    for (int i = 0; i <= 2000; ++i) {
      const double x = width * i / 2000.0;
      line.points.push_back({x, level + height * std::sin(std::numbers::pi * x / width)});
    }
    lines.push_back(line);
  }
  return test::section_of(lines);
}

TEST(Balance, AreaDepthStrainFindsTheDisplacementAndTheDetachmentOfAFold) {
  const auto result = area_depth(detachment_fold(600.0, -750.0), {});
  ASSERT_TRUE(result);
  ASSERT_TRUE(result->fit);
  // The polygons of 2000 chords have 2e-7 less area than the sines.
  EXPECT_NEAR(result->fit->displacement, 600.0, 1e-3);
  EXPECT_NEAR(*result->fit->detachment, -750.0, 1e-3);
  EXPECT_NEAR(*result->fit->r_squared, 1.0, 1e-12);
  EXPECT_LT(*result->fit->displacement_error, 1e-3);
  for (const BedBalance& bed : result->beds) {
    EXPECT_NEAR(*bed.depth, bed.excess_area / bed.shortening, 1e-9);
    EXPECT_GT(*bed.layer_strain, -0.15);
  }
}

TEST(Balance, TheConfidenceOfTheFitIsStudents) {
  // y = 2x + 1 with residuals of one: worked by hand, t(2, 0.9) = 1.885618, t(2, 0.975) = 4.302653.
  const auto fit = fit_area_depth({0.0, 1.0, 2.0, 3.0}, {2.0, 2.0, 6.0, 6.0}, 80.0);
  ASSERT_TRUE(fit && fit->detachment);
  EXPECT_NEAR(fit->displacement, 1.6, 1e-12);
  EXPECT_NEAR(*fit->detachment, -1.0, 1e-12);
  const double deviation = std::sqrt(3.2 / 2.0);
  EXPECT_NEAR(*fit->displacement_error, 1.885618083 * deviation / std::sqrt(5.0), 1e-8);
  EXPECT_NEAR(*fit->detachment_error, 1.885618083 * deviation / 1.6 * std::sqrt(0.25 + 6.25 / 5.0), 1e-8);
  // At 95 % the slope is 1.6 +- 2.4: it may be 0, so that the detachment may lie anywhere.
  const auto wide = fit_area_depth({0.0, 1.0, 2.0, 3.0}, {2.0, 2.0, 6.0, 6.0}, 95.0);
  ASSERT_TRUE(wide);
  EXPECT_NEAR(*wide->displacement_error, 4.302652730 * deviation / std::sqrt(5.0), 1e-8);
  EXPECT_FALSE(wide->detachment || wide->detachment_error);
  EXPECT_FALSE(fit_area_depth({1.0, 1.0}, {2.0, 3.0}, 95.0));
}

TEST(Balance, TwoLevelsLeaveNoFreedomSoThatNoIntervalIsTold) {
  const auto fit = fit_area_depth({0.0, 2.0}, {2.0, 5.0}, 95.0);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->displacement, 1.5, 1e-12);
  EXPECT_NEAR(*fit->detachment, -4.0 / 3.0, 1e-12);
  EXPECT_FALSE(fit->displacement_error || fit->detachment_error || fit->r_squared);
  section::Section two = detachment_fold(600.0, -750.0);
  two.horizons.resize(2);
  const auto result = area_depth(two, {});
  ASSERT_TRUE(result && result->fit);
  EXPECT_NEAR(*result->fit->detachment, -750.0, 1e-3);
  EXPECT_NE(result->remarks.back().find("no freedom"), std::string::npos) << result->remarks.back();
  EXPECT_EQ(result->remarks.back().find("+-"), std::string::npos) << result->remarks.back();
}

bool tells(const AreaDepth& balance, const std::string& words) {
  return std::any_of(balance.remarks.begin(), balance.remarks.end(),
                     [&](const std::string& remark) { return remark.find(words) != std::string::npos; });
}

TEST(Balance, PiecesOfOneHorizonAreNoLevels) {
  section::Section section = detachment_fold(600.0, -750.0);
  const geom::Polyline whole = section.horizons[1].line;
  section.horizons.push_back(section.horizons[1]);
  section.horizons[1].line.points.assign(whole.points.begin(), whole.points.begin() + 900);
  section.horizons.back().line.points.assign(whole.points.begin() + 1100, whole.points.end());
  section.horizons[1].piece_of = section.horizons.back().piece_of = "cut";
  const AreaDepth three = area_depth(section, {}).value();
  EXPECT_NEAR(*three.fit->detachment, -750.0, 1e-3);
  EXPECT_TRUE(tells(three, "leaves out 'cut'"));
  for (const BedBalance& bed : three.beds) {
    EXPECT_EQ(bed.depth.has_value(), bed.piece_of.empty());
    EXPECT_EQ(bed.layer_strain.has_value(), bed.piece_of.empty());
  }
  section.horizons.erase(section.horizons.begin() + 2);  // two whole ones are left
  EXPECT_FALSE(area_depth(section, {}).value().fit->displacement_error);
  section.horizons.erase(section.horizons.begin());  // one
  const AreaDepth one = area_depth(section, {}).value();
  EXPECT_FALSE(one.fit);
  EXPECT_TRUE(tells(one, "no detachment can be told"));
}

TEST(Balance, BedsOfOneShapeTellNoDetachment) {
  // Their areas are one, but for rounding; also as they are digitised to a thousandth of a metre.
  for (const double step : {0.0, 1e-3}) {
    for (const std::size_t count : {2, 3, 5}) {
      std::vector<geom::Polyline> lines(count);
      for (std::size_t k = 0; k < count; ++k) {
        for (int i = 0; i <= 40; ++i) {
          const double z = 500.0 * std::sin(std::numbers::pi * i / 40.0) - 100.1 * static_cast<double>(k);
          lines[k].points.push_back({75.3 * i, step > 0.0 ? step * std::round(z / step + 0.3) : z});
        }
      }
      const AreaDepth told = area_depth(test::section_of(lines), {}).value();
      EXPECT_FALSE(told.fit) << step << " " << count;
      EXPECT_TRUE(tells(told, "no detachment can be told"));
      EXPECT_FALSE(tells(told, "z ="));
    }
  }
}

TEST(Balance, ADisplacementThatMayBeNothingTellsNoDetachment) {
  section::Section section = detachment_fold(600.0, -750.0);
  for (const std::size_t i : {0, 2}) {  // levels and areas no longer go together
    for (geom::Point& p : section.horizons[i].line.points)
      p.y += 0.4 * (p.y - section.horizons[i].line.points.front().y) * (i == 0 ? -1.0 : 1.0);
  }
  const AreaDepth told = area_depth(section, {}).value();
  ASSERT_TRUE(told.fit);
  EXPECT_GT(*told.fit->displacement_error, std::abs(told.fit->displacement));
  EXPECT_FALSE(told.fit->detachment);
  EXPECT_TRUE(tells(told, "detachment is undetermined"));
  EXPECT_FALSE(tells(told, "z ="));
}

TEST(Balance, AreasOfRoundingTellNoDetachment) {
  // Whole waves have no area over their regional but what rounding leaves.
  std::vector<geom::Polyline> lines(3);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    for (int i = 0; i <= 100; ++i)
      lines[k].points.push_back(
          {20.0 * i, 200.0 * std::sin(std::numbers::pi * i / 25.0) - 300.0 * static_cast<double>(k)});
  }
  const auto result = area_depth(test::section_of(lines), {});
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->fit);
  EXPECT_FALSE(result->beds[0].layer_strain);
}

TEST(Balance, LayersLieBetweenHorizonsAndNotBetweenPiecesOfOne) {
  const auto arc = [](double from, double level) {
    geom::Polyline line;
    for (int i = 0; i <= 40; ++i)
      line.points.push_back({from + 25.0 * i, level + 200.0 * std::sin(std::numbers::pi * i / 40.0)});
    return line;
  };
  const auto names = [&](std::vector<std::string> wholes, const std::vector<double>& from,
                         const std::vector<double>& level) {
    std::vector<geom::Polyline> lines;
    for (std::size_t i = 0; i < from.size(); ++i) lines.push_back(arc(from[i], level[i]));
    section::Section section = test::section_of(lines);
    for (std::size_t i = 0; i < wholes.size(); ++i) {
      section.horizons[i].piece_of = wholes[i];
      section.horizons[i].name = wholes[i] + std::to_string(i);
    }
    std::vector<std::string> found;
    const AreaDepth told = area_depth(section, {}).value();
    for (const LayerClass& layer : told.layers) found.push_back(layer.name);
    return found;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names({"A", "A", "B", "B"}, {0, 1100, 0, 1100}, {0, 50, -200, -150}), (Names{"A0 - B2", "A1 - B3"}));
  EXPECT_EQ(names({"A", "B", "A", "B"}, {0, 0, 1100, 1100}, {0, -200, 50, -150}), (Names{"A0 - B1", "A2 - B3"}));
  EXPECT_EQ(names({"A", "A", "B"}, {0, 1100, 1100}, {0, 50, -200}), (Names{"A1 - B2"}));
  EXPECT_EQ(names({"A", "A"}, {0, 100}, {0, -200}), Names{});  // a thrust doubles it: still no layer
}

TEST(Balance, ASectionWithoutShorteningHasNoDetachment) {
  const auto result = area_depth(test::section_of({{{{0, 0}, {9, 0}}, false}, {{{0, -2}, {9, -2}}, false}}), {});
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->fit);
  EXPECT_EQ(result->verdict, BalanceVerdict::Balanced);
  EXPECT_FALSE(result->beds[0].depth);
}

TEST(Balance, TheAreaOfASquareWithErrorsIsAsWorkedByHand) {
  const UncertainPolygon square{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{1, 0}, {0, 0}, {0, 2}, {0, 0}}};
  const WithError area = area_with_error(square);
  EXPECT_EQ(area.value, 100.0);
  EXPECT_NEAR(area.error, std::hypot(5.0, 10.0), 1e-12);
  EXPECT_NEAR(area.most, 15.0, 1e-12);
}

TEST(Balance, TheSubandeanBeltGivesThePublishedShortening) {
  const auto data = dobra::test::data_folder();
  if (!data) GTEST_SKIP() << dobra::test::no_data;
  AreaBalanceParams params;
  params.file = "subandean.txt";
  params.unit = section::LengthUnit::Kilometre;
  params.thickness = {2.9, 4.6};
  params.thickness_error = {0.29, 0.46};
  params.width_points = {3, 30};
  dobra::scenario::Context context;
  context.folder = *data / "sections/subandean_area_balance";
  const auto balance = balance_area(params, context);
  ASSERT_TRUE(balance) << to_string(balance.error());
  EXPECT_NEAR(balance->area.value / 1e6, 447.80, 5e-3);
  EXPECT_NEAR(balance->area.error / 1e6, 47.81, 5e-3);
  EXPECT_NEAR(balance->initial_width.value / 1e3, 119.41, 5e-3);
  EXPECT_NEAR(balance->width.value / 1e3, 74.36, 5e-3);
  EXPECT_NEAR(balance->shortening.value / 1e3, 45.06, 5e-3);
  EXPECT_NEAR(balance->percent.value, 37.73, 5e-3);
}

TEST(Balance, PhiloxGivesThePublishedWords) {
  // Known answers of the Random123 distribution for philox4x32_10.
  EXPECT_EQ(base::philox({0, 0, 0, 0}, 0), (base::Counter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(base::philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, 0xffffffffffffffffULL),
            (base::Counter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
}

TEST(Balance, NormalDeviatesHaveTheirMomentsAndAreIndependent) {
  double sum = 0.0, squares = 0.0, product = 0.0;
  const int count = 20000;
  for (int i = 0; i < count; ++i) {
    const auto pair = base::normal_pair({static_cast<std::uint32_t>(i), 0, 0, 0}, 7);
    sum += pair[0];
    squares += pair[0] * pair[0];
    product += pair[0] * pair[1];
  }
  EXPECT_NEAR(sum / count, 0.0, 0.025);
  EXPECT_NEAR(squares / count, 1.0, 0.035);
  EXPECT_NEAR(product / count, 0.0, 0.025);
}

model::Model restored_fold(unfold::RestoreMethod method) {
  model::Model model;
  const geom::Polyline top = test::cosine();
  model.section = test::section_of({top, test::parallel(top, 0.3), test::parallel(top, 0.6)});
  unfold::GridParams grid;
  grid.count = 1;
  unfold::RestoreParams restore;
  restore.method = method;
  unfold::TargetParams target;
  target.pin = 6.0;
  const model::Model with_grid = core::run_grid(model, grid, {}, {}).value();
  const model::Model with_target = core::run_target(with_grid, target, {}, {}).value();
  return core::run_restore(with_target, restore, {}, {}).value();
}

TEST(Balance, MonteCarloWithoutErrorsRepeatsTheRestoration) {
  const model::Model model = restored_fold(unfold::RestoreMethod::Variable);
  unfold::MonteCarloParams params;
  params.draws = 4;
  const auto result = core::run_monte_carlo(model, params, {}, {});
  ASSERT_TRUE(result) << to_string(result.error());
  const auto& spreads = result->findings.get<unfold::MonteCarlo>()->spreads;
  const auto find = [&](const std::string& name) {
    for (const unfold::Spread& s : spreads) {
      if (s.name == name) return s;
    }
    ADD_FAILURE() << name;
    return unfold::Spread{};
  };
  const unfold::Restoration& once = *model.restoration;
  EXPECT_NEAR(find("shortening").mean, once.lengths[0].shortening, 1e-9);
  EXPECT_NEAR(find("horizon.bed2.length_after").mean, once.lengths[2].length_after, 1e-9);
  EXPECT_NEAR(find("unit.top - bed1.area_after").mean, once.ledger.units[0].area_after, 1e-9);
  EXPECT_NEAR(find("horizon.bed2.shortening").mean, once.lengths[2].shortening, 1e-9);
  EXPECT_NEAR(find("horizon.bed2.shortening_percent").mean, once.lengths[2].shortening_percent, 1e-9);
  EXPECT_NEAR(find("unit.top - bed1.thickness_mean_before").mean, once.ledger.units[0].thickness_before->mean, 1e-9);
  EXPECT_NEAR(find("unit.bed1 - bed2.thickness_mean_after").mean, once.ledger.units[1].thickness_after->mean, 1e-9);
  for (const unfold::Spread& s : spreads) EXPECT_NEAR(s.deviation, 0.0, 1e-9) << s.name;
  EXPECT_EQ(result->findings.get<unfold::MonteCarlo>()->balanced_share,
            once.balance.verdict == BalanceVerdict::Balanced ? 1.0 : 0.0);
}

TEST(Balance, MonteCarloTellsNoShareWhereNothingIsJudged) {
  model::Model model;
  model.section = test::section_of({test::cosine()});
  unfold::GridParams grid;
  grid.count = 1;
  model = core::run_grid(model, grid, {}, {}).value();
  model = core::run_target(model, {}, {}, {}).value();
  model = core::run_restore(model, {}, {}, {}).value();
  unfold::MonteCarloParams params;
  params.draws = 4;
  const unfold::MonteCarlo made =
      *core::run_monte_carlo(model, params, {}, {}).value().findings.get<unfold::MonteCarlo>();
  EXPECT_FALSE(made.balanced_share);
  EXPECT_EQ(made.remarks.back(), "4 of 4 draws have nothing to judge: no two beds lie beside each other");
}

TEST(Balance, MonteCarloIsTheSameAtAnyNumberOfThreadsAndAnotherForAnotherSeed) {
  const model::Model model = restored_fold(unfold::RestoreMethod::Flexural);
  unfold::MonteCarloParams params;
  params.draws = 200;
  params.pick_error = 0.01;
  params.pin_error = 0.1;
  std::vector<std::vector<double>> means;
  for (const std::size_t threads : {1, 4}) {
    base::set_thread_count(threads);
    const auto run = core::run_monte_carlo(model, params, {}, {});
    ASSERT_TRUE(run);
    means.emplace_back();
    for (const unfold::Spread& s : run->findings.get<unfold::MonteCarlo>()->spreads)
      means.back().push_back(s.mean + 1e3 * s.deviation);
  }
  base::set_thread_count(0);
  EXPECT_EQ(means[0], means[1]);
  params.seed = 2;
  const auto other = core::run_monte_carlo(model, params, {}, {});
  ASSERT_TRUE(other);
  EXPECT_NE(other->findings.get<unfold::MonteCarlo>()->spreads[0].mean +
                1e3 * other->findings.get<unfold::MonteCarlo>()->spreads[0].deviation,
            means[0][0]);
}

TEST(Balance, TheSpreadOfAnEndPickIsTheSpreadOfTheWidth) {
  // Two picks a horizon, far beyond the correlation length: the length of a straight bed has a deviation of sqrt(2) s.
  model::Model model;
  model.section = test::section_of({{{{0, 0}, {1000, 0}}, false}, {{{0, -100}, {1000, -100}}, false}});
  unfold::GridParams grid;
  grid.count = 1;
  const model::Model with_target = core::run_target(core::run_grid(model, grid, {}, {}).value(), {}, {}, {}).value();
  const model::Model restored = core::run_restore(with_target, {}, {}, {}).value();
  unfold::MonteCarloParams params;
  params.draws = 4000;
  params.pick_error = 1.0;
  const auto run = core::run_monte_carlo(restored, params, {}, {});
  ASSERT_TRUE(run);
  for (const unfold::Spread& s : run->findings.get<unfold::MonteCarlo>()->spreads) {
    if (s.name != "horizon.top.length_before") continue;
    EXPECT_NEAR(s.deviation, std::sqrt(2.0), 0.05);
    EXPECT_NEAR(s.mean, 1000.0, 0.1);
    EXPECT_NEAR(s.high - s.low, 2.0 * 1.96 * std::sqrt(2.0), 0.25);
  }
}

/// Two straight beds, 10 long, at 0 and -4, with what the caller adds, restored as they are.
model::Model flat_section(const std::function<void(section::Section&)>& add) {
  model::Model model;
  model.section = test::section_of({{{{0, 0}, {10, 0}}, false}, {{{0, -4}, {10, -4}}, false}});
  add(model.section);
  unfold::GridParams grid;
  grid.count = 1;
  const model::Model with_target = core::run_target(core::run_grid(model, grid, {}, {}).value(), {}, {}, {}).value();
  auto restored = core::run_restore(with_target, {}, {}, {});
  EXPECT_TRUE(restored) << to_string(restored.error());
  return *restored;
}

std::map<std::string, unfold::Spread> drawn(const model::Model& model, double pick_error, int draws = 4000) {
  unfold::MonteCarloParams params;
  params.draws = draws;
  params.pick_error = pick_error;
  params.correlation = 0.5;  // far less than between two picks
  const auto run = core::run_monte_carlo(model, params, {}, {});
  EXPECT_TRUE(run) << to_string(run.error());
  std::map<std::string, unfold::Spread> spreads;
  for (const unfold::Spread& s : run->findings.get<unfold::MonteCarlo>()->spreads) spreads[s.name] = s;
  return spreads;
}

TEST(Balance, TheAreaOfARectangleOfFourPicksHasTheSpreadOfTheShoelaceFormula) {
  // dA/dx = +-b/2, dA/dz = +-a/2 at each of four corners, and four products of errors: s^2 (a^2 + b^2) + 2 s^4.
  const double a = 6.0, b = 3.0, s = 0.3;
  const model::Model model = flat_section([&](section::Section& section) {
    section.units.push_back(
        {section::UnitId(0), "sand", {{{2, -3.5}, {2 + a, -3.5}, {2 + a, -3.5 + b}, {2, -3.5 + b}}, true}, {}});
  });
  const auto spreads = drawn(model, s);
  ASSERT_TRUE(spreads.count("unit.sand.area_before"));
  const unfold::Spread& area = spreads.at("unit.sand.area_before");
  const double deviation = std::sqrt(s * s * (a * a + b * b) + 2.0 * s * s * s * s);
  EXPECT_NEAR(area.deviation, deviation, 0.04 * deviation);
  EXPECT_NEAR(area.mean, a * b, 4.0 * deviation / std::sqrt(4000.0));
  EXPECT_FALSE(spreads.count("unit.top - bed1.area_before"));  // polygons are the units then
}

TEST(Balance, PolygonsThatShareAnEdgeShareItInEveryDraw) {
  // What is between two beds in two polygons: the sum does not feel the edge between them.
  const auto left_and_right = [](section::Section& section) {
    section.units.push_back({section::UnitId(0), "left", {{{0, -4}, {5, -4}, {5, 0}, {0, 0}}, true}, {}});
    section.units.push_back({section::UnitId(1), "right", {{{10, 0}, {5, 0}, {5, -4}, {10, -4}}, true}, {}});
  };
  const model::Model model = flat_section(left_and_right);
  section::Section section = model.section;
  const unfold::Picks picks(section, {section.units[0].contour, section.units[1].contour}, {0.2, 0.5, 7});
  for (std::uint32_t number = 0; number < 20; ++number) {
    const unfold::Picks::Draw draw = picks.draw(number);
    EXPECT_EQ(draw.contours[0].points[1], draw.contours[1].points[2]);
    EXPECT_EQ(draw.contours[0].points[2], draw.contours[1].points[1]);
    EXPECT_EQ(draw.contours[0].points[3], draw.horizons[0].points.front());  // with the horizon's end
    EXPECT_NE(draw.contours[0].points[1], section.units[0].contour.points[1]);
  }
}

TEST(Balance, UnitsByFacesHaveErrorBarsToo) {
  // A border from x = 2 to 8 leaves of each bed the piece between; its mean height is that of the bed at x = 5, half of
  // each end: s^2 / 2 a bed, so 6 s for the area between the two, and 6 s / sqrt(2) for the one down to the border.
  const double s = 0.01;
  const model::Model model = flat_section([](section::Section& section) {
    section.border = geom::Polyline{{{2, -5}, {8, -5}, {8, 1}, {2, 1}}, true};
  });
  const auto spreads = drawn(model, s);
  ASSERT_TRUE(spreads.count("unit.top - bed1.area_before"));
  EXPECT_NEAR(spreads.at("unit.top - bed1.area_before").mean, 24.0, 0.01);
  EXPECT_NEAR(spreads.at("unit.top - bed1.area_before").deviation, 6.0 * s, 0.04 * 6.0 * s);
  EXPECT_NEAR(spreads.at("unit.bed1.area_before").deviation, 6.0 * s / std::sqrt(2.0), 0.04 * 6.0 * s);
  // Without errors the same numbers as the ledger's.
  const auto still = drawn(model, 0.0, 3);
  for (const UnitRow& row : model.restoration->ledger.units) {
    EXPECT_NEAR(still.at("unit." + row.name + ".area_before").mean, row.area_before, 1e-12) << row.name;
    EXPECT_NEAR(still.at("unit." + row.name + ".area_after").mean, row.area_after, 1e-12) << row.name;
  }
}

TEST(Balance, WhereAFaultCutsABedTheDrawnLinesMeet) {
  // A vertical fault at x = 4 between two beds and a border: the piece left of it is 2 wide; the fault's two picks move
  // it by s / sqrt(2) in the mean over the height of 4, the beds by their heights at x = 3.
  const double s = 0.01;
  const model::Model model = flat_section([](section::Section& section) {
    section.border = geom::Polyline{{{2, -5}, {8, -5}, {8, 1}, {2, 1}}, true};
    section.lines.push_back({section::LineId(0), section::LineKind::Fault, "F", {{{4, 0}, {4, -4}}, false}, {}});
  });
  const geom::Polyline left{{{2, 0}, {2, -4}, {4, -4}, {4, 0}}, true};
  const unfold::Picks picks(model.section, {left}, {s, 0.5, 3});
  double squares = 0.0;
  const int draws = 4000;
  for (int i = 0; i < draws; ++i) {
    const unfold::Picks::Draw draw = picks.draw(static_cast<std::uint32_t>(i));
    const double area = geom::signed_area(draw.contours[0]);
    squares += (area - 8.0) * (area - 8.0);
    EXPECT_NEAR(draw.contours[0].points[0].x, 2.0, 1e-12);  // along the border
  }
  const double beds = 2.0 * (0.7 * 0.7 + 0.3 * 0.3) * 4.0;  // two beds, 2 wide
  const double expected = s * std::sqrt(beds + 16.0 / 2.0);
  EXPECT_NEAR(std::sqrt(squares / draws), expected, 0.04 * expected);
}

TEST(Balance, ErrorBarsNeedARestoration) {
  const auto none = core::run_monte_carlo({}, {}, {}, {});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("put a step 'restore' before it"), std::string::npos);
}

}  // namespace
}  // namespace recon::balance
