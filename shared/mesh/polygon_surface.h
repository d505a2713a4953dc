#pragma once
// A polygon mesh looked at as a surface: how large it is, how good its faces are, how many borders it has, and the
// faces that no surface has: without area, or given twice. What check() (polygon_mesh.h) finds comes first.
// Page: docs/algorithms/polygon_mesh.md. Source: [foley1990graphics] 11.1 for the checks; alpha as in quality.h.

#include <cstddef>
#include <string>
#include <vector>

#include "shared/mesh/polygon_mesh.h"

namespace dobra::mesh {

struct PolygonSurface {
  /// Something that is wrong, in a line with 0-based indices.
  struct Fault {
    std::string message;
    geom::Point3 place;  ///< The middle of the points that are meant.
  };
  std::vector<Fault> faults;      ///< Those of check(), then faces without area, then faces given twice.
  double area = 0.0;              ///< Of all faces, by Newell's vector, m2.
  std::size_t triangles = 0;      ///< Faces of three corners.
  double alpha_min = 1.0;         ///< Least alpha of the triangles; 1 without any.
  geom::Point3 worst;             ///< The middle of that triangle.
  std::size_t parts = 0;          ///< Faces that hang together over edges.
  std::size_t open_edges = 0;     ///< Edges of one face.
  std::size_t borders = 0;        ///< Of them, those that hang together over points.
  std::size_t shared_places = 0;  ///< Points at the place of an earlier one, as at a crack.
};

/// @param thin  a face is without area whose area is below this part of its longest side squared.
/// @cost O(n log n)
PolygonSurface surface_of(const PolygonMesh& mesh, Closedness closedness, double thin = 1e-12);

}  // namespace dobra::mesh
