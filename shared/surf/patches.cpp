// B-spline patches, given or through points, and graphs of formulas.
#include <fmt/format.h>

#include <Eigen/SparseLU>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "shared/base/formula.h"
#include "shared/surf/homogeneous.h"
#include "shared/surf/surface.h"

namespace dobra::surf {

using base::Error;
using base::ErrorCode;
using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;

namespace {

struct PatchShape : Surface::Shape {
  SplineBasis basis_u, basis_v;
  std::vector<Homogeneous> points;
  PatchShape(SplineBasis u, SplineBasis v, std::vector<Homogeneous> control)
      : basis_u(std::move(u)), basis_v(std::move(v)), points(std::move(control)) {}

  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i) jets[i] = jet(uv[i]);
  }
  [[nodiscard]] Jet jet(Point uv) const {
    const SplineBasis::Values in_u = basis_u.at(uv.x), in_v = basis_v.at(uv.y);
    const std::size_t row = basis_v.count();
    Homogeneous s{}, u{}, v{}, uu{}, uw{}, vv{};
    for (std::size_t i = 0; i <= basis_u.degree(); ++i) {
      const Homogeneous* const across = &points[(in_u.first + i) * row + in_v.first];
      std::array<Homogeneous, 3> sum{};
      for (std::size_t j = 0; j <= basis_v.degree(); ++j) {
        for (std::size_t k = 0; k < 3; ++k) sum[k] += in_v.of[k][j] * across[j];
      }
      s += in_u.of[0][i] * sum[0];
      v += in_u.of[0][i] * sum[1];
      vv += in_u.of[0][i] * sum[2];
      u += in_u.of[1][i] * sum[0];
      uw += in_u.of[1][i] * sum[1];
      uu += in_u.of[2][i] * sum[0];
    }
    // Of the quotient, by its own rule.
    const Point3 at = s.point();
    const Vector3 here = from_origin(at);
    const Vector3 by_u = (u.vector() - u.w * here) / s.w, by_v = (v.vector() - v.w * here) / s.w;
    return {at,
            by_u,
            by_v,
            (uu.vector() - 2.0 * u.w * by_u - uu.w * here) / s.w,
            (uw.vector() - u.w * by_v - v.w * by_u - uw.w * here) / s.w,
            (vv.vector() - 2.0 * v.w * by_v - vv.w * here) / s.w};
  }
};

struct GraphShape : Surface::Shape {
  base::Formula formula;
  Box chart;
  double part = 2e-3;  ///< The step of the differences, part of the chart.
  GraphShape(base::Formula height, const Box& where) : formula(std::move(height)), chart(where) {}

  [[nodiscard]] double height(double x, double y) const { return formula.at(std::array{x, y}); }
  void jets(std::span<const Point> uv, std::span<Jet> jets) const override {
    for (std::size_t i = 0; i < uv.size(); ++i) jets[i] = jet(uv[i]);
  }

  /// Values at nine places of a line, -4 .. 4 steps from where the derivatives are wanted, or to one side of it where
  /// the formula ends.
  struct Stencil {
    std::array<double, 9> first{}, second{};
  };
  /// Weights at step `from` .. `from` + 8, by Fornberg's recurrence [fornberg1988].
  static Stencil stencil(int from) {
    std::array<std::array<double, 3>, 9> c{};
    double c1 = 1.0;
    double c4 = from;
    c[0][0] = 1.0;
    for (int i = 1; i < 9; ++i) {
      const int most = std::min(i, 2);
      double c2 = 1.0;
      const double c5 = c4;
      c4 = from + i;
      for (int j = 0; j < i; ++j) {
        const double c3 = i - j;
        c2 *= c3;
        if (j == i - 1) {
          for (int k = most; k > 0; --k) c[i][k] = c1 * (k * c[i - 1][k - 1] - c5 * c[i - 1][k]) / c2;
          c[i][0] = -c1 * c5 * c[i - 1][0] / c2;
        }
        for (int k = most; k > 0; --k) c[j][k] = (c4 * c[j][k] - k * c[j][k - 1]) / c3;
        c[j][0] = c4 * c[j][0] / c3;
      }
      c1 = c2;
    }
    Stencil made;
    for (std::size_t i = 0; i < 9; ++i) made.first[i] = c[i][1], made.second[i] = c[i][2];
    return made;
  }

  /// The stencil whose places lie within the range, from which step on.
  static std::pair<const Stencil&, int> stencil_at(double at, double low, double high, double h) {
    static const std::array<Stencil, 9> stencils = [] {
      std::array<Stencil, 9> made;
      for (int from = -8; from <= 0; ++from) made[static_cast<std::size_t>(from + 8)] = stencil(from);
      return made;
    }();
    int from = -4;
    if (at - 4.0 * h < low) from = -static_cast<int>(std::floor((at - low) / h + 1e-9));
    if (at + 4.0 * h > high) from = static_cast<int>(std::floor((high - at) / h + 1e-9)) - 8;
    from = std::clamp(from, -8, 0);
    return {stencils[static_cast<std::size_t>(from + 8)], from};
  }

  /// Second derivatives by a step, by the chart's width and height: (zxx, zyy).
  [[nodiscard]] std::array<double, 2> bend(Point uv, double by) const {
    const double hx = by * chart.width(), hy = by * chart.height();
    const auto [across, left] = stencil_at(uv.x, chart.low.x, chart.high.x, hx);
    const auto [up, below] = stencil_at(uv.y, chart.low.y, chart.high.y, hy);
    double zxx = 0.0, zyy = 0.0;
    for (int i = 0; i < 9; ++i) {
      zxx += across.second[static_cast<std::size_t>(i)] * height(uv.x + (left + i) * hx, uv.y);
      zyy += up.second[static_cast<std::size_t>(i)] * height(uv.x, uv.y + (below + i) * hy);
    }
    return {zxx / (by * by), zyy / (by * by)};
  }
  /// Takes the step whose second derivatives are nearest to those of half of it, over the chart: a long one leaves
  /// terms out, a short one is all rounding.
  void choose_step() {
    constexpr int places = 13;
    double least = std::numeric_limits<double>::infinity(), best = part;
    for (double by = part; by > 2e-5; by *= 0.5) {
      double apart = 0.0;
      for (int i = 0; i < places * places; ++i) {
        const Point at{geom::interpolate(chart.low, chart.high, (i / places + 0.37) / places).x,
                       geom::interpolate(chart.low, chart.high, (i % places + 0.43) / places).y};
        const std::array<double, 2> whole = bend(at, by), half = bend(at, 0.5 * by);
        apart = std::max({apart, std::abs(whole[0] - half[0]), std::abs(whole[1] - half[1])});
      }
      if (apart < 0.7 * least) least = apart, best = by;
    }
    part = best;
  }

  [[nodiscard]] Jet jet(Point uv) const {
    const double hx = part * chart.width(), hy = part * chart.height();
    const auto [across, left] = stencil_at(uv.x, chart.low.x, chart.high.x, hx);
    const auto [up, below] = stencil_at(uv.y, chart.low.y, chart.high.y, hy);
    double zx = 0.0, zxx = 0.0, zy = 0.0, zyy = 0.0, zxy = 0.0;
    for (std::size_t i = 0; i < 9; ++i) {
      const double z = height(uv.x + (left + static_cast<int>(i)) * hx, uv.y);
      zx += across.first[i] * z;
      zxx += across.second[i] * z;
      const double w = height(uv.x, uv.y + (below + static_cast<int>(i)) * hy);
      zy += up.first[i] * w;
      zyy += up.second[i] * w;
      for (std::size_t j = 0; j < 9; ++j)
        zxy += across.first[i] * up.first[j] *
               height(uv.x + (left + static_cast<int>(i)) * hx, uv.y + (below + static_cast<int>(j)) * hy);
    }
    return {{uv.x, uv.y, height(uv.x, uv.y)}, {1.0, 0.0, zx / hx},         {0.0, 1.0, zy / hy},
            {0.0, 0.0, zxx / (hx * hx)},      {0.0, 0.0, zxy / (hx * hy)}, {0.0, 0.0, zyy / (hy * hy)}};
  }
};

/// Parameters of the columns of a grid by chord length, the mean over the rows that have a length.
/// @error DegenerateCurve
base::Result<std::vector<double>> parameters(std::size_t count, std::size_t rows, const char* called,
                                             const std::function<Point3(std::size_t, std::size_t)>& at) {
  std::vector<double> mean(count, 0.0);
  std::size_t counted = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    std::vector<double> chord(count, 0.0);
    for (std::size_t i = 1; i < count; ++i) chord[i] = chord[i - 1] + geom::distance(at(i - 1, row), at(i, row));
    if (chord.back() == 0.0) continue;
    ++counted;
    for (std::size_t i = 0; i < count; ++i) mean[i] += chord[i] / chord.back();
  }
  if (counted == 0)
    return Error{ErrorCode::DegenerateCurve, fmt::format("all {}s of the grid are one point each", called)};
  for (double& each : mean) each /= static_cast<double>(counted);
  mean.back() = 1.0;
  for (std::size_t i = 1; i < count; ++i) {
    if (!(mean[i] > mean[i - 1] + 1e-12))
      return Error{ErrorCode::DegenerateCurve,
                   fmt::format("points {} and {} are the same in every {} of the grid", i, i + 1, called)};
  }
  return mean;
}

base::Result<SplineBasis> averaged_knots(const std::vector<double>& parameters, std::size_t degree,
                                         const char* called) {
  std::vector<double> knots(degree + 1, 0.0);
  for (std::size_t j = 1; j + degree < parameters.size(); ++j) {
    double sum = 0.0;
    for (std::size_t i = j; i < j + degree; ++i) sum += parameters[i];
    knots.push_back(sum / static_cast<double>(degree));
  }
  knots.insert(knots.end(), degree + 1, 1.0);
  return SplineBasis::make(degree, std::move(knots), called);
}

/// The functions of a basis at each parameter, as the matrix that control values are multiplied by.
void factorise(const SplineBasis& basis, const std::vector<double>& at,
               Eigen::SparseLU<Eigen::SparseMatrix<double>>& solver) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const SplineBasis::Values values = basis.at(at[i]);
    for (std::size_t j = 0; j <= basis.degree(); ++j) {
      if (values.of[0][j] != 0.0)
        entries.emplace_back(static_cast<int>(i), static_cast<int>(values.first + j), values.of[0][j]);
    }
  }
  const auto size = static_cast<Eigen::Index>(at.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  solver.compute(matrix);
}

}  // namespace

base::Result<Surface> Surface::nurbs(std::size_t degree_u, std::vector<double> knots_u, std::size_t degree_v,
                                     std::vector<double> knots_v, const std::vector<Point3>& points,
                                     std::vector<double> weights) {
  DOBRA_TRY(SplineBasis u, SplineBasis::make(degree_u, std::move(knots_u), "knots_u"));
  DOBRA_TRY(SplineBasis v, SplineBasis::make(degree_v, std::move(knots_v), "knots_v"));
  DOBRA_TRY(std::vector<Homogeneous> control, homogeneous(points, std::move(weights), u.count() * v.count()));
  const double same = 1e-12 * extent(control);
  const auto torn = [&](const SplineBasis& basis, std::size_t at, std::size_t rows, std::size_t step,
                        std::size_t row_step) -> base::Result<void> {
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t after = at * step + row * row_step, before = after - step;
      const double gap = geom::distance(control[before].point(), control[after].point());
      if (gap > same)
        return Error{
            ErrorCode::DegenerateCurve,
            fmt::format("the patch is torn at {} = {}, a knot that stands {} times: control points {} and {} are "
                        "{:.6g} m apart; give them one place",
                        step == 1 ? "v" : "u", basis.knots()[at], basis.degree() + 1, before + 1, after + 1, gap)};
    }
    return {};
  };
  for (const std::size_t i : u.jumps()) DOBRA_TRY_VOID(torn(u, i, v.count(), v.count(), 1));
  for (const std::size_t j : v.jumps()) DOBRA_TRY_VOID(torn(v, j, u.count(), 1, v.count()));
  const Box chart{{u.low(), v.low()}, {u.high(), v.high()}};
  Breaks breaks{u.breaks(), v.breaks()};
  return make(std::make_shared<const PatchShape>(std::move(u), std::move(v), std::move(control)), chart,
              std::move(breaks));
}

base::Result<Surface> Surface::through(const std::vector<Point3>& points, std::size_t count_u, std::size_t count_v,
                                       std::size_t degree) {
  if (count_u < 2 || count_v < 2)
    return Error{ErrorCode::InvalidOption,
                 fmt::format("a grid of {} x {} points; two by two are the least", count_u, count_v)};
  if (points.size() != count_u * count_v)
    return Error{ErrorCode::InvalidOption,
                 fmt::format("{} points for a grid of {} x {}", points.size(), count_u, count_v)};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!geom::is_finite(points[i]))
      return Error{ErrorCode::NotFinite, fmt::format("point {} of the grid is not finite", i + 1)};
  }
  DOBRA_TRY(const std::vector<double> in_u, parameters(count_u, count_v, "row", [&](std::size_t i, std::size_t row) {
              return points[i * count_v + row];
            }));
  DOBRA_TRY(const std::vector<double> in_v, parameters(count_v, count_u, "column", [&](std::size_t j, std::size_t row) {
              return points[row * count_v + j];
            }));
  DOBRA_TRY(SplineBasis u, averaged_knots(in_u, std::min(degree, count_u - 1), "knots_u"));
  DOBRA_TRY(SplineBasis v, averaged_knots(in_v, std::min(degree, count_v - 1), "knots_v"));
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solve_u, solve_v;
  factorise(u, in_u, solve_u);
  factorise(v, in_v, solve_v);
  if (solve_u.info() != Eigen::Success || solve_v.info() != Eigen::Success)
    return Error{ErrorCode::DegenerateCurve, "no B-spline patch goes through the points of the grid"};
  std::vector<Homogeneous> control(points.size());
  const auto rows = static_cast<Eigen::Index>(count_u), columns = static_cast<Eigen::Index>(count_v);
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::MatrixXd values(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i) {
      for (Eigen::Index j = 0; j < columns; ++j) {
        const Point3& p = points[static_cast<std::size_t>(i * columns + j)];
        values(i, j) = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
      }
    }
    const Eigen::MatrixXd half = solve_u.solve(values);
    const Eigen::MatrixXd turned = half.transpose();
    const Eigen::MatrixXd made = solve_v.solve(turned);
    for (Eigen::Index i = 0; i < rows; ++i) {
      for (Eigen::Index j = 0; j < columns; ++j) {
        Homogeneous& c = control[static_cast<std::size_t>(i * columns + j)];
        (axis == 0 ? c.x : axis == 1 ? c.y : c.z) = made(j, i);
        c.w = 1.0;
      }
    }
  }
  Breaks breaks{u.breaks(), v.breaks()};
  return make(std::make_shared<const PatchShape>(std::move(u), std::move(v), std::move(control)),
              {{0.0, 0.0}, {1.0, 1.0}}, std::move(breaks));
}

base::Result<Surface> Surface::graph(const std::string& formula, const Box& chart) {
  const std::array<std::string, 2> names{"x", "y"};
  DOBRA_TRY(base::Formula height, base::Formula::make(formula, names));
  const auto shape = std::make_shared<GraphShape>(std::move(height), chart);
  constexpr int parts = 32;
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; j <= parts; ++j) {
      const Point at = {geom::interpolate(chart.low, chart.high, i / static_cast<double>(parts)).x,
                        geom::interpolate(chart.low, chart.high, j / static_cast<double>(parts)).y};
      if (geom::is_finite(at) && !std::isfinite(shape->height(at.x, at.y)))
        return Error{ErrorCode::OutsideDomain,
                     fmt::format("the formula '{}' has no value at x = {}, y = {}", formula, at.x, at.y),
                     base::Place{.item = "graph", .x = at.x, .y = at.y}};
    }
  }
  if (geom::is_finite(chart.low) && geom::is_finite(chart.high)) shape->choose_step();
  return make(shape, chart);
}

}  // namespace dobra::surf
