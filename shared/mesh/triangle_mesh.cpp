#include "shared/mesh/triangle_mesh.h"

#include <algorithm>

namespace dobra::mesh {

namespace {

/// Kahan-Neumaier sum.
class Sum {
 public:
  void add(double value) {
    const double total = total_ + value;
    rest_ += std::abs(total_) >= std::abs(value) ? (total_ - total) + value : (value - total) + total_;
    total_ = total;
  }
  [[nodiscard]] double value() const { return total_ + rest_; }

 private:
  double total_ = 0.0;
  double rest_ = 0.0;
};

}  // namespace

double area(const TriangleMesh& mesh, TriangleId triangle) {
  const Corners& corner = mesh.corners(triangle);
  const geom::Point a = mesh.point(corner[0]);
  return 0.5 * geom::cross(mesh.point(corner[1]) - a, mesh.point(corner[2]) - a);
}

double area(const TriangleMesh& mesh) {
  Sum sum;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) sum.add(area(mesh, TriangleId(t)));
  return sum.value();
}

NodeStars stars_of(const TriangleMesh& mesh) {
  NodeStars stars;
  stars.first.assign(mesh.points.size() + 1, 0);
  for (const Corners& corners : mesh.triangles) {
    for (const NodeId node : corners) ++stars.first[node.index() + 1];
  }
  for (std::size_t n = 0; n < mesh.points.size(); ++n) stars.first[n + 1] += stars.first[n];
  stars.triangles.resize(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next(stars.first.begin(), stars.first.end() - 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const NodeId node : mesh.triangles[t]) stars.triangles[next[node.index()]++] = TriangleId(t);
  }
  return stars;
}

std::vector<std::array<TriangleId, 3>> neighbours_of(const TriangleMesh& mesh) {
  std::vector<std::array<TriangleId, 3>> neighbours(mesh.triangles.size());
  const NodeStars stars = stars_of(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t side = 0; side < 3; ++side) {
      const NodeId from = mesh.triangles[t][side];
      const NodeId to = mesh.triangles[t][(side + 1) % 3];
      for (std::uint32_t k = stars.first[to.index()]; k < stars.first[to.index() + 1]; ++k) {
        const Corners& other = mesh.corners(stars.triangles[k]);
        const auto at = static_cast<std::size_t>(std::find(other.begin(), other.end(), to) - other.begin());
        if (other[(at + 1) % 3] == from) neighbours[t][side] = stars.triangles[k];
      }
    }
  }
  return neighbours;
}

std::vector<Edge> boundary_edges(const TriangleMesh& mesh) {
  const auto neighbours = neighbours_of(mesh);
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t side = 0; side < 3; ++side) {
      if (neighbours[t][side].valid()) continue;
      edges.push_back({mesh.triangles[t][side], mesh.triangles[t][(side + 1) % 3]});
    }
  }
  return edges;
}

std::vector<Edge> all_edges(const TriangleMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const Corners& corner : mesh.triangles) {
    for (std::size_t side = 0; side < 3; ++side) {
      edges.push_back({std::min(corner[side], corner[(side + 1) % 3]), std::max(corner[side], corner[(side + 1) % 3])});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<std::uint8_t> fixed_nodes(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> fixed(mesh.points.size(), 0);
  const auto fix = [&](NodeId node) { fixed[node.index()] = 1; };
  for (const Edge& edge : boundary_edges(mesh)) std::for_each(edge.begin(), edge.end(), fix);
  for (const auto* sets : {&mesh.boundary_sets, &mesh.constraint_sets}) {
    for (const auto& [name, edges] : *sets) {
      for (const Edge& edge : edges) std::for_each(edge.begin(), edge.end(), fix);
    }
  }
  for (const auto& [name, nodes] : mesh.node_sets) std::for_each(nodes.begin(), nodes.end(), fix);
  return fixed;
}

}  // namespace dobra::mesh
