#include "shared/surf/param/relax.h"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/geom/intersect.h"
#include "shared/geom/predicates.h"
#include "shared/geom/spatial_index.h"

namespace dobra::surf::param {

using base::Result;
using geom::Point;
using geom::Vector;
using geom::Vector3;

namespace {

using Matrix = Eigen::Matrix2d;

/// A triangle of the sheet laid flat by itself.
struct Flat {
  double area = 0.0;
  /// Derivatives, along two axes of its plane, of what is 1 in a corner and 0 in the others.
  std::array<Eigen::Vector2d, 3> slopes;
};

Flat flat_of(const Sheet& sheet, const std::array<std::uint32_t, 3>& t) {
  const Vector3 p = sheet.points[t[1]] - sheet.points[t[0]], q = sheet.points[t[2]] - sheet.points[t[0]];
  const double base = geom::length(p), along = dot(p, q) / base, twice = geom::length(cross(p, q));
  const double height = twice / base;
  Flat flat;
  flat.area = 0.5 * twice;
  flat.slopes[1] = {1.0 / base, -along / (base * height)};
  flat.slopes[2] = {0.0, 1.0 / height};
  flat.slopes[0] = -flat.slopes[1] - flat.slopes[2];
  return flat;
}

class Relaxer {
 public:
  Relaxer(const Sheet& sheet, std::vector<Point>& uv) : sheet_(sheet), uv_(uv) {
    double in_space = 0.0, in_chart = 0.0;
    for (const auto& t : sheet_.triangles) {
      flats_.push_back(flat_of(sheet_, t));
      in_space += flats_.back().area;
      in_chart += 0.5 * cross(uv_[t[1]] - uv_[t[0]], uv_[t[2]] - uv_[t[0]]);
    }
    area_ = in_space;
    const double scale = std::sqrt(in_space / in_chart);
    for (Point& p : uv_) p = {scale * p.x, scale * p.y};
  }

  Result<Relaxed> run(const RelaxOptions& options, const base::Progress& progress) {
    Relaxed made;
    made.energy_before = made.energy = energy(uv_);
    constexpr double least = 4.0;  // of any energy
    constexpr int patience = 3;
    int slow = 0;
    while (made.steps < options.steps && slow < patience) {
      DOBRA_TRY_VOID(progress.check());
      const std::vector<Vector> step = solve();
      if (step.empty()) break;
      const double before = made.energy;
      if (!go(step, made)) break;
      ++made.steps;
      slow = before - made.energy < options.enough * (before - least) ? slow + 1 : 0;
      if (made.energy - least < options.enough) break;
    }
    return made;
  }

 private:
  [[nodiscard]] Matrix map_of(const std::vector<Point>& uv, std::size_t t) const {
    Matrix map = Matrix::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Point p = uv[sheet_.triangles[t][k]];
      map += Eigen::Vector2d(p.x, p.y) * flats_[t].slopes[k].transpose();
    }
    return map;
  }
  [[nodiscard]] double energy(const std::vector<Point>& uv) const {
    double sum = 0.0;
    for (std::size_t t = 0; t < flats_.size(); ++t) {
      const Matrix map = map_of(uv, t);
      const double det = map.determinant();
      if (!(det > 0.0)) return std::numeric_limits<double>::infinity();
      const double squares = map.squaredNorm();
      sum += flats_[t].area * (squares + squares / (det * det));  // |J^-1|^2 = |J|^2 / det^2 in the plane
    }
    return sum / area_;
  }

  /// Towards the least of the energy in which that of each triangle is a weighted distance from its nearest rotation.
  std::vector<Vector> solve() {
    const auto n = static_cast<Eigen::Index>(uv_.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(21 * flats_.size() + 2 * uv_.size());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * n);
    for (std::size_t t = 0; t < flats_.size(); ++t) {
      const Flat& flat = flats_[t];
      const Matrix map = map_of(uv_, t);
      const Eigen::JacobiSVD<Matrix> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
      const Matrix rotation = svd.matrixU() * svd.matrixV().transpose();
      Eigen::Vector2d pull;
      for (int i = 0; i < 2; ++i) {
        const double s = svd.singularValues()(i);
        pull(i) = std::abs(s - 1.0) < 1e-6 ? 4.0 : (s - 1.0 / (s * s * s)) / (s - 1.0);
      }
      const Matrix weight = flat.area * svd.matrixU() * pull.asDiagonal() * svd.matrixU().transpose();
      const Matrix to = weight * (rotation - map);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto row = static_cast<Eigen::Index>(sheet_.triangles[t][i]);
        const Eigen::Vector2d force = to * flat.slopes[i];
        right(row) += force(0);
        right(n + row) += force(1);
        for (std::size_t j = 0; j < 3; ++j) {
          const auto column = static_cast<Eigen::Index>(sheet_.triangles[t][j]);
          const double both = flat.slopes[i].dot(flat.slopes[j]);
          if (row >= column) {
            entries.emplace_back(row, column, both * weight(0, 0));
            entries.emplace_back(n + row, n + column, both * weight(1, 1));
          }
          entries.emplace_back(n + row, column, both * weight(1, 0));
        }
      }
    }
    // No place is given, so a little resistance holds the sheet.
    constexpr double resistance = 1e-8;
    for (Eigen::Index i = 0; i < 2 * n; ++i) entries.emplace_back(i, i, resistance);
    Eigen::SparseMatrix<double> matrix(2 * n, 2 * n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    if (!analysed_) solver_.analyzePattern(matrix);
    analysed_ = true;
    solver_.factorize(matrix);
    if (solver_.info() != Eigen::Success) return {};
    const Eigen::VectorXd found = solver_.solve(right);
    std::vector<Vector> step(uv_.size());
    for (Eigen::Index i = 0; i < n; ++i) {
      step[static_cast<std::size_t>(i)] = {found(i), found(n + i)};
      if (!std::isfinite(found(i)) || !std::isfinite(found(n + i))) return {};
    }
    return step;
  }

  /// The part of a step at which the first triangle loses its area.
  [[nodiscard]] double first_flat(const std::vector<Vector>& step) const {
    double first = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : sheet_.triangles) {
      const Vector p = uv_[b] - uv_[a], q = uv_[c] - uv_[a], dp = step[b] - step[a], dq = step[c] - step[a];
      const double square = cross(dp, dq), linear = cross(p, dq) + cross(dp, q), constant = cross(p, q);
      // constant + linear s + square s^2 = 0, by the root that does not cancel
      const double root = linear * linear - 4.0 * square * constant;
      if (root < 0.0) continue;
      const double sum = -0.5 * (linear + std::copysign(std::sqrt(root), linear));
      for (const double s : {sum / square, constant / sum}) {
        if (s > 0.0) first = std::min(first, s);
      }
    }
    return first;
  }

  /// As much of the step as lowers the energy and keeps triangles and borders. @return none does
  bool go(const std::vector<Vector>& step, Relaxed& made) {
    constexpr double short_of = 0.8;
    constexpr int halvings = 12, for_borders = 4;
    double part = std::min(1.0, short_of * first_flat(step));
    std::vector<Point> next(uv_.size());
    int crossings = 0;
    for (int i = 0; i < halvings; ++i, part *= 0.5) {
      for (std::size_t v = 0; v < next.size(); ++v) next[v] = uv_[v] + part * step[v];
      const double energy_there = energy(next);
      if (!(energy_there < made.energy) || flips(next)) continue;
      if (borders_cross(sheet_, next)) {
        made.held_by_border = true;
        if (++crossings == for_borders) return false;
        continue;
      }
      made.energy = energy_there;
      uv_ = next;
      return true;
    }
    return false;
  }
  [[nodiscard]] bool flips(const std::vector<Point>& uv) const {
    return std::any_of(sheet_.triangles.begin(), sheet_.triangles.end(), [&](const auto& t) {
      return geom::orient2d(uv[t[0]], uv[t[1]], uv[t[2]]) != geom::Sign::Positive;
    });
  }

  const Sheet& sheet_;
  std::vector<Point>& uv_;
  std::vector<Flat> flats_;
  double area_ = 0.0;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
  bool analysed_ = false;
};

}  // namespace

bool borders_cross(const Sheet& sheet, const std::vector<Point>& uv) {
  std::vector<geom::Box> boxes;
  std::vector<HalfEdge> sides;
  for (HalfEdge h = 0; h < sheet.twins.size(); ++h) {
    if (sheet.twins[h] != no_half_edge) continue;
    sides.push_back(h);
    boxes.emplace_back();
    boxes.back().add(uv[sheet.start(h)]);
    boxes.back().add(uv[sheet.end(h)]);
  }
  const geom::SpatialIndex index(boxes);
  bool crossing = false;
  for (std::size_t i = 0; i < sides.size() && !crossing; ++i) {
    const std::uint32_t a = sheet.start(sides[i]), b = sheet.end(sides[i]);
    index.for_each_overlapping(boxes[i], [&](std::size_t j) {
      if (j <= i) return geom::Visit::Continue;
      const std::uint32_t c = sheet.start(sides[j]), d = sheet.end(sides[j]);
      const auto meeting = geom::intersect(geom::Segment{uv[a], uv[b]}, geom::Segment{uv[c], uv[d]});
      const bool beside = a == c || a == d || b == c || b == d;
      crossing =
          beside ? meeting.kind == geom::IntersectionKind::Overlap : meeting.kind != geom::IntersectionKind::None;
      return crossing ? geom::Visit::Stop : geom::Visit::Continue;
    });
  }
  return crossing;
}

Result<Relaxed> relax(const Sheet& sheet, std::vector<Point>& uv, const RelaxOptions& options,
                      const base::Progress& progress) {
  return Relaxer(sheet, uv).run(options, progress);
}

}  // namespace dobra::surf::param
