#pragma once
// Edges that a file calls one curve and that are not.

#include <vector>

#include "shared/io/faces/piece.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::io::faces {

/// An edge that ends elsewhere than the first face has it, by more than a tenth of the length and the tolerance, is a
/// curve of its own from then on, with the finding `edge_apart`.
/// @param places  of the faces in their file
/// @cost  O(edges)
void part_unlike_edges(std::vector<surf::trim::TrimmedSurface>& faces, const std::vector<base::Place>& places,
                       std::vector<surf::mesh::Finding>& findings);

}  // namespace dobra::io::faces
