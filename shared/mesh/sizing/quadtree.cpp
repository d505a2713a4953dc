#include "shared/mesh/sizing/quadtree.h"

#include <algorithm>
#include <bit>

#include "shared/base/check.h"

namespace dobra::mesh::sizing {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Box;
using geom::Point;

namespace {

constexpr std::uint32_t width_of(std::uint32_t level) { return 1U << (Quadtree::max_level - level); }
constexpr std::uint32_t full = 1U << Quadtree::max_level;
constexpr double finest = 1.0 / full;  ///< Side of the finest cell over that of the root.

}  // namespace

Quadtree::Quadtree(const Box& box) {
  root_side_ = std::max(box.width(), box.height());
  DOBRA_CHECK(root_side_ > 0.0);
  const Point centre = box.centre();
  origin_ = {centre.x - 0.5 * root_side_, centre.y - 0.5 * root_side_};
  cells_.emplace_back();
}

Result<Quadtree> Quadtree::build(std::span<const SizedEdge> edges, const QuadtreeOptions& options) {
  if (!(options.refinement_factor > 0.0)) {
    return Error{ErrorCode::InvalidOption, "the refinement factor of the quadtree must be greater than 0"};
  }
  Box box;
  for (const SizedEdge& edge : edges) box.add(edge.segment.box());
  if (box.empty() || !(std::max(box.width(), box.height()) > 0.0)) {
    return Error{ErrorCode::CannotMesh, "no edge of positive length to take sizes from: give a boundary"};
  }
  Quadtree tree(box);
  const Error too_many{
      ErrorCode::TooManyElements,
      "the quadtree would need more than the allowed number of cells: use longer edges or raise the limit"};
  std::uint32_t coarsest = max_level;
  for (const SizedEdge& edge : edges) {
    const double length = edge.segment.length();
    if (length == 0.0) continue;
    const std::uint32_t level =
        tree.refine_at(geom::midpoint(edge.segment.from, edge.segment.to), length, options.refinement_factor);
    if (edge.role == SizeRole::Boundary) coarsest = std::min(coarsest, level);
    if (tree.cells_.size() > options.max_cells) return too_many;
  }
  // A coarse cell of an early edge may have been split by a later one: that only makes rule 3 stricter than asked.
  if (options.interior == InteriorCells::Free) coarsest = 0;
  if (coarsest < max_level && !tree.refine_to_level(coarsest, options.max_cells)) return too_many;
  tree.balance();
  if (tree.cells_.size() > options.max_cells) return too_many;
  tree.cells_.shrink_to_fit();
  return tree;
}

void Quadtree::split(QuadCellId id) {
  const Cell parent = cells_[id.index()];
  DOBRA_CHECK(!parent.first_child.valid() && parent.level < max_level);
  index_.clear();
  const auto level = static_cast<std::uint8_t>(parent.level + 1);
  const std::uint32_t width = width_of(level);
  cells_[id.index()].first_child = QuadCellId(cells_.size());
  for (std::uint32_t k = 0; k < 4; ++k) {
    cells_.push_back({parent.x + (k & 1U) * width, parent.y + (k >> 1U) * width, {}, level});
  }
}

std::uint32_t Quadtree::refine_at(Point p, double size, double factor) {
  // Units of the finest grid. Rounding may put a point of the border outside the root, where no child would hold it.
  const Point at{on_grid(p.x, origin_.x), on_grid(p.y, origin_.y)};
  std::uint32_t coarsest = max_level;
  std::vector<QuadCellId> todo{QuadCellId(0)};
  while (!todo.empty()) {
    const QuadCellId id = todo.back();
    todo.pop_back();
    if (is_leaf(id)) {
      const std::uint32_t level = cell(id).level;
      if (side(id) * factor < size || level == max_level) {
        coarsest = std::min(coarsest, level);
        continue;
      }
      split(id);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const QuadCellId child(cell(id).first_child.index() + k);
      const Cell& c = cell(child);
      const double width = width_of(c.level);
      if (at.x >= c.x && at.x <= c.x + width && at.y >= c.y && at.y <= c.y + width) todo.push_back(child);
    }
  }
  return coarsest;
}

bool Quadtree::refine_to_level(std::uint32_t level, std::size_t max_cells) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i].first_child.valid() || cells_[i].level >= level) continue;
    if (cells_.size() + 4 > max_cells) return false;
    split(QuadCellId(i));
  }
  return true;
}

bool Quadtree::refine_where(const std::function<bool(QuadCellId)>& wanted, std::size_t max_cells) {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i].first_child.valid() || cells_[i].level == max_level || !wanted(QuadCellId(i))) continue;
    if (cells_.size() + 4 > max_cells) return false;
    split(QuadCellId(i));
  }
  return true;
}

QuadCellId Quadtree::leaf_at_grid(std::uint32_t x, std::uint32_t y) const {
  const std::uint32_t shift = max_level - index_level_;
  QuadCellId id = index_.empty() ? QuadCellId(0) : index_[((y >> shift) << index_level_) | (x >> shift)];
  while (!is_leaf(id)) {
    const std::uint32_t bit = width_of(cell(id).level + 1U);
    const std::uint32_t k = ((x & bit) != 0 ? 1U : 0U) + ((y & bit) != 0 ? 2U : 0U);
    id = QuadCellId(cell(id).first_child.index() + k);
  }
  return id;
}

/// The leaf that holds the finest cell beyond the lower or left end of a side; none at the border.
QuadCellId Quadtree::leaf_across(QuadCellId id, Direction direction) const {
  const Cell& c = cell(id);
  const std::uint32_t width = width_of(c.level);
  switch (direction) {
    case Direction::Left:
      return c.x == 0 ? QuadCellId() : leaf_at_grid(c.x - 1, c.y);
    case Direction::Right:
      return c.x + width == full ? QuadCellId() : leaf_at_grid(c.x + width, c.y);
    case Direction::Down:
      return c.y == 0 ? QuadCellId() : leaf_at_grid(c.x, c.y - 1);
    case Direction::Up:
      break;
  }
  return c.y + width == full ? QuadCellId() : leaf_at_grid(c.x, c.y + width);
}

void Quadtree::index_leaves() {
  // No more places than cells.
  index_level_ = std::min(finest_index, (static_cast<std::uint32_t>(std::bit_width(cells_.size())) - 1U) / 2U);
  index_.assign(std::size_t{1} << (2 * index_level_), QuadCellId(0));
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Cell& c = cells_[i];
    if (c.level > index_level_ || (c.level < index_level_ && c.first_child.valid())) continue;
    const std::uint32_t width = 1U << (index_level_ - c.level);
    const std::uint32_t x = c.x >> (max_level - index_level_);
    const std::uint32_t y = c.y >> (max_level - index_level_);
    for (std::uint32_t row = y; row < y + width; ++row) {
      for (std::uint32_t column = x; column < x + width; ++column) {
        index_[(row << index_level_) | column] = QuadCellId(i);
      }
    }
  }
}

void Quadtree::balance() {
  std::vector<QuadCellId> todo = leaves();
  while (!todo.empty()) {
    const QuadCellId id = todo.back();
    todo.pop_back();
    if (!is_leaf(id)) continue;
    for (const Direction direction : {Direction::Left, Direction::Right, Direction::Down, Direction::Up}) {
      QuadCellId other = leaf_across(id, direction);
      while (other.valid() && cell(other).level + 1 < cell(id).level) {
        split(other);
        for (std::size_t k = 0; k < 4; ++k) todo.emplace_back(cell(other).first_child.index() + k);
        other = leaf_across(id, direction);
      }
    }
  }
}

std::vector<QuadCellId> Quadtree::leaves() const {
  std::vector<QuadCellId> leaves;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (!cells_[i].first_child.valid()) leaves.emplace_back(i);
  }
  return leaves;
}

double Quadtree::side(QuadCellId id) const { return root_side_ * (width_of(cell(id).level) * finest); }

/// In units of the finest grid from `low`, within the root.
double Quadtree::on_grid(double value, double low) const {
  return std::clamp((value - low) / root_side_ * static_cast<double>(full), 0.0, static_cast<double>(full));
}

Point Quadtree::position(std::uint32_t x, std::uint32_t y) const {
  const auto at = [this](double low, std::uint32_t i) { return low + root_side_ * (i * finest); };
  return {at(origin_.x, x), at(origin_.y, y)};
}

Box Quadtree::box(QuadCellId id) const {
  const Cell& c = cell(id);
  const std::uint32_t width = width_of(c.level);
  return {position(c.x, c.y), position(c.x + width, c.y + width)};
}

QuadCellId Quadtree::leaf_at(Point p) const {
  const auto grid = [this](double value, double low) {
    return std::min(static_cast<std::uint32_t>(on_grid(value, low)), full - 1);
  };
  return leaf_at_grid(grid(p.x, origin_.x), grid(p.y, origin_.y));
}

std::vector<QuadCellId> Quadtree::neighbours(QuadCellId leaf, Direction direction) const {
  const QuadCellId first = leaf_across(leaf, direction);
  if (!first.valid()) return {};
  std::vector<QuadCellId> found{first};
  const Cell& c = cell(leaf);
  const bool vertical = direction == Direction::Left || direction == Direction::Right;
  const std::uint32_t end = (vertical ? c.y : c.x) + width_of(c.level);
  while (true) {
    const Cell& last = cell(found.back());
    const std::uint32_t at = (vertical ? last.y : last.x) + width_of(last.level);
    if (at >= end) return found;
    found.push_back(vertical
                        ? leaf_at_grid(last.x + (direction == Direction::Left ? width_of(last.level) - 1 : 0), at)
                        : leaf_at_grid(at, last.y + (direction == Direction::Down ? width_of(last.level) - 1 : 0)));
  }
}

}  // namespace dobra::mesh::sizing
