#pragma once
// How the elements of a mesh stood in the file that it was read from. Readers turn clockwise elements, since programs
// may count either way round; whoever judges the file asks here which they were.

#include <cstddef>
#include <vector>

#include "shared/mesh/element_mesh.h"

namespace dobra::io::meshes {

struct FileElements {
  std::vector<std::size_t> numbers = {};  ///< Of every element, in the file; empty: 1, 2, ... in the order of the mesh.
  std::vector<mesh::ElementId> turned = {};  ///< Those that were clockwise, ascending.
  friend bool operator==(const FileElements&, const FileElements&) = default;
};

}  // namespace dobra::io::meshes
