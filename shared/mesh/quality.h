#pragma once
// How good the triangles of a mesh are: the shape measure alpha, the angles, and how gently the sizes change.
// Page: docs/algorithms/quality.md. Source: [miranda2009surface].

#include <array>
#include <cstddef>

#include "shared/base/angle.h"
#include "shared/geom/point3.h"
#include "shared/mesh/triangle_mesh.h"

namespace dobra::mesh {

/// alpha = 2 sqrt(3) |AB x AC| / (AB^2 + BC^2 + CA^2): 1 for the equilateral triangle, 0 for a flat one; negative when
/// the corners run clockwise. 0 if all three coincide.
double alpha(geom::Point a, geom::Point b, geom::Point c);
/// The same in space, where no triangle runs clockwise.
double alpha_in_space(geom::Point3 a, geom::Point3 b, geom::Point3 c);

/// Least and greatest angle of a triangle.
struct AngleRange {
  base::Angle least;
  base::Angle greatest;
};
AngleRange angles_of(geom::Point a, geom::Point b, geom::Point c);
/// The angles at a, b and c, radians.
std::array<double, 3> angles_in_space(geom::Point3 a, geom::Point3 b, geom::Point3 c);

struct MeshQuality {
  std::size_t nodes = 0;
  std::size_t triangles = 0;
  double area = 0.0;  ///< m2.
  double alpha_mean = 0.0;
  double alpha_90 = 0.0;  ///< Fraction of the triangles with alpha >= 0.90, 0..1.
  double alpha_min = 0.0;
  TriangleId worst;  ///< The triangle of alpha_min; none in an empty mesh.
  base::Angle angle_min;
  base::Angle angle_max;
  double gradation_p95 = 1.0;  ///< 95th percentile of the area ratio (>= 1) of triangles that share a side.
  double gradation_max = 1.0;
  std::array<std::size_t, 20> histogram{};  ///< Triangles by alpha, bins of 0.05 from 0; clockwise ones in the first.
};

/// @cost O(n)
MeshQuality quality_of(const TriangleMesh& mesh);

}  // namespace dobra::mesh
