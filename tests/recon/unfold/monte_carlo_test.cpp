#include "recon/unfold/monte_carlo.h"

#include <gtest/gtest.h>

#include <cmath>

#include "recon/core/grid_step.h"
#include "recon/core/monte_carlo_step.h"
#include "recon/core/operations.h"
#include "recon/core/report.h"
#include "recon/core/restore_step.h"
#include "recon/core/target_step.h"
#include "tests/recon/shapes.h"

namespace recon::unfold {
namespace {

/// A ridge whose limbs dip 30 degrees to both sides, restored by shear at an angle from the vertical.
model::Model sheared_ridge(double degrees) {
  const double rise = 1000.0 * std::tan(std::acos(-1.0) / 6.0);
  const auto ridge = [&](double z) { return geom::Polyline{{{0.0, z}, {1000.0, z + rise}, {2000.0, z}}, false}; };
  model::Model model;
  model.section = test::section_of({ridge(0.0), ridge(-200.0)});
  GridParams grid;
  grid.count = 1;
  RestoreParams restore;
  restore.method = RestoreMethod::Shear;
  restore.angle = base::Angle::from_degrees(degrees);
  model = core::run_target(core::run_grid(model, grid, {}, {}).value(), {}, {}, {}).value();
  return core::run_restore(model, restore, {}, {}).value();
}

TEST(MonteCarlo, DrawsWhoseAngleIsBeyondTheDipAreCountedAsFailedAndToldInEveryForm) {
  // Shear at more than 60 degrees from the vertical runs along or under a limb, whichever way it leans.
  constexpr int draws = 600;
  for (const auto& [angle, error] : {std::pair(50.0, 10.0), {40.0, 30.0}, {-55.0, 5.0}}) {
    MonteCarloParams params;
    params.draws = draws;
    params.angle_error = base::Angle::from_degrees(error);
    const auto run = core::run_monte_carlo(sheared_ridge(angle), params, {}, {});
    ASSERT_TRUE(run) << to_string(run.error());
    const auto beyond = [&](double limit) { return 0.5 * std::erfc(limit / std::sqrt(2.0)); };
    const double share = beyond((60.0 - angle) / error) + beyond((60.0 + angle) / error);
    const double deviation = std::sqrt(draws * share * (1.0 - share));
    const MonteCarlo& made = *run->findings.get<MonteCarlo>();
    EXPECT_NEAR(static_cast<double>(made.failed), draws * share, 4.0 * deviation) << angle;
    const std::string count = std::to_string(made.failed) + " of 600 draws could not be restored";
    EXPECT_NE(made.remarks.front().find(count), std::string::npos) << made.remarks.front();
    bool told = false;
    for (const auto& quantity : core::program().quantities_of(dobra::scenario::make_state(*run))) {
      EXPECT_TRUE(std::isfinite(quantity.value)) << quantity.name;
      told = told || (quantity.name == "error.failed" && quantity.value == static_cast<double>(made.failed));
    }
    EXPECT_TRUE(told);
    for (const Spread& spread : made.spreads) EXPECT_LT(std::abs(spread.high), 1e8) << spread.name;
  }
}

TEST(MonteCarlo, WithoutFailuresNothingIsSaidOfThem) {
  MonteCarloParams params;
  params.draws = 50;
  params.angle_error = base::Angle::from_degrees(1.0);
  const auto run = core::run_monte_carlo(sheared_ridge(0.0), params, {}, {});
  ASSERT_TRUE(run);
  EXPECT_EQ(run->findings.get<MonteCarlo>()->failed, 0U);
  EXPECT_EQ(run->findings.get<MonteCarlo>()->remarks.size(), 1U);
}

TEST(MonteCarlo, WhereNoDrawCanBeRestoredItIsRefusedWithTheirNumber) {
  MonteCarloParams params;
  params.draws = 1;
  params.angle_error = base::Angle::from_degrees(1e-9);
  model::Model model = sheared_ridge(59.0);
  model.restoration->params.angle = base::Angle::from_degrees(75.0);
  const auto run = core::run_monte_carlo(model, params, {}, {});
  ASSERT_FALSE(run);
  EXPECT_NE(to_string(run.error()).find("none of 1 draws"), std::string::npos) << to_string(run.error());
}

}  // namespace
}  // namespace recon::unfold
