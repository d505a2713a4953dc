#include "shared/geom/polyline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace dobra::geom {
namespace {

Polyline square(double size) { return {{{0, 0}, {size, 0}, {size, size}, {0, size}}, true}; }

TEST(Polyline, SquareHasFourSidesAndSquareArea) {
  EXPECT_EQ(square(3).segment_count(), 4U);
  EXPECT_EQ(length(square(3)), 12.0);
  EXPECT_EQ(signed_area(square(3)), 9.0);
  EXPECT_EQ(signed_area(reversed(square(3))), -9.0);
  EXPECT_EQ(square(3).segment(3), (Segment{{0, 3}, {0, 0}}));
}

TEST(Polyline, OpenChainHasOneSegmentFewerAndNoArea) {
  const Polyline chain{{{0, 0}, {3, 4}, {3, 5}}, false};
  EXPECT_EQ(chain.segment_count(), 2U);
  EXPECT_EQ(length(chain), 6.0);
  EXPECT_EQ(signed_area(chain), 0.0);
  EXPECT_EQ((Polyline{{{1, 1}}, true}).segment_count(), 0U);
}

TEST(Polyline, AreaFarFromTheOriginKeepsItsDigits) {
  Polyline far = square(1);
  for (Point& p : far.points) p = p + Vector{4e6, 7e6};
  EXPECT_EQ(signed_area(far), 1.0);
}

TEST(Polyline, LengthOfManySegmentsDoesNotDrift) {
  Polyline chain;
  for (int i = 0; i <= 1000000; ++i) chain.points.push_back({0.0, 0.1 * i});
  EXPECT_NEAR(length(chain), 100000.0, 1e-10);
}

TEST(Polyline, PointAtFollowsTheArcAndGoesOnStraightBeyondTheEnds) {
  const Polyline chain{{{0, 0}, {2, 0}, {2, 4}}, false};
  const auto arc = arc_lengths(chain);
  EXPECT_EQ(arc, (std::vector<double>{0, 2, 6}));
  EXPECT_EQ(point_at(chain, arc, 0), (Point{0, 0}));
  EXPECT_EQ(point_at(chain, arc, 2), (Point{2, 0}));
  EXPECT_EQ(point_at(chain, arc, 3), (Point{2, 1}));
  EXPECT_EQ(point_at(chain, arc, 6), (Point{2, 4}));
  EXPECT_EQ(point_at(chain, arc, -1), (Point{-1, 0}));
  EXPECT_EQ(point_at(chain, arc, 8), (Point{2, 6}));
}

TEST(Polyline, PointAtOnAClosedContourReturnsToItsStart) {
  const auto arc = arc_lengths(square(2));
  EXPECT_EQ(arc.size(), 5U);
  EXPECT_EQ(point_at(square(2), arc, 7), (Point{0, 1}));
  EXPECT_EQ(point_at(square(2), arc, 8), (Point{0, 0}));
}

TEST(Polyline, PointAtIsDefinedWhereEndPointsAreRepeated) {
  const Polyline chain{{{0, 0}, {0, 0}, {2, 0}, {2, 0}}, false};
  const auto arc = arc_lengths(chain);
  EXPECT_EQ(point_at(chain, arc, -1), (Point{-1, 0}));
  EXPECT_EQ(point_at(chain, arc, 0), (Point{0, 0}));
  EXPECT_EQ(point_at(chain, arc, 2), (Point{2, 0}));
  EXPECT_EQ(point_at(chain, arc, 3), (Point{3, 0}));
  const Polyline point{{{4, 5}, {4, 5}}, false};
  EXPECT_EQ(point_at(point, arc_lengths(point), 1), (Point{4, 5}));
}

TEST(Polyline, DistanceIsToTheNearestSide) {
  EXPECT_EQ(distance(square(4), {1, 2}), 1.0);
  EXPECT_EQ(distance(square(4), {7, 8}), 5.0);
  EXPECT_EQ(distance(square(4), {4, 3}), 0.0);
}

TEST(Polyline, RepeatedPointsAreDroppedAndTheClosingOneToo) {
  const Polyline repeated{{{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 0}}, true};
  EXPECT_EQ(without_repeated_points(repeated), (Polyline{{{0, 0}, {1, 0}, {1, 1}}, true}));
  Polyline open = repeated;
  open.closed = false;
  EXPECT_EQ(without_repeated_points(open), (Polyline{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, false}));
}

TEST(Polyline, ValidationNamesWhatIsWrong) {
  EXPECT_TRUE(validate(square(1)).ok());
  const auto nan = validate({{{0, 0}, {1, std::nan("")}}, false});
  ASSERT_FALSE(nan.ok());
  EXPECT_EQ(nan.error().code, base::ErrorCode::NotFinite);
  EXPECT_NE(nan.error().message.find("point 2"), std::string::npos);
  const auto flat = validate({{{3, 4}, {3, 4}, {5, 6}}, true});
  ASSERT_FALSE(flat.ok());
  EXPECT_EQ(flat.error().code, base::ErrorCode::DegenerateCurve);
  EXPECT_EQ(flat.error().place->x, 3.0);
  EXPECT_EQ(validate({{}, false}).error().code, base::ErrorCode::DegenerateCurve);
}

TEST(Polyline, PointsAreLocatedInsideOutsideOrOnTheBoundary) {
  const Polyline contour{{{0, 0}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}, true};
  EXPECT_EQ(locate(contour, {1, 1}), Side::Inside);
  EXPECT_EQ(locate(contour, {2, 3}), Side::Outside);
  EXPECT_EQ(locate(contour, {-1, 4}), Side::Outside);
  EXPECT_EQ(locate(contour, {1, 2}), Side::Inside);  // level with the notch
  EXPECT_EQ(locate(contour, {3, 3}), Side::Boundary);
  EXPECT_EQ(locate(contour, {2, 2}), Side::Boundary);
  EXPECT_EQ(locate(contour, {4, 1}), Side::Boundary);
}

TEST(Polyline, LocationDoesNotDependOnStartOrDirection) {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> coordinate(0, 8);
  Polyline contour{{{0, 0}, {8, 1}, {5, 4}, {8, 8}, {3, 5}, {0, 7}}, true};
  for (int i = 0; i < 200; ++i) {
    const Point p{static_cast<double>(coordinate(random)), static_cast<double>(coordinate(random))};
    const Side side = locate(contour, p);
    Polyline turned = contour;
    for (std::size_t start = 0; start < contour.points.size(); ++start) {
      std::rotate(turned.points.begin(), turned.points.begin() + 1, turned.points.end());
      ASSERT_EQ(locate(turned, p), side) << p;
      ASSERT_EQ(locate(reversed(turned), p), side) << p;
    }
  }
}

}  // namespace
}  // namespace dobra::geom
