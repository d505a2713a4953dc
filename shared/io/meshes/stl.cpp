// OpenMesh wants its readers and writers included before its meshes.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "shared/io/meshes/stl.h"

#include <sstream>

#include "shared/mesh/openmesh.h"

namespace dobra::io::meshes {

using base::Error;
using base::ErrorCode;
using base::Result;

namespace {

constexpr int all_digits = 17;
constexpr const char* as_text = ".stla";  // as OpenMesh calls it

}  // namespace

Result<std::string> stl_text(const mesh::TriangleMesh& mesh) {
  DOBRA_TRY(const mesh::OpenMeshTriangles triangles, to_openmesh(mesh));
  omlog().disable();  // It says on standard error which writer it takes.
  std::ostringstream out;
  if (!OpenMesh::IO::write_mesh(triangles, out, as_text, OpenMesh::IO::Options::Default, all_digits)) {
    return Error{ErrorCode::CannotMesh, "OpenMesh could not write the mesh"};
  }
  return out.str();
}

Result<mesh::TriangleMesh> parse_stl(std::string_view text, const std::string& file) {
  std::istringstream in{std::string(text)};
  mesh::OpenMeshTriangles triangles;
  OpenMesh::IO::Options options;
  if (!OpenMesh::IO::read_mesh(triangles, in, as_text, options)) {
    return Error{ErrorCode::CannotMesh, "OpenMesh could not read the mesh", base::Place{.file = file}};
  }
  auto mesh = mesh::from_openmesh(triangles);
  if (!mesh) return base::located(mesh.error(), {.file = file});
  return mesh;
}

}  // namespace dobra::io::meshes
