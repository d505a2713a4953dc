#pragma once
// The mesh size wanted at every point: the quadtree's sizes made smooth. Each corner of a leaf carries a size; in a
// leaf the size is interpolated bilinearly. Corners of the leaves that input edges and size requests fall into start
// with the size asked; from there sizes spread over the tree, growing by at most (growth - 1) a unit of length, up to a
// largest size. So h(x) = min over everything asked of (size + (growth - 1) * distance), to the accuracy of the tree.
// Page: docs/algorithms/size_field.md. Source: [borouchaki1998] for the growth bound, [miranda1999mesh] for the tree.

#include <array>
#include <span>
#include <vector>

#include "shared/base/result.h"
#include "shared/mesh/mesh_input.h"
#include "shared/mesh/quadtree.h"

namespace dobra::mesh {

struct SizeFieldOptions {
  double growth = 1.3;    ///< Greatest ratio of the sizes of neighbouring elements, > 1.
  double max_size = 0.0;  ///< Upper bound, m; 0 takes the longest input edge.
  QuadtreeOptions quadtree = {};
};

class SizeField {
 public:
  /// @error InvalidOption with the option's name; errors of Quadtree::build.  @cost O(c log c) for c cells
  static base::Result<SizeField> build(std::span<const SizedEdge> edges, std::span<const SizeRequest> requests,
                                       const SizeFieldOptions& options = {});

  /// Size wanted at p, m; > 0.  @cost the depth of the tree.
  [[nodiscard]] double size_at(geom::Point p) const;
  [[nodiscard]] const Quadtree& quadtree() const { return tree_; }
  /// Sizes at the corners of a leaf: lower left, lower right, upper left, upper right.
  [[nodiscard]] std::array<double, 4> corner_sizes(QuadCellId leaf) const;
  /// About how many triangles fill the tree's square at these sizes: to refuse an impossible request in time.
  [[nodiscard]] double estimated_triangles() const;

 private:
  explicit SizeField(Quadtree tree) : tree_(std::move(tree)) {}
  void number_corners();
  void spread(double slope);

  Quadtree tree_;
  std::vector<std::array<std::uint32_t, 4>> corners_;  ///< One a cell; meaningful for leaves.
  std::vector<geom::Point> corner_points_;
  std::vector<double> sizes_;  ///< One a corner.
};

}  // namespace dobra::mesh
