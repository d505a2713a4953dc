#include "shared/io/mesh_sides.h"

#include <algorithm>

#include "shared/geom/predicates.h"

namespace dobra::io {

using mesh::Edge;
using mesh::TriangleId;
using mesh::TriangleMesh;

namespace {

std::uint64_t key_of(mesh::NodeId from, mesh::NodeId to) {
  return (static_cast<std::uint64_t>(from.index()) << 32U) | static_cast<std::uint64_t>(to.index());
}

}  // namespace

MeshSides::MeshSides(const TriangleMesh& mesh) {
  sides_.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const mesh::Corners& corners = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) sides_.emplace_back(key_of(corners[i], corners[(i + 1) % 3]), 3 * t + i);
  }
  std::sort(sides_.begin(), sides_.end());
}

std::optional<TriangleSide> MeshSides::left_of(const Edge& edge) const {
  const std::uint64_t key = key_of(edge[0], edge[1]);
  const auto found = std::lower_bound(sides_.begin(), sides_.end(), std::pair{key, std::size_t{0}});
  if (found == sides_.end() || found->first != key) return std::nullopt;
  return TriangleSide{TriangleId(found->second / 3), found->second % 3};
}

std::int32_t region_of(const TriangleMesh& mesh, TriangleId triangle) {
  return mesh.regions.empty() ? 0 : mesh.regions[triangle.index()];
}

void orient(TriangleMesh& mesh) {
  for (mesh::Corners& corners : mesh.triangles) {
    if (geom::orient2d(mesh.point(corners[0]), mesh.point(corners[1]), mesh.point(corners[2])) ==
        geom::Sign::Negative) {
      std::swap(corners[1], corners[2]);
    }
  }
  const MeshSides sides(mesh);
  for (auto set = mesh.boundary_sets.begin(); set != mesh.boundary_sets.end();) {
    bool internal = !set->second.empty();
    for (Edge& edge : set->second) {
      const bool left = sides.left_of(edge).has_value();
      const bool right = sides.left_of({edge[1], edge[0]}).has_value();
      if (right && !left) std::swap(edge[0], edge[1]);
      internal = internal && left && right;
    }
    if (!internal || mesh.constraint_sets.contains(set->first)) {
      ++set;
      continue;
    }
    mesh.constraint_sets.insert(mesh.boundary_sets.extract(set++));
  }
}

}  // namespace dobra::io
