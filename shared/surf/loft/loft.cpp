// 1. Every line by the part of its length, or by place; the vertices of all of them are the breaks of u.
// 2. v by the mean chord over all breaks.
// 3. One collocation matrix for all breaks: control points across the lines.
#include "shared/surf/loft/loft.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "shared/surf/spline_basis.h"

namespace dobra::surf::loft {

using base::Error;
using base::ErrorCode;
using geom::Point3;

namespace {

constexpr double same_break = 1e-10;  // of the length of a line

base::Place place_at(Point3 p) { return {.x = p.x, .y = p.y, .z = p.z}; }

/// The parts of the length at each point. @error as loft
base::Result<std::vector<double>> parts_of(const std::vector<Point3>& line, std::size_t number) {
  if (line.size() < 2) return Error{ErrorCode::DegenerateCurve, fmt::format("line {} has no two points", number + 1)};
  std::vector<double> parts{0.0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = geom::distance(line[i - 1], line[i]);
    if (!geom::is_finite(line[i]) || !std::isfinite(step))
      return Error{ErrorCode::NotFinite, fmt::format("point {} of line {} is not finite", i + 1, number + 1)};
    if (!(step > 0.0))
      return Error{ErrorCode::DegenerateCurve,
                   fmt::format("points {} and {} of line {} are in one place", i, i + 1, number + 1),
                   place_at(line[i])};
    parts.push_back(parts.back() + step);
  }
  for (double& part : parts) part /= parts.back();
  parts.back() = 1.0;
  return parts;
}

/// The line at each break: its own vertices as they are.
std::vector<Point3> at_breaks(const std::vector<Point3>& line, const std::vector<double>& parts,
                              const std::vector<double>& breaks) {
  std::vector<Point3> points;
  std::size_t k = 0;
  for (const double u : breaks) {
    while (k + 2 < parts.size() && parts[k + 1] < u - same_break) ++k;
    if (std::abs(parts[k] - u) <= same_break) {
      points.push_back(line[k]);
    } else if (std::abs(parts[k + 1] - u) <= same_break) {
      points.push_back(line[k + 1]);
    } else {
      points.push_back(line[k] + (u - parts[k]) / (parts[k + 1] - parts[k]) * (line[k + 1] - line[k]));
    }
  }
  return points;
}

/// v of each line, by the mean of the chords; the trapezoidal rule over u.
base::Result<std::vector<double>> chord_parameters(const CommonBreaks& common) {
  std::vector<double> v{0.0};
  for (std::size_t j = 1; j < common.points.size(); ++j) {
    const auto& a = common.points[j - 1];
    const auto& b = common.points[j];
    double mean = 0.0;
    for (std::size_t i = 1; i < common.u.size(); ++i) {
      mean += 0.5 * (common.u[i] - common.u[i - 1]) * (geom::distance(a[i - 1], b[i - 1]) + geom::distance(a[i], b[i]));
    }
    if (!(mean > 0.0))
      return Error{ErrorCode::DegenerateCurve, fmt::format("lines {} and {} are in one place; leave one out", j, j + 1),
                   place_at(b.front())};
    v.push_back(v.back() + mean);
  }
  for (double& value : v) value /= v.back();
  v.back() = 1.0;
  return v;
}

/// Knots of the spline through values at v whose end pieces are one piece each ("not a knot").
std::vector<double> knots_across(const std::vector<double>& v, std::size_t degree) {
  std::vector<double> knots(degree + 1, v.front());
  if (degree == 3) knots.insert(knots.end(), v.begin() + 2, v.end() - 2);
  knots.insert(knots.end(), degree + 1, v.back());
  return knots;
}

}  // namespace

base::Result<CommonBreaks> common_breaks(const std::vector<std::vector<Point3>>& lines, const LineParts& parts) {
  CommonBreaks common;
  std::vector<std::vector<Point3>> whole = lines;
  LineParts of_lines;
  std::vector<double> all;
  for (std::size_t j = 0; j < lines.size(); ++j) {
    DOBRA_TRY(std::vector<double> of_line, parts_of(lines[j], j));
    if (!parts.empty()) {
      of_line = parts[j];
      if (of_line.front() > same_break) {
        of_line.insert(of_line.begin(), 0.0);
        whole[j].insert(whole[j].begin(), lines[j].front());
      }
      if (of_line.back() < 1.0 - same_break) {
        of_line.push_back(1.0);
        whole[j].push_back(lines[j].back());
      }
    }
    all.insert(all.end(), of_line.begin(), of_line.end());
    of_lines.push_back(std::move(of_line));
  }
  std::sort(all.begin(), all.end());
  for (const double u : all) {
    if (common.u.empty() || u - common.u.back() > same_break) common.u.push_back(u);
  }
  common.u.front() = 0.0;
  common.u.back() = 1.0;
  for (std::size_t j = 0; j < whole.size(); ++j) common.points.push_back(at_breaks(whole[j], of_lines[j], common.u));
  return common;
}

std::optional<LineParts> parts_by_place(const std::vector<std::vector<Point3>>& lines, geom::Vector way,
                                        std::array<bool, 2> held) {
  LineParts places;
  const Point3 origin = lines.front().front();
  double low = INFINITY, high = -INFINITY;
  for (const auto& line : lines) {
    std::vector<double>& of_line = places.emplace_back();
    for (const Point3 p : line) of_line.push_back((p.x - origin.x) * way.x + (p.y - origin.y) * way.y);
    low = std::min(low, of_line.front());
    high = std::max(high, of_line.back());
  }
  for (std::vector<double>& of_line : places) {
    const double from = held[0] ? of_line.front() : low, to = held[1] ? of_line.back() : high;
    for (std::size_t i = 0; i < of_line.size(); ++i) {
      of_line[i] = (of_line[i] - from) / (to - from);
      // Vertices that would be one break, and lines that turn back.
      if (i > 0 && !(of_line[i] - of_line[i - 1] > 4.0 * same_break)) return std::nullopt;
    }
  }
  return places;
}

base::Result<Loft> loft(const std::vector<std::vector<Point3>>& lines, const LineParts& parts) {
  if (lines.size() < 2)
    return Error{ErrorCode::InvalidOption, fmt::format("a surface through {} lines; give two at least", lines.size())};
  DOBRA_TRY(const CommonBreaks common, common_breaks(lines, parts));
  DOBRA_TRY(std::vector<double> v, chord_parameters(common));
  const std::size_t count = lines.size(), degree = std::min<std::size_t>(count - 1, 3);
  const std::vector<double> knots_v = knots_across(v, degree);
  DOBRA_TRY(const SplineBasis basis, SplineBasis::make(degree, knots_v, "knots across the lines"));
  const auto rows = static_cast<Eigen::Index>(count);
  Eigen::MatrixXd collocation = Eigen::MatrixXd::Zero(rows, rows);
  for (std::size_t j = 0; j < count; ++j) {
    const SplineBasis::Values values = basis.at(v[j]);
    for (std::size_t k = 0; k <= degree; ++k)
      collocation(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(values.first + k)) = values.of[0][k];
  }
  const Eigen::PartialPivLU<Eigen::MatrixXd> solver(collocation);
  std::vector<Point3> controls;
  Eigen::MatrixX3d right(rows, 3);
  for (std::size_t i = 0; i < common.u.size(); ++i) {
    for (Eigen::Index j = 0; j < rows; ++j) {
      const Point3 p = common.points[static_cast<std::size_t>(j)][i];
      right.row(j) << p.x, p.y, p.z;
    }
    const Eigen::MatrixX3d found = solver.solve(right);
    for (Eigen::Index j = 0; j < rows; ++j) controls.push_back({found(j, 0), found(j, 1), found(j, 2)});
  }
  std::vector<double> knots_u{0.0};
  knots_u.insert(knots_u.end(), common.u.begin(), common.u.end());
  knots_u.push_back(1.0);
  DOBRA_TRY(Surface surface, Surface::nurbs(1, std::move(knots_u), degree, knots_v, controls));
  return Loft{std::move(surface), std::move(v)};
}

}  // namespace dobra::surf::loft
