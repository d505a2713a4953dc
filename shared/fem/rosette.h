#pragma once
// Rosettes of quarter-point triangles round crack tips: where the mesher must put nodes, and the shift of the mid-side
// nodes once the mesh is quadratic. Page: docs/algorithms/crack.md. Source: [barsoum1976], [henshell1975].

#include <vector>

#include "shared/base/result.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::fem {

struct RosetteOptions {
  int sectors = 16;     ///< Of the full circle, even and at least 6; below 12 the intensity factors lose digits.
  double radius = 0.0;  ///< Of the quarter-point elements, m, > 0; a/20 to a/50 of the crack.
  int rings = 3;        ///< Rings of elements, the quarter-point ones included, >= 1.
  double growth = 1.0;  ///< Thickness of a ring to that of the one inside it.
};

/// Points by rings from the inside: ring k has sectors + 1 points, from the crack (angle -pi) anticlockwise back to the
/// crack (pi, the same point): point sectors / 2 is straight ahead.
struct Rosette {
  geom::Point tip;
  std::vector<std::vector<geom::Point>> rings;
  [[nodiscard]] double outer_radius() const { return distance(tip, rings.back().front()); }
};
/// @param ahead  unit; where the crack points.
/// @error InvalidOption
base::Result<Rosette> make_rosette(geom::Point tip, geom::Vector ahead, const RosetteOptions& options);

/// Moves the mid-side nodes of the sides that end in a crack tip to a quarter of the side from the tip.
/// @return how many nodes were moved.
/// @error  BadCrack with the place: an element at a tip is not quadratic, or two tips share a side.
base::Result<std::size_t> set_quarter_points(mesh::ElementMesh& mesh);

}  // namespace dobra::fem
