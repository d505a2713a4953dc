#include "shared/mesh/delaunay/mesh_input.h"

#include <map>

namespace dobra::mesh::delaunay {

void add_chain(MeshInput& input, const std::vector<geom::Point>& points, Closure closure, const InputSet& set) {
  std::map<geom::Point, NodeId> known;
  for (std::size_t i = 0; i < input.points.size(); ++i) known.emplace(input.points[i], NodeId(i));
  const auto number = static_cast<std::uint32_t>(input.sets.size());
  input.sets.push_back(set);
  std::vector<NodeId> nodes;
  for (const geom::Point p : points) {
    const auto [at, is_new] = known.emplace(p, NodeId(input.points.size()));
    if (is_new) input.points.push_back(p);
    nodes.push_back(at->second);
  }
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) input.edges.push_back({{nodes[i], nodes[i + 1]}, number});
  if (closure == Closure::Closed && nodes.size() > 2) input.edges.push_back({{nodes.back(), nodes.front()}, number});
}

}  // namespace dobra::mesh::delaunay
