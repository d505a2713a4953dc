#pragma once
// gmsh's mesh formats 4.1 and 2.2, ASCII: triangles and quadrilaterals of first and second order with their regions,
// and the named sets as physical groups. 4.1 stands on an entities section (points, chains of edges, regions) that
// bounds them consistently, so that gmsh takes the file as its own. Source: [gmsh-manual].
//
// Names in the file: a side set keeps its name as a physical curve, a node set as a physical point. A region is a
// physical surface: its name under its tag, or "region:TAG" ("region:TAG:NAME" for a tag that is not above 0).

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/meshes/file_elements.h"
#include "shared/io/meshes/heights.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::io::meshes {

struct MshContents {
  mesh::ElementMesh mesh;
  std::vector<std::string> remarks;  ///< What was left out, one line each.
  FileElements elements = {};
  std::vector<double> heights = {};  ///< z of the nodes, m, of a mesh in space; empty: it is plane.
};

enum class MshVersion { V22, V41 };

/// The text of a .msh with every digit. Node and element tags are the positions in the mesh, from 1.
/// Names stand in quotes on one line: a quote in a name becomes ', a line end a blank (msh_renamings says which).
/// @error NotFinite; CannotMesh: no elements.
base::Result<std::string> msh_text(const mesh::ElementMesh& mesh, MshVersion version = MshVersion::V41,
                                   Heights heights = {});
/// @error those of msh_text, CannotWrite
base::Result<void> write_msh(const std::string& path, const mesh::ElementMesh& mesh,
                             MshVersion version = MshVersion::V41);

/// The names of sets and regions that a .msh cannot hold, and what stands there instead.
std::map<std::string, std::string> msh_renamings(const mesh::ElementMesh& mesh);

/// A .msh of version 4.1 or 2.2, ASCII; ours or gmsh's. Nodes and elements come in the order of their tags, elements
/// anticlockwise. A surface outside physical groups gives region 0; lines outside are left out.
/// @error FileNotFound, NotAFile, CannotRead, EmptyFile; BadFormat, NotFinite with line and column; UnknownFormat:
///        another version, binary, other elements.
base::Result<MshContents> read_msh(const std::string& path);
base::Result<MshContents> parse_msh(std::string_view text, const std::string& file,
                                    Flatness flatness = Flatness::Plane);

}  // namespace dobra::io::meshes
