#pragma once
// A mesh to and from the file format that the ending of its name says; one entry for commands and operations.

#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/formats/format.h"
#include "shared/io/meshes/inp.h"
#include "shared/io/meshes/vtu.h"
#include "shared/mesh/element_mesh.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::io::formats {

/// By the ending. Elements come anticlockwise; a remark counts those that were turned.
/// @error UnknownFormat naming the endings; those of the readers.
base::Result<MeshContents> read_mesh(const std::string& path);

/// The same of a mesh that may lie in space: then it has heights, and its elements stand as in the file.
/// Formats that hold elements in the plane alone are read as by read_mesh.
base::Result<MeshContents> read_mesh_in_space(const std::string& path);

struct MeshAndFields {
  mesh::ElementMesh mesh;
  meshes::MeshFields fields;
};

/// A mesh with its fields of numbers. @error UnknownFormat naming the endings; those of the readers.
base::Result<MeshAndFields> read_fields(const std::string& path);

/// Polygons in space as they stand. @error UnknownFormat naming the endings; those of the readers.
base::Result<mesh::PolygonMesh> read_polygons(const std::string& path);

struct PolygonsAndRemarks {
  mesh::PolygonMesh mesh;
  std::vector<Remark> remarks;  ///< On what is not as it stands in the file, such as another unit.
};
/// The same with what is to be said of them.
base::Result<PolygonsAndRemarks> read_polygons_told(const std::string& path);

/// Elements that ran against most others of their region (an only element of its region: of the mesh) in the file, each
/// with its number there and its place. A region that is clockwise as a whole is none: other programs allow that, and a
/// remark of read_mesh tells it.
std::vector<base::Error> inverted_elements(const MeshContents& contents);

/// @param use  WriteMesh, or WriteSpaceMesh for the mesh of a surface.
/// @error BadUsage naming the endings of meshes if it is none of them; to be asked before a long computation.
base::Result<void> check_mesh_ending(const std::string& path, Use use = Use::WriteMesh);

/// By the ending (docs/user/formats.md). .node and .ele are both written, whichever is named.
/// @error BadUsage for another ending; those of the writers.
/// @param element  of .inp, which alone says what kind of elements they are.
/// @param heights  of a mesh in space.
base::Result<void> write_mesh(const std::string& path, const mesh::ElementMesh& mesh, meshes::InpElement element,
                              meshes::Heights heights = {});

/// Puts a comment at the head of a mesh file, where its format has comments.
/// @error those of read_text and write_text.
base::Result<void> add_note(const std::string& path, const std::string& note);

/// What write_mesh leaves out or renames for the format of that ending, one line each, for the user.
std::vector<std::string> losses(const std::string& path, const mesh::ElementMesh& mesh);

}  // namespace dobra::io::formats
