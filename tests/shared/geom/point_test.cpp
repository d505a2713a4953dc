#include "shared/geom/point.h"

#include <gtest/gtest.h>

#include "shared/geom/box.h"
#include "shared/geom/segment.h"

namespace dobra::geom {
namespace {

TEST(Point, LeftIsAQuarterTurnAnticlockwise) {
  EXPECT_EQ(left_of({1, 0}), (Vector{0, 1}));
  EXPECT_EQ(right_of({1, 0}), (Vector{0, -1}));
  EXPECT_GT(cross({1, 0}, left_of({1, 0})), 0.0);
}

TEST(Point, InterpolationIsExactAtBothEnds) {
  const Point p{0.1, 1e17};
  const Point q{0.7, -3.3};
  EXPECT_EQ(interpolate(p, q, 0.0), p);
  EXPECT_EQ(interpolate(p, q, 1.0), q);
}

TEST(Point, PointsAreOrderedByXThenY) {
  EXPECT_LT((Point{1, 9}), (Point{2, 0}));
  EXPECT_LT((Point{1, 0}), (Point{1, 9}));
}

TEST(Box, DefaultOneIsEmptyAndGrowsToWhatIsAdded) {
  Box box;
  EXPECT_TRUE(box.empty());
  EXPECT_EQ(box.diagonal(), 0.0);
  box.add(Point{1, 2});
  box.add(Point{4, -2});
  EXPECT_EQ(box, (Box{{1, -2}, {4, 2}}));
  EXPECT_EQ(box.diagonal(), 5.0);
  EXPECT_EQ(box.grown(1), (Box{{0, -3}, {5, 3}}));
  box.add(Box{});
  EXPECT_EQ(box.width(), 3.0);
}

TEST(Box, ClosedBoxesThatTouchOverlap) {
  const Box box{{0, 0}, {1, 1}};
  EXPECT_TRUE(box.overlaps({{1, 1}, {2, 2}}));
  EXPECT_FALSE(box.overlaps({{1.5, 0}, {2, 1}}));
  EXPECT_FALSE(box.overlaps(Box{}));
  EXPECT_TRUE(box.contains({1, 0}));
  EXPECT_FALSE(box.contains({1, -0.1}));
}

TEST(Segment, NearestFractionIsClampedToTheEnds) {
  const Segment segment{{0, 0}, {4, 0}};
  EXPECT_EQ(nearest_fraction(segment, {1, 7}), 0.25);
  EXPECT_EQ(nearest_fraction(segment, {-3, 4}), 0.0);
  EXPECT_EQ(distance(segment, {-3, 4}), 5.0);
  EXPECT_EQ(distance(segment, {9, 12}), 13.0);
  EXPECT_EQ(distance(Segment{{1, 1}, {1, 1}}, {4, 5}), 5.0);
}

}  // namespace
}  // namespace dobra::geom
