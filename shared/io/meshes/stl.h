#pragma once
// Triangles as STL: plane meshes as text with every digit, z = 0, through OpenMesh; faces in space, for solids, from
// text and binary.

#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"
#include "shared/mesh/triangle_mesh.h"

namespace dobra::io::meshes {

/// Sets and regions are left behind. @error those of mesh::to_openmesh; CannotMesh if OpenMesh fails.
base::Result<std::string> stl_text(const mesh::TriangleMesh& mesh);
/// Of a surface in space; quadrilaterals are cut along their shorter diagonal. @pre faces of three or four corners
std::string stl_text(const mesh::PolygonMesh& mesh);
/// @error CannotMesh if the text is no STL, or a face has no area or is clockwise.
base::Result<mesh::TriangleMesh> parse_stl(std::string_view text, const std::string& file);

/// Triangles as the file gives them; corners with equal coordinates are one point, without tolerance. A file is binary
/// if it is as long as its count of triangles says, whatever word it begins with. Normals are passed over.
/// @error EmptyFile; BadFormat (a facet without three corners, no endsolid, a length that the count does not explain)
///        and NotFinite, with the line, or the number of the triangle.
/// @cost  O(n)
base::Result<mesh::PolygonMesh> parse_stl_facets(std::string_view bytes, const std::string& file);

}  // namespace dobra::io::meshes
