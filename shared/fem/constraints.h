#pragma once
// Supports and ties as linear equations between displacements, and the equations that remain when they are eliminated:
// u = T v + g, so that K v = f becomes (T^T K T) v = T^T (f - K g). Page: docs/algorithms/fem.md.
// A degree of freedom is 2 * node + axis.

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shared/base/result.h"
#include "shared/fem/assemble.h"
#include "shared/fem/sparse_solver.h"

namespace dobra::fem {

using DofTerm = std::pair<std::uint32_t, double>;

/// sum of coefficient * displacement = value.
struct DofConstraint {
  std::vector<DofTerm> terms;
  double value = 0.0;
  std::string name;  ///< The support or tie that it comes from.
};

/// Those of the supports, in their order, then those of the ties.  @pre check(mesh, problem)
std::vector<DofConstraint> constraints_of(const mesh::ElementMesh& mesh, const Problem& problem);

class EquationMap {
 public:
  /// Eliminates one displacement a constraint.
  /// @error InvalidOption naming the support or tie that contradicts the earlier ones, with the place of its node.
  static base::Result<EquationMap> make(const mesh::ElementMesh& mesh, const std::vector<DofConstraint>& constraints);

  [[nodiscard]] std::size_t equation_count() const { return equations_; }
  /// T^T K T, lower triangle. @cost O(blocks)
  [[nodiscard]] SymmetricMatrix reduce(const BlockMatrix& matrix) const;
  /// T^T (f - K g), with the prescribed values g times `settlement`.
  [[nodiscard]] std::vector<double> reduce(const BlockMatrix& matrix, std::span<const geom::Vector> forces,
                                           double settlement) const;
  /// T v + g.
  [[nodiscard]] std::vector<geom::Vector> expand(std::span<const double> solution, double settlement) const;
  /// The node that an equation (from 0) belongs to.
  [[nodiscard]] std::size_t node_of_equation(std::size_t equation) const;

 private:
  /// A displacement as equations times coefficients plus a constant.
  struct Slave {
    std::vector<DofTerm> terms;
    double value = 0.0;
  };
  struct View {
    std::span<const DofTerm> terms;
    double value = 0.0;
  };
  [[nodiscard]] View view(std::size_t dof) const;

  std::vector<std::int32_t> index_;  ///< One a dof: its equation, or -1 - position in slaves_.
  std::vector<DofTerm> unit_;        ///< One a dof: {equation, 1}, for view().
  std::vector<Slave> slaves_;
  std::size_t equations_ = 0;
};

}  // namespace dobra::fem
