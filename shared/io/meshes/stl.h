#pragma once
// Triangles as STL, text with every digit, z = 0, through OpenMesh.

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

}  // namespace dobra::io::meshes
