#include "shared/geom/transform.h"

#include <gtest/gtest.h>

#include <random>

namespace dobra::geom {
namespace {

using base::Angle;

void expect_within(Point p, Point q, double tolerance) {
  EXPECT_NEAR(p.x, q.x, tolerance);
  EXPECT_NEAR(p.y, q.y, tolerance);
}

TEST(Transform, TRF_e_PivotRotationTurnsAboutThePivot) {
  const auto turn = Transform::rotation(Angle::from_degrees(90), {2, 1});
  EXPECT_EQ(turn(Point{3, 1}), (Point{2, 2}));
  EXPECT_EQ(turn(Point{2, 1}), (Point{2, 1}));
}

TEST(Transform, REC_i_FaultBlockTurnedByChainedMatricesKeepsItsAreaAndComesBack) {
  const Point pivot{1200.0, -300.0};
  const Polyline block{{{1000, -800}, {2600, -900}, {2400, 50}, {1250, 0}}, true};
  for (const double degrees : {-37.0, -5.0, 12.5, 90.0, 180.0}) {
    const auto angle = Angle::from_degrees(degrees);
    const Transform to_pivot = Transform::translation({pivot.x, pivot.y});
    const Transform from_pivot = Transform::translation({-pivot.x, -pivot.y});
    const Transform chained = to_pivot * Transform::rotation(angle) * from_pivot;
    EXPECT_EQ(chained, Transform::rotation(angle, pivot));
    const Polyline turned = chained(block);
    EXPECT_NEAR(signed_area(turned), signed_area(block), 1e-12 * signed_area(block));
    const Polyline restored = Transform::rotation(Angle::from_degrees(-degrees), pivot)(turned);
    for (std::size_t i = 0; i < block.points.size(); ++i) {
      expect_within(restored.points[i], block.points[i], 1e-12 * 2600.0);
      EXPECT_NEAR(distance(turned.points[i], pivot), distance(block.points[i], pivot), 1e-12 * 2600.0);
    }
  }
}

TEST(Transform, QuarterTurnsAreExact) {
  EXPECT_EQ(Transform::rotation(Angle::from_degrees(90))(Point{3, 5}), (Point{-5, 3}));
  EXPECT_EQ(Transform::rotation(Angle::from_degrees(180))(Point{3, 5}), (Point{-3, -5}));
  EXPECT_EQ(Transform::rotation(Angle::from_degrees(-90))(Point{3, 5}), (Point{5, -3}));
  EXPECT_EQ(Transform::rotation(Angle::from_degrees(720)), Transform());
  expect_within(Transform::rotation(Angle::from_degrees(30))(Point{2, 0}), {std::sqrt(3.0), 1}, 1e-15);
}

TEST(Transform, TranslationMovesPointsAndLeavesDisplacements) {
  const auto move = Transform::translation({2, -3});
  EXPECT_EQ(move(Point{1, 1}), (Point{3, -2}));
  EXPECT_EQ(move(Vector{1, 1}), (Vector{1, 1}));
}

TEST(Transform, ScaleKeepsThePivotAndAMirrorTurnsAreasOver) {
  const auto stretch = Transform::scale(2, 3, {1, 1});
  EXPECT_EQ(stretch(Point{1, 1}), (Point{1, 1}));
  EXPECT_EQ(stretch(Point{2, 2}), (Point{3, 4}));
  const Polyline square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, true};
  EXPECT_EQ(signed_area(stretch(square)), 6.0);
  EXPECT_EQ(signed_area(Transform::scale(-1, 1)(square)), -1.0);
  EXPECT_EQ(Transform::scale(-1, 1).determinant(), -1.0);
}

TEST(Transform, ProductAppliesTheRightFactorFirst) {
  const auto turn = Transform::rotation(Angle::from_degrees(90));
  const auto move = Transform::translation({1, 0});
  EXPECT_EQ((move * turn)(Point{1, 0}), (Point{1, 1}));
  EXPECT_EQ((turn * move)(Point{1, 0}), (Point{0, 2}));
}

TEST(Transform, InverseTakesBackAndTheProductIsAssociative) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-3, 3);
  const auto any = [&] {
    return Transform::translation({number(random), number(random)}) *
           Transform::rotation(Angle::from_radians(number(random)), {number(random), 1}) *
           Transform::scale(4 + number(random), number(random) - 4);
  };
  for (int i = 0; i < 100; ++i) {
    const Transform a = any();
    const Transform b = any();
    const Point p{number(random), number(random)};
    expect_within((*a.inverse())(a(p)), p, 1e-12);
    expect_within(((*b.inverse()) * (*a.inverse()))((a * b)(p)), p, 1e-11);
    expect_within(((a * b) * a)(p), (a * (b * a))(p), 1e-10);
    EXPECT_NEAR((a * b).determinant(), a.determinant() * b.determinant(), 1e-10);
  }
}

TEST(Transform, FlatteningMapHasNoInverse) {
  EXPECT_FALSE(Transform::scale(1, 0).inverse().has_value());
  EXPECT_FALSE(Transform(1, 2, 0, 2, 4, 0).inverse().has_value());
}

TEST(Transform, MatrixIsHomogeneous) {
  const auto rows = Transform::translation({7, 8}).matrix();
  EXPECT_EQ(rows[0][2], 7.0);
  EXPECT_EQ(rows[1][2], 8.0);
  EXPECT_EQ(rows[2], (std::array<double, 3>{0, 0, 1}));
}

}  // namespace
}  // namespace dobra::geom
