#pragma once
// Superconvergent patch recovery: smooth values at the nodes of a mesh from samples inside its elements. Round each
// vertex the samples of a patch of elements are fitted by a polynomial, weighted least squares in coordinates scaled to
// the patch; mid-side nodes take the mean of the patches of their ends. A patch never crosses into another region or
// through a boundary (so not through the lips of a crack), and grows where a boundary leaves it too few samples.
// Page: docs/algorithms/recover.md. Source: [zienkiewicz1992spr].

#include <span>
#include <vector>

#include "shared/fem/material.h"
#include "shared/geom/fit/patch_fit.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::fem::error {

using geom::fit::Basis;
using geom::fit::PatchFit;
using geom::fit::term_count;

struct RecoveredStress {
  /// One an element's node, in the order of mesh.nodes, Pa: equal at a node within a region, different across regions.
  std::vector<Voigt> at_element_nodes;
  std::size_t grown = 0;     ///< Patches that had to grow beyond the elements round their vertex.
  std::size_t degraded = 0;  ///< Patches whose samples determine a linear polynomial only, or just a mean.
};

/// Stresses recovered from the displacements `u` of a case.
/// @pre  check(mesh), a material for each region.  @cost O(n), in parallel.
RecoveredStress recover_stress(const mesh::ElementMesh& mesh, const Materials& materials,
                               std::span<const geom::Vector> u);

/// Mean at each node over the regions that meet there, for drawing, Pa.
std::vector<Voigt> nodal_mean(const mesh::ElementMesh& mesh, std::span<const Voigt> at_element_nodes);

}  // namespace dobra::fem::error
