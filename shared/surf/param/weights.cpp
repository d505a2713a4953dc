// Weights of a vertex's neighbours, and the equations that they make.
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/surf/param/parametrise.h"

namespace dobra::surf::param {

using base::Error;
using base::ErrorCode;
using geom::Point;
using geom::Vector;
using geom::Vector3;

namespace {

/// What is seen from a vertex inside: its neighbours, anticlockwise, and the angles between each and the next.
struct Ring {
  std::vector<std::uint32_t> vertices;
  std::vector<double> lengths, angles;
};

void look_round(const Sheet& sheet, HalfEdge first, Ring& ring) {
  ring.vertices.clear();
  ring.lengths.clear();
  ring.angles.clear();
  const geom::Point3 at = sheet.points[sheet.start(first)];
  HalfEdge h = first;
  do {
    const Vector3 here = sheet.points[sheet.end(h)] - at, after = sheet.points[sheet.start(previous(h))] - at;
    ring.vertices.push_back(sheet.end(h));
    ring.lengths.push_back(geom::length(here));
    ring.angles.push_back(std::atan2(geom::length(cross(here, after)), dot(here, after)));
    h = sheet.twins[previous(h)];
  } while (h != first);
}

/// tan(a/2) + tan(b/2) over the length: [floater2003], (2.1).
void mean_value(const Ring& ring, std::vector<double>& weights) {
  const std::size_t d = ring.vertices.size();
  for (std::size_t k = 0; k < d; ++k)
    weights[k] = (std::tan(0.5 * ring.angles[(k + d - 1) % d]) + std::tan(0.5 * ring.angles[k])) / ring.lengths[k];
}

/// [floater1997], 6: the ring laid flat with its lengths and its angles in proportion; each neighbour's ray through the
/// centre meets an opposite side, and the centre is a mean of the three. @return false where an angle is too wide
bool shape_preserving(const Ring& ring, std::vector<double>& weights) {
  const std::size_t d = ring.vertices.size();
  double sum = 0.0;
  for (const double angle : ring.angles) sum += angle;
  const double turn = 2.0 * std::numbers::pi;
  constexpr double widest = std::numbers::pi * (1.0 - 1e-9);
  std::vector<double> direction(d + 1, 0.0);
  for (std::size_t k = 0; k < d; ++k) {
    const double angle = ring.angles[k] * turn / sum;
    if (!(angle < widest)) return false;
    direction[k + 1] = direction[k] + angle;
  }
  direction[d] = turn;
  const auto place = [&](std::size_t k) {
    return Vector{ring.lengths[k] * std::cos(direction[k]), ring.lengths[k] * std::sin(direction[k])};
  };
  std::fill(weights.begin(), weights.end(), 0.0);
  for (std::size_t l = 0; l < d; ++l) {
    const double opposite = std::fmod(direction[l] + std::numbers::pi, turn);
    std::size_t r =
        static_cast<std::size_t>(std::upper_bound(direction.begin(), direction.end(), opposite) - direction.begin()) -
        1;
    r = std::min(r, d - 1);
    const std::size_t after = (r + 1) % d;
    const Vector p = place(l), q = place(r), s = place(after);
    const double of_p = std::max(0.0, cross(q, s)), of_q = std::max(0.0, cross(s, p)),
                 of_s = std::max(0.0, cross(p, q));
    const double all = of_p + of_q + of_s;
    if (!(all > 0.0)) return false;
    weights[l] += of_p / all;
    weights[r] += of_q / all;
    weights[after] += of_s / all;
  }
  return *std::min_element(weights.begin(), weights.end()) > 0.0;
}

/// Least degree first. Eigen's own class gives the inverse of the order that its LU asks for.
struct LeastDegree {
  using PermutationType = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;
  template <class Matrix>
  void operator()(const Matrix& matrix, PermutationType& order) const {
    PermutationType inverse;
    Eigen::AMDOrdering<int>()(matrix, inverse);
    order = inverse.inverse();
  }
};

void weigh(const Ring& ring, Weights kind, std::vector<double>& weights) {
  weights.assign(ring.vertices.size(), 0.0);
  if (kind == Weights::MeanValue || !shape_preserving(ring, weights)) mean_value(ring, weights);
  double sum = 0.0;
  for (const double weight : weights) sum += weight;
  for (double& weight : weights) weight /= sum;
}

}  // namespace

std::vector<Neighbour> ring_weights(const Sheet& sheet, HalfEdge first, Weights kind) {
  Ring ring;
  std::vector<double> weights;
  look_round(sheet, first, ring);
  weigh(ring, kind, weights);
  std::vector<Neighbour> neighbours;
  for (std::size_t k = 0; k < weights.size(); ++k) neighbours.push_back({ring.vertices[k], weights[k]});
  return neighbours;
}

base::Result<void> solve_inside(const Sheet& sheet, Weights kind, std::vector<Point>& uv) {
  const std::vector<HalfEdge> first = sheet.first_half_edges();
  std::vector<int> row(sheet.points.size(), -1);
  int rows = 0;
  for (std::size_t v = 0; v < row.size(); ++v) {
    if (sheet.twins[first[v]] != no_half_edge) row[v] = rows++;
  }
  if (rows == 0) return {};
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(rows) * 7);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(rows, 2);
  Ring ring;
  std::vector<double> weights;
  for (std::size_t v = 0; v < row.size(); ++v) {
    if (row[v] < 0) continue;
    look_round(sheet, first[v], ring);
    weigh(ring, kind, weights);
    entries.emplace_back(row[v], row[v], 1.0);
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const std::uint32_t w = ring.vertices[k];
      if (row[w] >= 0) {
        entries.emplace_back(row[v], row[w], -weights[k]);
      } else {
        right(row[v], 0) += weights[k] * uv[w].x;
        right(row[v], 1) += weights[k] * uv[w].y;
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  // Diagonally dominant by rows, and its pattern is symmetric: no pivots are needed but those of the diagonal.
  Eigen::SparseLU<Eigen::SparseMatrix<double>, LeastDegree> solver;
  solver.isSymmetric(true);
  solver.setPivotThreshold(0.0);
  solver.analyzePattern(matrix);
  solver.factorize(matrix);
  if (solver.info() != Eigen::Success)
    return Error{ErrorCode::CannotSolve, "the equations of the parametrisation have no solution"};
  Eigen::MatrixXd found = solver.solve(right);
  const Eigen::MatrixXd rest = right - matrix * found;
  found += solver.solve(rest);
  for (std::size_t v = 0; v < row.size(); ++v) {
    if (row[v] >= 0) uv[v] = {found(row[v], 0), found(row[v], 1)};
    if (!geom::is_finite(uv[v]))
      return Error{ErrorCode::CannotSolve, "the equations of the parametrisation have no solution"};
  }
  return {};
}

}  // namespace dobra::surf::param
