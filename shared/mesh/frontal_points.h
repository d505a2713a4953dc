#pragma once
// Places the interior points of a mesh so that its triangles come out nearly equilateral and of the size wanted:
// a Delaunay triangulation is kept at all times, and points are put where an advancing front would put them - on the
// perpendicular through the middle of a side of the front, at the distance that makes a triangle of the wanted
// circumradius. The front is the border between triangles that are small enough and those that are not. Marked sides
// are never split and points keep clear of them. Method: frontal Delaunay [rebay1993]. Used by triangulate.h.

#include <cstddef>

#include "shared/base/progress.h"
#include "shared/mesh/delaunay_kernel.h"
#include "shared/mesh/size_field.h"

namespace dobra::mesh {

struct FrontalOptions {
  double accept = 1.2;          ///< A triangle is small enough if its circumradius is below accept * h / sqrt(3).
  double least_spacing = 0.75;  ///< A point nearer than this * h to another is not inserted.
  double least_wall = 0.6;      ///< Nor one nearer than this * min(h, length) to a marked side of that length.
  std::size_t max_triangles = 20'000'000;  ///< More end in TooManyElements.
};

/// @error TooManyElements with advice if `triangles` are more than the options allow.
base::Result<void> check_limit(std::size_t triangles, const FrontalOptions& options);

/// Inserts points into the cells with region >= 0 of `kernel`.
/// @return number of points inserted.
/// @error  TooManyElements with advice; Cancelled.
/// @cost   O(n log n); ends because no two points come nearer than least_spacing * h.
base::Result<std::size_t> place_points(DelaunayKernel& kernel, const SizeField& field, const FrontalOptions& options,
                                       const base::Progress& progress);

}  // namespace dobra::mesh
