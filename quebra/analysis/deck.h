#pragma once
// An analysis as a deck that CalculiX (and Abaqus) runs: mesh, materials, supports, springs, ties, and the loads as the
// very nodal forces that we solve for, a step a load case. Page: docs/algorithms/fem.md. Source: [calculix-ccx].
//
// CalculiX turns plane elements into a layer of solid ones. In plane strain the displacements are ours. In plane stress
// the layer's thickness would change from node to node as the shape functions do, and shear it: so plane stress is
// written as plane strain of the elastic constants that give the same stresses in the plane, exactly.

#include <optional>
#include <string>

#include "shared/base/result.h"
#include "shared/fem/problem.h"
#include "shared/scenario/units.h"

namespace quebra::analysis {

/// What the format has no words for: beds of springs, ties whose every displacement has a spring, plane stress with nu
/// <= -0.5.
std::optional<dobra::base::Error> deck_gap(const dobra::mesh::ElementMesh& mesh, const dobra::fem::Problem& problem);

/// The deck in `units`, which it says at its head. @error that of deck_gap
dobra::base::Result<std::string> deck_text(const dobra::mesh::ElementMesh& mesh, const dobra::fem::Problem& problem,
                                           const dobra::scenario::UnitSystem& units = {});

}  // namespace quebra::analysis
