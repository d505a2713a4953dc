#pragma once
// What a mesh of surfaces that was made all the same is to be doubted for.

#include <span>
#include <vector>

#include "quebra/model/surface_meshed.h"
#include "shared/surf/measure.h"
#include "shared/surf/mesh/chart_input.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

/// An area of a surface that quadrature may have wrong by more than a thousandth.
void doubt_area(const dobra::surf::trim::TrimmedSurface& face, const dobra::surf::Measured& area,
                std::vector<dobra::surf::mesh::Finding>& findings);

/// An area off that of the surfaces, a flat triangle, parts that hang together in a node.
/// @param owner  of which face of the set each surface of the mesh is
/// @param areas  of the faces by quadrature, m2
void doubt_triangles(model::SurfaceMeshed& meshed, const model::SurfaceSet& set, std::span<const std::size_t> owner,
                     std::span<const double> areas);

/// Peaks, ridges and steps of graphs that are narrower than the triangles: a finding for each face of which the surface
/// turns away from the triangles by more than twice the turn asked, and 20 degrees at least, where it bends closely,
/// with the place where it does so most. Page: docs/algorithms/surfaces.md.
/// @param surfaces  one a face of the mesh
void doubt_details(model::SurfaceMeshed& meshed, std::span<const dobra::surf::trim::TrimmedSurface> surfaces,
                   const dobra::surf::mesh::SizeOptions& sizes);

/// Elements of second order whose sides bend so much that a corner looks against the surface.
/// @param surfaces  those that were meshed, in the order of elements.faces
void doubt_elements(model::SurfaceMeshed& meshed, std::span<const dobra::surf::trim::TrimmedSurface> surfaces);

}  // namespace quebra::surfaces
