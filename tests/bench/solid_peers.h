#pragma once
// Peers of solid_bench.

#include "shared/mesh/polygon_mesh.h"

namespace bench {

struct NefUnion {
  double seconds = 0.0;  ///< Of the union alone, without reading.
  std::size_t vertices = 0;
};

/// CGAL's Nef polyhedra, exact.  @pre closed, its faces plane
NefUnion cgal_nef_union(const dobra::mesh::PolygonMesh& a, const dobra::mesh::PolygonMesh& b);

}  // namespace bench
