#pragma once
// Other meshers, for comparison in benchmarks only.

#include "shared/mesh/delaunay/mesh_input.h"

namespace bench {

struct Peer {
  double seconds = 0.0;  ///< Of processor time.
  double triangles = 0.0;
};

/// CGAL's Mesh_2 on the outline `input`: angles of at least 20.7 degrees (its default), sides up to 1.5 times the mean
/// side of the outline.
Peer cgal_mesh_2(const dobra::mesh::delaunay::MeshInput& input);

}  // namespace bench
