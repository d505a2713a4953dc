#pragma once
// A mesh to and from the file format that the ending of its name says; one entry for commands and operations.

#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/meshes/file_elements.h"
#include "shared/io/meshes/inp.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::io::formats {

struct MeshContents {
  mesh::ElementMesh mesh;
  std::vector<std::string> remarks;  ///< What was left out, one line each.
  meshes::FileElements elements = {};
};

/// The endings that read_mesh knows, each with its dot.
std::vector<std::string> mesh_read_endings();
/// Whether read_mesh reads it.
bool is_mesh_ending(const std::string& ending);

/// By the ending. Elements come anticlockwise; a remark counts those that were turned.
/// @error UnknownFormat for another ending; those of the readers.
base::Result<MeshContents> read_mesh(const std::string& path);

/// Elements that ran against most others of their region (an only element of its region: of the mesh) in the file, each
/// with its number there and its place. A region that is clockwise as a whole is none: other programs allow that, and a
/// remark of read_mesh tells it.
std::vector<base::Error> inverted_elements(const MeshContents& contents);

/// The endings that write_mesh knows, each with its dot.
const std::vector<std::string>& mesh_endings();

/// @error BadUsage naming the endings if this is none of them; to be asked before a long computation.
base::Result<void> check_mesh_ending(const std::string& path);

/// .vtu .msh (4.1) .msh2 (2.2) .inp .bdf .nas (large field) .nf; .node and .ele (both are written, whichever is named);
/// .poly: the lines of the geometry (mesh_polygons.h); .obj .ply .off: the corners as polygons, .stl as triangles,
/// without sets.
/// @error BadUsage for another ending; those of the writers.
/// @param element  of .inp, which alone says what kind of plane elements they are.
base::Result<void> write_mesh(const std::string& path, const mesh::ElementMesh& mesh, meshes::InpElement element);

/// Puts a comment at the head of a mesh file, where its format has comments (.vtu .msh .inp .bdf .node .ele .poly
/// .obj).
/// @error those of read_text and write_text.
base::Result<void> add_note(const std::string& path, const std::string& note);

/// What write_mesh leaves out or renames for the format of that ending, one line each, for the user.
std::vector<std::string> losses(const std::string& path, const mesh::ElementMesh& mesh);

}  // namespace dobra::io::formats
