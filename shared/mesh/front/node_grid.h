#pragma once
// Finds nodes near a point while a front advances: buckets whose side follows the size field, so that each holds about
// one node wherever it is. The leaf of the size field that a node lies in says how large its bucket is; buckets are
// found by hashing, in blocks of 8 x 8 so that neighbours share cache lines. Page: docs/algorithms/advancing_front.md.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "shared/mesh/front/space.h"
#include "shared/mesh/sizing/size_field.h"

namespace dobra::mesh::front {

template <class Space>
class Buckets {
 public:
  using Place = typename Space::Place;
  static constexpr std::uint32_t none = 0xffffffffU;
  /// A node, or a place to keep clear of (vertex none).
  struct Entry {
    typename Space::Point at;
    std::uint32_t vertex = none;
    std::uint32_t next = none;  ///< In the same bucket.
  };

  /// @param expected about how many entries will come.  @cost O(leaves + expected)
  Buckets(const sizing::SizeField& field, const Space& space, std::size_t expected);
  /// @param leaf the leaf that holds `at`.
  void add(const Place& at, std::uint32_t vertex, sizing::QuadCellId leaf);

  /// Calls visit(entry) for every entry within `radius` of `p`, and for some others, on a surface of other sheets too.
  /// @param leaf the leaf that holds p.
  template <class Visit>
  void visit_near(geom::Point p, double radius, sizing::QuadCellId leaf, const Visit& visit) const;

 private:
  struct Levels {
    std::uint8_t own = 0;     ///< Buckets of a leaf of level k have the side root / 2^k.
    std::uint8_t lowest = 0;  ///< Of the leaves that share a corner.
    std::uint8_t highest = 0;
    float reach_u = 1.0F;  ///< Most that a step of length 1 in space goes along u and v of the chart.
    float reach_v = 1.0F;
  };
  void find_levels(const sizing::SizeField& field, const Space& space);
  [[nodiscard]] std::size_t bucket(std::uint32_t level, std::int64_t x, std::int64_t y) const {
    const std::uint64_t block = static_cast<std::uint64_t>(x >> 3) * 0x9e3779b97f4a7c15ULL +
                                static_cast<std::uint64_t>(y >> 3) * 0xc2b2ae3d27d4eb4fULL +
                                level * 0x165667b19e3779f9ULL;
    const std::uint64_t mixed = (block ^ (block >> 29U)) * 0xbf58476d1ce4e5b9ULL;
    return ((mixed >> shift_) << 6U) | static_cast<std::size_t>(((y & 7) << 3) | (x & 7));
  }

  std::vector<Levels> levels_;  ///< One a cell of the tree; meaningful for leaves.
  std::vector<std::uint32_t> first_;
  std::vector<Entry> entries_;
  std::vector<double> scale_;  ///< 1 / side of the buckets, by level.
  geom::Point origin_;
  std::uint32_t shift_ = 0;
};

/// Those of the plane.
class NodeGrid : public Buckets<Plane> {
 public:
  NodeGrid(const sizing::SizeField& field, std::size_t expected) : Buckets(field, Plane(), expected) {}
  void add(geom::Point at, std::uint32_t vertex, sizing::QuadCellId leaf) { Buckets::add({at}, vertex, leaf); }
};

template <class Space>
Buckets<Space>::Buckets(const sizing::SizeField& field, const Space& space, std::size_t expected) {
  const sizing::Quadtree& tree = field.quadtree();
  const double root = tree.side(sizing::QuadCellId(0));
  // Well below every point, so that buckets have positive numbers and truncation rounds down.
  origin_ = tree.box(sizing::QuadCellId(0)).low - geom::Vector{root, root};
  for (std::uint32_t level = 0; level <= sizing::Quadtree::max_level; ++level) {
    scale_.push_back(std::ldexp(1.0 / root, static_cast<int>(level)));
  }
  find_levels(field, space);
  const std::size_t blocks = std::bit_ceil(std::clamp<std::size_t>(expected / 48, 16, std::size_t{1} << 24U));
  shift_ = 64U - static_cast<std::uint32_t>(std::countr_zero(blocks));
  first_.assign(blocks * 64, none);
}

template <class Space>
void Buckets<Space>::find_levels(const sizing::SizeField& field, const Space& space) {
  /// Side of a bucket over the size, at least: with 3/4 a disc of that radius meets three buckets by three at most.
  constexpr double least_bucket = 0.75;
  const sizing::Quadtree& tree = field.quadtree();
  const double root = tree.side(sizing::QuadCellId(0));
  levels_.resize(tree.cell_count());
  struct Range {
    std::uint8_t low = 255;
    std::uint8_t high = 0;
  };
  std::vector<Range> range(field.corner_count());
  const std::vector<sizing::QuadCellId> leaves = tree.leaves();
  for (const sizing::QuadCellId leaf : leaves) {
    const auto sizes = field.corner_sizes(leaf);
    const LeafScale scale = space.scale(leaf);
    const double ratio = root / (least_bucket * *std::max_element(sizes.begin(), sizes.end()) * scale.mean);
    levels_[leaf.index()].reach_u = static_cast<float>(scale.reach_u);
    levels_[leaf.index()].reach_v = static_cast<float>(scale.reach_v);
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
      if (tree.side(leaf) >= 2.0 * *std::max_element(sizes.begin(), sizes.end()) * space.scale(leaf).mean) continue;
      Levels& levels = levels_[leaf.index()];
      for (const std::uint32_t corner : field.corners(leaf)) {
        levels.lowest = std::min(levels.lowest, range[corner].low);
        levels.highest = std::max(levels.highest, range[corner].high);
      }
    }
  }
}

template <class Space>
void Buckets<Space>::add(const Place& place, std::uint32_t vertex, sizing::QuadCellId leaf) {
  const geom::Point at = place.chart();
  const std::uint32_t level = levels_[leaf.index()].own;
  const auto x = static_cast<std::int64_t>((at.x - origin_.x) * scale_[level]);
  const auto y = static_cast<std::int64_t>((at.y - origin_.y) * scale_[level]);
  std::uint32_t& first = first_[bucket(level, x, y)];
  entries_.push_back({place.at, vertex, first});
  first = static_cast<std::uint32_t>(entries_.size() - 1);
}

template <class Space>
template <class Visit>
void Buckets<Space>::visit_near(geom::Point p, double radius, sizing::QuadCellId leaf, const Visit& visit) const {
  const Levels& levels = levels_[leaf.index()];
  const double reach_u = Space::curved ? radius * levels.reach_u : radius;
  const double reach_v = Space::curved ? radius * levels.reach_v : radius;
  for (std::uint32_t level = levels.lowest; level <= levels.highest; ++level) {
    const double scale = scale_[level];
    const auto x0 = static_cast<std::int64_t>((p.x - reach_u - origin_.x) * scale);
    const auto x1 = static_cast<std::int64_t>((p.x + reach_u - origin_.x) * scale);
    const auto y0 = static_cast<std::int64_t>((p.y - reach_v - origin_.y) * scale);
    const auto y1 = static_cast<std::int64_t>((p.y + reach_v - origin_.y) * scale);
    for (std::int64_t y = y0; y <= y1; ++y) {
      for (std::int64_t x = x0; x <= x1; ++x) {
        for (std::uint32_t k = first_[bucket(level, x, y)]; k != none; k = entries_[k].next) visit(entries_[k]);
      }
    }
  }
}

}  // namespace dobra::mesh::front
