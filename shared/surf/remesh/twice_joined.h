#pragma once
// Two nodes of lines that are joined by more than one side, through different parts or across a cut: a mesh would have
// one side for them. Internal to remesh.h.

#include <vector>

#include "shared/surf/mesh/assemble.h"

namespace dobra::surf::remesh {

/// Halves sides inside of charts until no two nodes of lines are joined twice, and none with itself. New nodes lie on
/// the surface given.
/// @param surfaces  one a face  @cost O(n log n)
void part_twice_joined(std::vector<mesh::FaceMesh>& faces, const mesh::Division& division,
                       const std::vector<trim::TrimmedSurface>& surfaces);

}  // namespace dobra::surf::remesh
