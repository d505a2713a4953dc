#pragma once
// The mesher of plane domains: sizes from the quadtree, a constrained Delaunay triangulation that holds every given
// edge, interior points placed for quality, flips and smoothing. Page: docs/algorithms/triangulate.md. Sources:
// [miranda1999mesh] (quadtree), [rebay1993] (points), [miranda2009surface] (smoothing, measure of quality).

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/mesh/frontal_points.h"
#include "shared/mesh/mesh_input.h"
#include "shared/mesh/size_field.h"
#include "shared/mesh/smooth.h"

namespace dobra::mesh {

struct MeshOptions {
  SizeFieldOptions sizes;                      ///< Growth 1.3; no element larger than the longest given edge.
  FrontalOptions points;                       ///< Where points may be put; limit on the number of triangles.
  SmoothOptions smoothing = {.enough = 0.92};  ///< Of each round.
  int rounds = 3;  ///< Rounds of flips and smoothing after the points are placed; 0 for none.
};

/// Meshes the inside of the boundary edges of `input`.
/// @return mesh with every boundary and constraint edge as given (cut only at input points that lie exactly on it), in
///         named sets; triangles anticlockwise; nodes: the input points in their order (equal ones once), then the
///         rest.
/// @error  of build_domain (planar_domain.h): NotFinite, InvalidOption, CannotMesh, SelfIntersection, OutsideDomain;
///         TooManyElements with advice; Cancelled. With the place where there is one.
/// @cost   O(n log n) in the number n of triangles.
base::Result<TriangleMesh> triangulate(const MeshInput& input, const MeshOptions& options = {},
                                       const base::Progress& progress = {});

/// The size field that `triangulate` would use: to draw it, or to ask sizes for something else.
/// @error as triangulate, before any point is placed.
base::Result<SizeField> size_field_of(const MeshInput& input, const SizeFieldOptions& options = {});

}  // namespace dobra::mesh
