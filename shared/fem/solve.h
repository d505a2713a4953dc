#pragma once
// Linear elastic analysis: assembly, elimination of supports and ties, one factorisation, every load case.
// Page: docs/algorithms/fem.md.

#include <string>
#include <vector>

#include "shared/base/progress.h"
#include "shared/fem/problem.h"
#include "shared/fem/sparse_solver.h"

namespace dobra::fem {

struct CaseResult {
  std::string name;
  std::vector<geom::Vector> displacements;  ///< One a node, m.
  std::vector<geom::Vector> reactions;      ///< Forces of supports and ties on the mesh, one a node, N; 0 where free.
  double energy = 0.0;                      ///< u K u / 2, springs included, J.
};

struct Solution {
  std::vector<CaseResult> cases;  ///< In the order of the problem.
  SolverStatistics statistics;
};

/// @error those of mesh::check, fem::check, EquationMap, check_supported (what floats, and how), assemble,
/// Factorisation.
/// @cost  O(n^1.5) in the number n of nodes.
base::Result<Solution> solve(const mesh::ElementMesh& mesh, const Problem& problem, const SolverOptions& options = {},
                             const base::Progress& progress = {});

}  // namespace dobra::fem
