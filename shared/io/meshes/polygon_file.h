#pragma once
// Polygon meshes in space: OBJ (v, f) and OFF, read and written as text, and PLY, written as text. ply.h reads it. Read
// as they stand, without mending: polygon_mesh.h says what is wrong with them.

#include <span>
#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::io::meshes {

/// The statements v and f count (f 1, 1/2, 1//3, -1: from the last point); normals, textures, groups and materials are
/// passed over. Corners are checked here and by the parsers below, so that each fault has its line.
/// @error BadFormat, NotFinite with line and column.
base::Result<mesh::PolygonMesh> parse_obj(std::string_view text, const std::string& file);
base::Result<mesh::PolygonMesh> parse_off(std::string_view text, const std::string& file);

enum class PolygonFormat { Obj, Off, Ply };
/// With every digit: the parsers give the same mesh back.
/// @param groups  of OBJ: the names of the groups that each face is in, with blanks between; none if empty. The other
///                formats have no place for them.
std::string polygons_text(const mesh::PolygonMesh& mesh, PolygonFormat format,
                          std::span<const std::string> groups = {});

}  // namespace dobra::io::meshes
