#pragma once
// The three representations of a polygon mesh and the ways between them: explicit polygons, each with the places of its
// corners; the list of points with faces by index (PolygonMesh); the list of edges with faces by edge. Page:
// docs/algorithms/polygon_mesh.md. Source: [foley1990graphics] 11.1.

#include <cstdint>
#include <vector>

#include "shared/base/result.h"
#include "shared/mesh/polygon_mesh.h"

namespace dobra::mesh {

/// Every polygon holds its corners' places, common ones once for each polygon.
using ExplicitPolygons = std::vector<std::vector<geom::Point3>>;

/// A face passes an edge, from its lower point or towards it.
struct EdgeUse {
  std::uint32_t edge = 0;
  bool backwards = false;
  friend bool operator==(const EdgeUse&, const EdgeUse&) = default;
};

struct EdgeListMesh {
  std::vector<geom::Point3> points;
  std::vector<PolygonEdge> edges;           ///< Each pair of ends once; names the faces that pass it.
  std::vector<std::vector<EdgeUse>> faces;  ///< In the order in which the face passes them.
};

/// @pre corners exist  @cost O(n)
ExplicitPolygons explicit_polygons(const PolygonMesh& mesh);

/// Points are numbered as they come; places that lie within `tolerance` of each other, directly or over others between,
/// are one point, the first of them.
/// @param tolerance  m; 0 for equal places.  @pre finite  @cost O(n log n) if few lie within the tolerance
PolygonMesh with_points(const ExplicitPolygons& polygons, double tolerance = 0.0);

/// @pre corners exist  @cost O(n log n)
EdgeListMesh with_edges(const PolygonMesh& mesh);

/// @error BadFormat: an edge or point that does not exist, a face whose edges do not follow each other, or an edge that
///        does not name the face (or names one that does not pass it).
base::Result<PolygonMesh> with_points(const EdgeListMesh& mesh);

/// Of each point the first one that lies at its place or within the tolerance, over others between.
/// @pre finite, tolerance >= 0  @cost as above
std::vector<std::uint32_t> merged_points(const std::vector<geom::Point3>& points, double tolerance);

}  // namespace dobra::mesh
