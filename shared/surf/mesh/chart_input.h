#pragma once
// What a mesher of one face is given: its surface, and points and edges in its chart that stand already. What comes
// back is a mesh::TriangleMesh in the chart, whose first points are the ones given.

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "shared/mesh/delaunay/mesh_input.h"
#include "shared/surf/surface.h"

namespace dobra::surf::mesh {

struct ChartInput {
  Surface surface;
  /// In the chart: loops as boundary edges, lines inside as constraints and interfaces, points, seeds of regions. Sizes
  /// asked for are lengths in space, m.
  dobra::mesh::delaunay::MeshInput chart;
  /// One a point of `chart`: where it is in space, the same for points that are one node (on both sides of a seam, on
  /// edges that faces share), though surfaces may differ there by the tolerance of a file.
  std::vector<geom::Point3> at;
  /// One a point of `chart`: its number in the mesh of all faces; points of one number are one node.
  std::vector<std::uint32_t> node;
};

/// Sizes wanted on a surface: the least of all counts.
struct SizeOptions {
  double largest = 0.0;  ///< L: no side longer, m; 0 takes a twentieth of the diagonal of the face.
  double turn = 15.0;    ///< A: most that the normal turns along a side, degrees; 0 does not ask.
  double chord = 0.0;    ///< Most that a side (a triangle) may be off the surface, m; 0 does not ask.
  double growth = 1.17;  ///< Greatest ratio of the sizes of neighbouring elements, > 1.
  double narrow = 1.0;   ///< Elements across narrow places; 0: sides as long as elsewhere.
  double least = 0.0;    ///< No size below, m; 0: none.
  /// Of a graph: most of a side times the geodesic curvature of straight lines of the chart there. A side is an eighth
  /// of its product with that off to the side in its middle; a triangle over it is 0.87 sides high.
  double sideways = 2.5;
  std::size_t most_cells = 2'000'000;  ///< Of the tree of sizes; more end in TooManyElements.
  /// Size wanted at a place of the chart and in space, m; where it is no positive number it asks for nothing.
  std::function<double(geom::Point uv, geom::Point3 at)> wanted = {};

  [[nodiscard]] double wanted_at(geom::Point uv, geom::Point3 at) const {
    const double size = wanted ? wanted(uv, at) : 0.0;
    return size > 0.0 ? size : std::numeric_limits<double>::infinity();
  }
};

}  // namespace dobra::surf::mesh
