#pragma once
// Which element holds a point, and where in it: to read fields anywhere. Page: docs/algorithms/fem.md.

#include <optional>

#include "shared/fem/element.h"

namespace dobra::fem {

struct Located {
  std::size_t element = 0;
  Shape shape;  ///< At the point: a nodal field has the value sum of n[a] times that of node a.
};

/// The first element that holds the point (on a side both do), by its box and then by Newton's method on its map.
/// Nothing outside the mesh. @pre boxes = element_boxes(mesh)  @cost O(n), a comparison of boxes for nearly all
std::optional<Located> locate(const mesh::ElementMesh& mesh, std::span<const geom::Box> boxes, geom::Point at);

/// A box round every element, with room for sides that bulge.
std::vector<geom::Box> element_boxes(const mesh::ElementMesh& mesh);

}  // namespace dobra::fem
