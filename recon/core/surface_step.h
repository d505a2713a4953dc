#pragma once
// The operation `surface`.

#include "recon/model/model.h"
#include "recon/space/surfaces.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// Surfaces through the sections of the document. @error CannotRestore: it has one section, not several in space; those
/// of make_surfaces()
base::Result<model::Model> run_surface(const model::Model& model, const space::SurfaceParams& params,
                                       const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities: surfaces; surface.NAME.area, .dip_mean, .pieces, .greatest_mistie; between.UPPER.LOWER.volume. Tables surfaces,
/// misties and volumes; the file surfaces.ts, and contours.geojson where they are asked for.
dobra::scenario::Operation surface_step();

/// What is to be known of the surfaces, a line each with its place.
std::vector<std::string> surface_remarks(const std::vector<dobra::surf::loft::Finding>& findings);

}  // namespace recon::core
