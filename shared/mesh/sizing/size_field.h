#pragma once
// The mesh size wanted at every point: the quadtree's sizes made smooth. Each corner of a leaf carries a size; inside a
// leaf the size is bilinear. Leaves that input edges and size requests fall into start with the size asked. From there
// sizes spread over the tree, growing by at most (growth - 1) a unit of length, up to a largest size. To the accuracy
// of the tree, h(x) is the least of size + (growth - 1) * distance over everything that asks for a size.
// Page: docs/algorithms/size_field.md. Source: [borouchaki1998] for the growth bound, [miranda1999mesh] for the tree.

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "shared/base/result.h"
#include "shared/geom/point3.h"
#include "shared/mesh/delaunay/mesh_input.h"
#include "shared/mesh/sizing/quadtree.h"

namespace dobra::mesh::sizing {

/// Sizes wanted everywhere: by a formula, or as another mesh has them.
struct SizeFunction {
  std::function<double(geom::Point)> at = {};           ///< m, > 0; infinite: no wish there. Empty: no function.
  std::function<bool(const geom::Box&)> concerns = {};  ///< False of a box in which sizes do not matter; empty: all do.
};

struct SizeFieldOptions {
  double growth = 1.3;         ///< Greatest ratio of the sizes of neighbouring elements, > 1.
  double max_size = 0.0;       ///< Upper bound, m; 0 takes the longest input edge.
  SizeFunction function = {};  ///< Followed to a tenth, as far as growth allows.
  /// Of the tree that carries the sizes: interior cells are not bounded, sizes are; and where growth is slow the cells
  /// may be larger than the edges, see `build`.
  QuadtreeOptions quadtree = {.interior = InteriorCells::Free};
};

class SizeField {
 public:
  /// @error InvalidOption with the option's name; errors of Quadtree::build.  @cost O(c log c) for c cells
  static base::Result<SizeField> build(std::span<const SizedEdge> edges,
                                       std::span<const delaunay::SizeRequest> requests,
                                       const SizeFieldOptions& options = {});

  /// For a surface in whose chart a tree stands: sizes at its corners that count in space. Each is infinite till asked.
  static SizeField on(Quadtree tree);
  /// Where the corners are in the tree's plane.
  [[nodiscard]] std::vector<geom::Point> corner_places() const;
  /// No size at a corner above this.
  void ask(std::uint32_t corner, double size) { sizes_[corner] = std::min(sizes_[corner], size); }
  /// Bounds all sizes, and their growth from corner to corner. @param at  where the corners are in space
  void spread(double slope, double largest, std::span<const geom::Point3> at);

  /// Size wanted at p, m; > 0.  @cost the depth of the tree.
  [[nodiscard]] double size_at(geom::Point p) const;
  [[nodiscard]] const Quadtree& quadtree() const { return tree_; }
  /// Sizes at the corners of a leaf: lower left, lower right, upper left, upper right.
  [[nodiscard]] std::array<double, 4> corner_sizes(QuadCellId leaf) const;
  /// The number of corners, and those of a leaf in the same order.
  [[nodiscard]] std::size_t corner_count() const { return sizes_.size(); }
  [[nodiscard]] const std::array<std::uint32_t, 4>& corners(QuadCellId leaf) const { return corners_[leaf.index()]; }
  /// About how many triangles fill the tree's square at these sizes: to refuse an impossible request in time.
  [[nodiscard]] double estimated_triangles() const;
  /// The same for the part of the square where `inside` holds, from some thousands of places.
  [[nodiscard]] double estimated_triangles(const std::function<bool(geom::Point)>& inside) const;

 private:
  explicit SizeField(Quadtree tree) : tree_(std::move(tree)) {}
  /// @return how many there are.
  std::uint32_t number_corners();
  void ask_function(const SizeFunction& function);
  template <class Grow>
  void spread(double largest, const Grow& grow);

  Quadtree tree_;
  std::vector<std::array<std::uint32_t, 4>> corners_;  ///< One a cell; meaningful for leaves.
  std::vector<double> sizes_;                          ///< One a corner.
};

/// Reads sizes one after the other at points near each other: remembers the last leaf.
class SizeSampler {
 public:
  explicit SizeSampler(const SizeField& field) : field_(field) {}
  /// As SizeField::size_at.
  double at(geom::Point p) {
    double u = (p.x - low_.x) * scale_;
    double v = (p.y - low_.y) * scale_;
    if (!(u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0)) {
      enter(p);
      u = std::clamp((p.x - low_.x) * scale_, 0.0, 1.0);
      v = std::clamp((p.y - low_.y) * scale_, 0.0, 1.0);
    }
    return (1.0 - v) * ((1.0 - u) * size_[0] + u * size_[1]) + v * ((1.0 - u) * size_[2] + u * size_[3]);
  }
  /// The leaf of the last point, its lower left corner, and 1 / its side.
  [[nodiscard]] QuadCellId leaf() const { return leaf_; }
  [[nodiscard]] geom::Point low() const { return low_; }
  [[nodiscard]] double scale() const { return scale_; }

 private:
  void enter(geom::Point p);

  const SizeField& field_;
  QuadCellId leaf_;
  geom::Point low_;
  double scale_ = std::numeric_limits<double>::quiet_NaN();  ///< Of no leaf: no point is inside.
  std::array<double, 4> size_{};
};

}  // namespace dobra::mesh::sizing
