#include "shared/mesh/front/node_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace dobra::mesh::front {

namespace {

/// Side of a bucket over the size, at least: with 3/4 a disc of that radius meets three buckets by three at most.
constexpr double least_bucket = 0.75;

}  // namespace

NodeGrid::NodeGrid(const sizing::SizeField& field, std::size_t expected) {
  const sizing::Quadtree& tree = field.quadtree();
  const double root = tree.side(sizing::QuadCellId(0));
  // Well below every point, so that buckets have positive numbers and truncation rounds down.
  origin_ = tree.box(sizing::QuadCellId(0)).low - geom::Vector{root, root};
  for (std::uint32_t level = 0; level <= sizing::Quadtree::max_level; ++level) {
    scale_.push_back(std::ldexp(1.0 / root, static_cast<int>(level)));
  }
  levels_.resize(tree.cell_count());
  struct Range {
    std::uint8_t low = 255;
    std::uint8_t high = 0;
  };
  std::vector<Range> range(field.corner_count());
  const std::vector<sizing::QuadCellId> leaves = tree.leaves();
  for (const sizing::QuadCellId leaf : leaves) {
    const auto sizes = field.corner_sizes(leaf);
    const double ratio = root / (least_bucket * *std::max_element(sizes.begin(), sizes.end()));
    const auto level =
        static_cast<std::uint8_t>(std::clamp(std::ilogb(ratio), 0, static_cast<int>(sizing::Quadtree::max_level)));
    levels_[leaf.index()].own = level;
    for (const std::uint32_t corner : field.corners(leaf)) {
      range[corner].low = std::min(range[corner].low, level);
      range[corner].high = std::max(range[corner].high, level);
    }
  }
  for (const sizing::QuadCellId leaf : leaves) {
    Levels& levels = levels_[leaf.index()];
    levels.lowest = levels.highest = levels.own;
    for (const std::uint32_t corner : field.corners(leaf)) {
      levels.lowest = std::min(levels.lowest, range[corner].low);
      levels.highest = std::max(levels.highest, range[corner].high);
    }
  }
  // Where leaves are not much larger than elements, nodes beyond their neighbours count too.
  constexpr int further_rings = 2;
  for (int ring = 0; ring < further_rings; ++ring) {
    for (const sizing::QuadCellId leaf : leaves) {
      const Levels levels = levels_[leaf.index()];
      for (const std::uint32_t corner : field.corners(leaf)) {
        range[corner].low = std::min(range[corner].low, levels.lowest);
        range[corner].high = std::max(range[corner].high, levels.highest);
      }
    }
    for (const sizing::QuadCellId leaf : leaves) {
      const auto sizes = field.corner_sizes(leaf);
      if (tree.side(leaf) >= 2.0 * *std::max_element(sizes.begin(), sizes.end())) continue;
      Levels& levels = levels_[leaf.index()];
      for (const std::uint32_t corner : field.corners(leaf)) {
        levels.lowest = std::min(levels.lowest, range[corner].low);
        levels.highest = std::max(levels.highest, range[corner].high);
      }
    }
  }
  const std::size_t blocks = std::bit_ceil(std::clamp<std::size_t>(expected / 48, 16, std::size_t{1} << 24U));
  shift_ = 64U - static_cast<std::uint32_t>(std::countr_zero(blocks));
  first_.assign(blocks * 64, none);
}

void NodeGrid::add(geom::Point at, std::uint32_t vertex, sizing::QuadCellId leaf) {
  const std::uint32_t level = levels_[leaf.index()].own;
  const auto x = static_cast<std::int64_t>((at.x - origin_.x) * scale_[level]);
  const auto y = static_cast<std::int64_t>((at.y - origin_.y) * scale_[level]);
  std::uint32_t& first = first_[bucket(level, x, y)];
  entries_.push_back({at, vertex, first});
  first = static_cast<std::uint32_t>(entries_.size() - 1);
}

}  // namespace dobra::mesh::front
