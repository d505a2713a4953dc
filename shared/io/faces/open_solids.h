#pragma once
// Solids of a boundary model that do not close.

#include <span>
#include <vector>

#include "shared/io/brep/faces.h"
#include "shared/surf/mesh/surface_mesh.h"

namespace dobra::io::faces {

/// One finding `solid_open` for each solid with edges that one of its faces has alone, with their number, the face and
/// an end of the first. Edges inside a face (internal, external) and those that are a point do not count; shells that
/// are of no solid may be open.
/// @cost  O(edges)
void tell_open_solids(const brep::Model& model, std::span<const brep::TrimmedFace> faces,
                      std::vector<surf::mesh::Finding>& findings);

}  // namespace dobra::io::faces
