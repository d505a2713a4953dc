#pragma once
// VTK's XML polygon data (.vtp), for ParaView and the like: polygons in space with numbers at their points and faces.
// Written as ASCII, every digit; read as that, and binary. Source: [vtkfileformats].

#include <string>
#include <string_view>

#include "shared/base/result.h"
#include "shared/io/meshes/vtu.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::io::meshes {

/// @param fields  `at_elements`: at faces
/// @error NotFinite; InvalidOption: a field whose length is not components times the number of items.
base::Result<std::string> vtp_text(const mesh::PolygonMesh& mesh, const MeshFields& fields = {});

/// The polygons of the file; its single points, lines and fields are passed over.
/// @error EmptyFile; BadFormat, NotFinite with line and column: an array that is missing or does not fit, counts that
///        the piece states otherwise; UnknownFormat: strips of triangles, several pieces,
///        data compressed by another library than zlib.
base::Result<mesh::PolygonMesh> parse_vtp(std::string_view text, const std::string& file);

}  // namespace dobra::io::meshes
