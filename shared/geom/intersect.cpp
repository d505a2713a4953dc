#include "shared/geom/intersect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "shared/geom/expansion.h"
#include "shared/geom/predicates.h"

namespace dobra::geom {
namespace {

At place_on(const Segment& segment, Point p) {
  if (p == segment.from) return At::From;
  return p == segment.to ? At::To : At::Interior;
}

Meeting meeting(const Segment& first, const Segment& second, Point p) {
  return {p, place_on(first, p), place_on(second, p)};
}

/// Power of two that brings the largest coordinate into the range of expansions; 0 where it is there already.
int scaling_exponent(const std::array<Point, 4>& points) {
  double largest = 0.0;
  for (const Point p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest == 0.0 || in_expansion_range(largest) ? 0 : -std::ilogb(largest);
}

Point scaled(Point p, int exponent) { return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)}; }

Box common_box(const Segment& first, const Segment& second) {
  const Box a = first.box();
  const Box b = second.box();
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y)}};
}

/// Rounds `value`, known to within `error`, if both ends of that interval round to the same double.
bool round_once(long double value, long double error, double& rounded) {
  rounded = static_cast<double>(value - error);
  return rounded == static_cast<double>(value + error);
}

/// The crossing with longer mantissas than doubles have, where its rounding is beyond doubt: all but one in some
/// hundreds, and where long double is no longer than double, none.
bool crossing_filtered(const Segment& first, const Segment& second, Point& p) {
  using Long = long double;
  constexpr Long epsilon = std::numeric_limits<Long>::epsilon();
  const Long along_x = Long(first.to.x) - first.from.x;
  const Long along_y = Long(first.to.y) - first.from.y;
  const Long across_x = Long(second.to.x) - second.from.x;
  const Long across_y = Long(second.to.y) - second.from.y;
  const Long between_x = Long(second.from.x) - first.from.x;
  const Long between_y = Long(second.from.y) - first.from.y;
  const Long n1 = between_x * across_y;
  const Long n2 = between_y * across_x;
  const Long d1 = along_x * across_y;
  const Long d2 = along_y * across_x;
  const Long denominator = d1 - d2;
  const Long t = (n1 - n2) / denominator;
  // Each product carries three roundings, the difference one more; all bounds are taken twice as large as need be.
  const Long t_error =
      4 * epsilon * ((std::abs(n1) + std::abs(n2) + std::abs(d1) + std::abs(d2)) / std::abs(denominator) + 1);
  const Long x = first.from.x + t * along_x;
  const Long y = first.from.y + t * along_y;
  const Long x_error = std::abs(along_x) * t_error + 2 * epsilon * (std::abs(x) + std::abs(along_x));
  const Long y_error = std::abs(along_y) * t_error + 2 * epsilon * (std::abs(y) + std::abs(along_y));
  return round_once(x, x_error, p.x) && round_once(y, y_error, p.y);
}

/// a + (n / d)(b - a) with n = (c - a) x (d - c) and d = (b - a) x (d - c), each coordinate as one quotient of two
/// exact numbers.
Point crossing_exact(const Segment& first, const Segment& second) {
  const int exponent = scaling_exponent({first.from, first.to, second.from, second.to});
  const Point a = scaled(first.from, exponent);
  const Point b = scaled(first.to, exponent);
  const Point c = scaled(second.from, exponent);
  const Point d = scaled(second.to, exponent);
  const auto first_x = difference(b.x, a.x);
  const auto first_y = difference(b.y, a.y);
  const auto second_x = difference(d.x, c.x);
  const auto second_y = difference(d.y, c.y);
  const auto denominator = first_x * second_y - first_y * second_x;
  const auto numerator = difference(c.x, a.x) * second_y - difference(c.y, a.y) * second_x;
  const Point p{rounded_quotient(denominator * a.x + numerator * first_x, denominator),
                rounded_quotient(denominator * a.y + numerator * first_y, denominator)};
  return scaled(p, -exponent);
}

/// Four collinear points: along any line the lexicographic order of points is the order along the line.
Intersection intersect_collinear(const Segment& first, const Segment& second) {
  Point low = std::max(std::min(first.from, first.to), std::min(second.from, second.to));
  Point high = std::min(std::max(first.from, first.to), std::max(second.from, second.to));
  if (low > high) return {};
  if (low == high) return {IntersectionKind::Point, meeting(first, second, low), {}};
  if (first.to < first.from) std::swap(low, high);
  return {IntersectionKind::Overlap, meeting(first, second, low), meeting(first, second, high)};
}

}  // namespace

Point crossing(const Segment& first, const Segment& second) {
  Point p;
  if (!crossing_filtered(first, second, p)) p = crossing_exact(first, second);
  // Rounding to nearest cannot leave the boxes, whose sides are doubles; what underflow can take in extreme ranges
  // could.
  const Box box = common_box(first, second);
  return {std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y)};
}

Intersection intersect(const Segment& first, const Segment& second) {
  if (!first.box().overlaps(second.box())) return {};
  const Sign first_from = orient2d(second.from, second.to, first.from);
  const Sign first_to = orient2d(second.from, second.to, first.to);
  if (first_from * first_to == Sign::Positive) return {};
  const Sign second_from = orient2d(first.from, first.to, second.from);
  const Sign second_to = orient2d(first.from, first.to, second.to);
  if (second_from * second_to == Sign::Positive) return {};
  const bool all_zero =
      first_from == Sign::Zero && first_to == Sign::Zero && second_from == Sign::Zero && second_to == Sign::Zero;
  if (all_zero) return intersect_collinear(first, second);
  // The lines cross in one point, which both segments contain; an end point on the other line is that point.
  const auto point = [&](Point p) { return Intersection{IntersectionKind::Point, meeting(first, second, p), {}}; };
  if (first_from == Sign::Zero) return point(first.from);
  if (first_to == Sign::Zero) return point(first.to);
  if (second_from == Sign::Zero) return point(second.from);
  if (second_to == Sign::Zero) return point(second.to);
  // A rounded crossing may coincide with an end point; the topology stays that of the exact one.
  return {IntersectionKind::Point, {crossing(first, second), At::Interior, At::Interior}, {}};
}

bool point_on_segment(Point p, const Segment& segment) {
  return segment.box().contains(p) && orient2d(segment.from, segment.to, p) == Sign::Zero;
}

bool before_along(const Segment& segment, Point p, Point q) {
  const Sign ahead = dot_sign(p, q, segment.from, segment.to);
  return ahead == Sign::Zero ? p < q : ahead == Sign::Positive;
}

void sort_along(const Segment& segment, std::vector<Point>& points) {
  std::sort(points.begin(), points.end(), [&](Point p, Point q) { return before_along(segment, p, q); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

}  // namespace dobra::geom
