#include "recon/inversion/least_squares.h"

#include <algorithm>
#include <cmath>

#include "recon/inversion/bed_shapes.h"
#include "shared/base/counter_random.h"
#include "shared/base/parallel.h"

namespace recon::inversion {

namespace {

constexpr double coarse = 1e-3;  ///< Differences that tell a valley.

double cost_at(const Residuals& residuals, std::span<const double> at) {
  std::vector<double> values;
  if (!residuals(at, values)) return std::numeric_limits<double>::infinity();
  const double sum = sum_of_squares(values);
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

/// Uniform numbers of one member of one generation.
class MemberDraws {
 public:
  MemberDraws(std::uint64_t seed, std::uint32_t generation, std::uint32_t member)
      : seed_(seed), generation_(generation), member_(member) {}
  double next() {
    const base::Counter bits = base::philox({generation_, member_, count_++, 0}, seed_);
    return (bits[0] + 0.5) * 0x1p-32;
  }
  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(next() * static_cast<double>(count)));
  }

 private:
  std::uint64_t seed_;
  std::uint32_t generation_, member_;
  std::uint32_t count_ = 0;
};

/// A trial: the difference of two members added to a third, crossed with the one that it is to replace.
std::vector<double> trial_of(const std::vector<Minimum>& members, std::size_t own, MemberDraws draws) {
  std::size_t others[3] = {own, own, own};
  for (int k = 0; k < 3; ++k) {
    do {
      others[k] = draws.below(members.size());
    } while (others[k] == own || (k > 0 && others[k] == others[0]) || (k > 1 && others[k] == others[1]));
  }
  const double scale = 0.4 + 0.6 * draws.next();
  std::vector<double> trial = members[own].at;
  const std::size_t sure = draws.below(trial.size());
  for (std::size_t i = 0; i < trial.size(); ++i) {
    if (draws.next() >= 0.9 && i != sure) continue;
    const double base = members[others[0]].at[i];
    const double moved = base + scale * (members[others[1]].at[i] - members[others[2]].at[i]);
    // Beyond a face: half way from the base to it.
    trial[i] = moved < 0.0 ? 0.5 * base : moved > 1.0 ? 0.5 * (base + 1.0) : moved;
  }
  return trial;
}

/// Least squares about one place.
struct Linear {
  std::vector<double> residuals;
  Matrix normal;                 ///< J'J
  std::vector<double> gradient;  ///< J'r
};

/// By forward differences; zeros for what is held.
Matrix columns_of(const Residuals& residuals, const std::vector<double>& at, const std::vector<double>& here,
                  const std::vector<bool>& held, double difference) {
  return base::parallel_map<std::vector<double>>(at.size(), [&](std::size_t i) {
    std::vector<double> column;
    if (!held.empty() && held[i]) return std::vector<double>(here.size(), 0.0);
    std::vector<double> moved = at;
    const double h = at[i] + difference > 1.0 ? -difference : difference;
    moved[i] += h;
    if (!residuals(moved, column)) return std::vector<double>(here.size(), 0.0);
    for (std::size_t k = 0; k < column.size(); ++k) column[k] = (column[k] - here[k]) / h;
    return column;
  });
}

std::optional<Linear> linearised(const Residuals& residuals, const std::vector<double>& at,
                                 const std::vector<bool>& held, double difference) {
  Linear linear;
  if (!residuals(at, linear.residuals)) return std::nullopt;
  const Matrix columns = columns_of(residuals, at, linear.residuals, held, difference);
  linear.normal = normal_matrix(columns);
  for (const std::vector<double>& column : columns) {
    double sum = 0.0;
    for (std::size_t k = 0; k < linear.residuals.size(); ++k) sum += column[k] * linear.residuals[k];
    linear.gradient.push_back(sum);
  }
  return linear;
}

/// The lower triangle L of L L' = matrix; nothing where it is not positive definite.
std::optional<Matrix> cholesky(const Matrix& matrix) {
  const std::size_t n = matrix.size();
  Matrix lower(n, std::vector<double>(n, 0.0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = matrix[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= lower[i][k] * lower[j][k];
      if (i == j) {
        if (!(sum > 1e-13 * matrix[i][i])) return std::nullopt;
        lower[i][i] = std::sqrt(sum);
      } else {
        lower[i][j] = sum / lower[j][j];
      }
    }
  }
  return lower;
}

std::vector<double> solved(const Matrix& lower, std::vector<double> right) {
  const std::size_t n = right.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) right[i] -= lower[i][k] * right[k];
    right[i] /= lower[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) right[i] -= lower[k][i] * right[k];
    right[i] /= lower[i][i];
  }
  return right;
}

/// The damped step; coordinates that are held, or on a face that they would leave, stay.
std::vector<double> damped_step(const Linear& linear, const std::vector<double>& at, const std::vector<bool>& held,
                                double damping) {
  const std::size_t n = at.size();
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < n; ++i) {
    const bool outward = (at[i] <= 0.0 && linear.gradient[i] > 0.0) || (at[i] >= 1.0 && linear.gradient[i] < 0.0);
    if ((held.empty() || !held[i]) && !outward && linear.normal[i][i] > 0.0) free.push_back(i);
  }
  Matrix matrix(free.size(), std::vector<double>(free.size()));
  std::vector<double> right(free.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    right[i] = -linear.gradient[free[i]];
    for (std::size_t j = 0; j < free.size(); ++j) matrix[i][j] = linear.normal[free[i]][free[j]];
    matrix[i][i] *= 1.0 + damping;
  }
  std::vector<double> moved = at;
  const std::optional<Matrix> lower = cholesky(matrix);
  if (!lower) return moved;
  const std::vector<double> step = solved(*lower, std::move(right));
  for (std::size_t i = 0; i < free.size(); ++i) moved[free[i]] = std::clamp(at[free[i]] + step[i], 0.0, 1.0);
  return moved;
}

}  // namespace

base::Result<std::vector<Minimum>> evolve(const Residuals& residuals, std::size_t dimension,
                                          const SearchOptions& options, const base::Progress& progress) {
  std::vector<Minimum> members(std::max<std::size_t>(options.population, 5));
  base::parallel_for(members.size(), [&](std::size_t i) {
    MemberDraws draws(options.seed, 0, static_cast<std::uint32_t>(i));
    for (std::size_t k = 0; k < dimension; ++k) members[i].at.push_back(draws.next());
    members[i].sum = cost_at(residuals, members[i].at);
  });
  for (int generation = 1; generation <= options.generations; ++generation) {
    DOBRA_TRY_VOID(progress.check());
    progress.report(static_cast<double>(generation) / options.generations);
    const auto trials = base::parallel_map<Minimum>(members.size(), [&](std::size_t i) {
      Minimum trial;
      trial.at =
          trial_of(members, i, {options.seed, static_cast<std::uint32_t>(generation), static_cast<std::uint32_t>(i)});
      trial.sum = cost_at(residuals, trial.at);
      return trial;
    });
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (trials[i].sum <= members[i].sum) members[i] = trials[i];
    }
    const auto [least, most] = std::minmax_element(members.begin(), members.end(),
                                                   [](const Minimum& a, const Minimum& b) { return a.sum < b.sum; });
    if (most->sum <= least->sum * (1.0 + 1e-3)) break;
  }
  std::stable_sort(members.begin(), members.end(), [](const Minimum& a, const Minimum& b) { return a.sum < b.sum; });
  return members;
}

base::Result<Minimum> descend(const Residuals& residuals, std::vector<double> start, const DescentOptions& options,
                              const base::Progress& progress) {
  Minimum best{std::move(start), 0.0};
  best.sum = cost_at(residuals, best.at);
  double damping = 1e-3;
  int idle = 0;
  for (int step = 0; step < options.most_steps && idle < 2 && best.sum > 0.0; ++step) {
    DOBRA_TRY_VOID(progress.check());
    const std::optional<Linear> linear = linearised(residuals, best.at, options.held, options.difference);
    if (!linear) break;
    bool better = false;
    for (int attempt = 0; attempt < 10 && !better; ++attempt) {
      Minimum next{damped_step(*linear, best.at, options.held, damping), 0.0};
      next.sum = cost_at(residuals, next.at);
      better = next.sum < best.sum;
      damping = better ? std::max(damping * 0.1, 1e-12) : damping * 5.0;
      if (!better) continue;
      idle = best.sum - next.sum <= options.enough * best.sum ? idle + 1 : 0;
      best = std::move(next);
    }
    if (!better) break;
  }
  return best;
}

std::optional<Matrix> slopes_of(const Residuals& residuals, const std::vector<double>& at) {
  std::vector<double> here;
  if (!residuals(at, here)) return std::nullopt;
  return columns_of(residuals, at, here, {}, coarse);
}

Matrix normal_matrix(const Matrix& columns) {
  const std::size_t n = columns.size();
  Matrix normal(n, std::vector<double>(n, 0.0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0.0;
      for (std::size_t k = 0; k < columns[i].size(); ++k) sum += columns[i][k] * columns[j][k];
      normal[i][j] = normal[j][i] = sum;
    }
  }
  return normal;
}

std::optional<Matrix> inverse_of(const Matrix& matrix) {
  const std::optional<Matrix> lower = cholesky(matrix);
  if (!lower) return std::nullopt;
  Matrix inverse;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    std::vector<double> unit(matrix.size(), 0.0);
    unit[i] = 1.0;
    inverse.push_back(solved(*lower, std::move(unit)));
  }
  return inverse;
}

}  // namespace recon::inversion
