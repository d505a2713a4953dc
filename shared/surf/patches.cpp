// B-spline patches, given or through points.
#include <fmt/format.h>

#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

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
    if (basis_u.degree() == 3 && basis_v.degree() == 3) {
      for (std::size_t i = 0; i < uv.size(); ++i) jets[i] = jet<3, 3>(basis_u.few<3>(uv[i].x), basis_v.few<3>(uv[i].y));
    } else if (basis_u.degree() == 2 && basis_v.degree() == 2) {
      for (std::size_t i = 0; i < uv.size(); ++i) jets[i] = jet<2, 2>(basis_u.few<2>(uv[i].x), basis_v.few<2>(uv[i].y));
    } else {
      for (std::size_t i = 0; i < uv.size(); ++i) jets[i] = jet<0, 0>(basis_u.at(uv[i].x), basis_v.at(uv[i].y));
    }
  }
  /// @tparam P, Q  degrees; 0: any
  template <std::size_t P, std::size_t Q, class InU, class InV>
  [[nodiscard]] Jet jet(const InU& in_u, const InV& in_v) const {
    const std::size_t p = P == 0 ? basis_u.degree() : P, q = P == 0 ? basis_v.degree() : Q;
    const std::size_t row = basis_v.count();
    Homogeneous s{}, u{}, v{}, uu{}, uw{}, vv{};
    for (std::size_t i = 0; i <= p; ++i) {
      const Homogeneous* const across = &points[(in_u.first + i) * row + in_v.first];
      std::array<Homogeneous, 3> sum{};
      for (std::size_t j = 0; j <= q; ++j) {
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
  [[nodiscard]] Bend bend(const Box& part) const override {
    Bend most;
    std::vector<Homogeneous> net, half;
    const std::size_t p = basis_u.degree(), q = basis_v.degree(), row = basis_v.count();
    for (const auto& [u0, u1] : basis_u.pieces(part.low.x, part.high.x)) {
      const SplineBasis::ToBezier in_u = basis_u.bezier(u0, u1);
      for (const auto& [v0, v1] : basis_v.pieces(part.low.y, part.high.y)) {
        const SplineBasis::ToBezier in_v = basis_v.bezier(v0, v1);
        half.assign((p + 1) * (q + 1), {});
        net.assign((p + 1) * (q + 1), {});
        for (std::size_t i = 0; i <= p; ++i) {
          for (std::size_t k = 0; k <= p; ++k) {
            for (std::size_t j = 0; j <= q; ++j)
              half[i * (q + 1) + j] += in_u.of[i][k] * points[(in_u.first + k) * row + in_v.first + j];
          }
        }
        for (std::size_t i = 0; i <= p; ++i) {
          for (std::size_t j = 0; j <= q; ++j) {
            for (std::size_t k = 0; k <= q; ++k) net[i * (q + 1) + j] += in_v.of[j][k] * half[i * (q + 1) + k];
          }
        }
        const NetBounds bounds(net, p + 1, q + 1);
        const double du = u1 - u0, dv = v1 - v0;
        most = {std::max(most.uu, bounds.uu / (du * du)), std::max(most.uv, bounds.uv / (du * dv)),
                std::max(most.vv, bounds.vv / (dv * dv))};
      }
    }
    return most;
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

}  // namespace dobra::surf
