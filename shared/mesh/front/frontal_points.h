#pragma once
// Places the interior points of a mesh so that its triangles come out nearly equilateral and of the size wanted:
// a Delaunay triangulation is kept at all times, and points are put where an advancing front would put them: on the
// perpendicular through the middle of a side of the front, at the distance that gives the triangle the wanted
// circumradius. The front is the border between triangles that are small enough and those that are not. Marked sides
// are never split and points keep clear of them. Method: frontal Delaunay [rebay1993]. Used by triangulate.h.

#include "shared/mesh/front/fill_engine.h"

namespace dobra::mesh::front {

/// Inserts points into the cells with region >= 0 of `kernel`, which stays constrained Delaunay at every step.
/// @cost O(n log n); ends because no two points come nearer than least_spacing * h.
std::unique_ptr<FillEngine> frontal_points(delaunay::DelaunayKernel& kernel, const sizing::SizeField& field,
                                           const FrontalOptions& options);

}  // namespace dobra::mesh::front
