#pragma once
// Triangle meshes as the surface formats that OpenMesh writes: OBJ, PLY, STL, OFF, all as text with every digit, z = 0.

#include <string>

#include "shared/base/result.h"
#include "shared/mesh/triangle_mesh.h"

namespace dobra::mesh {

enum class SurfaceFormat { Obj, Ply, Stl, Off };

/// Sets and regions are left behind. @error those of to_openmesh (openmesh.h); CannotMesh if OpenMesh fails.
base::Result<std::string> surface_text(const TriangleMesh& mesh, SurfaceFormat format);
/// @error CannotMesh if the text is not of that format, or a face has no area or is clockwise.
base::Result<TriangleMesh> surface_mesh(const std::string& text, SurfaceFormat format);

}  // namespace dobra::mesh
