#pragma once
// Blocks that slide along a level datum, one unknown each, so that what is said of pairs of them holds best.
// Page: docs/algorithms/jigsaw.md

#include <cstddef>
#include <string>
#include <vector>

#include "shared/base/result.h"

namespace recon {
namespace base = dobra::base;
}  // namespace recon

namespace recon::jigsaw {

/// weight * (X[right] - X[left] - apart)^2 is to be small.
struct Tie {
  std::size_t left = 0, right = 0;
  double weight = 1.0;    ///< > 0
  double apart = 0.0;     ///< m
  std::size_t fault = 0;  ///< That it speaks of.
};

/// A x = b for a symmetric positive definite A, by Cholesky's L L^T.
std::vector<double> solve_positive(std::vector<std::vector<double>> a, std::vector<double> b);

/// The X of least squares with X[pinned] = 0, by a dense weighted Laplacian.
/// @param names  of the blocks, one each.
/// @error CannotRestore: blocks that no chain of ties leads to from the pinned one; it names them.
/// @cost  O(blocks^3)
base::Result<std::vector<double>> slide(const std::vector<std::string>& names, std::size_t pinned,
                                        const std::vector<Tie>& ties);

}  // namespace recon::jigsaw
