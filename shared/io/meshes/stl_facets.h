#pragma once
// STL as faces in space, text or binary, for solids. stl.h reads and writes the plane meshes of the same format.

#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::io::meshes {

/// Triangles as the file gives them; corners with equal coordinates are one point, without tolerance. A file is binary
/// if it is as long as its count of triangles says, whatever word it begins with. Normals are passed over.
/// @error EmptyFile; BadFormat (a facet without three corners, no endsolid, a length that the count does not explain)
///        and NotFinite, with the line, or the number of the triangle.
/// @cost  O(n)
base::Result<mesh::PolygonMesh> parse_stl_facets(std::string_view bytes, const std::string& file);

}  // namespace dobra::io::meshes
