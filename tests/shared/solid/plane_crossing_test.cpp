#include "shared/solid/plane_crossing.h"

#include <gtest/gtest.h>

#include <random>

#include "shared/solid/space.h"

namespace dobra::solid {
namespace {

using geom::Point3;

/// By exact numbers.
Point3 exact_crossing(const CutPlane& plane, Point3 p, Point3 q) {
  Space space;
  const PlaneId cut = space.add(Plane{{Point3{plane.a, plane.b, plane.c}, {}, {}}, plane.d});
  const PointId first = space.add(p), last = space.add(q);
  return space.rounded(space.meet(first, last, cut));
}

bool apart(const CutPlane& plane, Point3 p, Point3 q) {
  Space space;
  const PlaneId cut = space.add(Plane{{Point3{plane.a, plane.b, plane.c}, {}, {}}, plane.d});
  return space.side(cut, p) != space.side(cut, q) && space.side(cut, p) != geom::Sign::Zero &&
         space.side(cut, q) != geom::Sign::Zero;
}

TEST(PlaneCrossing, IsTheNearestDoublesOrSaysThatItCannotTell) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> real(-1.0, 1.0);
  int sure = 0, asked = 0;
  for (int i = 0; i < 4000; ++i) {
    const double far = std::ldexp(1.0, static_cast<int>(random() % 30));    // far from the origin
    const double near = std::ldexp(1.0, -static_cast<int>(random() % 30));  // short edges
    const double flat = std::ldexp(1.0, -static_cast<int>(random() % 40));  // edges almost in the plane
    const CutPlane plane{real(random), real(random), random() % 3 == 0 ? 0.0 : real(random), far * real(random)};
    const geom::Vector3 n{plane.a, plane.b, plane.c};
    const Point3 on = Point3{} + (-plane.d / dot(n, n)) * n;
    const geom::Vector3 way = near * geom::Vector3{real(random), real(random), real(random)};
    const geom::Vector3 back = near * geom::Vector3{real(random), real(random), real(random)};
    const Point3 p = on + way + flat * n, q = on - back - flat * n;
    if (!apart(plane, p, q)) continue;
    const auto at = crossing_in_doubles(plane, p, q);
    if (flat > 1e-3) ++asked;
    if (!at) continue;
    if (flat > 1e-3) ++sure;
    EXPECT_EQ(*at, exact_crossing(plane, p, q)) << i;
    EXPECT_EQ(at, crossing_in_doubles(plane, q, p)) << i;
  }
  EXPECT_GT(asked, 800);
  EXPECT_GT(sure, 0.98 * asked);
}

TEST(PlaneCrossing, LeavesWhatLiesHalfWayBetweenTwoDoublesToExactNumbers) {
  const Point3 p{1.0, 0, -1}, q{std::nextafter(1.0, 2.0), 0, 1};  // z = 0 half way between neighbours
  EXPECT_FALSE(crossing_in_doubles({0, 0, 1, 0}, p, q));
  EXPECT_FALSE(crossing_in_doubles({0, 0, 1, 0}, {0x1p-300, 0, -1}, {1, 0, 1}));  // its square is no double
  EXPECT_EQ(crossing_in_doubles({0, 0, 1, 0}, {7, 0, -1}, {7, 3, 1}), (Point3{7, 1.5, 0}));
  EXPECT_EQ(crossing_in_doubles({0, 3, 0, 1}, {7, 0, 5}, {7, -1, 9})->y, -1.0 / 3.0);
}

}  // namespace
}  // namespace dobra::solid
