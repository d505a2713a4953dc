#include "shared/fem/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "shared/base/text.h"
#include "shared/fem/constraints.h"
#include "shared/fem/rigid_parts.h"

namespace dobra::fem {
namespace {

using base::Error;
using base::ErrorCode;
using geom::Vector;

base::Result<void> check_nodes(const mesh::ElementMesh& mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const mesh::NodeId node : mesh.nodes) used[node.index()] = true;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) continue;
    return Error{ErrorCode::CannotMesh, fmt::format("node {} belongs to no element; remove it", i),
                 base::Place{.x = mesh.points[i].x, .y = mesh.points[i].y}};
  }
  return {};
}

/// A formula may have no value somewhere.
base::Result<void> check_finite(const mesh::ElementMesh& mesh, std::span<const Vector> values,
                                const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i].x) && std::isfinite(values[i].y)) continue;
    return Error{ErrorCode::InvalidOption, what + " has no finite value here",
                 base::Place{.x = mesh.points[i].x, .y = mesh.points[i].y}};
  }
  return {};
}

/// The constrained displacements' axes: what is not among them has no reaction.
std::vector<Vector> held_axes(const mesh::ElementMesh& mesh, const std::vector<DofConstraint>& constraints) {
  std::vector<Vector> held(mesh.points.size());
  for (const DofConstraint& constraint : constraints) {
    for (const auto& [dof, coefficient] : constraint.terms) (dof % 2 == 0 ? held[dof / 2].x : held[dof / 2].y) = 1.0;
  }
  return held;
}

/// What is left of the forces at displacements that are free, against the forces that act: great if the equations were
/// singular to rounding.
constexpr double greatest_residual = 1e-6;

base::Result<void> check_residual(const mesh::ElementMesh& mesh, const CaseResult& result, double scale,
                                  const std::vector<Vector>& rest) {
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (length(rest[i]) <= greatest_residual * scale) continue;
    return Error{ErrorCode::CannotSolve,
                 fmt::format("the equations of case '{}' are singular to rounding: something near this node can move "
                             "almost without resistance",
                             result.name),
                 base::Place{.x = mesh.points[i].x, .y = mesh.points[i].y}};
  }
  return {};
}

}  // namespace

base::Result<Solution> solve(const mesh::ElementMesh& mesh, const Problem& problem, const SolverOptions& options,
                             const base::Progress& progress) {
  DOBRA_TRY_VOID(check(mesh));
  DOBRA_TRY_VOID(check_nodes(mesh));
  DOBRA_TRY_VOID(check(mesh, problem));
  const std::vector<DofConstraint> constraints = constraints_of(mesh, problem);
  DOBRA_TRY_VOID(check_supported(mesh, problem, constraints));
  for (const DofConstraint& constraint : constraints) {
    if (std::isfinite(constraint.value)) continue;
    const geom::Point at = mesh.points[constraint.terms.front().first / 2];
    return Error{ErrorCode::InvalidOption, "prescribes a displacement that has no finite value here",
                 base::Place{.item = constraint.name, .x = at.x, .y = at.y}};
  }
  DOBRA_TRY(const EquationMap equations, EquationMap::make(mesh, constraints));
  DOBRA_TRY(const BlockMatrix matrix, assemble(mesh, problem));
  DOBRA_TRY_VOID(progress.check());
  progress.report(0.15, base::translated("solving the equations"));

  std::vector<std::vector<Vector>> forces;
  std::vector<double> unknowns;
  for (const LoadCase& load : problem.cases) {
    forces.push_back(load_vector(mesh, problem, load));
    DOBRA_TRY_VOID(check_finite(mesh, forces.back(), "a load of case '" + load.name + "'"));
    const std::vector<double> right = equations.reduce(matrix, forces.back(), load.settlement);
    unknowns.insert(unknowns.end(), right.begin(), right.end());
  }
  Solution solution;
  if (equations.equation_count() > 0) {
    const SymmetricMatrix reduced = equations.reduce(matrix);
    DOBRA_TRY(Factorisation factors, Factorisation::make(reduced, options, progress.part(0.15, 0.95)));
    DOBRA_TRY_VOID(factors.solve(unknowns, problem.cases.size()));
    solution.statistics = factors.statistics();
  }

  const std::vector<Vector> held = held_axes(mesh, constraints);
  for (std::size_t c = 0; c < problem.cases.size(); ++c) {
    const auto own = std::span(unknowns).subspan(c * equations.equation_count(), equations.equation_count());
    CaseResult result{problem.cases[c].name, equations.expand(own, problem.cases[c].settlement), {}, 0.0};
    result.reactions = multiply(matrix, result.displacements);
    double scale = 0.0;
    std::vector<Vector> unbalanced(mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      result.energy += 0.5 * dot(result.displacements[i], result.reactions[i]);
      scale = std::max({scale, length(forces[c][i]), length(result.reactions[i])});
      const Vector rest = result.reactions[i] - forces[c][i];
      result.reactions[i] = {rest.x * held[i].x, rest.y * held[i].y};
      unbalanced[i] = rest - result.reactions[i];
    }
    DOBRA_TRY_VOID(check_residual(mesh, result, scale, unbalanced));
    solution.cases.push_back(std::move(result));
  }
  return solution;
}

}  // namespace dobra::fem
