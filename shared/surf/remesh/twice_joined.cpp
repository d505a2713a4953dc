#include "shared/surf/remesh/twice_joined.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace dobra::surf::remesh {

using dobra::mesh::Corners;
using dobra::mesh::NodeId;

namespace {

using Side = std::pair<std::size_t, std::size_t>;

/// A side of a chart, by the numbers of its points, the lesser first.
struct ChartSide {
  std::size_t face = 0;
  Side ends;
  friend auto operator<=>(const ChartSide&, const ChartSide&) = default;
};

/// The triangles at a side get a node in its middle.
void halve(mesh::FaceMesh& face, Side side, const Surface& surface) {
  auto& chart = face.chart;
  const NodeId middle(chart.points.size());
  chart.points.push_back(geom::midpoint(chart.points[side.first], chart.points[side.second]));
  face.at.push_back(surface.at(chart.points.back()));
  const std::size_t count = chart.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Corners c = chart.triangles[t];
      if (Side(std::minmax(c[i].index(), c[(i + 1) % 3].index())) != side) continue;
      chart.triangles[t][(i + 1) % 3] = middle;
      Corners other = c;
      other[i] = middle;
      chart.triangles.push_back(other);
      if (t < chart.regions.size()) chart.regions.push_back(chart.regions[t]);
      break;
    }
  }
}

}  // namespace

void part_twice_joined(std::vector<mesh::FaceMesh>& faces, const mesh::Division& division,
                       const std::vector<trim::TrimmedSurface>& surfaces) {
  std::vector<std::size_t> own{division.nodes};  // of a face: the number of its first node that no other has
  for (const mesh::FaceMesh& face : faces) own.push_back(own.back() + face.chart.points.size());
  const auto nodes_of = [&](std::size_t face, Side side) {
    const auto node = [&](std::size_t point) {
      const auto& given = division.faces[face].node;
      return point < given.size() ? given[point] : own[face] + point;
    };
    return Side(std::minmax(node(side.first), node(side.second)));
  };
  std::set<Side> lines;  // between nodes
  std::set<ChartSide> on_lines;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const auto& edge : division.faces[f].chart.edges) {
      const Side ends = std::minmax(edge.nodes[0].index(), edge.nodes[1].index());
      on_lines.insert({f, ends});
      lines.insert(nodes_of(f, ends));
    }
  }
  std::map<Side, std::set<ChartSide>> inside;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::size_t given = division.faces[f].node.size();
    for (const Corners& c : faces[f].chart.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Side ends = std::minmax(c[i].index(), c[(i + 1) % 3].index());
        if (ends.first >= given || on_lines.contains({f, ends})) continue;
        inside[nodes_of(f, ends)].insert({f, ends});
      }
    }
  }
  for (const auto& [nodes, sides] : inside) {
    if (sides.size() == 1 && nodes.first != nodes.second && !lines.contains(nodes)) continue;
    for (const ChartSide& side : sides) halve(faces[side.face], side.ends, surfaces[side.face].surface);
  }
}

}  // namespace dobra::surf::remesh
