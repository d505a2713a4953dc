#pragma once
// Surfaces that cut through each other or lie on each other without a common line, found on their triangles.

#include <span>

#include "quebra/model/surface_meshed.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace quebra::surfaces {

/// Tells "surfaces_cross" and "surfaces_overlap": how many pairs of faces, and the first with both names and a place.
/// Two faces cross where triangles of theirs do, exactly, and deeper than these are off their surfaces, which stand at
/// such an angle there too, or where the
/// surface over one of them has places on both sides of the other: faces that only touch, such as pipes laid against
/// each other, do not. They overlap where triangles lie over each other and their
/// surfaces, at three places of what both cover, are nearer than a hundred thousandth of the smaller one's diagonal and
/// bend alike: faces that touch along a line do not. A face that cuts through itself is told the same way: by triangles
/// without a common corner, where the surface over one has places on both sides of the surface over the other.
/// @param charts  the surfaces of the mesh; owner: of which face of the set each of them is
/// @cost  O((n + pairs of triangles whose boxes, grown by what they are off, overlap) log n)
void doubt_crossings(model::SurfaceMeshed& meshed, const model::SurfaceSet& set,
                     std::span<const dobra::surf::trim::TrimmedSurface> charts, std::span<const std::size_t> owner);

}  // namespace quebra::surfaces
