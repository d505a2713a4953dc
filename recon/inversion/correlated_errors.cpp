#include "recon/inversion/correlated_errors.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <numeric>

namespace recon::inversion {

namespace {

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void subtract(double factor, std::span<const double> from, std::vector<double>& column) {
  for (std::size_t i = 0; i < column.size(); ++i) column[i] -= factor * from[i];
}

Matrix zeros(std::size_t n) { return Matrix(n, std::vector<double>(n, 0.0)); }

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c = zeros(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a.size(); ++k) {
      for (std::size_t j = 0; j < a.size(); ++j) c[i][j] += a[i][k] * b[k][j];
    }
  }
  return c;
}

double trace(const Matrix& a) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i][i];
  return sum;
}

/// a'b of two lists of columns.
Matrix products(const Matrix& a, const Matrix& b) {
  Matrix all;
  for (const std::vector<double>& column : a) {
    all.emplace_back();
    for (const std::vector<double>& other : b) all.back().push_back(dot(column, other));
  }
  return all;
}

/// Makes a column orthogonal to a basis.
void project_off(const Matrix& basis, std::vector<double>& column) {
  for (int again = 0; again < 2; ++again) {
    for (const std::vector<double>& unit : basis) subtract(dot(unit, column), unit, column);
  }
}

/// Adds what a column has of its own.
void extend(Matrix& basis, std::vector<double> column) {
  const double before = std::sqrt(dot(column, column));
  project_off(basis, column);
  const double norm = std::sqrt(dot(column, column));
  if (!(norm > 1e-9 * before)) return;
  for (double& value : column) value /= norm;
  basis.push_back(std::move(column));
}

/// One bed among the rows of all.
struct Rows {
  std::size_t first = 0, count = 0;
  const BedPoints* bed = nullptr;
  [[nodiscard]] double root(std::size_t i) const { return std::sqrt(bed->weights[i]); }
  /// exp(-power step / length), point by point.
  [[nodiscard]] std::vector<double> kept(double length, double power = 1.0) const {
    std::vector<double> all(count, 0.0);
    for (std::size_t i = 1; i < count && length > 0.0; ++i) all[i] = std::exp(-power * bed->steps[i] / length);
    return all;
  }
  [[nodiscard]] double extent() const { return std::accumulate(bed->steps.begin(), bed->steps.end(), 0.0); }
};

/// The correlations of all points times numbers of them.
std::vector<double> correlate(const std::vector<double>& kept, const std::vector<double>& values) {
  std::vector<double> sums(values);
  double carried = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    carried = kept[i] * (carried + values[i - 1]);
    sums[i] += carried;
  }
  carried = 0.0;
  for (std::size_t i = values.size() - 1; i-- > 0;) {
    carried = kept[i + 1] * (carried + values[i + 1]);
    sums[i] += carried;
  }
  return sums;
}

/// V times the rows of a bed of some columns; V is the covariance of its weighted errors of variance 1.
Matrix covaried(const Rows& rows, double length, const Matrix& columns) {
  Matrix result;
  const std::vector<double> kept = rows.kept(length);
  for (const std::vector<double>& column : columns) {
    std::vector<double> part(rows.count);
    for (std::size_t i = 0; i < rows.count; ++i) part[i] = rows.root(i) * column[rows.first + i];
    part = correlate(kept, part);
    for (std::size_t i = 0; i < rows.count; ++i) part[i] *= rows.root(i);
    result.push_back(std::move(part));
  }
  return result;
}

Matrix rows_of(const Rows& rows, const Matrix& columns) {
  Matrix part;
  for (const std::vector<double>& column : columns) {
    const auto begin = column.begin() + static_cast<std::ptrdiff_t>(rows.first);
    part.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(rows.count));
  }
  return part;
}

/// The sum over i and all lags k from 1 to last of a_i b_(i + k).
double lagged(std::span<const double> a, std::span<const double> b, std::size_t last) {
  double sum = 0.0;
  double window = 0.0;  // of b behind i
  for (std::size_t k = 1; k <= last && k < b.size(); ++k) window += b[k];
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    sum += a[i] * window;
    window -= b[i + 1];
    if (i + 1 + last < b.size()) window += b[i + 1 + last];
  }
  return sum;
}

/// The last lag before the autocorrelation of a bed is no longer positive.
std::size_t last_positive(std::span<const double> values) {
  for (std::size_t lag = 1; lag < values.size(); ++lag) {
    if (dot(values.subspan(lag), values.first(values.size() - lag)) <= 0.0) return lag - 1;
  }
  return values.size() - 1;
}

/// The errors of all beds, and what the fit leaves of them.
class Errors {
 public:
  Errors(std::vector<Rows> rows, Matrix basis) : rows_(std::move(rows)), basis_(std::move(basis)) {
    lengths_.assign(rows_.size(), 0.0);
    for (const Rows& bed : rows_) shares_.push_back(share(bed, 0.0));
  }

  /// One after the other, as each bed takes part in the fit of the others.
  void find_lengths(std::span<const double> residuals) {
    for (int sweep = 0; sweep < 3; ++sweep) {
      for (std::size_t b = 0; b < rows_.size(); ++b) {
        lengths_[b] = length_of(b, residuals.subspan(rows_[b].first, rows_[b].count));
        shares_[b] = share(rows_[b], lengths_[b]);
      }
    }
  }
  [[nodiscard]] const std::vector<double>& lengths() const { return lengths_; }
  /// columns' V columns
  [[nodiscard]] Matrix covariance(const Matrix& columns) const {
    Matrix sum = zeros(columns.size());
    for (std::size_t b = 0; b < rows_.size(); ++b)
      add(products(rows_of(rows_[b], columns), covaried(rows_[b], lengths_[b], columns)), sum);
    return sum;
  }
  /// The traces of M V and of its square, M being what the fit leaves of any residuals.
  [[nodiscard]] std::array<double, 2> traces() const {
    Matrix all = zeros(basis_.size());
    std::array<double, 2> sums{};
    for (std::size_t b = 0; b < rows_.size(); ++b) {
      const std::vector<double>& weights = rows_[b].bed->weights;
      sums[0] += std::accumulate(weights.begin(), weights.end(), 0.0);
      sums[1] += dot(weights, correlate(rows_[b].kept(lengths_[b], 2.0), weights));
      for (const std::vector<double>& column : covaried(rows_[b], lengths_[b], basis_))
        sums[1] -= 2.0 * dot(column, column);
      add(shares_[b], all);
    }
    return {sums[0] - trace(all), sums[1] + trace(product(all, all))};
  }

 private:
  static void add(const Matrix& part, Matrix& sum) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (std::size_t j = 0; j < part.size(); ++j) sum[i][j] += part[i][j];
    }
  }
  [[nodiscard]] Matrix share(const Rows& bed, double length) const {
    return products(rows_of(bed, basis_), covaried(bed, length, basis_));
  }

  /// What is expected of the products of residuals of one bed: the sum over the lags up to `last` over that of lag 0.
  [[nodiscard]] double expected_ratio(std::size_t b, double length, std::size_t last, const Matrix& others) const {
    const Rows& bed = rows_[b];
    const Matrix q = rows_of(bed, basis_);
    const Matrix vq = covaried(bed, length, basis_);
    Matrix all = others;
    add(products(q, vq), all);
    double squares = std::accumulate(bed.bed->weights.begin(), bed.bed->weights.end(), 0.0);
    double lags = 0.0;
    const std::vector<double> kept = bed.kept(length);
    for (std::size_t i = 0; i < bed.count; ++i) {
      double left = bed.root(i);
      for (std::size_t k = i + 1; k <= i + last && k < bed.count; ++k) lags += (left *= kept[k]) * bed.root(k);
    }
    for (std::size_t c = 0; c < q.size(); ++c) {
      std::vector<double> seen(bed.count, 0.0);
      for (std::size_t d = 0; d < q.size(); ++d) subtract(-all[c][d], q[d], seen);
      squares += dot(q[c], seen) - 2.0 * dot(q[c], vq[c]);
      lags += lagged(q[c], seen, last) - lagged(q[c], vq[c], last) - lagged(vq[c], q[c], last);
    }
    return lags / squares;
  }

  [[nodiscard]] double length_of(std::size_t b, std::span<const double> residuals) const {
    const Rows& bed = rows_[b];
    const std::size_t last = last_positive(residuals);
    if (last == 0) return 0.0;
    const double found = lagged(residuals, residuals, last) / dot(residuals, residuals);
    Matrix others = zeros(basis_.size());
    for (std::size_t other = 0; other < rows_.size(); ++other) {
      if (other != b) add(shares_[other], others);
    }
    double low = std::log(0.1 * bed.extent() / static_cast<double>(bed.count));
    double high = std::log(10.0 * bed.extent());
    if (expected_ratio(b, std::exp(low), last, others) >= found) return 0.0;
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (low + high);
      (expected_ratio(b, std::exp(middle), last, others) < found ? low : high) = middle;
    }
    return std::exp(0.5 * (low + high));
  }

  std::vector<Rows> rows_;
  Matrix basis_;  ///< Orthonormal, of what the fit can follow.
  std::vector<double> lengths_;
  std::vector<Matrix> shares_;  ///< basis' V basis, bed by bed.
};

std::vector<Rows> rows_of_beds(const std::vector<BedPoints>& beds) {
  std::vector<Rows> rows;
  std::size_t first = 0;
  for (const BedPoints& bed : beds) {
    rows.push_back({first, bed.weights.size(), &bed});
    first += bed.weights.size();
  }
  return rows;
}

/// What shifts and turns of the lines do to the residuals.
Matrix basis_of_lines(const std::vector<Rows>& beds, std::size_t points, LineIs line) {
  Matrix basis;
  for (const Rows& rows : beds) {
    std::vector<double> shift(points, 0.0), turn(points, 0.0);
    for (std::size_t i = 0; i < rows.count; ++i) {
      shift[rows.first + i] = rows.root(i);
      turn[rows.first + i] = rows.root(i) * rows.bed->along[i];
    }
    extend(basis, std::move(shift));
    if (line == LineIs::Turned) extend(basis, std::move(turn));
  }
  return basis;
}

/// Points from which the mean of a bed is as well known, were they independent.
double effective_points(const Rows& rows, double length) {
  const std::vector<double>& weights = rows.bed->weights;
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  return sum * sum / dot(weights, correlate(rows.kept(length), weights));
}

}  // namespace

CorrelatedErrors::CorrelatedErrors(const std::vector<BedPoints>& beds, std::span<const double> residuals, Matrix slopes,
                                   LineIs line) {
  const std::vector<Rows> rows = rows_of_beds(beds);
  Matrix basis = basis_of_lines(rows, residuals.size(), line);
  for (std::vector<double>& column : slopes) project_off(basis, column);
  for (const std::vector<double>& column : slopes) extend(basis, column);
  Errors errors(rows, std::move(basis));
  errors.find_lengths(residuals);
  lengths_ = errors.lengths();
  for (std::size_t b = 0; b < rows.size(); ++b) effective_.push_back(effective_points(rows[b], lengths_[b]));
  const auto [mean, squares] = errors.traces();
  expected_ = mean;
  freedom_ = squares > 0.0 ? std::max(mean * mean / squares, 1.0) : 1.0;
  Matrix normal = products(slopes, slopes);
  for (std::size_t i = 0; i < normal.size(); ++i) normal[i][i] = normal[i][i] * (1.0 + 1e-10) + 1e-300;
  plain_ = inverse_of(normal).value_or(zeros(normal.size()));
  correlated_ = product(product(plain_, errors.covariance(slopes)), plain_);
}

double CorrelatedErrors::allowance(std::span<const std::size_t> values, double confidence) const {
  Matrix plain = zeros(values.size());
  Matrix correlated = plain;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t j = 0; j < values.size(); ++j) {
      plain[i][j] = plain_[values[i]][values[j]];
      correlated[i][j] = correlated_[values[i]][values[j]];
    }
  }
  const Matrix grown = product(inverse_of(plain).value_or(zeros(values.size())), correlated);
  double sum = trace(grown);
  double count = sum * sum / trace(product(grown, grown));
  if (!(sum > 0.0)) sum = count = static_cast<double>(values.size());  // the residuals do not depend on them
  return sum * boost::math::quantile(boost::math::fisher_f(count, freedom_), 0.01 * confidence);
}

double CorrelatedErrors::joint_allowance(double confidence) const {
  std::vector<std::size_t> all(plain_.size());
  std::iota(all.begin(), all.end(), 0);
  return allowance(all, confidence);
}

}  // namespace recon::inversion
