#pragma once
// Strains, stresses and energies inside elements, straight from the displacements.

#include <span>
#include <vector>

#include "shared/fem/element.h"
#include "shared/fem/material.h"

namespace dobra::fem {

/// u_x,x  u_x,y  u_y,x  u_y,y
using Gradient = std::array<double, 4>;
/// @param u  displacements of all nodes of the mesh.
Gradient gradient_at(const ElementGeometry& element, const Mapped& mapped, std::span<const geom::Vector> u);
inline Voigt strain_of(const Gradient& g) { return {g[0], g[3], g[1] + g[2]}; }

/// Stress at a point of an element, Pa.
Voigt stress_at(const ElementGeometry& element, const Elasticity& elasticity, const Mapped& mapped,
                std::span<const geom::Vector> u);

/// sigma : epsilon integrated over each element, J: twice its strain energy. @cost O(n), in parallel
std::vector<double> element_energies(const mesh::ElementMesh& mesh, const Materials& materials,
                                     std::span<const geom::Vector> u);

/// Stress at each node of an element from the shape functions there, in the order of mesh.nodes; not averaged.
std::vector<Voigt> element_stresses(const mesh::ElementMesh& mesh, const Materials& materials,
                                    std::span<const geom::Vector> u);

}  // namespace dobra::fem
