#pragma once
// Rosettes of quarter-point triangles round crack tips: rings of points whose outermost one bounds a hole for the
// mesher, the triangles that fill it, and the shift of the mid-side nodes once the mesh is quadratic.
// Page: docs/algorithms/crack.md. Source: [barsoum1976], [henshell1975].

#include <cstdint>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/mesh/element_mesh.h"

namespace dobra::fem::fracture {

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

/// Which end of its crack a tip is.
enum class CrackEnd : std::uint8_t { Start, End };

/// Fills the hole that the mesher left inside the outermost ring with the triangles of the rosette, and continues the
/// side set `crack` through it, to its tip: what open_lips then opens.
/// @param mesh    first order; the points of the outermost ring are nodes, its sides boundary sides.
/// @param region  tag of the new elements.
/// @error BadCrack with the place: a point of the ring is no node.
base::Result<void> fill_rosette(mesh::ElementMesh& mesh, const Rosette& rosette, const std::string& crack, CrackEnd end,
                                std::int32_t region);

/// Which half of a rosette lies in the material, if its tip lies on a straight boundary that is a line of symmetry:
/// left or right of the way ahead.
enum class RosetteHalf : std::uint8_t { Left, Right };
/// The points of the outermost ring that bound that half, from one end on the boundary to the other, anticlockwise.
std::vector<geom::Point> rim_of(const Rosette& rosette, RosetteHalf half);
/// Fills one half as fill_rosette fills a whole; its sides on the boundary go to the side sets `lip` and `ahead`.
/// @error BadCrack with the place: a point of the ring is no node.
base::Result<void> fill_half_rosette(mesh::ElementMesh& mesh, const Rosette& rosette, RosetteHalf half,
                                     const std::string& lip, const std::string& ahead, std::int32_t region);

/// Moves the mid-side nodes of the sides that end in a crack tip to a quarter of the side from the tip.
/// @return how many nodes were moved.
/// @error  BadCrack with the place: an element at a tip is not quadratic, or two tips share a side.
base::Result<std::size_t> set_quarter_points(mesh::ElementMesh& mesh);

}  // namespace dobra::fem::fracture
