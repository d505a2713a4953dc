#pragma once
// What a mesh leaves out of its surfaces: peaks, ridges and steps of a graph that are narrower than its triangles.
// Page: docs/algorithms/surfaces.md.

#include <span>

#include "quebra/model/surface_meshed.h"
#include "shared/surf/mesh/chart_input.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

/// Adds a finding for each face of which the surface turns away from the triangles by more than twice the turn asked,
/// and 20 degrees at least, where it bends closely, with the place where it does so most.
/// @param surfaces  one a face of the mesh
void doubt_details(model::SurfaceMeshed& meshed, std::span<const dobra::surf::trim::TrimmedSurface> surfaces,
                   const dobra::surf::mesh::SizeOptions& sizes);

}  // namespace quebra::surfaces
