#pragma once
// A surface in cells of its chart, each with a proven hull in space; halved where somebody looks closer.
// Page: docs/algorithms/surface_search.md.

#include <array>
#include <vector>

#include "shared/surf/surface.h"

namespace dobra::surf {

/// Each point of the surface over a cell is centre + s along_u + t along_v, |s|, |t| <= 1, but for `rest`, m.
struct Hull {
  geom::Point3 centre;
  geom::Vector3 along_u, along_v;  ///< By half of the cell.
  double rest = 0.0;
  double turn_u = 0.0, turn_v = 0.0;  ///< along_u and along_v change no more than this over the cell, m.

  /// How far the cell reaches from its centre along a unit direction, m, at most.
  [[nodiscard]] double reach(geom::Vector3 direction) const {
    return std::abs(dot(along_u, direction)) + std::abs(dot(along_v, direction)) + rest;
  }
  [[nodiscard]] double radius() const { return geom::length(along_u) + geom::length(along_v) + rest; }
};
Hull hull_of(const Surface& surface, const geom::Box& cell);

/// The parts of the chart between lines on which the tangents jump (knots that stand as often as the degree). The right
/// side of a part is the double before such a line, where derivatives are still those of the part.
std::vector<geom::Box> smooth_parts(const Surface& surface);

/// Cells by number; those of the smooth parts come first.
class Cells {
 public:
  struct Cell {
    geom::Box box;
    Hull hull;
    std::size_t part = 0;   ///< Number of the smooth part.
    std::size_t child = 0;  ///< The first of two; 0: not halved yet.
  };

  explicit Cells(const Surface& surface);
  [[nodiscard]] const Surface& surface() const { return surface_; }
  [[nodiscard]] std::size_t parts() const { return parts_.size(); }
  [[nodiscard]] const geom::Box& part(std::size_t number) const { return parts_[number]; }
  [[nodiscard]] const Cell& operator[](std::size_t cell) const { return cells_[cell]; }
  /// Both halves of a cell, across its longer way in space.
  std::array<std::size_t, 2> halves(std::size_t cell);

 private:
  Surface surface_;
  std::vector<geom::Box> parts_;
  std::vector<Cell> cells_;
};

}  // namespace dobra::surf
