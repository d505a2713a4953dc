#pragma once
// The mesh step of a model of surfaces: the parameters of the plane one, as far as they mean something there.

#include "quebra/meshing/meshing.h"
#include "quebra/model/model.h"

namespace quebra::surfaces {

/// Adds a mesh of the model's surfaces. @pre model.surfaces
/// @error NotSupported: engine delaunay, and what is of plane domains (background, rosettes, stop_after); those of
///        mesh_surfaces.
dobra::base::Result<model::Model> add_surface_mesh(const model::Model& model, const meshing::MeshParams& params,
                                                   const dobra::scenario::Context& context,
                                                   const dobra::base::Progress& progress);

}  // namespace quebra::surfaces
