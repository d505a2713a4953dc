#pragma once
// What fills one face. Internal to mesh_surfaces.

#include "quebra/surfaces/mesh_surfaces.h"
#include "shared/surf/mesh/assemble.h"

namespace quebra::surfaces {

struct FilledFace {
  dobra::surf::mesh::FaceMesh mesh;
  std::vector<dobra::surf::mesh::Finding> findings;
};

/// @error those of the engines
dobra::base::Result<FilledFace> mesh_face(const dobra::surf::mesh::ChartInput& input, const SurfaceMeshOptions& options,
                                          const dobra::base::Progress& progress);

}  // namespace quebra::surfaces
