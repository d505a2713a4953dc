#pragma once
// The colour of a face under the light, and the normals that it goes by. Drawers use the same formula: a face turned to
// the viewer has `ambient` of its colour, and the rest by the cosine between its normal and the light (Lambert).
// Source: [foley1990graphics].

#include "shared/scene/space/picture.h"

namespace dobra::scene::space {

/// The unit normal of a triangle as it is drawn, turned to the viewer: to the right, upwards, towards the viewer.
/// Straight towards the viewer for a triangle without area.
geom::Vector3 normal_to_viewer(const Frame& frame, const std::array<geom::Point3, 3>& corners);

/// @param normal  of normal_to_viewer
Color shaded(const Color& color, geom::Vector3 normal, const Light& light);

/// The colour of a triangle before the light falls on it; of values at points that of their mean.
Color color_of(const Surface& surface, std::size_t triangle, const Style& style);

}  // namespace dobra::scene::space
