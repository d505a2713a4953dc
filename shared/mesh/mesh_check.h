#pragma once
// Verification of a mesh: ids in range, every triangle anticlockwise (exact), every side shared by at most two
// triangles, Euler's relation. Run by tests, by the mesher's callers after an import, and by the command line on
// request.

#include <cstddef>

#include "shared/base/result.h"
#include "shared/mesh/triangle_mesh.h"

namespace dobra::mesh {

/// What Euler's relation relates. A node where the domain touches itself is counted once an umbrella of triangles.
struct TopologyCounts {
  std::size_t umbrellas = 0;  ///< Nodes, a pinched one counted once a fan of triangles.
  std::size_t edges = 0;      ///< Sides, each counted once.
  std::size_t triangles = 0;
  std::size_t boundary_edges = 0;
  std::size_t components = 0;    ///< Sets of triangles joined through sides.
  std::size_t loops = 0;         ///< Closed boundary contours, outer ones and holes.
  std::size_t unused_nodes = 0;  ///< Nodes of no triangle.

  /// Boundary loops that are holes.
  [[nodiscard]] std::size_t holes() const { return loops - components; }
  /// V - E + F = 2 C - L: true for every set of plane domains with holes.
  [[nodiscard]] bool euler_holds() const { return umbrellas + triangles + loops == edges + 2 * components; }
};

/// @pre the mesh passes `check` (ids in range, sides shared by at most two triangles).  @cost O(n)
TopologyCounts topology_of(const TriangleMesh& mesh);

/// @error CannotMesh naming the first triangle or edge that breaks a rule, with its place: node out of range or not
///        finite, triangle not anticlockwise, side used twice in one direction, region array of the wrong length,
///        set edge that is no edge of the mesh, Euler's relation.
/// @cost  O(n log n)
base::Result<void> check(const TriangleMesh& mesh);

}  // namespace dobra::mesh
