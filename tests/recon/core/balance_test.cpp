// Area-depth-strain, area balance with errors, Monte Carlo.

#include "recon/core/balance.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "recon/core/counter_random.h"
#include "recon/core/operations.h"
#include "shared/base/parallel.h"
#include "tests/recon/core/shapes.h"

namespace recon::core {
namespace {

/// A detachment fold: every horizon has the excess area D (h - h_d), as a half sine over its width.
Section detachment_fold(double displacement, double detachment) {
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
  EXPECT_NEAR(result->fit->detachment, -750.0, 1e-3);
  EXPECT_NEAR(result->fit->r_squared, 1.0, 1e-12);
  EXPECT_LT(result->fit->displacement_error, 1e-3);
  for (const BedBalance& bed : result->beds) {
    EXPECT_NEAR(*bed.depth, bed.excess_area / bed.shortening, 1e-9);
    EXPECT_GT(bed.layer_strain, -0.15);
  }
}

TEST(Balance, TheConfidenceOfTheFitIsStudents) {
  // y = 2x + 1 with residuals of one: worked by hand, t(2, 0.975) = 4.302653.
  const auto fit = fit_area_depth({0.0, 1.0, 2.0, 3.0}, {2.0, 2.0, 6.0, 6.0}, 95.0);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->displacement, 1.6, 1e-12);
  EXPECT_NEAR(fit->detachment, -1.0, 1e-12);
  const double deviation = std::sqrt(3.2 / 2.0);
  EXPECT_NEAR(fit->displacement_error, 4.302652730 * deviation / std::sqrt(5.0), 1e-8);
  EXPECT_NEAR(fit->detachment_error, 4.302652730 * deviation / 1.6 * std::sqrt(0.25 + 6.25 / 5.0), 1e-8);
  EXPECT_FALSE(fit_area_depth({1.0, 1.0}, {2.0, 3.0}, 95.0));
}

TEST(Balance, ASectionWithoutShorteningHasNoDetachment) {
  const auto result = area_depth(test::section_of({{{{0, 0}, {9, 0}}, false}, {{{0, -2}, {9, -2}}, false}}), {});
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->fit);
  EXPECT_TRUE(result->balanced);
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
  const char* data = std::getenv("DOBRA_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "DOBRA_TEST_DATA is not set";
  AreaBalanceParams params;
  params.file = "subandean.txt";
  params.unit = LengthUnit::Kilometre;
  params.thickness = {2.9, 4.6};
  params.thickness_error = {0.29, 0.46};
  params.width_points = {3, 30};
  dobra::scenario::Context context;
  context.folder = std::filesystem::path(data) / "sections/subandean_area_balance";
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
  EXPECT_EQ(philox({0, 0, 0, 0}, 0), (Counter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, 0xffffffffffffffffULL),
            (Counter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
}

TEST(Balance, NormalDeviatesHaveTheirMomentsAndAreIndependent) {
  double sum = 0.0, squares = 0.0, product = 0.0;
  const int count = 20000;
  for (int i = 0; i < count; ++i) {
    const auto pair = normal_pair({static_cast<std::uint32_t>(i), 0, 0, 0}, 7);
    sum += pair[0];
    squares += pair[0] * pair[0];
    product += pair[0] * pair[1];
  }
  EXPECT_NEAR(sum / count, 0.0, 0.025);
  EXPECT_NEAR(squares / count, 1.0, 0.035);
  EXPECT_NEAR(product / count, 0.0, 0.025);
}

Model restored_fold(RestoreMethod method) {
  Model model;
  const geom::Polyline top = test::cosine();
  model.section = test::section_of({top, test::parallel(top, 0.3), test::parallel(top, 0.6)});
  GridParams grid;
  grid.count = 1;
  RestoreParams restore;
  restore.method = method;
  TargetParams target;
  target.pin = 6.0;
  const Model with_grid = run_grid(model, grid, {}, {}).value();
  const Model with_target = run_target(with_grid, target, {}, {}).value();
  return run_restore(with_target, restore, {}, {}).value();
}

TEST(Balance, MonteCarloWithoutErrorsRepeatsTheRestoration) {
  const Model model = restored_fold(RestoreMethod::Variable);
  MonteCarloParams params;
  params.draws = 4;
  const auto result = run_monte_carlo(model, params, {}, {});
  ASSERT_TRUE(result) << to_string(result.error());
  const auto& spreads = result->monte_carlo->spreads;
  const auto find = [&](const std::string& name) {
    for (const Spread& s : spreads) {
      if (s.name == name) return s;
    }
    ADD_FAILURE() << name;
    return Spread{};
  };
  const Restoration& once = *model.restoration;
  EXPECT_NEAR(find("shortening").mean, once.lengths[0].shortening, 1e-9);
  EXPECT_NEAR(find("horizon.bed2.length_after").mean, once.lengths[2].length_after, 1e-9);
  EXPECT_NEAR(find("unit.top - bed1.area_after").mean, once.ledger.units[0].area_after, 1e-9);
  for (const Spread& s : spreads) EXPECT_NEAR(s.deviation, 0.0, 1e-9) << s.name;
  EXPECT_EQ(result->monte_carlo->balanced_share, once.balance.balanced ? 1.0 : 0.0);
}

TEST(Balance, MonteCarloIsTheSameAtAnyNumberOfThreadsAndAnotherForAnotherSeed) {
  const Model model = restored_fold(RestoreMethod::Flexural);
  MonteCarloParams params;
  params.draws = 200;
  params.pick_error = 0.01;
  params.pin_error = 0.1;
  std::vector<std::vector<double>> means;
  for (const std::size_t threads : {1, 4}) {
    base::set_thread_count(threads);
    const auto run = run_monte_carlo(model, params, {}, {});
    ASSERT_TRUE(run);
    means.emplace_back();
    for (const Spread& s : run->monte_carlo->spreads) means.back().push_back(s.mean + 1e3 * s.deviation);
  }
  base::set_thread_count(0);
  EXPECT_EQ(means[0], means[1]);
  params.seed = 2;
  const auto other = run_monte_carlo(model, params, {}, {});
  ASSERT_TRUE(other);
  EXPECT_NE(other->monte_carlo->spreads[0].mean + 1e3 * other->monte_carlo->spreads[0].deviation, means[0][0]);
}

TEST(Balance, TheSpreadOfAnEndPickIsTheSpreadOfTheWidth) {
  // Two picks a horizon, far beyond the correlation length: the length of a straight bed has a deviation of sqrt(2) s.
  Model model;
  model.section = test::section_of({{{{0, 0}, {1000, 0}}, false}, {{{0, -100}, {1000, -100}}, false}});
  GridParams grid;
  grid.count = 1;
  const Model with_target = run_target(run_grid(model, grid, {}, {}).value(), {}, {}, {}).value();
  const Model restored = run_restore(with_target, {}, {}, {}).value();
  MonteCarloParams params;
  params.draws = 4000;
  params.pick_error = 1.0;
  const auto run = run_monte_carlo(restored, params, {}, {});
  ASSERT_TRUE(run);
  for (const Spread& s : run->monte_carlo->spreads) {
    if (s.name != "horizon.top.length_before") continue;
    EXPECT_NEAR(s.deviation, std::sqrt(2.0), 0.05);
    EXPECT_NEAR(s.mean, 1000.0, 0.1);
    EXPECT_NEAR(s.high - s.low, 2.0 * 1.96 * std::sqrt(2.0), 0.25);
  }
}

TEST(Balance, ErrorBarsNeedARestoration) {
  const auto none = run_monte_carlo({}, {}, {}, {});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("put a step 'restore' before it"), std::string::npos);
}

}  // namespace
}  // namespace recon::core
