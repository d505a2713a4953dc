#pragma once
// Direct solution of symmetric positive definite sparse systems by MUMPS (multifrontal LDL^T, sequential build):
// analysis with an estimate of the memory, factorisation once, any number of right sides. Source: [amestoy2001mumps].

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"

namespace dobra::fem {

/// One triangle of a symmetric matrix, entry by entry; entries at the same place add up, in the order given.
struct SymmetricMatrix {
  std::size_t size = 0;
  std::vector<std::int32_t> rows;     ///< From 1.
  std::vector<std::int32_t> columns;  ///< From 1.
  std::vector<double> values;
};

struct SolverOptions {
  double memory_limit = 0.0;  ///< Bytes that the factorisation may take; 0 takes what the machine has.
};

struct SolverStatistics {
  std::size_t unknowns = 0;
  double memory_estimate = 0.0;  ///< Bytes, from the analysis, before anything is factorised.
  double factor_entries = 0.0;   ///< Numbers in the factors.
};

class Factorisation {
 public:
  /// Analyses and factorises; the matrix is freed with its owner. Calls from several threads wait for each other.
  /// @error CannotSolve: not enough memory (says how much is needed), or singular.
  /// @cost  O(n^1.5) for plane meshes of n unknowns, O(n log n) numbers.
  static base::Result<Factorisation> make(const SymmetricMatrix& matrix, const SolverOptions& options = {},
                                          const base::Progress& progress = {});

  /// Replaces `count` right sides, one after the other, by their solutions. @error CannotSolve
  base::Result<void> solve(std::span<double> right_sides, std::size_t count = 1);
  [[nodiscard]] const SolverStatistics& statistics() const { return statistics_; }

 private:
  struct Instance;
  struct Deleter {
    void operator()(Instance* instance) const;
  };
  Factorisation() = default;
  std::unique_ptr<Instance, Deleter> instance_;
  SolverStatistics statistics_;
};

/// Bytes of memory of this machine; 0 if it cannot be found out.
double machine_memory();

}  // namespace dobra::fem
