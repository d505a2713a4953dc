#include "shared/solid/plane_crossing.h"

#include <cmath>

#include "shared/geom/expansion.h"

namespace dobra::solid {
namespace {

using geom::fast_two_sum;
using geom::Point3;
using geom::two_product;
using geom::two_sum;
using geom::TwoTerms;

/// Of one sum, product or quotient of two pairs, relative to what goes in; [dekker1971arithmetic] has less.
constexpr double pair_unit = 0x1p-100;

TwoTerms sum(TwoTerms a, TwoTerms b) {
  const TwoTerms high = two_sum(a.high, b.high);
  const TwoTerms low = two_sum(a.low, b.low);
  const TwoTerms both = fast_two_sum(high.high, high.low + low.high);
  return fast_two_sum(both.high, both.low + low.low);
}

TwoTerms product(TwoTerms a, TwoTerms b) {
  const TwoTerms high = two_product(a.high, b.high);
  return fast_two_sum(high.high, high.low + (a.high * b.low + a.low * b.high));
}

TwoTerms quotient(TwoTerms a, TwoTerms b) {
  const double first = a.high / b.high;
  const TwoTerms back = product({first, 0.0}, b);
  const TwoTerms rest = sum(a, {-back.high, -back.low});
  const double second = rest.high / b.high;
  const TwoTerms again = product({second, 0.0}, b);
  const TwoTerms left = sum(rest, {-again.high, -again.low});
  return sum(fast_two_sum(first, second), {left.high / b.high, 0.0});
}

/// a x + b y + c z + d, and the sizes of what is added up.
struct Height {
  TwoTerms value;
  double sizes;
};

Height height(const CutPlane& plane, Point3 p) {
  const TwoTerms x = two_product(plane.a, p.x);
  const TwoTerms y = two_product(plane.b, p.y);
  const TwoTerms z = two_product(plane.c, p.z);
  return {sum(sum(x, y), sum(z, {plane.d, 0.0})),
          std::abs(x.high) + std::abs(y.high) + std::abs(z.high) + std::abs(plane.d)};
}

bool in_range(const CutPlane& plane, Point3 p) {
  constexpr double least = 0x1p-100, greatest = 0x1p100;
  for (const double value : {plane.a, plane.b, plane.c, plane.d, p.x, p.y, p.z}) {
    if (value != 0.0 && (std::abs(value) < least || std::abs(value) > greatest)) return false;
  }
  return true;
}

/// From p to q at the part t of the way, with its error; none if that leaves the nearest double open.
std::optional<double> between(double p, double q, TwoTerms t, double error) {
  if (p == q) return p;
  const TwoTerms way = two_sum(q, -p);
  const TwoTerms at = sum({p, 0.0}, product(t, way));
  const double bound = 2.0 * (error * std::abs(way.high) + 4.0 * pair_unit * (std::abs(p) + std::abs(way.high)));
  const bool sure = at.high + (at.low - bound) == at.high && at.high + (at.low + bound) == at.high;
  return sure ? std::optional(at.high) : std::nullopt;
}

}  // namespace

std::optional<Point3> crossing_in_doubles(const CutPlane& plane, Point3 p, Point3 q) {
  if (!in_range(plane, p) || !in_range(plane, q)) return std::nullopt;
  const Height at_p = height(plane, p);
  const Height at_q = height(plane, q);
  const TwoTerms rise = sum(at_p.value, {-at_q.value.high, -at_q.value.low});
  const TwoTerms t = quotient(at_p.value, rise);
  // Heights have opposite signs: nothing cancels in their difference, and t is between 0 and 1.
  const double error = 16.0 * pair_unit * (1.0 + (at_p.sizes + at_q.sizes) / std::abs(rise.high));
  // Along an axis that the plane stands upright on, all of it is at one place.
  const auto x = plane.b == 0.0 && plane.c == 0.0 ? 0.0 - plane.d / plane.a : between(p.x, q.x, t, error);
  const auto y = plane.a == 0.0 && plane.c == 0.0 ? 0.0 - plane.d / plane.b : between(p.y, q.y, t, error);
  const auto z = plane.a == 0.0 && plane.b == 0.0 ? 0.0 - plane.d / plane.c : between(p.z, q.z, t, error);
  if (!x || !y || !z) return std::nullopt;
  return Point3{*x, *y, *z};
}

}  // namespace dobra::solid
