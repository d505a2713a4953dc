#pragma once
// The nearest place of a triangle mesh in space: a tree of boxes over its triangles. Built once, then only read.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "shared/geom/point3.h"

namespace dobra::surf::remesh {

/// The place of a triangle next to p. Source: [ericson2005], 5.1.5.
geom::Point3 nearest_on(geom::Point3 p, geom::Point3 a, geom::Point3 b, geom::Point3 c);

class TriangleTree {
 public:
  struct Nearest {
    std::uint32_t triangle = 0;
    double distance = 0.0;  ///< m.
    geom::Point3 at;
  };
  /// @pre outlives no points or triangles: both are copied  @cost O(n log n)
  TriangleTree(std::vector<geom::Point3> points, std::vector<std::array<std::uint32_t, 3>> triangles);
  /// Among equals one that depends on the mesh alone. @pre there is a triangle  @cost O(log n)
  [[nodiscard]] Nearest nearest(geom::Point3 p) const;

 private:
  struct Node {
    geom::Point3 low, high;
    std::uint32_t first = 0, count = 0;  ///< Triangles of a leaf; else the children are `first` and `first` + 1.
  };
  void build(std::uint32_t node, std::uint32_t from, std::uint32_t to);
  std::vector<geom::Point3> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace dobra::surf::remesh
