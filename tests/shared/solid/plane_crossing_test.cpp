#include "shared/solid/plane_crossing.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>

#include "shared/solid/section.h"

namespace dobra::solid {
namespace {

using geom::Point3;

Plane by_coefficients(double a, double b, double c, double d) { return {{Point3{a, b, c}, {}, {}}, d}; }

using Rational = boost::multiprecision::cpp_rational;
using Rational3 = std::array<Rational, 3>;
Rational3 rational(Point3 p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

/// n x + d in fractions, by a determinant where the plane runs through points.
Rational height(const Plane& plane, const Rational3& p) {
  const Rational3 a = rational(plane.through[0]);
  if (plane.constant) return a[0] * p[0] + a[1] * p[1] + a[2] * p[2] + Rational(*plane.constant);
  const Rational3 b = rational(plane.through[1]), c = rational(plane.through[2]);
  std::array<Rational3, 3> m;
  for (std::size_t i = 0; i < 3; ++i) m[i] = {b[i] - a[i], c[i] - a[i], p[i] - a[i]};
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Rational3 exact_crossing(const Plane& plane, Point3 p, Point3 q) {
  const Rational3 from = rational(p), to = rational(q);
  const Rational t = height(plane, from) / (height(plane, from) - height(plane, to));
  return {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), from[2] + t * (to[2] - from[2])};
}

/// Neither neighbour is nearer.
bool is_nearest(double value, const Rational& place) {
  const Rational off = abs(Rational(value) - place);
  return off <= abs(Rational(std::nextafter(value, -INFINITY)) - place) &&
         off <= abs(Rational(std::nextafter(value, INFINITY)) - place);
}

bool apart(const Plane& plane, Point3 p, Point3 q) {
  Space space;
  const PlaneId cut = space.add(plane);
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
    const Plane given =
        by_coefficients(real(random), real(random), random() % 3 == 0 ? 0.0 : real(random), far * real(random));
    const geom::Vector3 n = given.through[0] - Point3{};
    const Point3 on = Point3{} + (-*given.constant / dot(n, n)) * n;
    const auto any = [&] { return near * geom::Vector3{real(random), real(random), real(random)}; };
    const Plane through{{on, on + cross(n, any()), on + cross(n, any())}, {}};  // nearly the same plane
    const Point3 p = on + any() + flat * n, q = on - any() - flat * n;
    for (const Plane& plane : {given, through}) {
      if (!apart(plane, p, q)) continue;
      const auto found = crossing_in_doubles(plane, p, q);
      if (flat > 1e-3) ++asked;
      if (!found) continue;
      if (flat > 1e-3) ++sure;
      const Rational3 place = exact_crossing(plane, p, q);
      EXPECT_TRUE(is_nearest(found->at.x, place[0])) << i;
      EXPECT_TRUE(is_nearest(found->at.y, place[1])) << i;
      EXPECT_TRUE(is_nearest(found->at.z, place[2])) << i;
      EXPECT_FALSE(found->rounded && rational(found->at) == place) << i;
      EXPECT_EQ(found, crossing_in_doubles(plane, q, p)) << i;
    }
  }
  EXPECT_GT(asked, 1600);
  EXPECT_GT(sure, 0.98 * asked);
}

TEST(PlaneCrossing, LeavesWhatLiesHalfWayBetweenTwoDoublesToExactNumbers) {
  const Point3 p{1.0, 0, -1}, q{std::nextafter(1.0, 2.0), 0, 1};  // z = 0 half way between neighbours
  const Plane level = by_coefficients(0, 0, 1, 0);
  EXPECT_FALSE(crossing_in_doubles(level, p, q));
  EXPECT_FALSE(crossing_in_doubles(level, {0x1p-300, 0, -1}, {1, 0, 1}));  // its square is no double
  EXPECT_EQ(crossing_in_doubles(level, {7, 0, -1}, {7, 3, 1}), (CrossingInDoubles{{7, 1.5, 0}, false}));
  EXPECT_EQ(crossing_in_doubles(by_coefficients(0, 3, 0, 1), {7, 0, 5}, {7, -1, 9})->at.y, -1.0 / 3.0);
}

TEST(PlaneCrossing, TellsWhatIsOffAPlaneForSure) {
  const Plane plane{{Point3{0, 0, 1}, {1, 0, 2}, {0, 1, 3}}, {}};
  EXPECT_FALSE(apart_in_doubles(plane, {2, 3, 9}));
  EXPECT_TRUE(apart_in_doubles(plane, {2, 3, std::nextafter(9.0, 10.0)}));
  EXPECT_FALSE(apart_in_doubles(plane, {0x1p-300, 0, 1}));
}

/// Positive if a, b, c turn left.
int turn(const Rational3& a, const Rational3& b, const Rational3& c, Projection onto) {
  const auto u = static_cast<std::size_t>(onto.u), v = static_cast<std::size_t>(onto.v);
  const Rational value = (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
  return value.sign();
}

/// Edges through a common line and planes, each given in several ways, so that some places are equal and some are
/// nearly so.
struct Crossings {
  Space space;
  std::vector<PointId> points;
  std::vector<Rational3> places;

  explicit Crossings(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto some = [&] { return static_cast<double>(random() % 15) - 7.0; };
    const Point3 p{some(), some(), -8.0}, q{some(), some(), 9.0};
    const geom::Vector3 way = q - p;
    const Point3 beyond = q + way;
    const Point3 moved{std::nextafter(q.x, 100.0), q.y, q.z};
    const double a = some() / 64, b = some() / 64, d = some() / 7;
    const Point3 origin{some(), some(), 1.0};
    const geom::Vector3 u{5.0, some() / 8, some() / 32}, v{some() / 8, 5.0, some() / 32};
    const std::vector<Plane> planes{
        by_coefficients(a, b, 1.0, d),
        by_coefficients(2.0 * a, 2.0 * b, 2.0, 2.0 * d),
        by_coefficients(a + 0x1p-60, b, 1.0, d),
        {{origin, origin + u, origin + v}, {}},
        {{origin + u + v, origin - u, origin + 2.0 * v}, {}},
        {{origin, origin + u, {origin.x + v.x, std::nextafter(origin.y + v.y, 99.0), 1.0}}, {}}};
    for (const Plane& plane : planes) {
      const PlaneId cut = space.add(plane);
      for (const auto& [from, to] : {std::pair{p, q}, {q, p}, {p, beyond}, {p, moved}}) {
        if (!apart(plane, from, to)) continue;
        add(space.meet(space.add(from), space.add(to), cut), exact_crossing(plane, from, to));
      }
      if (!apart(plane, p, q)) continue;
      const PlaneId one = space.add(Plane{{p, q, p + geom::Vector3{1, 0, 0}}, {}});
      const PlaneId other = space.add(Plane{{p, q, p + geom::Vector3{0, 1, 0}}, {}});
      add(space.meet(one, other, cut), exact_crossing(plane, p, q));
    }
    for (const Point3 end : {p, q}) add(space.add(end), rational(end));
  }

  void add(PointId id, const Rational3& place) {
    points.push_back(id);
    places.push_back(place);
  }
};

TEST(SpaceCrossing, EqualPlacesAreOnePointHoweverTheyWereMade) {
  int equal = 0;
  int rounded_alike = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Crossings all(seed);
    for (std::size_t i = 0; i < all.points.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool same = all.places[i] == all.places[j];
        EXPECT_EQ(all.points[i] == all.points[j], same) << seed << ": " << i << ", " << j;
        if (same) ++equal;
        if (!same && all.space.rounded(all.points[i]) == all.space.rounded(all.points[j])) ++rounded_alike;
      }
    }
  }
  EXPECT_GT(equal, 10000);
  EXPECT_GT(rounded_alike, 1000);
}

TEST(SpaceCrossing, OrderAndTurnsAreThoseOfThePlaces) {
  int straight = 0;
  int bent = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Crossings all(seed);
    for (std::size_t i = 0; i < all.points.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (int axis = 0; axis < 3; ++axis) {
          const auto k = static_cast<std::size_t>(axis);
          EXPECT_EQ(all.space.compare(axis, all.points[i], all.points[j]),
                    all.places[i][k].compare(all.places[j][k]) <=> 0);
        }
        for (std::size_t k = 0; k < j; k += 3) {
          for (const Projection onto : {Projection{0, 1}, Projection{1, 2}, Projection{2, 0}}) {
            const int expected = turn(all.places[i], all.places[j], all.places[k], onto);
            EXPECT_EQ(static_cast<int>(all.space.orient(onto, all.points[i], all.points[j], all.points[k])), expected);
            ++(expected == 0 ? straight : bent);
          }
        }
      }
    }
  }
  EXPECT_GT(straight, 10000);
  EXPECT_GT(bent, 1000);
}

TEST(SpaceCrossing, IsTheSameInAnotherSpace) {
  const Crossings all(3);
  Space other;
  for (std::size_t i = 0; i < all.points.size(); ++i) {
    const PointId there = other.add(all.space, all.points[i]);
    EXPECT_EQ(other.rounded(there), all.space.rounded(all.points[i]));
    const Homogeneous place = other.place(there);
    EXPECT_TRUE(is_nearest(other.rounded(there).x, all.places[i][0]));
    EXPECT_EQ(place.weight.sign(), geom::Sign::Positive);
    EXPECT_EQ(other.add(place), there);
  }
}

}  // namespace
}  // namespace dobra::solid
