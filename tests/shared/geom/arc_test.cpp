#include "shared/geom/arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace dobra::geom {
namespace {

using base::Angle;
using std::numbers::pi;

void expect_near(Point p, Point q, double tolerance = 1e-14) {
  EXPECT_NEAR(p.x, q.x, tolerance);
  EXPECT_NEAR(p.y, q.y, tolerance);
}

Arc quarter() { return *Arc::from_angles({0, 0}, 1, Angle{}, Angle::from_degrees(90)); }

TEST(Arc, QuarterCircleHasItsClosedForms) {
  expect_near(quarter().point(0), {1, 0});
  expect_near(quarter().point(1), {0, 1});
  expect_near(quarter().point(0.5), {std::sqrt(0.5), std::sqrt(0.5)});
  EXPECT_NEAR(quarter().length(), pi / 2, 1e-15);
  EXPECT_NEAR(length(quarter().tangent(0.3)), pi / 2, 1e-15);
  EXPECT_NEAR(quarter().tangent(0).x, 0.0, 1e-15);
  EXPECT_GT(quarter().tangent(0).y, 0.0);
}

TEST(Arc, TangentIsTheDerivativeOfThePoint) {
  const Arc arc = *Arc::from_angles({3, -1}, 2, Angle::from_degrees(20), Angle::from_degrees(-250));
  constexpr double h = 1e-5;
  for (const double t : {0.1, 0.5, 0.8}) {
    const Vector slope = (arc.point(t + h) - arc.point(t - h)) / (2 * h);
    EXPECT_NEAR(slope.x, arc.tangent(t).x, 1e-7);
    EXPECT_NEAR(slope.y, arc.tangent(t).y, 1e-7);
  }
}

TEST(Arc, EndsGivenAreKeptBitForBit) {
  const Point from{0.1 + 3 * std::cos(0.3), 0.2 + 3 * std::sin(0.3)};
  const Point to{0.1 + 3 * std::cos(2.0), 0.2 + 3 * std::sin(2.0)};
  const Arc shorter = *Arc::from_ends({0.1, 0.2}, from, to, Orientation::Anticlockwise);
  EXPECT_EQ(shorter.point(0), from);
  EXPECT_EQ(shorter.point(1), to);
  EXPECT_NEAR(shorter.sweep().radians(), 1.7, 1e-14);
  const Arc longer = *Arc::from_ends({0.1, 0.2}, from, to, Orientation::Clockwise);
  EXPECT_NEAR(longer.sweep().radians(), 1.7 - 2 * pi, 1e-14);
}

TEST(Arc, EqualEndsGiveTheFullCircle) {
  for (const Orientation orientation : {Orientation::Anticlockwise, Orientation::Clockwise}) {
    const Arc arc = *Arc::from_ends({0, 0}, {3, 4}, {3, 4}, orientation);
    EXPECT_NEAR(arc.length(), 10 * pi, 1e-13);
    EXPECT_TRUE(arc.closed());
    EXPECT_EQ(arc.sweep().radians() > 0, orientation == Orientation::Anticlockwise);
    EXPECT_NEAR(arc.box().width(), 10.0, 1e-14);
    EXPECT_NEAR(arc.box().height(), 10.0, 1e-14);
  }
  EXPECT_FALSE(quarter().closed());
}

TEST(Arc, ThroughThreePointsPassesThroughThem) {
  const Arc upper = *Arc::through({1, 0}, {0, 1}, {-1, 0});
  expect_near(upper.centre(), {0, 0});
  EXPECT_NEAR(upper.radius(), 1.0, 1e-15);
  EXPECT_NEAR(upper.sweep().radians(), pi, 1e-15);
  const Arc clockwise = *Arc::through({-1, 0}, {0, 1}, {1, 0});
  EXPECT_NEAR(clockwise.sweep().radians(), -pi, 1e-15);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(0.1, 2.0);
  for (int i = 0; i < 100; ++i) {
    const Arc truth = *Arc::from_angles({50, -20}, 7, Angle::from_radians(3 * angle(random)),
                                        Angle::from_radians((i % 2 == 0 ? 3.0 : -3.0) * angle(random)));
    const Arc arc = *Arc::through(truth.from(), truth.point(0.4), truth.to());
    expect_near(arc.centre(), truth.centre(), 1e-10);
    EXPECT_NEAR(arc.sweep().radians(), truth.sweep().radians(), 1e-10);
    EXPECT_EQ(arc.to(), truth.to());
  }
}

TEST(Arc, BoxHoldsTheArcTightly) {
  const Arc arc = *Arc::from_angles({1, 1}, 2, Angle::from_degrees(-45), Angle::from_degrees(90));
  const double side = 2 * std::sqrt(0.5);
  EXPECT_NEAR(arc.box().low.x, 1 + side, 1e-14);
  EXPECT_NEAR(arc.box().high.x, 3.0, 1e-14);
  EXPECT_NEAR(arc.box().low.y, 1 - side, 1e-14);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> degrees(-360.0, 360.0);
  for (int i = 0; i < 200; ++i) {
    const Arc any =
        *Arc::from_angles({0, 0}, 1, Angle::from_degrees(degrees(random)), Angle::from_degrees(degrees(random)));
    Box sampled;
    for (int k = 0; k <= 1000; ++k) sampled.add(any.point(k / 1000.0));
    ASSERT_NEAR(any.box().low.x, sampled.low.x, 1e-5);
    ASSERT_NEAR(any.box().high.x, sampled.high.x, 1e-5);
    ASSERT_NEAR(any.box().low.y, sampled.low.y, 1e-5);
    ASSERT_NEAR(any.box().high.y, sampled.high.y, 1e-5);
  }
}

TEST(Arc, ReversedRunsTheSamePointsBackwards) {
  const Arc arc = *Arc::from_angles({1, 2}, 3, Angle::from_degrees(10), Angle::from_degrees(-200));
  const Arc back = arc.reversed();
  EXPECT_EQ(back.from(), arc.to());
  EXPECT_EQ(back.to(), arc.from());
  for (const double t : {0.0, 0.25, 0.7, 1.0}) expect_near(back.point(t), arc.point(1 - t));
}

TEST(Arc, ErrorsSayWhatToChange) {
  using base::ErrorCode;
  EXPECT_EQ(Arc::from_angles({0, 0}, 0, Angle{}, Angle::from_degrees(9)).error().code, ErrorCode::DegenerateCurve);
  EXPECT_EQ(Arc::from_angles({0, 0}, 1, Angle{}, Angle{}).error().code, ErrorCode::DegenerateCurve);
  EXPECT_EQ(Arc::from_angles({0, 0}, 1, Angle{}, Angle::from_degrees(400)).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(Arc::from_angles({0, 0}, std::nan(""), Angle{}, Angle{}).error().code, ErrorCode::NotFinite);
  EXPECT_EQ(Arc::from_ends({0, 0}, {1, 0}, {0, 2}, Orientation::Clockwise).error().code, ErrorCode::DegenerateCurve);
  EXPECT_EQ(Arc::from_ends({0, 0}, {0, 0}, {0, 2}, Orientation::Clockwise).error().code, ErrorCode::DegenerateCurve);
  const auto straight = Arc::through({0, 0}, {1, 1}, {2, 2});
  ASSERT_FALSE(straight.ok());
  EXPECT_EQ(straight.error().code, ErrorCode::DegenerateCurve);
  EXPECT_EQ(straight.error().place->x, 1.0);
}

}  // namespace
}  // namespace dobra::geom
