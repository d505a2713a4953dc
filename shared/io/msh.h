#pragma once
// gmsh's mesh format 4.1, ASCII: triangles with their regions and the named sets as physical groups, on an entities
// section (points, chains of edges, regions) that bounds them consistently, so that gmsh takes the file as its own.
// Source: [gmsh-manual].
//
// Names in the file: a boundary set keeps its name as a physical curve, a constraint set becomes the physical curve
// "constraint:NAME", a node set a physical point, a region the physical surface "region:TAG".

#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/mesh/triangle_mesh.h"

namespace dobra::io {

struct MshContents {
  mesh::TriangleMesh mesh;
  std::vector<std::string> remarks;  ///< What was left out, one line each.
};

/// The text of a .msh with every digit. Node and element tags are the positions in the mesh, from 1.
/// @error NotFinite; CannotMesh: no triangles; InvalidOption: a name with a quote or a line end.
base::Result<std::string> msh_text(const mesh::TriangleMesh& mesh);
/// @error those of msh_text, CannotWrite
base::Result<void> write_msh(const std::string& path, const mesh::TriangleMesh& mesh);

/// A .msh of version 4.1, ASCII, with points, 2-node lines and 3-node triangles; ours or gmsh's. Nodes and triangles
/// come in the order of their tags, triangles anticlockwise, boundary edges with the domain on their left. A surface
/// without "region:TAG" gives its physical tag as region, or 0; lines outside physical groups are left out.
/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat, NotFinite with line and column; UnknownFormat:
///        another version, binary, other elements.
base::Result<MshContents> read_msh(const std::string& path);
base::Result<MshContents> parse_msh(std::string_view text, const std::string& file);

}  // namespace dobra::io
