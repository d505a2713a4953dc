#pragma once
// How well a mesh of a face follows its sizes.

#include "shared/mesh/mesh_check.h"
#include "shared/surf/mesh/chart_mesher.h"

namespace dobra::support {

/// Part of the edges that are 0.7 to 1.4 times as long in space as the size in their middle. @pre the mesher is done
inline double part_in_size(const surf::mesh::ChartMesher& mesher, const surf::mesh::FaceMesh& face) {
  constexpr double shortest = 0.7, longest = 1.4;
  std::size_t edges = 0, in_size = 0;
  for (const auto& edge : mesh::all_edges(face.chart)) {
    const auto a = edge[0].index(), b = edge[1].index();
    const double ratio = geom::distance(face.at[a], face.at[b]) /
                         mesher.size_at(geom::midpoint(face.chart.points[a], face.chart.points[b]));
    ++edges;
    if (ratio >= shortest && ratio <= longest) ++in_size;
  }
  return static_cast<double>(in_size) / static_cast<double>(edges);
}

}  // namespace dobra::support
