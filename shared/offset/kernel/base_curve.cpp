#include "shared/offset/kernel/base_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "shared/geom/predicates.h"
#include "shared/offset/kernel/high.h"
#include "shared/offset/types/arcs.h"

namespace dobra::offset {
inline namespace kernel {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;

namespace {

Error at_point(ErrorCode code, std::string message, Point p) {
  Error error{code, std::move(message)};
  error.place.emplace();
  if (geom::is_finite(p)) {
    error.place->x = p.x;
    error.place->y = p.y;
  }
  return error;
}

/// A whole number of steps of the coordinates' own grid near `middle`, such that no coordinate loses a bit; else 0.
double exact_origin(const std::vector<Point>& points, double Point::*axis, double middle, double width) {
  if (middle == 0.0 || width == 0.0) return width == 0.0 ? middle : 0.0;
  const double step = std::exp2(std::ceil(std::log2(width)));
  const double origin = std::round(middle / step) * step;
  if (origin == 0.0) return 0.0;
  for (const Point& p : points) {
    const Real exact = static_cast<Real>(p.*axis) - static_cast<Real>(origin);
    if (static_cast<Real>(p.*axis - origin) != exact) return 0.0;
  }
  return origin;
}

/// Whole steps of a grid of 2^-100 of the size: what is smaller moves no place of the curve by more than it is rounded
/// anyway, and its products with others would not fit in the 256 bits of High.
class Grid {
 public:
  explicit Grid(double size)
      : exponent_(size > 0 ? std::ilogb(size) - 100 : 0), all_whole_(std::ldexp(1.0, exponent_ + 53)) {}
  [[nodiscard]] double nearest(double x) const {
    return std::abs(x) >= all_whole_ || x == 0 ? x : std::ldexp(std::nearbyint(std::ldexp(x, -exponent_)), exponent_);
  }
  [[nodiscard]] Point nearest(Point p) const { return {nearest(p.x), nearest(p.y)}; }

 private:
  int exponent_;
  double all_whole_;  // a double of at least this is on the grid
};

/// orient2d, with the test that nearly always tells in line.
inline geom::Sign turn_sign(Point a, Point b, Point c) {
  const geom::Vector u = b - a;
  const geom::Vector v = c - b;
  const double left = u.x * v.y;
  const double right = u.y * v.x;
  // Twice the bound of the predicate; far from underflow.
  const double sum = std::abs(left) + std::abs(right);
  const double cross = left - right;
  if (sum > 1e-250 && std::abs(cross) > 1e-15 * sum) return geom::sign_of(cross);
  return geom::orient2d(a, b, c);
}

void measure(BaseCurve& base) {
  const std::size_t count = base.points.size() - (base.closed ? 0 : 1);
  base.headings.resize(count);
  base.spans.resize(count);
  base.turn.assign(base.points.size(), Turn::Straight);
  base.half_tans.assign(base.points.size(), 0);
  const auto segment = [&](std::size_t i, Point from, Point to) {
    const geom::Vector along = to - from;
    double span = std::sqrt(along.x * along.x + along.y * along.y);
    if (!(span > 1e-150 && span < 1e150)) span = geom::length(along);  // squares out of range
    base.spans[i] = span;
    base.headings[i] = {along.x / span, along.y / span};
  };
  // Between two segments.
  const auto corner = [&](std::size_t before, std::size_t after, std::size_t at, Point next) {
    const geom::Vector u = base.headings[before];
    const geom::Vector v = base.headings[after];
    const geom::Sign sign = turn_sign(base.points[before], base.points[at], next);
    const double cosine = geom::dot(u, v);
    if (sign == geom::Sign::Zero && cosine > 0) return;
    base.turn[at] = sign == geom::Sign::Negative ? Turn::Inner : Turn::Outer;
    const double sine = std::abs(geom::cross(u, v));
    if (sign == geom::Sign::Zero) {
      base.half_tans[at] = std::numeric_limits<double>::infinity();
    } else if (cosine > 0) {
      base.half_tans[at] = sine / (1 + cosine);
    } else {
      base.half_tans[at] = static_cast<double>(base.half_tan_as<Real>(at));  // near a U-turn the sine has few digits
    }
  };
  const std::size_t last = base.points.size() - 1;
  for (std::size_t i = 0; i < last; ++i) segment(i, base.points[i], base.points[i + 1]);
  for (std::size_t i = 1; i < last; ++i) corner(i - 1, i, i, base.points[i + 1]);
  if (!base.closed) return;
  segment(last, base.points[last], base.points[0]);
  corner(last - 1, last, last, base.points[0]);
  corner(last, 0, 0, base.points[1]);
}

void measure_blocks(BaseCurve& base) {
  const std::size_t count = base.segment_count();
  const double margin = 1e-13 * base.size;
  base.blocks.reserve(count / BaseCurve::block_size + 1);
  base.least_outer = std::numeric_limits<double>::infinity();
  for (std::size_t first = 0; first < count; first += BaseCurve::block_size) {
    BaseCurve::SiteBlock block{std::numeric_limits<double>::infinity(), 0.0, 0};
    for (std::size_t i = first; i < std::min(count, first + BaseCurve::block_size); ++i) {
      const double before = base.turn[i] == Turn::Inner ? base.half_tans[i] : 0.0;
      const double after = base.turn[i + 1] == Turn::Inner ? base.half_tans[i + 1] : 0.0;
      block.regular_below = std::min(block.regular_below, (base.spans[i] - margin) / (before + after + 1e-300));
      block.sites |= BaseCurve::line_bit(i);
      if (base.turn[i] != Turn::Outer) continue;
      block.sites |= BaseCurve::corner_bit(i);
      block.greatest_outer = std::max(block.greatest_outer, base.half_tans[i]);
      base.least_outer = std::min(base.least_outer, base.half_tans[i]);
    }
    base.blocks.push_back(block);
  }
}

}  // namespace

Result<BaseCurve> prepare(const geom::Polyline& curve, Side side, double extension) {
  if (curve.points.empty()) return Error{ErrorCode::DegenerateCurve, "the curve has no points; give it at least two"};
  for (const Point p : curve.points) {
    if (!geom::is_finite(p)) {
      return at_point(ErrorCode::NotFinite,
                      "a coordinate of the curve is not a finite number; remove or correct the point", p);
    }
  }
  BaseCurve base;
  base.points.resize(curve.points.size());
  base.source.resize(curve.points.size());
  base.closed = curve.closed;
  base.mirrored = side == Side::LeftOfTravel;
  const geom::Box box = curve.box();
  base.origin = {exact_origin(curve.points, &Point::x, box.centre().x, box.width()),
                 exact_origin(curve.points, &Point::y, box.centre().y, box.height())};
  for (const geom::Vector v : {box.low - base.origin, box.high - base.origin}) {
    base.size = std::max({base.size, std::abs(v.x), std::abs(v.y)});
  }
  const Grid grid(base.size);
  std::size_t kept = 0;  // repeated points once, by the last of them
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Point p = grid.nearest({curve.points[i].x - base.origin.x, curve.points[i].y - base.origin.y});
    const Point q{p.x, base.mirrored ? -p.y : p.y};
    kept += kept == 0 || base.points[kept - 1] != q ? 1 : 0;
    base.points[kept - 1] = q;
    base.source[kept - 1] = static_cast<std::uint32_t>(i);
  }
  base.points.resize(kept);
  base.source.resize(kept);
  if (base.closed && base.points.size() > 1 && base.points.front() == base.points.back()) {
    base.points.pop_back();
    base.source.pop_back();
  }
  const std::size_t needed = base.closed ? 3 : 2;
  if (base.points.size() < needed) {
    return at_point(ErrorCode::DegenerateCurve,
                    fmt::format("the curve has {} distinct points; {} needs at least {}", base.points.size(),
                                base.closed ? "a closed contour" : "a curve", needed),
                    curve.points.front());
  }
  if (!base.closed) base.source.pop_back();
  if (!base.closed && extension > 0.0) {
    const auto lengthened = [&](Vec end, Vec inner) {
      return grid.nearest(rounded(end + static_cast<Real>(extension) * unit(end - inner)));
    };
    // The new ends are joined on, so that the old ones stay where they are; rounded, they turn the base there by 1e-16,
    // which the curve does not show (piece_writer.h). An extension that rounding swallows is none.
    const Point first = lengthened(base.point(0), base.point(1));
    const Point last = lengthened(base.point(base.points.size() - 1), base.point(base.points.size() - 2));
    if (first != base.points.front()) {
      base.points.insert(base.points.begin(), first);
      base.source.insert(base.source.begin(), base.source.front());
    }
    if (last != base.points.back()) {
      base.points.push_back(last);
      base.source.push_back(base.source.back());
    }
  }
  if (extension > 0.0) {
    for (const Point p : base.points) base.size = std::max({base.size, std::abs(p.x), std::abs(p.y)});
  }
  for (std::size_t i = 0; i < base.source.size(); ++i) base.renumbered |= base.source[i] != i;
  measure(base);
  if (!base.closed) measure_blocks(base);
  return base;
}

template <class T>
T BaseCurve::half_tan_as(std::size_t corner) const {
  using std::abs;
  if (turn[corner] == Turn::Straight) return 0;
  if (std::isinf(half_tans[corner])) return std::numeric_limits<T>::infinity();
  const auto at = [&](std::size_t i) { return VecOf<T>{points[i].x, points[i].y}; };
  const VecOf<T> u = at(corner) - at(corner == 0 ? points.size() - 1 : corner - 1);
  const VecOf<T> v = at(corner + 1 == points.size() ? 0 : corner + 1) - at(corner);
  const T cosine = dot(u, v);  // times the product of the lengths
  const T sine = abs(cross(u, v));
  const T unit = root(T(dot(u, u) * dot(v, v)));
  return cosine > 0 ? T(sine / (unit + cosine)) : T((unit - cosine) / sine);
}
template Real BaseCurve::half_tan_as<Real>(std::size_t) const;
template High BaseCurve::half_tan_as<High>(std::size_t) const;

CornerKind outer_corner(const BaseCurve& base, std::size_t corner, const OffsetOptions& options) {
  const double t = base.half_tans[corner];
  if (options.join == Join::Round || options.join == Join::Bevel) return CornerKind::Arc;
  const double limit = options.tip_limit();
  if (1 + t * t <= limit * limit * (1 + 1e-14)) return CornerKind::Mitre;  // 1 / cos(angle / 2) <= limit
  if (std::isinf(t) && options.u_turn == UTurn::ChordBevel) return CornerKind::Arc;
  return options.beyond_tip_limit() == BeyondLimit::TangentBevel ? CornerKind::Tangent : CornerKind::Arc;
}

RawChain raw_chain(const BaseCurve& base, Real distance, const OffsetOptions& options, RawArcs arcs) {
  RawChain chain;
  const auto add = [&](Vec p, std::size_t segment) {
    chain.points.push_back(p);
    chain.segment.push_back(static_cast<std::uint32_t>(segment));
    chain.is_arc.push_back(false);
  };
  const std::size_t count = base.segment_count();
  if (!base.closed) add(base.from(0) + distance * base.normal(0), 0);
  // The corner at the end of segment i; a closed chain starts with the corner before segment 0.
  const auto corner = [&](std::size_t i) {
    const std::size_t next = base.after(i);
    const std::size_t at = base.end_index(i);
    const Vec p = base.point(at);
    const Real t = base.half_tan_as<Real>(at);
    const Vec first = p + distance * base.normal(i);
    const Vec second = p + distance * base.normal(next);
    if (base.turn[at] == Turn::Straight) return add(second, next);
    if (base.turn[at] == Turn::Inner) return add(first - (distance * t) * base.along(i), next);
    const CornerKind fill = outer_corner(base, at, options);
    if (fill == CornerKind::Mitre) return add(first + (distance * t) * base.along(i), next);
    if (fill == CornerKind::Tangent) {
      const Real q = distance * quarter_tan(t);
      add(first + q * base.along(i), i);
      return add(second - q * base.along(next), next);
    }
    if (options.join != Join::Round || arcs == RawArcs::Kept) {
      add(first, i);
      chain.is_arc.back() = options.join == Join::Round;
      return add(second, next);
    }
    // Chords of a picture: where long double is a double, that will do.
    const long double angle = 2 * std::atan(static_cast<long double>(t));
    const long double step = 2 * std::acos(1 - static_cast<long double>(default_arc_tolerance));
    const auto parts = std::max<long>(1, std::lround(std::ceil(angle / step)));
    for (long k = 0; k < parts; ++k) {
      const long double a = angle * static_cast<long double>(k) / static_cast<long double>(parts);
      add(p + distance * (Real(std::cos(a)) * base.normal(i) + Real(std::sin(a)) * base.along(i)), i);
    }
    add(second, next);
  };
  if (base.closed) corner(count - 1);
  for (std::size_t i = 0; i + 1 < count; ++i) corner(i);
  if (!base.closed) {
    chain.points.push_back(base.to(count - 1) + distance * base.normal(count - 1));
  } else {
    // The corner before segment 0 may have several points; the chain starts with the one where segment 0 begins, and
    // the others come last, so that every edge label stays with its edge.
    const auto first =
        static_cast<std::ptrdiff_t>(std::find(chain.segment.begin(), chain.segment.end(), 0U) - chain.segment.begin());
    std::rotate(chain.points.begin(), chain.points.begin() + first, chain.points.end());
    std::rotate(chain.segment.begin(), chain.segment.begin() + first, chain.segment.end());
    std::rotate(chain.is_arc.begin(), chain.is_arc.begin() + first, chain.is_arc.end());
  }
  return chain;
}

}  // namespace kernel
}  // namespace dobra::offset
