#pragma once
// PLY: polygon meshes in space, as text or binary of either byte order. Written by polygon_file.h. Source: [ply].

#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::io::meshes {

/// Of the elements, vertex (x, y, z) and face count; of a face the list vertex_indices or vertex_index, or else its
/// first one. All other properties and elements are passed over.
/// @error BadFormat, NotFinite: of a text with line and column, of a binary file with the number of the record. A file
///        that ends before its last record, or goes on after it, is refused.
/// @cost  O(file size)
base::Result<mesh::PolygonMesh> parse_ply(std::string_view bytes, const std::string& file);

}  // namespace dobra::io::meshes
