#pragma once
// Surfaces of DXF drawings: 3DFACE entities, as programs of geology and CAD export meshes. Source: [autodeskdxf].

#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::io::meshes {

/// The faces of the entities (those of blocks are passed over), in drawing units, z up. Corners at one place are one
/// point; a fourth corner at the place of the third makes a triangle, and faces without an area are left out.
/// @error BadFormat with the line: no 3DFACE, a coordinate that is no number, the end missing; NotFinite.
base::Result<mesh::PolygonMesh> parse_dxf_faces(std::string_view text, const std::string& file);

}  // namespace dobra::io::meshes
