#pragma once
// Polygon meshes for tests.

#include "shared/mesh/polygon_mesh.h"

namespace dobra::mesh {

/// Outward faces; points are numbered as the faces come to them.
inline PolygonMesh unit_box(double size = 1.0, geom::Vector3 by = {}) {
  PolygonMesh mesh{{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                   {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 3, 5, 4}, {3, 2, 6, 5}, {2, 1, 7, 6}, {1, 0, 4, 7}}};
  for (geom::Point3& p : mesh.points) p = geom::Point3{} + size * (p - geom::Point3{}) + by;
  return mesh;
}

inline bool equal(const PolygonMesh& a, const PolygonMesh& b) { return a.points == b.points && a.faces == b.faces; }

}  // namespace dobra::mesh
