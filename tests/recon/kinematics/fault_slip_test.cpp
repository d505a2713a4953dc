#include "recon/kinematics/fault_slip.h"

#include <gtest/gtest.h>

#include "tests/recon/kinematics/draws.h"

namespace recon::kinematics {
namespace {

/// Flat, ramp, flat.
FaultPath staircase() { return test::fault({{-4000, 0}, {0, 0}, {1500, 600}, {6000, 600}}); }

TEST(FlexuralSlipOverAFault, PointsGoAlongTheParallelsOfTheFault) {
  // Where no walls have met these are the flow lines of fault-parallel flow, found in quite another way.
  test::Draws draws(61);
  for (const FaultPath& path : {staircase(), test::mirrored(staircase())}) {
    for (const double slip : {500.0, -700.0, 2500.0}) {
      const BlockMap slipped{maps::SectionMap(flexural_slip(path, slip).value())};
      const BlockMap flowing{fault_parallel_flow(path, slip).value()};
      for (int i = 0; i < 100; ++i) {
        geom::Point p = draws.in_box({-2500, 700}, {3500, 1500});
        if (path.hanging == Side::Right) p.x = -p.x;
        test::expect_near(slipped.forward(p), flowing.forward(p), 1e-9);
      }
    }
  }
}

TEST(FlexuralSlipOverAFault, BedsAlongTheFaultKeepTheirLengthAndPolygonsTheirArea) {
  const FaultPath path = staircase();
  const FlowDomains flow = FlowDomains::make(path, {1.0, 1.0, 1.0}).value();
  const BlockMap map{maps::SectionMap(flexural_slip(path, 900.0).value())};
  const geom::Polyline bed = flow.flow_line(400.0, 800.0);
  EXPECT_NEAR(geom::length(map.forward(bed).after), geom::length(bed), 1e-9);
  test::Draws draws(62);
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    const MovedLine moved = map.forward(test::star(draws, draws.in_box({-1500, 1200}, {2500, 1500}), 500.0));
    worst = std::max(worst, std::abs(test::area_change(moved)));
  }
  EXPECT_LE(worst, 1e-12);
}

TEST(FlexuralSlipOverAFault, BackIsTheInverseForRandomStaircasesSlipsAndPoints) {
  test::Draws draws(63);
  for (int i = 0; i < 10000; ++i) {
    const double rise = draws.in(100, 600);
    const double run = draws.in(800, 2000);
    const FaultPath path = test::fault({{-4000, 0}, {0, 0}, {run, rise}, {6000, rise}});
    const BlockMap map{maps::SectionMap(flexural_slip(path, draws.in(-900, 900)).value())};
    const geom::Point p = draws.in_box({-2500, 700}, {4000, 1600});
    test::expect_near(map.inverse(map.forward(p)), p, 1e-9);
  }
}

TEST(FlexuralSlipOverAFault, AFaultThatTurnsBackOnItselfIsRefused) {
  const auto refused = flexural_slip(test::fault({{0, 0}, {100, 0}, {50, 0}}), 10.0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, base::ErrorCode::CannotRestore);
  EXPECT_TRUE(refused.error().place);
}

}  // namespace
}  // namespace recon::kinematics
