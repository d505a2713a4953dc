#pragma once
// Polygon meshes in space: OBJ (v, f) and OFF, as text. Read as they stand, without mending: polygon_mesh.h says what
// is wrong with them.

#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::io {

/// By the ending: .obj or .off. Of OBJ the statements v and f count (f 1, 1/2, 1//3, -1: from the last point); normals,
/// textures, groups and materials are passed over. Corners are checked here, so that each fault has its line.
/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; UnknownFormat: another ending; BadFormat, NotFinite with line
///        and column.
base::Result<mesh::PolygonMesh> read_polygons(const std::string& path);
base::Result<mesh::PolygonMesh> parse_obj(std::string_view text, const std::string& file);
base::Result<mesh::PolygonMesh> parse_off(std::string_view text, const std::string& file);

}  // namespace dobra::io
