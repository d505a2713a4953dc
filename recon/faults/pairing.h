#pragma once
// Which cutoffs of a horizon on the two walls of a fault belong together. Page: docs/algorithms/cutoffs.md

#include <utility>
#include <vector>

#include "recon/faults/cutoffs.h"

namespace recon::faults {

/// The cutoffs of one horizon at a fault, from the higher end down.
struct WallCutoffs {
  std::vector<Cutoff> hanging, foot;
};
using Partners = std::pair<std::optional<Cutoff>, std::optional<Cutoff>>;  ///< In the hanging wall, in the footwall.

/// Separation along the fault that a cutoff in the hanging wall is likely to have, by its arc length: that of the
/// nearest horizon which has one cutoff on each wall; 0 without any.
class ExpectedSeparation {
 public:
  void learn_from(const WallCutoffs& walls);
  [[nodiscard]] double at(double arc) const;

 private:
  std::vector<std::pair<double, double>> known_;  ///< Arc in the hanging wall, separation, m.
};

/// As many pairs as the wall with fewer cutoffs has, in order along the fault, so that their separations differ least
/// from the expected ones in sum; those that are left over stand alone. A horizon that passes is its own partner.
/// @cost  O(cutoffs of one wall x of the other)
std::vector<Partners> partners_of(const WallCutoffs& walls, const ExpectedSeparation& expected);

}  // namespace recon::faults
