// Curves through points: straight from one to the next, and the cubic spline.
#include <fmt/format.h>

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

#include "shared/surf/curve.h"

namespace dobra::surf {

using base::Error;
using base::ErrorCode;
using geom::Point3;
using geom::Vector3;

namespace {

/// Length of the chords up to each point.
base::Result<std::vector<double>> chord_lengths(const std::vector<Point3>& points) {
  if (points.size() < 2)
    return Error{ErrorCode::DegenerateCurve, fmt::format("{} points; a curve has two at least", points.size())};
  std::vector<double> at{0.0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!geom::is_finite(points[i])) return Error{ErrorCode::NotFinite, fmt::format("point {} is not finite", i + 1)};
    if (i == 0) continue;
    const double chord = geom::distance(points[i - 1], points[i]);
    if (!(chord > 0.0))
      return Error{ErrorCode::DegenerateCurve,
                   fmt::format("points {} and {} of the curve are in one place; leave one out", i, i + 1),
                   base::Place{.x = points[i].x, .y = points[i].y}};
    at.push_back(at.back() + chord);
  }
  return at;
}

/// Cubics between points, with the first derivatives there.
struct CubicsShape : Curve::Shape {
  std::vector<double> t;
  std::vector<Point3> points;
  std::vector<Vector3> slopes;

  [[nodiscard]] std::size_t piece(double at) const {
    const auto after = std::upper_bound(t.begin() + 1, t.end() - 1, at);
    return static_cast<std::size_t>(after - t.begin()) - 1;
  }
  [[nodiscard]] Curve::Jet jet(double at) const override {
    const std::size_t k = piece(at);
    const double h = t[k + 1] - t[k], s = (at - t[k]) / h;
    const Vector3 d = points[k + 1] - points[k], a = h * slopes[k], b = h * slopes[k + 1];
    const Vector3 c2 = 3.0 * d - 2.0 * a - b, c3 = a + b - 2.0 * d;
    const Point3 place = s == 1.0 ? points[k + 1] : points[k] + s * (a + s * (c2 + s * c3));
    return {place, (a + s * (2.0 * c2 + 3.0 * s * c3)) / h, (2.0 * c2 + 6.0 * s * c3) / (h * h)};
  }
  /// The second derivative is linear between two points.
  [[nodiscard]] double bend(double from, double to) const override {
    double most = 0.0;
    for (std::size_t k = piece(from); k <= piece(to); ++k) {
      const double h = t[k + 1] - t[k];
      const Vector3 d = points[k + 1] - points[k], a = h * slopes[k], b = h * slopes[k + 1];
      const Vector3 c2 = 3.0 * d - 2.0 * a - b, c3 = a + b - 2.0 * d;
      most = std::max({most, 2.0 * geom::length(c2) / (h * h), geom::length(2.0 * c2 + 6.0 * c3) / (h * h)});
    }
    return most;
  }
};

/// The first derivatives that make the second ones continuous.
void solve_slopes(CubicsShape& shape) {
  const std::size_t n = shape.points.size();
  const bool closed = shape.points.front() == shape.points.back();
  const auto h = [&](std::size_t i) { return shape.t[i + 1] - shape.t[i]; };
  const auto by = [&](std::size_t i) { return (shape.points[i + 1] - shape.points[i]) / h(i); };
  const auto row_count = static_cast<Eigen::Index>(n);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX3d right(row_count, 3);
  const auto set = [&](std::size_t row, std::size_t column, double value) {
    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  const auto set_right = [&](std::size_t row, Vector3 v) {
    right.row(static_cast<Eigen::Index>(row)) << v.x, v.y, v.z;
  };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double a = h(i - 1), b = h(i);
    set(i, i - 1, b), set(i, i, 2.0 * (a + b)), set(i, i + 1, a);
    set_right(i, 3.0 * (b * by(i - 1) + a * by(i)));
  }
  if (closed) {
    const double a = h(n - 2), b = h(0);
    set(0, n - 2, b), set(0, 0, 2.0 * (a + b)), set(0, 1, a);
    set_right(0, 3.0 * (b * by(n - 2) + a * by(0)));
    set(n - 1, n - 1, 1.0), set(n - 1, 0, -1.0);
    set_right(n - 1, {});
  } else {
    const double a = h(0), b = h(1), c = h(n - 3), d = h(n - 2);
    set(0, 0, b), set(0, 1, a + b);
    set_right(0, ((a + 2.0 * (a + b)) * b * by(0) + a * a * by(1)) / (a + b));
    set(n - 1, n - 1, c), set(n - 1, n - 2, c + d);
    set_right(n - 1, ((d + 2.0 * (c + d)) * c * by(n - 2) + d * d * by(n - 3)) / (c + d));
  }
  Eigen::SparseMatrix<double> matrix(row_count, row_count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::MatrixX3d found = solver.solve(right);
  for (Eigen::Index i = 0; i < row_count; ++i) shape.slopes.push_back({found(i, 0), found(i, 1), found(i, 2)});
}

}  // namespace

base::Result<Curve> Curve::polyline(const std::vector<Point3>& points) {
  DOBRA_TRY(std::vector<double> knots, chord_lengths(points));
  knots.insert(knots.begin(), knots.front());
  knots.push_back(knots.back());
  return nurbs(1, std::move(knots), points);
}

base::Result<Curve> Curve::through(const std::vector<Point3>& points) {
  DOBRA_TRY(const std::vector<double> at, chord_lengths(points));
  return through(points, at);
}

base::Result<Curve> Curve::through(const std::vector<Point3>& points, const std::vector<double>& at) {
  DOBRA_TRY_VOID(chord_lengths(points));
  if (at.size() != points.size())
    return Error{ErrorCode::InvalidOption, fmt::format("{} parameters for {} points", at.size(), points.size())};
  for (std::size_t i = 1; i < at.size(); ++i) {
    if (!(at[i] > at[i - 1]) || !std::isfinite(at[i] - at[i - 1]))
      return Error{ErrorCode::InvalidOption, fmt::format("parameter {} does not rise", i + 1)};
  }
  if (points.size() == 2) return polyline(points);
  auto shape = std::make_shared<CubicsShape>();
  shape->t = at;
  shape->points = points;
  if (points.size() == 3 && !(points.front() == points.back())) {
    const double a = at[1], b = at[2] - at[1];
    const Vector3 p = (points[1] - points[0]) / a, q = (points[2] - points[1]) / b;
    const Vector3 bend = (q - p) / (a + b);
    shape->slopes = {p - a * bend, p + a * bend, q + b * bend};
  } else if (points.size() == 3) {
    return Error{ErrorCode::DegenerateCurve, "a closed curve through two places; give three at least"};
  } else {
    solve_slopes(*shape);
  }
  return Curve(std::move(shape), {at.front(), at.back()});
}

}  // namespace dobra::surf
