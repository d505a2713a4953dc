#pragma once
// Which triangle has a given directed edge as a side; for the mesh formats that need surfaces or oriented boundaries.

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "shared/mesh/triangle_mesh.h"

namespace dobra::io {

/// A triangle and its side 0..2 (side i runs from corner i to corner i + 1).
struct TriangleSide {
  mesh::TriangleId triangle;
  std::size_t side = 0;
};

class MeshSides {
 public:
  /// @cost O(n log n) for n triangles.
  explicit MeshSides(const mesh::TriangleMesh& mesh);
  /// The triangle on the left of `edge`; the one of lowest id if the mesh is wrong and has several. O(log n).
  [[nodiscard]] std::optional<TriangleSide> left_of(const mesh::Edge& edge) const;

 private:
  std::vector<std::pair<std::uint64_t, std::size_t>> sides_;  // (from, to) -> 3 * triangle + side, ascending
};

/// The region of a triangle; 0 where the mesh names none.
std::int32_t region_of(const mesh::TriangleMesh& mesh, mesh::TriangleId triangle);

/// For readers: turns clockwise triangles, directs each edge of a boundary set so that the domain is on its left, and
/// moves the sets whose edges all have triangles on both sides to the constraint sets.
void orient(mesh::TriangleMesh& mesh);

}  // namespace dobra::io
