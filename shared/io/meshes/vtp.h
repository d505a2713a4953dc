#pragma once
// VTK's XML polygon data (.vtp), written for ParaView and the like: polygons in space with numbers at their points and
// faces. ASCII, every digit. Source: [vtkfileformats].

#include <string>

#include "shared/base/result.h"
#include "shared/io/meshes/vtu.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::io::meshes {

/// @param fields  `at_elements`: at faces
/// @error NotFinite; InvalidOption: a field whose length is not components times the number of items.
base::Result<std::string> vtp_text(const mesh::PolygonMesh& mesh, const MeshFields& fields = {});

}  // namespace dobra::io::meshes
