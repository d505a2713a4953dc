#include "shared/geom/fit/patch_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace dobra::geom::fit {
namespace {

void monomials(Basis basis, double x, double y, double* terms) {
  const std::array<double, 8> serendipity{1, x, y, x * x, x * y, y * y, x * x * y, x * y * y};
  const std::array<double, 4> bilinear{1, x, y, x * y};
  if (basis == Basis::Bilinear)
    std::copy(bilinear.begin(), bilinear.end(), terms);
  else
    std::copy_n(serendipity.begin(), term_count(basis), terms);
}

}  // namespace

std::size_t term_count(Basis basis) {
  constexpr std::array<std::size_t, 4> counts{3, 6, 4, 8};
  return counts[static_cast<std::size_t>(basis)];
}

PatchFit::PatchFit(Basis basis, Point centre, double scale, std::span<const Point> points,
                   std::span<const double> weights)
    : basis_(basis), centre_(centre), scale_(scale), count_(points.size()) {
  const auto terms = static_cast<Eigen::Index>(term_count(basis));
  const auto rows = static_cast<Eigen::Index>(points.size());
  if (rows < terms) return;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Matrix a(rows, terms);
  Eigen::VectorXd root = Eigen::VectorXd::Ones(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Vector local = (points[static_cast<std::size_t>(i)] - centre) / scale;
    monomials(basis, local.x, local.y, a.row(i).data());
    if (!weights.empty()) root(i) = std::sqrt(weights[static_cast<std::size_t>(i)]);
  }
  const Eigen::MatrixXd weighted = root.asDiagonal() * a;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(weighted);
  qr.setThreshold(1e-8);  // coordinates are scaled to 1: below it the points stand on a curve of the basis
  determined_ = qr.rank() == terms;
  if (!determined_) return;
  const Eigen::MatrixXd right = root.asDiagonal();
  const Matrix solved = qr.solve(right);
  inverse_.assign(solved.data(), solved.data() + solved.size());
}

std::vector<double> PatchFit::weights_at(Point p) const {
  std::array<double, 8> terms{};
  const Vector local = (p - centre_) / scale_;
  monomials(basis_, local.x, local.y, terms.data());
  std::vector<double> weights(count_, 0.0);
  for (std::size_t t = 0; t < term_count(basis_); ++t) {
    for (std::size_t i = 0; i < count_; ++i) weights[i] += terms[t] * inverse_[t * count_ + i];
  }
  return weights;
}

std::array<double, 8> PatchFit::coefficients(std::span<const double> samples) const {
  std::array<double, 8> found{};
  for (std::size_t t = 0; t < term_count(basis_); ++t) {
    double sum = 0.0;
    for (std::size_t i = 0; i < count_; ++i) sum += inverse_[t * count_ + i] * samples[i];
    found[basis_ == Basis::Bilinear && t == 3 ? 4 : t] = sum;
  }
  return found;
}

}  // namespace dobra::geom::fit
