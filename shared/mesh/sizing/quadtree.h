#pragma once
// The background quadtree of the mesher: it only carries sizes. Four rules make it:
//   1. the root is the smallest square centred on the bounding box;
//   2. for every input edge of length l with midpoint m, the leaf with m is split while side * f >= l (f: refinement
//      factor); a midpoint on a cell line goes down both sides;
//   3. no cell is larger than the largest one that a boundary edge reached;
//   4. leaves that share a side differ by at most one level.
// Linear storage: cells in one array, the four children of a cell one after the other; integer coordinates on the grid
// of 2^30 x 2^30 finest cells, so that neighbours are found exactly.
// Page: docs/algorithms/quadtree.md. Source: [miranda1999mesh].

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "shared/base/id.h"
#include "shared/base/result.h"
#include "shared/geom/box.h"
#include "shared/geom/segment.h"

namespace dobra::mesh::sizing {

struct QuadCellTag {
  static constexpr const char* prefix = "q";
};
using QuadCellId = base::Id<QuadCellTag>;

/// Whether rule 3 is applied. Without it interior cells are as large as rule 4 lets them be.
enum class InteriorCells : std::uint8_t { AsBoundary, Free };

struct QuadtreeOptions {
  double refinement_factor = 1.0;  ///< f of rule 2: larger makes smaller cells.
  InteriorCells interior = InteriorCells::AsBoundary;
  std::size_t max_cells = 20'000'000;  ///< More end in TooManyElements.
};

/// Which edges bound the size of the interior cells (rule 3).
enum class SizeRole : std::uint8_t { Boundary, Internal };

/// An edge that asks for cells of its size.
struct SizedEdge {
  geom::Segment segment;
  SizeRole role = SizeRole::Boundary;
};

class Quadtree {
 public:
  static constexpr std::uint32_t max_level = 30;
  enum class Direction : std::uint8_t { Left, Right, Down, Up };

  struct Cell {
    std::uint32_t x = 0;  ///< Lower left corner on the finest grid.
    std::uint32_t y = 0;
    QuadCellId first_child;  ///< Of four: lower left, lower right, upper left, upper right; none in a leaf.
    std::uint8_t level = 0;  ///< 0 is the root.
  };

  /// One root cell over `box`. @pre box not empty and not a point.
  explicit Quadtree(const geom::Box& box);

  /// Rules 1 to 4 over `edges`; edges of zero length are passed over.
  /// @error InvalidOption (factor not positive), TooManyElements, CannotMesh (no edge of positive length).
  /// @cost  O(edges * depth + cells * depth)
  static base::Result<Quadtree> build(std::span<const SizedEdge> edges, const QuadtreeOptions& options = {});

  /// Rule 2 for one place: splits the leaves with p while side * factor >= size. @return the largest leaf reached
  /// (level).
  std::uint32_t refine_at(geom::Point p, double size, double factor);
  /// Rule 3: splits every leaf above `level`. False if more than max_cells would be needed.
  bool refine_to_level(std::uint32_t level, std::size_t max_cells);
  /// Splits leaves, their children too, as long as `wanted` says so of one. False if more than max_cells would be
  /// needed.
  bool refine_where(const std::function<bool(QuadCellId)>& wanted, std::size_t max_cells);
  /// Rule 4.
  void balance();

  [[nodiscard]] std::size_t cell_count() const { return cells_.size(); }
  [[nodiscard]] const Cell& cell(QuadCellId id) const { return cells_[id.index()]; }
  [[nodiscard]] bool is_leaf(QuadCellId id) const { return !cell(id).first_child.valid(); }
  [[nodiscard]] std::vector<QuadCellId> leaves() const;
  /// Side of a cell, m.
  [[nodiscard]] double side(QuadCellId id) const;
  [[nodiscard]] geom::Box box(QuadCellId id) const;
  /// The leaf that holds p; for a point outside the root, the leaf nearest in each coordinate.
  [[nodiscard]] QuadCellId leaf_at(geom::Point p) const;
  /// Makes leaf_at begin at a coarse grid instead of the root, until the tree changes. For many questions.
  void index_leaves();
  /// Side of that leaf: the size that the tree asks for at p, m.
  [[nodiscard]] double size_at(geom::Point p) const { return side(leaf_at(p)); }
  /// Leaves across one side: one of equal or larger size, or the smaller ones along it; none at the border of the root.
  [[nodiscard]] std::vector<QuadCellId> neighbours(QuadCellId leaf, Direction direction) const;
  /// Position of a corner of the finest grid.
  [[nodiscard]] geom::Point position(std::uint32_t x, std::uint32_t y) const;

 private:
  void split(QuadCellId id);
  [[nodiscard]] double on_grid(double value, double low) const;
  [[nodiscard]] QuadCellId leaf_at_grid(std::uint32_t x, std::uint32_t y) const;
  [[nodiscard]] QuadCellId leaf_across(QuadCellId id, Direction direction) const;

  static constexpr std::uint32_t finest_index = 6;

  std::vector<Cell> cells_;
  std::vector<QuadCellId> index_;  ///< The cell of level index_level_, or the leaf above, at each place; or empty.
  std::uint32_t index_level_ = 0;
  geom::Point origin_;
  double root_side_ = 0.0;
};

}  // namespace dobra::mesh::sizing
