#pragma once
// An analysis as a deck that CalculiX (and Abaqus) runs: mesh, materials, supports, springs, ties, and the loads as the very nodal
// forces that we solve for, a step a load case. Page: docs/algorithms/fem.md. Source: [calculix-ccx].
//
// CalculiX turns plane elements into a layer of solid ones. In plane strain the displacements are ours; in plane stress
// the thickness changes from node to node as the shape functions do, which shears the layer: no more than that is
// different, and nothing where the thickness stays even.

#include <optional>
#include <string>

#include "shared/base/result.h"
#include "shared/fem/problem.h"

namespace quebra::core {

/// What the format has no words for: beds of springs, ties whose every displacement has a spring.
std::optional<dobra::base::Error> deck_gap(const dobra::mesh::ElementMesh& mesh, const dobra::fem::Problem& problem);

/// @error that of deck_gap
dobra::base::Result<std::string> deck_text(const dobra::mesh::ElementMesh& mesh, const dobra::fem::Problem& problem);

}  // namespace quebra::core
