#pragma once
// The third coordinate of meshes on surfaces, beside a mesh::ElementMesh that holds x and y of its nodes.

#include <cstddef>
#include <span>

namespace dobra::io::meshes {

/// z of the nodes, m, one a node; empty: all are 0.
using Heights = std::span<const double>;

constexpr double height(Heights heights, std::size_t node) { return heights.empty() ? 0.0 : heights[node]; }

}  // namespace dobra::io::meshes
