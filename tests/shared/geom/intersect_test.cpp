#include "shared/geom/intersect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "tests/shared/geom/exact.h"

namespace dobra::geom {
namespace {

using namespace testing;

/// What two segments of positive length have in common, by rational arithmetic: nothing, a point or two.
struct Common {
  std::optional<RationalPoint> start;
  std::optional<RationalPoint> end;
};

Common exact_intersection(const Segment& first, const Segment& second) {
  const auto [a, b] = first;
  const auto [c, d] = second;
  const RationalPoint p = exact(a);
  const Rational dx = Rational(b.x) - p.x;
  const Rational dy = Rational(b.y) - p.y;
  const auto at = [&](const Rational& t) { return RationalPoint{p.x + t * dx, p.y + t * dy}; };
  const Rational denominator = exact_cross(a, b, c, d);
  if (denominator != 0) {
    const Rational t = exact_cross(a, c, c, d) / denominator;
    const Rational u = exact_cross(a, c, a, b) / denominator;
    if (t < 0 || t > 1 || u < 0 || u > 1) return {};
    return {at(t), std::nullopt};
  }
  if (exact_cross(a, b, a, c) != 0) return {};
  const Rational squared = dx * dx + dy * dy;
  Rational from = exact_dot(a, b, a, c) / squared;
  Rational to = exact_dot(a, b, a, d) / squared;
  if (from > to) std::swap(from, to);
  from = std::max(from, Rational(0));
  to = std::min(to, Rational(1));
  if (from > to) return {};
  if (from == to) return {at(from), std::nullopt};
  return {at(from), at(to)};
}

At exact_place(const Segment& segment, const RationalPoint& p) {
  if (p == exact(segment.from)) return At::From;
  return p == exact(segment.to) ? At::To : At::Interior;
}

bool nearest_double(double value, const Rational& truth) {
  const Rational error = abs(Rational(Rational(value) - truth));
  return error <= abs(Rational(Rational(moved_by_ulps(value, 1)) - truth)) &&
         error <= abs(Rational(Rational(moved_by_ulps(value, -1)) - truth));
}

void expect_exact(const Segment& first, const Segment& second) {
  const Intersection found = intersect(first, second);
  const Common common = exact_intersection(first, second);
  SCOPED_TRACE(::testing::Message() << first.from << first.to << second.from << second.to);
  const auto expect_meeting = [&](const Meeting& meeting, const RationalPoint& truth) {
    EXPECT_EQ(meeting.on_first, exact_place(first, truth));
    EXPECT_EQ(meeting.on_second, exact_place(second, truth));
    if (meeting.proper()) {
      EXPECT_TRUE(nearest_double(meeting.point.x, truth.x) && nearest_double(meeting.point.y, truth.y));
    } else {
      EXPECT_EQ(exact(meeting.point), truth);
    }
  };
  if (!common.start) {
    EXPECT_EQ(found.kind, IntersectionKind::None);
    return;
  }
  ASSERT_EQ(found.kind, common.end ? IntersectionKind::Overlap : IntersectionKind::Point);
  expect_meeting(found.start, *common.start);
  if (common.end) expect_meeting(found.end, *common.end);
}

TEST(Intersect, DiagonalsOfASquareCrossInItsCentre) {
  const auto found = intersect({{0, 0}, {2, 2}}, {{0, 2}, {2, 0}});
  ASSERT_EQ(found.kind, IntersectionKind::Point);
  EXPECT_EQ(found.start.point, (Point{1, 1}));
  EXPECT_TRUE(found.start.proper());
}

TEST(Intersect, TouchReturnsTheEndPointAndTellsWhichItIs) {
  const auto found = intersect({{0, 0}, {3, 0}}, {{1, 5}, {1, 0}});
  ASSERT_EQ(found.kind, IntersectionKind::Point);
  EXPECT_EQ(found.start.point, (Point{1, 0}));
  EXPECT_EQ(found.start.on_first, At::Interior);
  EXPECT_EQ(found.start.on_second, At::To);
  const auto corner = intersect({{0, 0}, {3, 0}}, {{3, 0}, {1, 4}});
  EXPECT_EQ(corner.start.on_first, At::To);
  EXPECT_EQ(corner.start.on_second, At::From);
}

TEST(Intersect, OverlapRunsAlongTheFirstSegment) {
  const auto found = intersect({{4, 4}, {0, 0}}, {{1, 1}, {9, 9}});
  ASSERT_EQ(found.kind, IntersectionKind::Overlap);
  EXPECT_EQ(found.start.point, (Point{4, 4}));
  EXPECT_EQ(found.start.on_first, At::From);
  EXPECT_EQ(found.start.on_second, At::Interior);
  EXPECT_EQ(found.end.point, (Point{1, 1}));
  EXPECT_EQ(found.end.on_first, At::Interior);
  EXPECT_EQ(found.end.on_second, At::From);
}

TEST(Intersect, ParallelAndDisjointSegmentsHaveNothingInCommon) {
  EXPECT_EQ(intersect({{0, 0}, {2, 0}}, {{0, 1}, {2, 1}}).kind, IntersectionKind::None);
  EXPECT_EQ(intersect({{0, 0}, {1, 1}}, {{2, 2}, {3, 3}}).kind, IntersectionKind::None);
  EXPECT_EQ(intersect({{0, 0}, {4, 4}}, {{3, 0}, {4, 1}}).kind, IntersectionKind::None);
}

TEST(Intersect, SegmentOfZeroLengthIsAPoint) {
  EXPECT_EQ(intersect({{1, 1}, {1, 1}}, {{0, 0}, {2, 2}}).kind, IntersectionKind::Point);
  EXPECT_EQ(intersect({{0, 0}, {2, 2}}, {{1, 1}, {1, 1}}).start.on_second, At::From);
  EXPECT_EQ(intersect({{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}).kind, IntersectionKind::Point);
  EXPECT_EQ(intersect({{1, 0}, {1, 0}}, {{0, 0}, {2, 2}}).kind, IntersectionKind::None);
  EXPECT_EQ(intersect({{1, 1}, {1, 1}}, {{1, 2}, {1, 2}}).kind, IntersectionKind::None);
}

TEST(Intersect, AgreesWithRationalsOnAnIntegerGrid) {
  std::mt19937_64 random(1);
  int overlaps = 0;
  for (int i = 0; i < 4000; ++i) {
    const Segment first{integer_point(random, 5), integer_point(random, 5)};
    const Segment second{integer_point(random, 5), integer_point(random, 5)};
    if (first.from == first.to || second.from == second.to) continue;
    expect_exact(first, second);
    overlaps += intersect(first, second).kind == IntersectionKind::Overlap;
  }
  EXPECT_GT(overlaps, 20);
}

TEST(Intersect, AgreesWithRationalsOnSegmentsMovedByUlps) {
  std::mt19937_64 random(2);
  std::uniform_int_distribution<int> steps(-2, 2);
  const auto near_tenths = [&] {
    const Point p = integer_point(random, 4);
    return Point{moved_by_ulps(1.0 + 0.1 * p.x, steps(random)), moved_by_ulps(7.0 + 0.1 * p.y, steps(random))};
  };
  int crossings = 0;
  for (int i = 0; i < 4000; ++i) {
    const Segment first{near_tenths(), near_tenths()};
    const Segment second{near_tenths(), near_tenths()};
    if (first.from == first.to || second.from == second.to) continue;
    expect_exact(first, second);
    const auto found = intersect(first, second);
    crossings += found.kind == IntersectionKind::Point && found.start.proper();
  }
  EXPECT_GT(crossings, 100);
}

TEST(Intersect, AgreesWithRationalsOverManyExponents) {
  std::mt19937_64 random(3);
  int crossings = 0;
  for (int i = 0; i < 1500; ++i) {
    const Segment first{random_point(random, -80, 3), random_point(random, -80, 3)};
    const Segment second{random_point(random, -80, 3), random_point(random, -80, 3)};
    expect_exact(first, second);
    crossings += intersect(first, second).kind == IntersectionKind::Point;
  }
  EXPECT_GT(crossings, 20);
}

TEST(Intersect, NearlyParallelCrossingIsRoundedOnce) {
  const double ulp = std::numeric_limits<double>::epsilon();
  expect_exact({{0, 0}, {1, 1}}, {{0, ulp / 4}, {1, 1 - ulp}});
  expect_exact({{1e6, 1e6}, {1e6 + 1, 1e6 + 1 + 0x1p-30}}, {{1e6, 1e6 + 0x1p-31}, {1e6 + 1, 1e6 + 1}});
}

TEST(Intersect, HugeAndTinySegmentsCrossInsideTheirBoxes) {
  for (const double size : {1e-300, 1e300}) {
    const auto found = intersect({{0, 0}, {size, size}}, {{0, size}, {size, 0}});
    ASSERT_EQ(found.kind, IntersectionKind::Point) << size;
    EXPECT_EQ(found.start.point, (Point{0.5 * size, 0.5 * size}));
  }
}

TEST(Intersect, SwappingOrTurningSegmentsKeepsThePoint) {
  std::mt19937_64 random(4);
  int crossings = 0;
  for (int i = 0; i < 3000; ++i) {
    const Segment first{random_point(random, -3, 3), random_point(random, -3, 3)};
    const Segment second{random_point(random, -3, 3), random_point(random, -3, 3)};
    const auto found = intersect(first, second);
    if (found.kind != IntersectionKind::Point) continue;
    ++crossings;
    const auto swapped = intersect({second.to, second.from}, first);
    ASSERT_EQ(swapped.kind, IntersectionKind::Point);
    ASSERT_EQ(swapped.start.point, found.start.point);
    ASSERT_EQ(swapped.start.on_second, found.start.on_first);
  }
  EXPECT_GT(crossings, 100);
}

TEST(Intersect, PointOnSegmentIsExact) {
  const Segment segment{{0, 0}, {3, 1}};
  EXPECT_TRUE(point_on_segment({0, 0}, segment));
  EXPECT_TRUE(point_on_segment({1.5, 0.5}, segment));
  EXPECT_FALSE(point_on_segment({1.5, moved_by_ulps(0.5, 1)}, segment));
  EXPECT_FALSE(point_on_segment({6, 2}, segment));
}

TEST(Intersect, PointsAreSortedAlongTheSegmentAndRepeatedOnesDropped) {
  std::mt19937_64 random(5);
  const Segment segment{{5, 1}, {-2, 4}};
  std::vector<Point> points;
  for (int i = 0; i < 200; ++i) points.push_back(integer_point(random, 7));
  sort_along(segment, points);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    ASSERT_NE(points[i], points[i + 1]);
    const Rational ahead = exact_dot(points[i], points[i + 1], segment.from, segment.to);
    ASSERT_TRUE(ahead > 0 || (ahead == 0 && points[i] < points[i + 1]));
  }
  EXPECT_GT(points.size(), 40U);
}

}  // namespace
}  // namespace dobra::geom
