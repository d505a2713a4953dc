#pragma once
// Borders of faces that are one curve in space: told apart from those that only come near, cut where one ends inside
// another, and numbered, so that both sides get the same nodes. Page: docs/user/surfaces.md.

#include <vector>

#include "shared/base/result.h"
#include "shared/surf/mesh/surface_mesh.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

struct CommonBorderOptions {
  double tolerance = 1e-6;  ///< Borders nearer than this part of the diagonal of all faces are one.
};

/// Numbers the edges of loops that coincide (ChartEdge::shared), among them both sides of a seam, and lines inside a
/// face (cracks left out) along which another face ends; edges that end inside another one cut it there. Tells
/// "borders_joined": how many, and the widest gap where it is above 1e-9 of the diagonal; "borders_near" with the
/// place: edges of two faces that run beside each other within 100 tolerances; "border_not_joined": one that lies on
/// another face without a line there; "border_near_surface": one that ends beside another face, along a quarter of it
/// at least nearer than a thousandth of the smaller face, from which its own goes away.
/// @cost O(edges^2) tests of boxes, and closest points for those that overlap.
void share_borders(std::vector<dobra::surf::trim::TrimmedSurface>& faces,
                   std::vector<dobra::surf::mesh::Finding>& findings, const CommonBorderOptions& options = {});

/// Two faces that meet at a border, and no third one, follow it in opposite ways, so that they look the same way.
/// @error CannotMesh with the place and both names, where they do not.
dobra::base::Result<void> check_ways(const std::vector<dobra::surf::trim::TrimmedSurface>& faces);

}  // namespace quebra::surfaces
