#pragma once
// The oracle of the exact tests: the same quantities in rational arithmetic, and sources of nearly degenerate points.

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "shared/geom/intersect.h"
#include "shared/geom/predicates.h"

namespace dobra::geom::testing {

using Rational = boost::multiprecision::cpp_rational;

struct RationalPoint {
  Rational x;
  Rational y;
  friend bool operator==(const RationalPoint&, const RationalPoint&) = default;
};

inline RationalPoint exact(Point p) { return {Rational(p.x), Rational(p.y)}; }
inline Sign sign_of(const Rational& value) { return static_cast<Sign>(value.sign()); }

inline Rational exact_cross(Point a, Point b, Point c, Point d) {
  const auto [ax, ay] = exact(a);
  const auto [bx, by] = exact(b);
  const auto [cx, cy] = exact(c);
  const auto [dx, dy] = exact(d);
  return (bx - ax) * (dy - cy) - (by - ay) * (dx - cx);
}

inline Rational exact_dot(Point a, Point b, Point c, Point d) {
  const auto [ax, ay] = exact(a);
  const auto [bx, by] = exact(b);
  const auto [cx, cy] = exact(c);
  const auto [dx, dy] = exact(d);
  return (bx - ax) * (dx - cx) + (by - ay) * (dy - cy);
}

inline Sign exact_orient2d(Point a, Point b, Point c) { return sign_of(exact_cross(a, b, a, c)); }

inline Sign exact_incircle(Point a, Point b, Point c, Point d) {
  const auto [dx, dy] = exact(d);
  const auto moved = [&dx = dx, &dy = dy](Point p) { return RationalPoint{Rational(p.x) - dx, Rational(p.y) - dy}; };
  const auto lifted = [](const RationalPoint& p) -> Rational { return p.x * p.x + p.y * p.y; };
  const auto minor = [](const RationalPoint& p, const RationalPoint& q) -> Rational { return p.x * q.y - q.x * p.y; };
  const RationalPoint u = moved(a);
  const RationalPoint v = moved(b);
  const RationalPoint w = moved(c);
  return sign_of(Rational(lifted(u) * minor(v, w) + lifted(v) * minor(w, u) + lifted(w) * minor(u, v)));
}

/// `value` moved by `steps` representable numbers.
inline double moved_by_ulps(double value, int steps) {
  const double target = steps > 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  for (int i = 0; i < std::abs(steps); ++i) value = std::nextafter(value, target);
  return value;
}

/// A finite number of random sign and mantissa and an exponent between the two given.
inline double random_double(std::mt19937_64& random, int least_exponent, int greatest_exponent) {
  const double mantissa = std::uniform_real_distribution<double>(1.0, 2.0)(random);
  const int exponent = std::uniform_int_distribution<int>(least_exponent, greatest_exponent)(random);
  return std::ldexp(random() % 2 == 0 ? mantissa : -mantissa, exponent);
}

inline Point random_point(std::mt19937_64& random, int least_exponent, int greatest_exponent) {
  const double x = random_double(random, least_exponent, greatest_exponent);
  return {x, random_double(random, least_exponent, greatest_exponent)};
}

inline Point integer_point(std::mt19937_64& random, int size) {
  std::uniform_int_distribution<int> coordinate(0, size);
  const int x = coordinate(random);
  return {static_cast<double>(x), static_cast<double>(coordinate(random))};
}

}  // namespace dobra::geom::testing
