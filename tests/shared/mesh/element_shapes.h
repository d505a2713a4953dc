#pragma once
// Element meshes that several tests share.

#include <cmath>
#include <string>
#include <vector>

#include "shared/mesh/element_mesh.h"

namespace dobra::mesh::test {

/// n x n squares of side 1 from the origin, each cut into two triangles; node (i, j) has number j (n + 1) + i.
inline ElementMesh triangle_grid(std::size_t n) {
  ElementMesh mesh;
  for (std::size_t j = 0; j <= n; ++j) {
    for (std::size_t i = 0; i <= n; ++i) mesh.points.push_back({static_cast<double>(i), static_cast<double>(j)});
  }
  const auto node = [&](std::size_t i, std::size_t j) { return NodeId(j * (n + 1) + i); };
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) {
      add_element(mesh, ElementType::T3, std::vector{node(i, j), node(i + 1, j), node(i + 1, j + 1)}, 0);
      add_element(mesh, ElementType::T3, std::vector{node(i, j), node(i + 1, j + 1), node(i, j + 1)}, 0);
    }
  }
  return mesh;
}

/// Adds the side set `name` of the sides on the left of the chain of points; each must be an edge of the mesh.
inline void add_chain(ElementMesh& mesh, const std::string& name, const std::vector<geom::Point>& chain) {
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      for (std::uint32_t i = 0; i < corner_count(mesh.types[e]); ++i) {
        const auto nodes = side_nodes(mesh, {ElementId(e), i});
        if (mesh.point(nodes[0]) == chain[k] && mesh.point(nodes[1]) == chain[k + 1]) {
          mesh.side_sets[name].push_back({ElementId(e), i});
        }
      }
    }
  }
}

}  // namespace dobra::mesh::test
