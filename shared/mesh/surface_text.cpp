// OpenMesh wants its readers and writers included before its meshes.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "shared/mesh/surface_text.h"

#include <sstream>

#include "shared/mesh/openmesh.h"

namespace dobra::mesh {

namespace {

constexpr int all_digits = 17;

const char* ending(SurfaceFormat format) {
  switch (format) {
    case SurfaceFormat::Obj:
      return ".obj";
    case SurfaceFormat::Ply:
      return ".ply";
    case SurfaceFormat::Stl:
      return ".stla";
    case SurfaceFormat::Off:
      return ".off";
  }
  return "";
}

}  // namespace

base::Result<std::string> surface_text(const TriangleMesh& mesh, SurfaceFormat format) {
  DOBRA_TRY(const OpenMeshTriangles triangles, to_openmesh(mesh));
  omlog().disable();  // It says on standard error which writer it takes.
  std::ostringstream out;
  if (!OpenMesh::IO::write_mesh(triangles, out, ending(format), OpenMesh::IO::Options::Default, all_digits)) {
    return base::Error{base::ErrorCode::CannotMesh, "OpenMesh could not write the mesh"};
  }
  return out.str();
}

base::Result<TriangleMesh> surface_mesh(const std::string& text, SurfaceFormat format) {
  std::istringstream in(text);
  OpenMeshTriangles triangles;
  OpenMesh::IO::Options options;
  if (!OpenMesh::IO::read_mesh(triangles, in, ending(format), options)) {
    return base::Error{base::ErrorCode::CannotMesh, "OpenMesh could not read the mesh"};
  }
  return from_openmesh(triangles);
}

}  // namespace dobra::mesh
