#pragma once
// Least squares in the unit box: differential evolution to find the valley, Levenberg-Marquardt to its floor.
// Deterministic at any number of threads. Page: docs/algorithms/inversion.md.
// Source: [storn1997], [marquardt1963].

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "shared/base/progress.h"

namespace recon {
namespace base = dobra::base;
}

namespace recon::inversion {

/// Fills the residuals at a place of the unit box; false where nothing can be computed. Called from many threads.
using Residuals = std::function<bool(std::span<const double> at, std::vector<double>& out)>;

struct Minimum {
  std::vector<double> at;  ///< In [0, 1] each.
  double sum = std::numeric_limits<double>::infinity();
};

struct SearchOptions {
  std::uint64_t seed = 1;
  std::size_t population = 48;
  int generations = 100;
};

/// Differential evolution (rand/1/bin, the scale of each difference drawn too), a generation in parallel.
/// @return the last generation, the best first.  @error Cancelled
base::Result<std::vector<Minimum>> evolve(const Residuals& residuals, std::size_t dimension,
                                          const SearchOptions& options, const base::Progress& progress);

struct DescentOptions {
  int most_steps = 60;
  double enough = 1e-10;        ///< Ends when the sum falls by less than this part of it, twice.
  double difference = 1e-6;     ///< Of forward differences; well above the rounding of the residuals.
  std::vector<bool> held = {};  ///< Coordinates that stay; empty: none.
};

/// Levenberg-Marquardt by forward differences, kept in the box: a coordinate on a face that the descent would leave
/// stays there.  @error Cancelled
base::Result<Minimum> descend(const Residuals& residuals, std::vector<double> start, const DescentOptions& options,
                              const base::Progress& progress);

/// Small symmetric matrices, row by row.
using Matrix = std::vector<std::vector<double>>;
/// What a coordinate does to the residuals, one column each; nothing where they cannot be computed.
/// By differences so large that a point which changes its wall over them does not count.
std::optional<Matrix> slopes_of(const Residuals& residuals, const std::vector<double>& at);
/// J'J of the columns J.
Matrix normal_matrix(const Matrix& columns);
/// Nothing where it is singular to rounding.
std::optional<Matrix> inverse_of(const Matrix& matrix);

}  // namespace recon::inversion
