#include "shared/solid/plane_crossing.h"

#include <array>
#include <cmath>

#include "shared/geom/expansion.h"

namespace dobra::solid {
namespace {

using geom::fast_two_sum;
using geom::Point3;
using geom::two_product;
using geom::two_sum;
using geom::TwoTerms;

/// Of one sum, product or quotient of two pairs, relative to what goes in; [joldes2017doubleword] has less.
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

TwoTerms difference(double a, double b) { return two_sum(a, -b); }
TwoTerms difference(TwoTerms a, TwoTerms b) { return sum(a, {-b.high, -b.low}); }
double size(TwoTerms a) { return std::abs(a.high); }

/// n x + d at a point, and the sizes of what is added up.
struct Height {
  TwoTerms value;
  double sizes;
};

/// Heights of points over a plane. Products and sums of pairs are off by at most 8 and 3 times 2^-106 of what they are:
/// the parts of a normal by 11 (two products, a difference), multiplied with the way by 19, and added up by 28 times
/// 2^-106 of the sizes, which is below pair_unit. Differences of two doubles are pairs without an error.
class Heights {
 public:
  explicit Heights(const Plane& plane) : origin_(plane.through[0]), constant_(plane.constant) {
    const auto& [a, b, c] = plane.through;
    if (constant_) {
      const std::array<double, 3> n{a.x, a.y, a.z};
      for (std::size_t i = 0; i < 3; ++i) normal_[i] = {n[i], 0.0};
      return;
    }
    const std::array<TwoTerms, 3> u{difference(b.x, a.x), difference(b.y, a.y), difference(b.z, a.z)};
    const std::array<TwoTerms, 3> v{difference(c.x, a.x), difference(c.y, a.y), difference(c.z, a.z)};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      const TwoTerms first = product(u[j], v[k]);
      const TwoTerms second = product(u[k], v[j]);
      normal_[i] = difference(first, second);
      sizes_[i] = size(first) + size(second);
    }
  }

  [[nodiscard]] Height over(Point3 p) const {
    if (constant_) {
      Height height{{*constant_, 0.0}, std::abs(*constant_)};
      const std::array<double, 3> at{p.x, p.y, p.z};
      for (std::size_t i = 0; i < 3; ++i) {
        if (normal_[i].high == 0.0) continue;  // as in every upright plane
        const TwoTerms part = two_product(normal_[i].high, at[i]);
        height.value = sum(height.value, part);
        height.sizes += size(part);
      }
      return height;
    }
    const std::array way{difference(p.x, origin_.x), difference(p.y, origin_.y), difference(p.z, origin_.z)};
    Height height{{0.0, 0.0}, 0.0};
    for (std::size_t i = 0; i < 3; ++i) {
      height.value = sum(height.value, product(normal_[i], way[i]));
      height.sizes += sizes_[i] * size(way[i]);
    }
    return height;
  }

 private:
  Point3 origin_;
  std::optional<double> constant_;
  std::array<TwoTerms, 3> normal_{};
  std::array<double, 3> sizes_{};  // of what a normal is made of, by points
};

bool in_range(double value) {
  constexpr double least = 0x1p-100, greatest = 0x1p100;
  return value == 0.0 || (std::abs(value) >= least && std::abs(value) <= greatest);
}
bool in_range(Point3 p) { return in_range(p.x) && in_range(p.y) && in_range(p.z); }
bool in_range(const Plane& plane) {
  if (plane.constant) return in_range(*plane.constant) && in_range(plane.through[0]);
  return in_range(plane.through[0]) && in_range(plane.through[1]) && in_range(plane.through[2]);
}

/// One coordinate; rounded if it is not the place itself for sure.
struct Between {
  double at;
  bool rounded;
};

/// From p to q at the part t of the way, with its error; none if that leaves the nearest double open.
std::optional<Between> between(double p, double q, TwoTerms t, double error) {
  if (p == q) return Between{p, false};
  const TwoTerms way = two_sum(q, -p);
  const TwoTerms at = sum({p, 0.0}, product(t, way));
  const double bound = 2.0 * (error * std::abs(way.high) + 4.0 * pair_unit * (std::abs(p) + std::abs(way.high)));
  const bool sure = at.high + (at.low - bound) == at.high && at.high + (at.low + bound) == at.high;
  if (!sure) return std::nullopt;
  return Between{at.high, std::abs(at.low) > bound};
}

/// Along an axis that a plane of coefficients stands upright on, all of it is at one place.
std::optional<Between> upright(const Plane& plane, double own, double other, double another) {
  if (!plane.constant || other != 0.0 || another != 0.0) return std::nullopt;
  return Between{0.0 - *plane.constant / own, false};
}

}  // namespace

std::optional<CrossingInDoubles> crossing_in_doubles(const Plane& plane, Point3 p, Point3 q) {
  if (!in_range(plane) || !in_range(p) || !in_range(q)) return std::nullopt;
  const Heights heights(plane);
  const Height at_p = heights.over(p);
  const Height at_q = heights.over(q);
  const TwoTerms rise = difference(at_p.value, at_q.value);
  const TwoTerms t = quotient(at_p.value, rise);
  // Heights have opposite signs: nothing cancels in their difference, and t is between 0 and 1. Three errors of heights
  // over the rise, a difference and a quotient would do.
  const double error = 32.0 * pair_unit * (1.0 + (at_p.sizes + at_q.sizes) / std::abs(rise.high));
  if (!(error < 0x1p-60)) return std::nullopt;
  const Point3& n = plane.through[0];
  auto x = upright(plane, n.x, n.y, n.z);
  auto y = upright(plane, n.y, n.x, n.z);
  auto z = upright(plane, n.z, n.x, n.y);
  if (!x) x = between(p.x, q.x, t, error);
  if (!y) y = between(p.y, q.y, t, error);
  if (!z) z = between(p.z, q.z, t, error);
  if (!x || !y || !z) return std::nullopt;
  return CrossingInDoubles{{x->at, y->at, z->at}, x->rounded || y->rounded || z->rounded};
}

bool apart_in_doubles(const Plane& plane, Point3 p) {
  if (!in_range(plane) || !in_range(p)) return false;
  const Height height = Heights(plane).over(p);
  return std::abs(height.value.high) > 32.0 * pair_unit * height.sizes;
}

}  // namespace dobra::solid
