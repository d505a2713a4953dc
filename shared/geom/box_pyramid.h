#pragma once
// Boxes of a structured grid of blocks (rows x columns), and above them the boxes of 2 x 2 of those below, up to one:
// which blocks may hold a point, in O(log n) where neighbours in the grid are neighbours in the plane.

#include <algorithm>
#include <array>
#include <vector>

#include "shared/geom/box.h"

namespace dobra::geom {

class BoxPyramid {
 public:
  BoxPyramid() = default;
  /// @param boxes rows * columns boxes, row by row; a block without anything has an empty box.
  BoxPyramid(std::size_t rows, std::size_t columns, std::vector<Box> boxes) {
    levels_.push_back({rows, columns, std::move(boxes)});
    while (levels_.back().rows > 1 || levels_.back().columns > 1) {
      const Level& below = levels_.back();
      Level level{(below.rows + 1) / 2, (below.columns + 1) / 2, {}};
      level.boxes.resize(level.rows * level.columns);
      for (std::size_t row = 0; row < below.rows; ++row) {
        for (std::size_t column = 0; column < below.columns; ++column)
          level.boxes[row / 2 * level.columns + column / 2].add(below.boxes[row * below.columns + column]);
      }
      levels_.push_back(std::move(level));
    }
  }

  /// Calls visit(row, column) for every block whose box overlaps the query, in no order that means anything.
  template <class Visit>
  void visit(const Box& query, Visit&& visit) const {
    if (levels_.empty()) return;
    struct Node {
      std::size_t level, row, column;
    };
    std::array<Node, 4 * 64> stack;  // four children at most on each level
    std::size_t depth = 0;
    stack[depth++] = {levels_.size() - 1, 0, 0};
    while (depth > 0) {
      const Node node = stack[--depth];
      const Level& level = levels_[node.level];
      if (!level.boxes[node.row * level.columns + node.column].overlaps(query)) continue;
      if (node.level == 0) {
        visit(node.row, node.column);
        continue;
      }
      const Level& below = levels_[node.level - 1];
      for (std::size_t row = 2 * node.row; row < std::min(2 * node.row + 2, below.rows); ++row) {
        for (std::size_t column = 2 * node.column; column < std::min(2 * node.column + 2, below.columns); ++column)
          stack[depth++] = {node.level - 1, row, column};
      }
    }
  }

 private:
  struct Level {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<Box> boxes;
  };
  std::vector<Level> levels_;  ///< The blocks first.
};

}  // namespace dobra::geom
