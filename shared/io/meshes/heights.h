#pragma once
// The third coordinate of meshes on surfaces, beside a mesh::ElementMesh that holds x and y of its nodes.

#include <cstddef>
#include <cstdint>
#include <span>

namespace dobra::io::meshes {

/// z of the nodes, m, one a node; empty: all are 0.
using Heights = std::span<const double>;

/// Whether a reader takes a mesh whose nodes lie in no plane z = constant.
enum class Flatness : std::uint8_t {
  Plane,  ///< It is refused.
  Any     ///< It comes with its heights, its elements as they stand in the file: none is turned.
};

constexpr double height(Heights heights, std::size_t node) { return heights.empty() ? 0.0 : heights[node]; }

}  // namespace dobra::io::meshes
