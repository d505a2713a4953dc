#include "recon/kinematics/fault_bend_fold.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/recon/kinematics/draws.h"

namespace recon::kinematics {
namespace {

using test::degrees;
constexpr double turn = std::numbers::pi / 180.0;

/// A flat, a ramp of 20 degrees up to 500 m, a flat.
FaultPath simple_step() {
  const double run = 500.0 / std::tan(20.0 * turn);
  return test::fault({{-5000, 0}, {0, 0}, {run, 500}, {8000, 500}});
}

/// A chain of dips, degrees, each of the given length.
FaultPath dipping(const std::vector<double>& dips, double length) {
  FaultPath path = test::fault({{0, 0}});
  for (const double dip : dips) {
    path.line.points.push_back(path.line.points.back() +
                               geom::Vector{length * std::cos(dip * turn), length * std::sin(dip * turn)});
  }
  return path;
}

/// Dips of the pieces of a line that are longer than a metre, degrees.
std::vector<double> dips_of(const geom::Polyline& line) {
  std::vector<double> dips;
  for (std::size_t i = 0; i < line.segment_count(); ++i) {
    const geom::Vector v = line.segment(i).vector();
    if (geom::length(v) > 1.0) dips.push_back(std::atan2(v.y, v.x) / turn);
  }
  return dips;
}

TEST(BendFold, TheStepFromARampToAFlatHasTheAnglesOfItsTable) {
  const double table[][4] = {
      {5, 87.481, 5.039, .9924},         {10, 84.839, 10.322, .9691},      {15, 81.913, 16.174, .9292},
      {20, 78.420, 23.160, .8696},       {25, 73.651, 32.697, .7823},      {28, 69.063, 41.875, .7033},
      {30, 60.000, 60.000, .5774},       {7, 86.44635, 7.10731, .984978},  {12, 83.71441, 12.57118, .955247},
      {18, 79.91365, 20.17271, .896088}, {22, 76.73887, 26.52226, .838899}};
  for (const auto& row : table) {
    const double digits = row[0] == 7 || row[0] == 12 || row[0] == 18 || row[0] == 22 ? 5.1e-6 : 5.1e-4;
    const BendFold step = step_up(degrees(row[0])).value();
    EXPECT_NEAR(step.gamma.degrees(), row[1], digits);
    EXPECT_NEAR(180.0 - 2.0 * step.gamma.degrees(), row[2], 2.0 * digits);
    EXPECT_NEAR(step.slip_ratio, row[3], digits < 1e-5 ? 5.1e-7 : 5.1e-5);
    const BendFold general = bend_fold(degrees(row[0]), degrees(row[0])).value();
    EXPECT_NEAR(general.gamma.degrees(), step.gamma.degrees(), row[0] == 30 ? 2e-6 : 1e-10);
    EXPECT_NEAR(general.slip_ratio, step.slip_ratio, row[0] == 30 ? 1e-7 : 1e-12);
  }
}

TEST(BendFold, AnyBendAgreesWithSuppesEquation) {
  test::Draws draws(31);
  for (int i = 0; i < 500; ++i) {
    const double theta = draws.in(1, 60);
    const auto made = bend_fold(degrees(theta), degrees(draws.in(-30, 50)));
    if (!made) continue;
    const double t = theta * turn;
    const double g = made->gamma.radians();
    const double part = std::sin(2 * g - t) - std::sin(t);
    const double phi = std::atan(-std::sin(g - t) * part / (std::cos(g - t) * part - std::sin(g)));
    const double off = std::abs(phi - made->phi.radians());
    EXPECT_LE(std::min(off, std::abs(off - std::numbers::pi)), 1e-9) << theta << ' ' << made->phi.degrees();
  }
}

TEST(BendFold, TheGreatestBendIsWhereTheTableSays) {
  const double table[][2] = {{5, 140.88}, {10, 106.37}, {20, 57.45}, {30, 30.00}};
  for (const auto& row : table) {
    EXPECT_TRUE(bend_fold(degrees(row[0]), degrees(row[1] - 0.006))) << row[0];
    const auto none = bend_fold(degrees(row[0]), degrees(row[1] + 0.006));
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("the greatest bend is"), std::string::npos);
  }
  EXPECT_FALSE(step_up(degrees(31)));
  EXPECT_FALSE(step_up(degrees(0)));
}

TEST(BendFold, FromAFlatUpARampTheAxisBisects) {
  const BendFold fold = bend_fold({}, degrees(-20)).value();
  EXPECT_NEAR(fold.gamma.degrees(), 100.0, 1e-12);
  EXPECT_EQ(fold.slip_ratio, 1.0);
  EXPECT_EQ(fold.beta.degrees(), 0.0);
}

TEST(FaultBendFold, PointsOfTheSimpleStepGoWhereTheyShouldBelowAndBeyondTheRamp) {
  const double table[][6] = {{-500, 200, 91.84249846, 246.26349018, 1411.83650965, 700},
                             {-100, 800, 463.81557247, 1005.21208600, 1811.83650965, 1300},
                             {300, 400, 863.81557247, 605.21208600, 2194.26470058, 814.24553600},
                             {1200, 900, 1742.37320062, 1000.56838664, 3029.98962124, 1000.56838664},
                             {2500, 1000, 3021.76589453, 1000, 4309.38231515, 1000}};
  for (const FaultPath& path : {simple_step(), test::mirrored(simple_step())}) {
    const double sign = path.hanging == Side::Left ? 1.0 : -1.0;
    const BlockMap early{fault_bend_fold(path, {}, 0, 600).value()};
    const BlockMap late{fault_bend_fold(path, {}, 0, 2000).value()};
    for (const auto& row : table) {
      test::expect_near(early.forward(geom::Point{sign * row[0], row[1]}), {sign * row[2], row[3]}, 1e-8);
      test::expect_near(late.forward(geom::Point{sign * row[0], row[1]}), {sign * row[4], row[5]}, 1e-8);
    }
  }
}

TEST(FaultBendFold, BedsKeepLengthAndThicknessAndHaveTheDipsOfTheFold) {
  const BlockMap map{fault_bend_fold(simple_step(), {}, 0, 600).value()};
  const geom::Polyline bed{{{-3000, 700}, {6000, 700}}, false};
  const geom::Polyline above{{{-3000, 800}, {6000, 800}}, false};
  const MovedLine moved = map.forward(bed);
  const double forelimb = -(180.0 - 2.0 * step_up(degrees(20)).value().gamma.degrees());
  for (const double dip : dips_of(moved.after)) {
    EXPECT_LE(std::min({std::abs(dip), std::abs(dip - 20.0), std::abs(dip - forelimb)}), 1e-9) << dip;
  }
  EXPECT_NEAR(geom::length(moved.after), 9000.0, 1e-8);
  // Thickness: distance of the middle of each piece from the bed above.
  const MovedLine top = map.forward(above);
  for (std::size_t i = 0; i < moved.after.segment_count(); ++i) {
    const geom::Segment piece = moved.after.segment(i);
    if (piece.length() > 300.0) {
      EXPECT_NEAR(geom::distance(top.after, geom::midpoint(piece.from, piece.to)), 100.0, 1e-9);
    }
  }
}

TEST(FaultBendFold, TheCutoffBehindABendIsBeta) {
  // Ramps of 20, 10 and 3 degrees: measured on moved beds that lay over the ramp before each bend.
  const FaultPath path = dipping({0, 20, 10}, 3000);
  const BendFold fold = bend_fold(degrees(20), degrees(10)).value();
  const BlockMap map{fault_bend_fold(path, {}, 0, 900).value()};
  const geom::Point bend = path.line.points[2];
  // A short bed just behind the axial plane of the bend, near the fault, brought there from over the ramp.
  const geom::Point place = bend + geom::Vector{300.0 * std::cos(10 * turn), 300.0 * std::sin(10 * turn)};
  const geom::Point home = map.inverse(place + geom::Vector{0.0, 1.0});
  const geom::Vector bed = map.forward(home + geom::Vector{0.1, 0.0}) - map.forward(home);
  EXPECT_NEAR(geom::length(bed), 0.1, 1e-9);
  const double cutoff = 10.0 - std::atan2(bed.y, bed.x) / turn;
  EXPECT_NEAR(cutoff, fold.beta.degrees(), 1e-6);
}

TEST(FaultBendFold, AreasAreKeptBelowAndBeyondTheRampAndOverManyBends) {
  test::Draws draws(32);
  double chords = 0.0;
  for (const FaultPath& path : {simple_step(), dipping({0, 12, 25, 14, 3}, 700), dipping({0, 8, 16, 24}, 900)}) {
    for (const double slip : {500.0, 1500.0, 3100.0}) {
      const auto made = fault_bend_fold(path, {}, 0, slip);
      ASSERT_TRUE(made) << to_string(made.error());
      const BlockMap map{*made};
      for (int i = 0; i < 40; ++i) {
        const geom::Point centre{draws.in(-1000, 3500), path.line.box().high.y + draws.in(700, 1500)};
        const MovedLine moved = map.forward(test::star(draws, centre, 650.0));
        EXPECT_LE(std::abs(test::area_change(moved)), 1e-12);
        chords = std::max(chords, std::abs(test::area_change_of_given(moved)));
      }
    }
  }
  EXPECT_GT(chords, 1e-3);
}

TEST(FaultBendFold, RestoringIsTheInverseForRandomFaultsSlipsAndPoints) {
  test::Draws draws(33);
  double worst = 0.0;
  int made = 0;
  int tried = 0;
  for (int i = 0; made < 10000 && i < 40000; ++i) {
    const FaultPath path =
        i % 3 == 0 ? simple_step() : dipping({0, draws.in(5, 25), draws.in(0, 5), draws.in(6, 20)}, 800);
    const double from = draws.in(0, 900);
    const double to = draws.in(0, 3000);
    const auto forward = fault_bend_fold(path, {}, from, to);
    if (!forward) continue;
    ++made;
    const BlockMap map{*forward};
    // Restoring is the same map turned round, which a tenth of the draws asks.
    const BlockMap back = made % 10 == 0 ? BlockMap{fault_bend_fold(path, {}, to, from).value()} : map.swapped();
    for (int k = 0; k < 2; ++k) {
      const geom::Point p = draws.in_box({-2000, -100}, {5000, 2500});
      if (wall_of(path, p) != Wall::Hanging) continue;
      worst = std::max(worst, geom::distance(back.forward(map.forward(p)), p));
      ++tried;
    }
  }
  EXPECT_EQ(made, 10000);
  EXPECT_GT(tried, 10000);
  EXPECT_LE(worst, 1e-9 * 3000.0);
}

TEST(FaultBendFold, StagesOfTheStepTurnFromTheRampsFoldToTheBisector) {
  const std::vector<BendStage> stages = bend_stages(simple_step(), {}, 0, 2000).value();
  ASSERT_EQ(stages.size(), 3U);
  EXPECT_EQ(stages[0].at, geom::Point(0, 0));
  EXPECT_EQ(stages[0].to, 2000.0);
  EXPECT_NEAR(stages[1].to, 1461.9022, 5e-5);
  EXPECT_NEAR(stages[1].fold.slip_ratio, 0.8696, 5e-5);
  EXPECT_NEAR(stages[2].fold.slip_ratio, 1.0, 1e-12);
}

TEST(FaultBendFold, WhatCannotBeFoldedIsRefusedWithTheBend) {
  const auto steep = fault_bend_fold(dipping({0, 31, 0}, 1000), {}, 0, 100);
  ASSERT_FALSE(steep);
  EXPECT_EQ(steep.error().code, base::ErrorCode::CannotRestore);
  EXPECT_NEAR(*steep.error().place->x, 1000.0 + 1000.0 * std::cos(31 * turn), 1e-9);
  EXPECT_NE(steep.error().message.find("fault_parallel_flow"), std::string::npos);
  const auto extension = fault_bend_fold(simple_step(), {}, 0, -100);
  ASSERT_FALSE(extension);
  EXPECT_NE(extension.error().message.find("for extension take"), std::string::npos);
  EXPECT_FALSE(fault_bend_fold(dipping({0, -15, 0}, 1000), {}, 0, 1500));
}

}  // namespace
}  // namespace recon::kinematics
