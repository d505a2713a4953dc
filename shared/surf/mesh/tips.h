#pragma once
// The tips of a face: points inside it at which the normals of the surface are many, as at the apex of a cone.
// Equilateral triangles do not fit there: a slender cone has room for one or two round its tip, and no turn of the
// normals is small. So a wheel of triangles is given before the front starts: spokes from the tip to a rim at equal
// angles of the developed surface. Page: docs/algorithms/surface_front.md.

#include <vector>

#include "shared/geom/point3.h"
#include "shared/surf/mesh/chart_input.h"

namespace dobra::surf::mesh {

struct Tip {
  geom::Point3 at;    ///< m.
  double size = 0.0;  ///< Wanted there, m.
};

struct Tips {
  ChartInput input;  ///< With the points and constraints of the wheels behind those given.
  std::vector<Tip> tips;
};

/// The part of the largest size within which sizes near a tip are those at that distance: its curvature has no bound.
inline constexpr double tip_seen = 0.01;
/// By how much sizes grow a metre of way from a tip: no row of the front is left to the gaps.
inline constexpr double tip_growth = 0.15;

/// Whether a corner of a face is the tip of a sector: the pole of the chart of an opened face (trim/open.h).
bool is_corner_tip(const Surface& surface, geom::Point at);

/// The way from a tip to the first node of a seam that ends there: so long that its sides and the ring of triangles
/// round the tip are as long as the size there, m.
/// @param half_angle  of the cone that the surface is like there
double first_way_from_tip(double half_angle, double size);

/// Of points that belong to no edge, and of the ends of seams: there both sides end in one node, and the wheel fills
/// the sector between them as far as that. Other tips of sectors have no wheel, only a size. A wheel has sides as long
/// as the sizes wanted at the tip, and is smaller where a border is near; it is left out where the surface has no
/// places round the tip.
/// @param largest  the largest size wanted, m
/// @cost  a hundred points of the surface a tip, and O(n) in the edges of the input
Tips with_wheels(const ChartInput& input, const SizeOptions& sizes, double largest);

}  // namespace dobra::surf::mesh
