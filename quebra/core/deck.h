#pragma once
// An analysis as a deck that CalculiX (and Abaqus) runs: mesh, materials, supports, ties, and the loads as the very nodal
// forces that we solve for, a step a load case. Page: docs/algorithms/fem.md. Source: [calculix-ccx].
//
// CalculiX turns plane elements into a layer of solid ones. In plane strain the displacements are ours; in plane stress
// it lets the thickness change from node to node, which ours, constant in each point, has not.

#include <string>

#include "shared/base/result.h"
#include "shared/fem/problem.h"

namespace quebra::core {

/// @error InvalidOption: what the format has no words for (springs, ties with a value other than zero).
dobra::base::Result<std::string> deck_text(const dobra::mesh::ElementMesh& mesh, const dobra::fem::Problem& problem);

}  // namespace quebra::core
