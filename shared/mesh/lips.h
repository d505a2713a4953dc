#pragma once
// Opens cracks in a mesh that has edges along them: round each node of a crack the elements fall into fans, divided by
// crack edges and the boundary, and each fan gets a copy of the node of its own. So any number of cracks, their
// branches and their crossings come apart with one rule, by topology alone: no distance is measured, and lips that lie
// on each other cannot be confused. A node with one fan stays one: it is a tip, if the crack ends there.
// Page: docs/algorithms/lips.md.

#include <span>
#include <string>

#include "shared/mesh/element_mesh.h"

namespace dobra::mesh {

/// @param mesh    first order; each crack is a side set of internal sides in the order of travel.
/// @param cracks  names of those side sets. Each is replaced by "NAME_left" (as given) and "NAME_right" (the sides that
///                faced them), now boundary sides; a tip at its start or end is the node set "NAME_start", "NAME_end".
/// @return        the mesh with as many elements and the same coordinates; copies come after the nodes there were, and
///                a node set that held a node holds its copies too. Those on one lip are the sets "SET_left" and
///                "SET_right"; where several cracks meet "SET_NAME_left" and "SET_NAME_right" of each.
/// @error InvalidOption for a name that is no side set; CannotMesh with the place: a crack of a single edge between two
///        tips (nothing can open), or one that runs along the boundary; errors of check.
/// @cost  O(n log n)
base::Result<ElementMesh> open_lips(ElementMesh mesh, std::span<const std::string> cracks);

/// The same by sides alone, for a mesh whose points are a view of ones in space: not checked, and without tips (their
/// node sets are made).
base::Result<ElementMesh> open_lips_of_sides(ElementMesh mesh, std::span<const std::string> cracks);

/// Finds the tips again in a mesh that was read from a file, by the names that open_lips gives.
void restore_tips(ElementMesh& mesh);

}  // namespace dobra::mesh
