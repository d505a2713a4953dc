#include "shared/geom/discretise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "shared/geom/arc.h"

namespace dobra::geom {
namespace {

using base::Angle;
using base::ErrorCode;

DiscretiseOptions limits(double length, double degrees) {
  DiscretiseOptions options;
  options.max_length = length;
  options.max_angle = Angle::from_degrees(degrees);
  return options;
}

Arc arc(double degrees) { return *Arc::from_angles({0, 0}, 1, Angle{}, Angle::from_degrees(degrees)); }

/// y = f(x) over [0, 1] with the length by Simpson's rule.
CurveFunctions graph(double (*f)(double), double (*slope)(double)) {
  CurveFunctions curve;
  curve.point = [f](double t) { return Point{t, f(t)}; };
  curve.tangent = [slope](double t) { return Vector{1.0, slope(t)}; };
  curve.length = [slope](double t0, double t1) {
    constexpr int steps = 64;
    double sum = 0.0;
    for (int i = 0; i <= steps; ++i) {
      const double weight = i == 0 || i == steps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
      sum += weight * std::hypot(1.0, slope(t0 + (t1 - t0) * i / steps));
    }
    return sum * (t1 - t0) / (3.0 * steps);
  };
  return curve;
}

TEST(Discretise, SUR_b_QuarterCircleHasTheNumbersOfSegmentsRequired) {
  const auto segments = [](double length, double degrees) {
    return discretise(arc(90), limits(length, degrees))->points.size() - 1;
  };
  EXPECT_EQ(segments(10, 10), 16U);
  EXPECT_EQ(segments(10, 15), 8U);
  EXPECT_EQ(segments(0.3, 10), 12U);
  EXPECT_EQ(segments(0.3, 20), 6U);
  EXPECT_EQ(segments(0.1, 45), 16U);
}

TEST(Discretise, LimitsThatDivideTheCurveExactlyAreMetWithoutAnExtraBisection) {
  EXPECT_EQ(discretise(arc(90), limits(10, 45))->points.size(), 3U);
  EXPECT_EQ(discretise(arc(90), limits(std::numbers::pi / 6, 90))->points.size(), 4U);
}

TEST(Discretise, ALengthThatVariesOnlyBisects) {
  DiscretiseOptions options = limits(0.3, 90);
  options.max_length_over = [](double t0, double) { return t0 < 0.3 ? 0.05 : 1.0; };
  const auto line = graph([](double) { return 3.0; }, [](double) { return 0.0; });
  const auto found = *discretise(line, options);
  for (std::size_t i = 0; i + 1 < found.parameters.size(); ++i) {
    const double length = found.parameters[i + 1] - found.parameters[i];
    if (found.parameters[i] < 0.3) {
      EXPECT_NEAR(length, 0.25 / 8, 1e-12);
    }
    if (found.parameters[i] >= 0.5) {
      EXPECT_NEAR(length, 0.25, 1e-12);
    }
  }
}

TEST(Discretise, EndPointsAreExactAndParametersAscend) {
  const Point from{0.3 + 0.1, 0.7};
  const Point to{0.3, 0.7 + 0.1};
  const Arc curve = *Arc::from_ends({0.3, 0.7}, from, to, Orientation::Clockwise);
  const auto found = *discretise(curve, limits(0.01, 7));
  EXPECT_EQ(found.points.front(), from);
  EXPECT_EQ(found.points.back(), to);
  EXPECT_EQ(found.parameters.front(), 0.0);
  EXPECT_EQ(found.parameters.back(), 1.0);
  for (std::size_t i = 0; i + 1 < found.parameters.size(); ++i) {
    ASSERT_LT(found.parameters[i], found.parameters[i + 1]);
    ASSERT_EQ(found.points[i], curve.point(found.parameters[i]));
  }
}

TEST(Discretise, FullCircleIsNotTakenForStraight) {
  const auto circle = *discretise(*Arc::circle({0, 0}, 1), limits(100, 10));
  EXPECT_EQ(circle.points.size() - 1, 64U);  // 360 / 64 = 5.625 <= 10 < 360 / 32
  const Polyline contour = circle.polyline();
  EXPECT_TRUE(contour.closed);
  EXPECT_EQ(contour.points.size(), 64U);
  EXPECT_NEAR(signed_area(contour), 32 * std::sin(2 * std::numbers::pi / 64), 1e-13);
  EXPECT_GT(discretise(arc(357), limits(100, 10))->points.size(), 33U);
}

TEST(Discretise, SCurveWithParallelEndTangentsIsNotTakenForStraight) {
  const auto wave = graph([](double x) { return 0.2 * std::sin(2 * std::numbers::pi * x); },
                          [](double x) { return 0.4 * std::numbers::pi * std::cos(2 * std::numbers::pi * x); });
  EXPECT_GT(discretise(wave, limits(100, 10))->points.size(), 17U);
}

TEST(Discretise, EverySegmentMeetsBothLimits) {
  const auto curve = graph([](double x) { return x * x * x; }, [](double x) { return 3 * x * x; });
  for (const auto& options : {limits(0.05, 90), limits(9, 2), limits(0.11, 5)}) {
    const auto found = *discretise(curve, options);
    ASSERT_GT(found.points.size(), 10U);
    for (std::size_t i = 0; i + 1 < found.parameters.size(); ++i) {
      const double t0 = found.parameters[i];
      const double t1 = found.parameters[i + 1];
      const double turned = std::atan(3 * t1 * t1) - std::atan(3 * t0 * t0);
      ASSERT_LE(turned, options.max_angle.radians() * (1 + 2e-9));
      ASSERT_LE(curve.length(t0, t1), options.max_length * (1 + 2e-9));
    }
  }
}

TEST(Discretise, StraightCurveIsCutByLengthAlone) {
  const auto line = graph([](double) { return 3.0; }, [](double) { return 0.0; });
  EXPECT_EQ(discretise(line, limits(0.25, 1))->parameters, (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
  EXPECT_EQ(discretise(line)->points.size(), 2U);
}

TEST(Discretise, VanishingEndTangentIsReplacedByTheChord) {
  CurveFunctions curve;  // t^2 along x: the derivative is zero at t = 0
  curve.point = [](double t) { return Point{t * t, 0}; };
  curve.tangent = [](double t) { return Vector{2 * t, 0}; };
  curve.length = [](double t0, double t1) { return t1 * t1 - t0 * t0; };
  EXPECT_EQ(discretise(curve, limits(10, 5))->points.size(), 2U);
}

TEST(Discretise, CornerIsAnErrorAtItsPlace) {
  const auto corner = graph([](double x) { return std::abs(x - 0.3); }, [](double x) { return x < 0.3 ? -1.0 : 1.0; });
  const auto found = discretise(corner, limits(10, 10));
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().code, ErrorCode::DegenerateCurve);
  ASSERT_TRUE(found.error().place.has_value());
  EXPECT_NEAR(*found.error().place->x, 0.3, 1e-6);
}

TEST(Discretise, OptionsThatCannotBeMetAreErrors) {
  EXPECT_EQ(discretise(arc(90), limits(0, 10)).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(discretise(arc(90), limits(1, 0)).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(discretise(arc(90), limits(std::nan(""), 5)).error().code, ErrorCode::InvalidOption);
  EXPECT_EQ(discretise(arc(90), limits(1e-12, 5)).error().code, ErrorCode::InvalidOption);
  CurveFunctions point;
  point.point = [](double) { return Point{1, 1}; };
  point.tangent = [](double) { return Vector{}; };
  point.length = [](double, double) { return 0.0; };
  EXPECT_EQ(discretise(point).error().code, ErrorCode::DegenerateCurve);
}

}  // namespace
TEST(Discretise, FullTurnsOfASpiralAreNotTakenForAStraightPiece) {
  for (const double turns : {1.0, 2.0, 4.0, 8.0}) {
    const double end = 2.0 * std::numbers::pi * turns;
    // r = 1 + t: an Archimedean spiral, with the integral of its speed in closed form.
    const auto arc = [end](double t) {
      const double r = 1.0 + end * t;
      return 0.5 * (r * std::sqrt(r * r + 1.0) + std::asinh(r));
    };
    CurveFunctions spiral;
    spiral.point = [end](double t) {
      return Point{(1.0 + end * t) * std::cos(end * t), (1.0 + end * t) * std::sin(end * t)};
    };
    spiral.tangent = [end](double t) {
      const double a = end * t;
      const double r = 1.0 + a;
      return end * Vector{std::cos(a) - r * std::sin(a), std::sin(a) + r * std::cos(a)};
    };
    spiral.length = [arc](double t0, double t1) { return arc(t1) - arc(t0); };
    const auto pieces = discretise(spiral, {.max_angle = base::Angle::from_degrees(10.0)});
    ASSERT_TRUE(pieces.ok());
    EXPECT_GE(static_cast<double>(pieces->parameters.size() - 1), 36.0 * turns);
  }
}

}  // namespace dobra::geom
