#pragma once
// Borders of faces that are one curve in space: told apart from those that only come near, cut where one ends inside
// another, and numbered, so that both sides get the same nodes. Page: docs/user/surfaces.md.

#include <vector>

#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

struct CommonBorderOptions {
  double tolerance = 1e-6;  ///< Borders nearer than this part of the diagonal of all faces are one.
};

/// Numbers the edges of loops that coincide (ChartEdge::shared), among them both sides of a seam; edges that end inside
/// another one cut it there. Tells "borders_joined": how many, and the widest gap where it is above 1e-9 of the
/// diagonal; and "borders_near" with the place: edges of two faces that run beside each other within 100 tolerances.
/// @cost O(edges^2) tests of boxes, and closest points for those that overlap.
void share_borders(std::vector<dobra::surf::trim::TrimmedSurface>& faces,
                   std::vector<dobra::surf::mesh::Finding>& findings, const CommonBorderOptions& options = {});

}  // namespace quebra::surfaces
