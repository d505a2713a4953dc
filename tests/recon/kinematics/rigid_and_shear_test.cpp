#include <gtest/gtest.h>

#include "recon/kinematics/shear.h"
#include "tests/recon/kinematics/draws.h"

namespace recon::kinematics {
namespace {

using test::degrees;

/// z = -1000 (1 - exp(-x / 800)) from x = 3000 to 0, so that the path climbs.
FaultPath listric_curve(int pieces) {
  FaultPath path{{}, Side::Right};
  for (int i = pieces; i >= 0; --i) {
    const double x = 3000.0 * i / pieces;
    path.line.points.push_back({x, -1000.0 * (1.0 - std::exp(-x / 800.0))});
  }
  return path;
}

TEST(Amounts, SlipHeaveAndThrowAlongARampAndBeyondItsEnd) {
  const FaultPath path = test::fault({{0, 0}, {10, 0}, {13, 4}});
  EXPECT_DOUBLE_EQ(arc_after(path, 2.0, {Measure::Slip, 5.0}).value(), 7.0);
  EXPECT_DOUBLE_EQ(arc_after(path, 2.0, {Measure::Heave, 11.0}).value(), 15.0);
  EXPECT_DOUBLE_EQ(arc_after(path, 2.0, {Measure::Throw, 8.0}).value(), 20.0);
  EXPECT_DOUBLE_EQ(arc_after(path, 15.0, {Measure::Heave, -6.0}).value(), 7.0);
  EXPECT_DOUBLE_EQ(arc_after(path, 12.0, {Measure::Throw, -1.6}).value(), 10.0);
}

TEST(Amounts, AThrowThatALevelFaultNeverHasIsRefusedWithThePlace) {
  const auto none = arc_after(test::fault({{0, 0}, {10, 0}}), 5.0, {Measure::Throw, 3.0});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("level"), std::string::npos);
  const auto turned = arc_after(test::fault({{0, 0}, {3, 4}, {0, 8}}), 1.0, {Measure::Heave, 7.0});
  ASSERT_FALSE(turned);
  EXPECT_EQ(turned.error().place->x, 3.0);
  EXPECT_EQ(turned.error().place->y, 4.0);
}

TEST(RigidMap, ATurnAndAShiftAndTheWayBack) {
  const BlockMap map{RigidMap(degrees(90), {1, 1}, {5, 0})};
  EXPECT_EQ(map.forward(geom::Point{3, 1}), geom::Point(6, 3));
  const BlockMap back = map.swapped();
  test::Draws draws(3);
  for (int i = 0; i < 10000; ++i) {
    const BlockMap any{RigidMap(degrees(draws.in(-180, 180)), draws.in_box({-5000, -5000}, {5000, 5000}),
                                {draws.in(-900, 900), draws.in(-900, 900)})};
    const geom::Point p = draws.in_box({-9000, -9000}, {9000, 9000});
    test::expect_near(any.inverse(any.forward(p)), p, 1e-11);
  }
  EXPECT_EQ(back.forward(geom::Point{6, 3}), geom::Point(3, 1));
}

TEST(RigidMap, HeaveAndThrowAreThoseOfTheChord) {
  const FaultPath path = test::fault({{0, 0}, {10, 0}, {30, 30}});
  EXPECT_EQ(shift_along_chord(path, {Measure::Heave, 5.0}).value(), geom::Vector(5.0, 5.0));
  EXPECT_EQ(shift_along_chord(test::mirrored(path), {Measure::Throw, -5.0}).value(), geom::Vector(5.0, -5.0));
  const auto none = shift_along_chord(test::fault({{0, 0}, {9, 0}}), {Measure::Throw, 5.0});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, base::ErrorCode::CannotRestore);
}

TEST(ShearOverAFault, APlaneOf45DegreesTakesItsPointsAlongItself) {
  const FaultPath plane = test::fault({{3000, -3000}, {0, 0}}, Side::Right);
  const auto gone = [&](double angle) {
    const BlockMap map{shear_over(plane, degrees(angle), 100.0).value()};
    const geom::Point end = map.forward(geom::Point{1000, -1000});
    EXPECT_NEAR(end.x + end.y, 0.0, 1e-9);
    return end.x - 1000.0;
  };
  EXPECT_NEAR(gone(20.0), 73.3154, 5e-5);
  EXPECT_NEAR(gone(-20.0), 157.2253, 5e-5);
  EXPECT_NEAR(gone(0.0), 100.0, 1e-10);
}

TEST(ShearOverAFault, VerticalShearDropsAPointByWhatTheFaultDrops) {
  const FaultPath path = listric_curve(60);
  const auto depth = [&](double x) {
    const double part = x / 50.0;
    const int i = static_cast<int>(part);
    const auto w = [](int k) { return -1000.0 * (1.0 - std::exp(-50.0 * k / 800.0)); };
    return w(i) + (part - i) * (w(i + 1) - w(i));
  };
  const BlockMap map{shear_over(path, degrees(0), 300.0).value()};
  for (const double x : {12.0, 700.0, 1333.0, 2501.0}) {
    test::expect_near(map.forward(geom::Point{x, 200}), {x + 300.0, 200.0 + depth(x + 300.0) - depth(x)}, 1e-9);
  }
}

TEST(ShearOverAFault, AreasAreKeptWithTheBreaksAndNotWithoutThem) {
  test::Draws draws(11);
  for (const double angle : {0.0, 20.0, -20.0}) {
    const BlockMap map{shear_over(listric_curve(60), degrees(angle), 300.0).value()};
    double chords = 0.0;
    for (int i = 0; i < 200; ++i) {
      const MovedLine moved = map.forward(test::star(draws, draws.in_box({200, -300}, {2500, 500}), 600.0));
      EXPECT_LE(std::abs(test::area_change(moved)), 1e-12);
      chords = std::max(chords, std::abs(test::area_change_of_given(moved)));
    }
    EXPECT_GT(chords, 1e-5);
  }
}

TEST(ShearOverAFault, BackIsTheInverseForRandomFaultsAnglesAndPoints) {
  test::Draws draws(12);
  int made = 0;
  for (int i = 0; i < 10000; ++i) {
    const auto map = shear_over(listric_curve(7), degrees(draws.in(-35, 35)), draws.in(-800, 800));
    if (!map) continue;
    ++made;
    const geom::Point p = draws.in_box({-500, -1500}, {4000, 800});
    const BlockMap block{*map};
    test::expect_near(block.inverse(block.forward(p)), p, 1e-9);
  }
  EXPECT_EQ(made, 10000);
}

TEST(ShearOverAFault, TheHeaveThatIsSolvedTakesTheCutoffSoFar) {
  const FaultPath path = listric_curve(40);
  for (const double angle : {0.0, 20.0, -20.0}) {
    for (const Amount amount : {Amount{Measure::Slip, -250.0}, Amount{Measure::Heave, -200.0},
                                Amount{Measure::Throw, -90.0}, Amount{Measure::Slip, 400.0}}) {
      const double arc = 2200.0;
      const double h = shear_heave(path, degrees(angle), arc, amount).value();
      const BlockMap map{shear_over(path, degrees(angle), h).value()};
      const geom::Point from = point_at(path, arc);
      const geom::Point to = map.forward(from);
      const OnPath end = nearest(path, to);
      EXPECT_NEAR(end.distance, 0.0, 1e-9);
      // Up this path is towards -x.
      const double gone = amount.as == Measure::Slip    ? end.arc - arc
                          : amount.as == Measure::Heave ? from.x - to.x
                                                        : to.y - from.y;
      EXPECT_NEAR(gone, amount.value, 1e-8);
    }
  }
}

TEST(ShearOverAFault, AFaultAlongTheDirectionOrFoldedBackInItIsRefusedWithThePlace) {
  const FaultPath steep = test::fault({{0, 0}, {1000, 100}, {1100, 900}});
  const auto folded = shear_over(steep, degrees(30), 100.0);
  ASSERT_FALSE(folded);
  EXPECT_EQ(folded.error().code, base::ErrorCode::CannotRestore);
  EXPECT_EQ(folded.error().place->x, 1000.0);
  EXPECT_NE(folded.error().message.find("the fault turns against"), std::string::npos);
  EXPECT_NE(folded.error().message.find("at angles from"), std::string::npos);
  EXPECT_FALSE(shear_over(test::fault({{0, 0}, {0, 1000}}), degrees(0), 10.0));
}

}  // namespace
}  // namespace recon::kinematics
