#include "recon/kinematics/propagation_fold.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/recon/kinematics/draws.h"

namespace recon::kinematics {
namespace {

using test::degrees;
constexpr double one_degree = std::numbers::pi / 180.0;

FaultPath flat_and_ramp(double theta, double ramp = 1000.0) {
  return test::fault({{-4000, 0}, {0, 0}, {ramp * std::cos(theta * one_degree), ramp * std::sin(theta * one_degree)}});
}

BlockMap fold(double theta, double from, double to) {
  return BlockMap(PropagationMap::make(flat_and_ramp(theta), {}, from, to).value());
}

TEST(PropagationAngles, AreThoseOfTheTable) {
  const double table[][6] = {{15, 21.552, 29.052, 1.6097, 1.065972, 1.407166},
                             {20, 27.878, 37.878, 1.7057, 1.114105, 1.346372},
                             {25, 33.627, 46.127, 1.8459, 1.172505, 1.279312},
                             {30, 38.794, 53.794, 2.0490, 1.239314, 1.210347},
                             {35, 43.407, 60.907, 2.3500, 1.312780, 1.142613}};
  for (const auto& row : table) {
    const PropagationAngles a = propagation_angles(degrees(row[0])).value();
    EXPECT_NEAR(a.gamma_star.degrees(), row[1], 5.1e-4);
    EXPECT_NEAR(a.gamma.degrees(), row[2], 5.1e-4);
    EXPECT_NEAR(a.propagation, row[3], 5.1e-5);
    EXPECT_NEAR(a.r1, row[4], 5.1e-7);
    EXPECT_NEAR(a.r2, row[5], 5.1e-7);
  }
  EXPECT_NEAR(propagation_angles(degrees(10)).value().gamma_star.degrees(), 14.706481, 5e-7);
  EXPECT_NEAR(propagation_angles(degrees(10)).value().propagation, 1.547005, 5e-7);
  EXPECT_NEAR(propagation_angles(degrees(12)).value().propagation, 1.568553, 5e-7);
  EXPECT_NEAR(propagation_angles(degrees(40)).value().gamma_star.degrees(), 47.515744, 1e-6);
  EXPECT_NEAR(propagation_angles(degrees(40)).value().propagation, 2.819078, 5e-7);
}

TEST(PropagationAngles, SolveTheEquationOfSuppeAndMedwedeff) {
  for (double theta = 2.0; theta < 60.0; theta += 1.7) {
    const double t = theta * one_degree;
    const auto off = [&](double g) {
      return (1.0 + 2.0 * std::cos(g) * std::cos(g)) / std::sin(2.0 * g) + (std::cos(t) - 2.0) / std::sin(t);
    };
    const PropagationAngles a = propagation_angles(degrees(theta)).value();
    EXPECT_NEAR(off(a.gamma_star.radians()), 0.0, 1e-10) << theta;
    // The other root is trivial.
    EXPECT_NEAR(off(0.5 * std::numbers::pi - 0.5 * t), 0.0, 1e-9);
    EXPECT_NEAR(a.propagation, 1.0 / (1.0 - std::sin(t) / std::sin(2.0 * a.gamma.radians() - t)), 1e-9 * a.propagation);
  }
}

TEST(PropagationFold, PointsGoWhereTinyStepsOfTheFieldTakeThem) {
  const double table[][4] = {{-300, 400, 82.323, 479.73},
                             {200, 500, 533.400, 800.41},
                             {600, 700, 925.046, 1038.095},
                             {900, 650, 990.39, 744.02},
                             {1200, 900, 1233.09, 934.42}};
  const BlockMap map = fold(25, 0, 400);
  const BlockMap other{PropagationMap::make(test::mirrored(flat_and_ramp(25)), {}, 0, 400).value()};
  for (const auto& row : table) {
    test::expect_near(map.forward(geom::Point{row[0], row[1]}), {row[2], row[3]}, 0.02);
    test::expect_near(other.forward(geom::Point{-row[0], row[1]}), {-row[2], row[3]}, 0.02);
  }
}

TEST(PropagationFold, BedsKeepLengthAndHaveTheDipsOfTheFold) {
  const double forelimb = -(180.0 - 2.0 * propagation_angles(degrees(25)).value().gamma.degrees());
  EXPECT_NEAR(forelimb, -87.745, 1e-3);
  const MovedLine bed = fold(25, 0, 400).forward(geom::Polyline{{{-2000, 700}, {3000, 700}}, false});
  for (std::size_t i = 0; i < bed.after.segment_count(); ++i) {
    const geom::Vector v = bed.after.segment(i).vector();
    if (geom::length(v) < 1e-6) continue;
    const double dip = std::atan2(v.y, v.x) / one_degree;
    EXPECT_LE(std::min({std::abs(dip), std::abs(dip - 25.0), std::abs(dip - forelimb)}), 1e-6) << dip;
  }
  // What lies in front of the fold is as far away as before but for the slip that the fold takes up.
  EXPECT_NEAR(geom::length(bed.after), 5000.0, 1e-8);
}

TEST(PropagationFold, AreasAreKeptWithTheBreaksAndNotWithoutThem) {
  test::Draws draws(41);
  double chords = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double theta = draws.in(8, 45);
    const double from = i % 2 == 0 ? 0.0 : draws.in(0, 500);
    const BlockMap map = fold(theta, from, draws.in(0, 700));
    const MovedLine moved = map.forward(test::star(draws, {draws.in(-700, 1500), draws.in(800, 1600)}, 500.0));
    EXPECT_LE(std::abs(test::area_change(moved)), 1e-12) << i << " ramp " << theta;
    chords = std::max(chords, std::abs(test::area_change_of_given(moved)));
  }
  EXPECT_GT(chords, 1e-3);
}

TEST(PropagationFold, RestoringIsTheInverseForRandomRampsSlipsAndPoints) {
  test::Draws draws(42);
  double worst = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double theta = draws.in(5, 50);
    const double from = i % 3 == 0 ? 0.0 : draws.in(0, 600);
    const BlockMap map = fold(theta, from, from + draws.in(0, 700));
    for (int k = 0; k < 3; ++k) {
      geom::Point p = draws.in_box({-1500, -500}, {3000, 2500});
      if (k == 0) p = {draws.in(-900, 0), 0};
      worst = std::max(worst, geom::distance(map.inverse(map.forward(p)), p));
    }
  }
  EXPECT_LE(worst, 1e-9 * 3000.0);
}

TEST(PropagationFold, TheFootwallStaysAndBothWallsOfTheFaultGoTheirOwnWays) {
  const BlockMap map = fold(30, 300, 500);
  for (const geom::Point p : {geom::Point{-800, -10}, {300, 100}, {2000, 300}, {5000, 4000}}) {
    EXPECT_EQ(map.forward(p), p);
  }
  const geom::Point on{200 * std::cos(30 * one_degree), 200 * std::sin(30 * one_degree)};
  EXPECT_EQ(map.forward(on, Wall::Foot), on);
  const geom::Point gone = map.forward(on, Wall::Hanging);
  test::expect_near(gone, on + 200.0 * geom::Vector{std::cos(30 * one_degree), std::sin(30 * one_degree)}, 1e-6);
  const Tip tip = map.tip().value();
  EXPECT_NEAR(geom::distance(tip.before, {0, 0}), 300 * 2.0490, 0.03);
  EXPECT_NEAR(geom::distance(tip.before, tip.after), 200 * 2.0490, 0.03);
}

TEST(PropagationFold, OtherFaultsAreRefusedWithThePlace) {
  const auto bends = PropagationMap::make(test::fault({{0, 0}, {9, 0}, {19, 5}, {30, 6}}), {}, 0, 1);
  ASSERT_FALSE(bends);
  EXPECT_NE(bends.error().message.find("this fault has 2 bends"), std::string::npos);
  EXPECT_EQ(bends.error().place->x, 19.0);
  EXPECT_FALSE(PropagationMap::make(test::fault({{0, 0}, {9, 0}}), {}, 0, 1));
  EXPECT_TRUE(PropagationMap::make(test::fault({{0, 0}, {9, 0}}), degrees(25), 0, 1));
  const auto steep = PropagationMap::make(flat_and_ramp(61), {}, 0, 1);
  ASSERT_FALSE(steep);
  EXPECT_EQ(steep.error().place->x, 0.0);
  EXPECT_FALSE(PropagationMap::make(flat_and_ramp(25), {}, 100, -1));
}

}  // namespace
}  // namespace recon::kinematics
