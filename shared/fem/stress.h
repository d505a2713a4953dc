#pragma once
// Strains, stresses and energies inside elements, straight from the displacements.

#include <optional>
#include <span>
#include <vector>

#include "shared/fem/element.h"
#include "shared/fem/material.h"
#include "shared/fem/mixed.h"

namespace dobra::fem {

/// u_x,x  u_x,y  u_y,x  u_y,y
using Gradient = std::array<double, 4>;
inline Voigt strain_of(const Gradient& g) { return {g[0], g[3], g[1] + g[2]}; }

/// The displacements of one element as a field: gradients and stresses inside, as the element has them (mixed.h).
class ElementSolution {
 public:
  /// @param u  displacements of all nodes of the mesh.
  ElementSolution(const ElementGeometry& element, const Material& material, std::span<const geom::Vector> u);
  [[nodiscard]] Gradient gradient(const Mapped& mapped) const;
  /// Pa
  [[nodiscard]] Voigt stress(const Mapped& mapped) const;
  /// That its stiffness is integrated by.
  [[nodiscard]] Rule rule() const;

 private:
  const ElementGeometry& element_;
  Elasticity elasticity_;
  std::array<geom::Vector, most_nodes> own_;
  std::optional<MixedElement> mixed_;
  geom::Vector bubble_;
  std::array<double, 3> dilatation_{};
};

/// sigma : epsilon integrated over each element, J: twice its strain energy. @cost O(n), in parallel
std::vector<double> element_energies(const mesh::ElementMesh& mesh, const Materials& materials,
                                     std::span<const geom::Vector> u);

/// Stress at each node of an element from the shape functions there, in the order of mesh.nodes; not averaged.
std::vector<Voigt> element_stresses(const mesh::ElementMesh& mesh, const Materials& materials,
                                    std::span<const geom::Vector> u);

}  // namespace dobra::fem
