#include "shared/offset/base_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "shared/geom/predicates.h"

namespace dobra::offset {

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
  for (const Point& p : points) {
    const Real exact = static_cast<Real>(p.*axis) - static_cast<Real>(origin);
    if (static_cast<Real>(p.*axis - origin) != exact) return 0.0;
  }
  return origin;
}

void measure(BaseCurve& base) {
  const std::size_t count = base.points.size() - (base.closed ? 0 : 1);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec along = base.to(i) - base.from(i);
    const Real length_i = length(along);
    base.lengths.push_back(length_i);
    base.along.push_back((1 / length_i) * along);
    base.normal.push_back(right_of(base.along.back()));
  }
  base.turn.assign(base.points.size(), Turn::Straight);
  base.half_tan.assign(base.points.size(), 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (!base.has_after(i)) continue;
    const std::size_t corner = base.end_index(i);
    const Vec u = base.along[i];
    const Vec v = base.along[base.after(i)];
    const geom::Sign sign =
        geom::orient2d(rounded(base.from(i)), rounded(base.to(i)), rounded(base.to(base.after(i))));
    const Real cosine = dot(u, v);
    const Real sine = std::abs(cross(u, v));
    if (sign == geom::Sign::Zero && cosine > 0) continue;
    base.turn[corner] = sign == geom::Sign::Negative ? Turn::Inner : Turn::Outer;
    if (sign == geom::Sign::Zero) {
      base.half_tan[corner] = std::numeric_limits<Real>::infinity();
    } else {
      base.half_tan[corner] = cosine > 0 ? sine / (1 + cosine) : (1 - cosine) / sine;
    }
  }
}

}  // namespace

Result<BaseCurve> prepare(const geom::Polyline& curve, Side side, double extension) {
  if (curve.points.empty()) return Error{ErrorCode::DegenerateCurve, "the curve has no points; give it at least two"};
  for (const Point p : curve.points) {
    if (!geom::is_finite(p)) {
      return at_point(ErrorCode::NotFinite, "a coordinate of the curve is not a finite number; remove or correct the point", p);
    }
  }
  BaseCurve base;
  base.closed = curve.closed;
  base.mirrored = side == Side::LeftOfTravel;
  const geom::Box box = curve.box();
  base.origin = {exact_origin(curve.points, &Point::x, box.centre().x, box.width()),
                 exact_origin(curve.points, &Point::y, box.centre().y, box.height())};
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const Point p{curve.points[i].x - base.origin.x, curve.points[i].y - base.origin.y};
    const Vec q{p.x, base.mirrored ? -p.y : p.y};
    if (!base.points.empty() && rounded(base.points.back()) == rounded(q)) {
      base.source.back() = static_cast<std::uint32_t>(i);
      continue;
    }
    base.points.push_back(q);
    base.source.push_back(static_cast<std::uint32_t>(i));
  }
  if (base.closed && base.points.size() > 1 && rounded(base.points.front()) == rounded(base.points.back())) {
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
      const Vec p = end + static_cast<Real>(extension) * unit(end - inner);
      return Vec{static_cast<double>(p.x), static_cast<double>(p.y)};
    };
    // The new ends are joined on, so that they are exactly where the exact predicates believe them to be.
    base.points.insert(base.points.begin(), lengthened(base.points[0], base.points[1]));
    base.points.push_back(lengthened(base.points[base.points.size() - 1], base.points[base.points.size() - 2]));
    base.source.insert(base.source.begin(), base.source.front());
    base.source.push_back(base.source.back());
  }
  for (const Vec p : base.points) base.size = std::max({base.size, std::abs(p.x), std::abs(p.y)});
  measure(base);
  return base;
}

Real quarter_tan(Real t) { return std::isinf(t) ? 1 : t / (1 + std::sqrt(1 + t * t)); }

Fill fill_of(const BaseCurve& base, std::size_t corner, const OffsetOptions& options) {
  const Real t = base.half_tan[corner];
  if (options.join == Join::Round || options.join == Join::Bevel) return Fill::Arc;
  if (options.join == Join::Bisector) return std::isinf(t) ? Fill::Tangent : Fill::Mitre;
  const Real limit = options.mitre_limit;
  if (1 + t * t <= limit * limit * (1 + 1e-15L)) return Fill::Mitre;  // 1 / cos(angle / 2) <= limit
  return options.beyond_limit == BeyondLimit::TangentBevel ? Fill::Tangent : Fill::Arc;
}

RawChain raw_chain(const BaseCurve& base, Real distance, const OffsetOptions& options) {
  RawChain chain;
  const auto add = [&](Vec p, std::size_t segment) {
    chain.points.push_back(p);
    chain.segment.push_back(static_cast<std::uint32_t>(segment));
  };
  const std::size_t count = base.segment_count();
  if (!base.closed) add(base.from(0) + distance * base.normal[0], 0);
  // The corner at the end of segment i; a closed chain starts with the corner before segment 0.
  const auto corner = [&](std::size_t i) {
    const std::size_t next = base.after(i);
    const std::size_t at = base.end_index(i);
    const Vec p = base.points[at];
    const Real t = base.half_tan[at];
    const Vec first = p + distance * base.normal[i];
    const Vec second = p + distance * base.normal[next];
    if (base.turn[at] == Turn::Straight) return add(second, next);
    if (base.turn[at] == Turn::Inner) return add(first - (distance * t) * base.along[i], next);
    const Fill fill = fill_of(base, at, options);
    if (fill == Fill::Mitre) return add(first + (distance * t) * base.along[i], next);
    if (fill == Fill::Tangent) {
      const Real q = distance * quarter_tan(t);
      add(first + q * base.along[i], i);
      return add(second - q * base.along[next], next);
    }
    add(first, i);
    const bool chord = options.join != Join::Round;
    const Real angle = 2 * std::atan(t);
    const Real step = 2 * std::acos(1 - static_cast<Real>(options.arc_tolerance));
    const auto parts = chord ? 1 : std::max<long>(1, std::lround(std::ceil(angle / step)));
    for (long k = 1; k < parts; ++k) {
      const Real a = angle * static_cast<Real>(k) / static_cast<Real>(parts);
      add(p + distance * (std::cos(a) * base.normal[i] + std::sin(a) * base.along[i]), i);
    }
    add(second, next);
  };
  if (base.closed) corner(count - 1);
  for (std::size_t i = 0; i + 1 < count; ++i) corner(i);
  if (!base.closed) {
    chain.points.push_back(base.to(count - 1) + distance * base.normal[count - 1]);
  } else {
    // The corner before segment 0 may have several points; the chain starts with the one where segment 0 begins, and
    // the others come last, so that every edge label stays with its edge.
    const auto first = static_cast<std::ptrdiff_t>(
        std::find(chain.segment.begin(), chain.segment.end(), 0U) - chain.segment.begin());
    std::rotate(chain.points.begin(), chain.points.begin() + first, chain.points.end());
    std::rotate(chain.segment.begin(), chain.segment.begin() + first, chain.segment.end());
  }
  return chain;
}

}  // namespace dobra::offset
