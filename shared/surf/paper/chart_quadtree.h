#pragma once
// The background quadtree of the paper's mesher: cells of the chart whose real size says how large triangles are there.
// The first cells are n_u x n_v, by the real lengths of the middle lines of the chart over the largest size. A cell is
// divided into four while
//   a. more than one given node lies in it,
//   b. the normal turns by more than A from its centre to a corner,
//   c. it is coarser than the coarsest cell with a given node,
//   d. a neighbour is finer by more than one level,
//   e. its longer middle line is longer than L (or than a size asked for in it).
// Page: docs/algorithms/paper_mesher.md. Source: [miranda2009surface].

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/surf/mesh/chart_input.h"

namespace dobra::surf::paper {

struct QuadtreeOptions {
  double largest = 1.0;  ///< L, m, > 0.
  double turn = 15.0;    ///< A, degrees, > 0.
  bool nodes = true;     ///< Whether rule a (and so c) is asked.
  /// A cell so deep stays as it is, though it may hold several nodes (`crowded`).
  std::uint32_t most_levels = 12;
  std::size_t most_cells = 2'000'000;  ///< More end in TooManyElements.
};

class ChartQuadtree {
 public:
  using CellIndex = std::uint32_t;

  struct Cell {
    std::uint32_t x = 0, y = 0;             ///< Lower left corner on the lattice of the finest cells.
    std::uint32_t level = 0;                ///< 0: one of the first n_u x n_v.
    CellIndex first_child = 0;              ///< Of four: lower left, lower right, upper left, upper right; 0 in a leaf.
    float size = 0.0F;                      ///< Mean of the real lengths of the two middle lines, m.
    float longest = 0.0F;                   ///< The longer of them, m.
    std::vector<std::uint32_t> nodes = {};  ///< Given nodes in it, of a leaf.
  };

  /// @error TooManyElements; InvalidOption: a size or turn that is not positive.  @cost O(c log c) for c cells
  static base::Result<ChartQuadtree> build(const mesh::ChartInput& input, const QuadtreeOptions& options,
                                           const base::Progress& progress = {});

  /// How many first cells there are along u and v.
  [[nodiscard]] std::array<std::uint32_t, 2> first_cells() const { return count_; }
  [[nodiscard]] const std::vector<Cell>& cells() const { return cells_; }
  [[nodiscard]] bool is_leaf(CellIndex cell) const { return cells_[cell].first_child == 0; }
  [[nodiscard]] std::vector<CellIndex> leaves() const;
  [[nodiscard]] geom::Box box(CellIndex cell) const;
  /// The leaf with a place of the chart, or the one next to it.
  [[nodiscard]] CellIndex leaf_at(geom::Point uv) const;
  /// H there, m.
  [[nodiscard]] double size_at(geom::Point uv) const { return cells_[leaf_at(uv)].size; }
  /// Calls visit(leaf) for all leaves that a box touches.
  void for_leaves(const geom::Box& box, const std::function<void(CellIndex)>& visit) const;
  /// Leaves of the deepest level with more than one node.
  [[nodiscard]] const std::vector<CellIndex>& crowded() const { return crowded_; }
  /// Real lengths of the middle lines over the sides of the chart: what makes the chart as long as the surface.
  [[nodiscard]] geom::Vector scale() const { return scale_; }

 private:
  struct Lattice {
    geom::Point3 at;
    geom::Vector3 normal;  ///< Nought where there is none.
  };

  ChartQuadtree(const mesh::ChartInput& input, const QuadtreeOptions& options) : input_(&input), options_(options) {}
  void make_first_cells();
  void split(CellIndex cell);
  void measure(CellIndex cell);
  [[nodiscard]] std::uint32_t span(std::uint32_t level) const { return 2U << (options_.most_levels - level); }
  [[nodiscard]] const Lattice& lattice(std::uint32_t x, std::uint32_t y);
  [[nodiscard]] geom::Point position(std::uint32_t x, std::uint32_t y) const;
  [[nodiscard]] CellIndex leaf_at_lattice(std::uint32_t x, std::uint32_t y) const;
  [[nodiscard]] bool wants_split(CellIndex cell);
  [[nodiscard]] bool bends(CellIndex cell);
  [[nodiscard]] bool has_kink(const geom::Box& box) const;
  [[nodiscard]] bool finer_neighbour(CellIndex cell) const;
  bool refine_interior();
  base::Result<bool> refine(const base::Progress& progress);

  const mesh::ChartInput* input_;  ///< While it is built.
  QuadtreeOptions options_;
  std::array<std::uint32_t, 2> count_{1, 1};
  geom::Box box_;
  geom::Vector scale_{1.0, 1.0};
  std::vector<Cell> cells_;
  std::vector<CellIndex> crowded_;
  std::unordered_map<std::uint64_t, Lattice> lattice_;
};

}  // namespace dobra::surf::paper
