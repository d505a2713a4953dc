#pragma once
// The network of loops and lines of all faces before it is divided: edges, where they are cut, and which of their cuts
// are one point of a chart or one node. Internal to division.h.

#include <map>
#include <optional>
#include <utility>

#include "shared/base/disjoint_sets.h"
#include "shared/surf/mesh/division.h"
#include "shared/surf/mesh/edge_in_space.h"

namespace dobra::surf::mesh {

/// A place on an edge that becomes a node, and its number among all.
struct Cut {
  double s = 0.0;
  std::uint32_t vertex = 0;
};

/// An edge of a loop or a line.
struct BorderEdge {
  std::uint32_t face = 0;
  EdgeInSpace space;
  std::optional<trim::ChartLine::Kind> line = std::nullopt;  ///< None: of a loop.
  std::string name = {};
  std::uint32_t loop = 0;      ///< Of its face, loops first, then lines.
  bool point = false;          ///< It is one point in space.
  double tolerance = 0.0;      ///< In space, m: what lies so near is on it.
  std::vector<Cut> cuts = {};  ///< Ascending once the network is made; the first at 0, the last at 1.
};

/// Edges of one curve, by their place among the edges; the first is the one that is divided.
using SharedGroup = std::vector<std::size_t>;

struct Border {
  std::vector<BorderEdge> edges;         ///< Face by face.
  std::vector<SharedGroup> groups;       ///< Of two edges and more.
  std::vector<std::size_t> vertex_edge;  ///< One a vertex: the edge that it was made on.
  std::vector<double> vertex_s;          ///< And where.
  /// One a vertex, once the network is made for those of point_of: its place where that is known to the last digit, as
  /// where a line of one u crosses one of one v.
  std::vector<std::optional<geom::Point>> exact;
  std::vector<std::size_t> point_of;  ///< One a vertex: the first vertex that is the same point of the chart.
  std::vector<std::size_t> node_of;   ///< The first vertex that is the same node; loops before lines.
  std::vector<std::vector<std::optional<std::size_t>>> on_edges;  ///< A face, a point asked for: its vertex, if it lies
                                                                  ///< on an edge.
  std::vector<Finding> findings;

  /// Whether an edge runs along the first of its group.
  [[nodiscard]] bool along(std::size_t edge, std::size_t first) const {
    return edges[edge].space.edge().against == edges[first].space.edge().against;
  }
  [[nodiscard]] geom::Point place(std::size_t vertex) const {
    return exact[vertex] ? *exact[vertex] : edges[vertex_edge[vertex]].space.place(vertex_s[vertex]);
  }
  [[nodiscard]] geom::Point3 at(std::size_t vertex) const {
    const EdgeInSpace& space = edges[vertex_edge[vertex]].space;
    return exact[vertex] ? space.surface().at(*exact[vertex]) : space.at(vertex_s[vertex]);
  }
};

/// @param corner  a break at which the tangent turns by more is a node, radians.
/// @error as divide
base::Result<Border> border_of(std::span<const trim::TrimmedSurface> surfaces, double closing, double corner);

}  // namespace dobra::surf::mesh
