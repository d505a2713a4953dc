#pragma once
// Surfaces in files, each a clean mesh (shared/surf/loft/joined.h): GOCAD TSurf with names and kinds, VTK with dips and
// azimuths, and every format of meshes in space, with a region (OBJ: a group) for each surface.

#include <string>

#include "recon/space/surfaces.h"

namespace recon::space {

/// The endings that can be written, each with its dot.
std::vector<std::string> surface_endings();

/// @error BadUsage naming the endings; asked before long work
base::Result<void> check_surface_ending(const std::string& path);

/// @error BadUsage; those of the writers
base::Result<void> write_surfaces(const std::string& path, const MadeSurfaces& surfaces);

}  // namespace recon::space
