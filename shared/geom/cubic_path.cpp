#include "shared/geom/cubic_path.h"

#include <fmt/format.h>

#include <algorithm>

#include "shared/base/check.h"
#include "shared/geom/arc_length.h"

namespace dobra::geom {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

Point hermite_point(const HermiteCubic& c, double u) {
  const double v = 1 - u;
  // Bernstein form of the Hermite basis: exact at both ends.
  const Vector first = c.from_tangent / 3.0;
  const Vector second = c.to_tangent / 3.0;
  const double b01 = v * v * (1 + 2 * u);
  const double b23 = u * u * (1 + 2 * v);
  return Point{b01 * c.from.x + b23 * c.to.x, b01 * c.from.y + b23 * c.to.y} +
         (3 * v * v * u * first - 3 * v * u * u * second);
}

Vector hermite_tangent(const HermiteCubic& c, double u) {
  return 6 * u * (1 - u) * (c.to - c.from) + (1 - u) * (1 - 3 * u) * c.from_tangent + u * (3 * u - 2) * c.to_tangent;
}

/// Row i of a (cyclic) tridiagonal system: below x[i-1] + middle x[i] + above x[i+1] = right. Diagonally dominant here.
struct Row {
  double below, middle, above;
  Vector right;
};

/// Gauss without pivots; rows.front().below and rows.back().above are not used.
std::vector<Vector> solve_open(std::vector<Row> rows) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double factor = rows[i].below / rows[i - 1].middle;
    rows[i].middle -= factor * rows[i - 1].above;
    rows[i].right = rows[i].right - factor * rows[i - 1].right;
  }
  std::vector<Vector> x(rows.size());
  x.back() = rows.back().right / rows.back().middle;
  for (std::size_t i = rows.size() - 1; i-- > 0;) x[i] = (rows[i].right - rows[i].above * x[i + 1]) / rows[i].middle;
  return x;
}

/// The corner elements are rows.front().below and rows.back().above: a rank-one change of an open system
/// (Sherman-Morrison).
std::vector<Vector> solve_cyclic(std::vector<Row> rows) {
  const std::size_t n = rows.size();
  const double gamma = -rows.front().middle;
  const double corner_above = rows.front().below;  // couples the first to the last
  const double corner_below = rows.back().above;
  rows.front().middle -= gamma;
  rows.back().middle -= corner_above * corner_below / gamma;
  std::vector<Row> changed = rows;
  for (std::size_t i = 0; i < n; ++i) changed[i].right = {i == 0 ? gamma : i + 1 == n ? corner_below : 0.0, 0.0};
  std::vector<Vector> x = solve_open(std::move(rows));
  const std::vector<Vector> z = solve_open(std::move(changed));
  const double share = corner_above / gamma;
  const Vector top = x.front() + share * x.back();
  const double factor = 1 + z.front().x + share * z.back().x;
  for (std::size_t i = 0; i < n; ++i) x[i] = x[i] - (z[i].x / factor) * top;
  return x;
}

Result<void> check_points(std::span<const Point> points, std::size_t least, const char* what) {
  if (points.size() < least) {
    return Error{ErrorCode::DegenerateCurve,
                 fmt::format("{} has {} points; give at least {}", what, points.size(), least)};
  }
  for (const Point p : points) {
    if (!is_finite(p)) return Error{ErrorCode::NotFinite, fmt::format("a point of {} is not finite; correct it", what)};
  }
  return {};
}

}  // namespace

CubicPath::CubicPath(std::vector<HermiteCubic> cubics, std::vector<double> knots)
    : cubics_(std::move(cubics)), knots_(std::move(knots)) {
  DOBRA_CHECK(!cubics_.empty() && knots_.size() == cubics_.size() + 1);
}

CubicPath::At CubicPath::at(double t) const {
  const double k = knots_.front() + t * (knots_.back() - knots_.front());
  const auto above = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, k);
  const auto i = static_cast<std::size_t>(above - knots_.begin()) - 1;
  return {i, std::clamp((k - knots_[i]) / span(i), 0.0, 1.0)};
}

Point CubicPath::point(double t) const {
  const At where = at(t);
  return hermite_point(cubics_[where.cubic], where.u);
}

Vector CubicPath::tangent(double t) const {
  const At where = at(t);
  const double whole = knots_.back() - knots_.front();
  return (whole / span(where.cubic)) * hermite_tangent(cubics_[where.cubic], where.u);
}

double CubicPath::length(double t0, double t1) const {
  if (t1 < t0) return -length(t1, t0);
  const At begin = at(t0);
  const At end = at(t1);
  double sum = 0.0;
  for (std::size_t i = begin.cubic; i <= end.cubic; ++i) {
    const auto speed = [&](double u) { return geom::length(hermite_tangent(cubics_[i], u)); };
    sum += arc_length(speed, i == begin.cubic ? begin.u : 0.0, i == end.cubic ? end.u : 1.0);
  }
  return sum;
}

std::vector<double> uniform_knots(std::size_t points, SplineEnds ends) {
  std::vector<double> knots;
  for (std::size_t i = 0; i < points + (ends == SplineEnds::Closed ? 1 : 0); ++i)
    knots.push_back(static_cast<double>(i));
  return knots;
}

std::vector<double> chord_length_knots(std::span<const Point> points, SplineEnds ends) {
  std::vector<double> knots{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) knots.push_back(knots.back() + distance(points[i - 1], points[i]));
  if (ends == SplineEnds::Closed && !points.empty())
    knots.push_back(knots.back() + distance(points.back(), points.front()));
  return knots;
}

std::vector<Vector> spline_derivatives(std::span<const Point> points, std::span<const double> knots, SplineEnds ends) {
  const std::size_t n = points.size();
  const bool closed = ends == SplineEnds::Closed;
  const auto step = [&](std::size_t i) { return knots[i + 1] - knots[i]; };
  const auto slope = [&](std::size_t i) { return (points[(i + 1) % n] - points[i]) / step(i); };
  std::vector<Row> rows(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (!closed && i == 0) {
      rows[i] = {0, 2, 1, 3.0 * slope(0)};
    } else if (!closed && i + 1 == n) {
      rows[i] = {1, 2, 0, 3.0 * slope(n - 2)};
    } else {
      const std::size_t before = (i + n - 1) % n;
      const double h = step(before);
      const double g = step(i);
      rows[i] = {g, 2 * (h + g), h, 3.0 * (h * slope(i) + g * slope(before))};
    }
  }
  return closed ? solve_cyclic(std::move(rows)) : solve_open(std::move(rows));
}

Result<CubicPath> cubic_spline(std::span<const Point> points, std::span<const double> knots, SplineEnds ends) {
  const bool closed = ends == SplineEnds::Closed;
  DOBRA_TRY_VOID(check_points(points, closed ? 3 : 2, "a spline"));
  if (knots.size() != points.size() + (closed ? 1 : 0)) {
    return Error{ErrorCode::InvalidOption, fmt::format("a spline through {} points has {} knots; give {}",
                                                       points.size(), knots.size(), points.size() + (closed ? 1 : 0))};
  }
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    if (!(knots[i + 1] > knots[i]) || !std::isfinite(knots[i + 1] - knots[i])) {
      return Error{
          ErrorCode::InvalidOption,
          fmt::format("knot {} of a spline is not above the one before; knots must increase (and points differ)",
                      i + 2)};
    }
  }
  const std::vector<Vector> derivatives = spline_derivatives(points, knots, ends);
  std::vector<HermiteCubic> cubics;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const std::size_t next = (i + 1) % points.size();
    const double h = knots[i + 1] - knots[i];
    cubics.push_back({points[i], points[next], h * derivatives[i], h * derivatives[next]});
  }
  return CubicPath(std::move(cubics), {knots.begin(), knots.end()});
}

Result<CubicPath> uniform_b_spline(std::span<const Point> vertices) {
  DOBRA_TRY_VOID(check_points(vertices, 4, "a B-spline"));
  // At a knot: (V0 + 4 V1 + V2) / 6, with the derivative (V2 - V0) / 2.
  const auto joint = [&](std::size_t i) {
    return vertices[i + 1] + ((vertices[i] - vertices[i + 1]) + (vertices[i + 2] - vertices[i + 1])) / 6.0;
  };
  const auto derivative = [&](std::size_t i) { return (vertices[i + 2] - vertices[i]) / 2.0; };
  std::vector<HermiteCubic> cubics;
  for (std::size_t i = 0; i + 3 < vertices.size(); ++i) {
    cubics.push_back({joint(i), joint(i + 1), derivative(i), derivative(i + 1)});
  }
  auto knots = uniform_knots(cubics.size() + 1, SplineEnds::Natural);
  return CubicPath(std::move(cubics), std::move(knots));
}

}  // namespace dobra::geom
