#pragma once
// Curves that two surfaces share as edges in both charts. Where the chain of an intersection has points, a spline gives
// the first guess between them, and Newton's rule on both surfaces the point itself, each time it is asked for. Page:
// docs/algorithms/trimming.md.

#include <span>
#include <string>
#include <vector>

#include "shared/surf/intersect.h"
#include "shared/surf/trim/trimmed_surface.h"

namespace dobra::surf::trim {

/// A piece of a shared curve without seams, poles and corners inside. All three curves have one parameter (about the
/// length in space, from 0), so that one t is one point of both surfaces, to 1e-10 of the smaller surface's size.
struct CommonEdge {
  ChartEdge first, second;  ///< In the charts of both; their ends on borders have the border's parameter exactly.
  Curve in_space;
};

struct CommonEdgeOptions {
  std::string name = {};     ///< Of all edges.
  SharedCurveId number = 0;  ///< Of the first piece; the others follow.
  double residual = 1e-10;   ///< Most that both surfaces may be apart on the curve, of the smaller one's size.
};

/// The pieces of a shared curve, in its order; the end of one and the beginning of the next are one place in space. A
/// closed curve without a seam is one piece that ends where it begins.
/// @error CannotMesh with the place, where the surfaces are apart by more than the residual between points of the
/// chain:
///        they touch there, or nearly so.
base::Result<std::vector<CommonEdge>> common_edges(const Surface& first, const Surface& second,
                                                   const SharedCurve& curve, const CommonEdgeOptions& options = {});

/// Of all curves that two surfaces share; numbers go on from curve to curve. @error as intersect_surfaces and above.
base::Result<std::vector<CommonEdge>> common_edges(const Surface& first, const Surface& second,
                                                   const CommonEdgeOptions& options = {});

/// The edges in which a plane cuts a surface. @error as intersect_plane and above.
base::Result<std::vector<ChartEdge>> plane_edges(const Surface& surface, geom::Point3 on_plane, geom::Vector3 normal,
                                                 const CommonEdgeOptions& options = {});

}  // namespace dobra::surf::trim
