#pragma once
// Borders and creases of an opened sheet, divided into sides of the new mesh. Internal to remesh.h.

#include <vector>

#include "shared/surf/mesh/chart_input.h"
#include "shared/surf/remesh/remesh.h"

namespace dobra::surf::remesh {

/// Points and edges of the chart, with the place in space and the number of the node of each point.
struct Network {
  dobra::mesh::delaunay::MeshInput chart;
  std::vector<geom::Point3> at;
  std::vector<std::uint32_t> node;
  std::uint32_t nodes = 0;
  std::size_t creases = 0;      ///< Lines kept.
  std::size_t cut_creases = 0;  ///< Of them, those that the cut runs along: these are kept whatever `crease` is.
};

/// Along each line between vertices that stay, as many sides as the sizes ask for, even by them. Both sides of a cut
/// get the same nodes.
/// @param sizes  one a point of the sheet before the cut, m
/// @param crease  degrees; 180: none are kept
Network divide_network(const Charted& charted, const std::vector<double>& sizes, double corner, double crease);

}  // namespace dobra::surf::remesh
