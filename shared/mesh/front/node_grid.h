#pragma once
// Finds nodes near a point while a front advances: buckets whose side follows the size field, so that each holds about
// one node wherever it is. The leaf of the size field that a node lies in says how large its bucket is; buckets are
// found by hashing, in blocks of 8 x 8 so that neighbours share cache lines. Page: docs/algorithms/advancing_front.md.

#include <cstdint>
#include <vector>

#include "shared/mesh/sizing/size_field.h"

namespace dobra::mesh::front {

class NodeGrid {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;
  /// A node, or a place to keep clear of (vertex none).
  struct Entry {
    geom::Point at;
    std::uint32_t vertex = none;
    std::uint32_t next = none;  ///< In the same bucket.
  };

  /// @param expected about how many entries will come.  @cost O(leaves + expected)
  NodeGrid(const sizing::SizeField& field, std::size_t expected);
  /// @param leaf the leaf that holds `at`.
  void add(geom::Point at, std::uint32_t vertex, sizing::QuadCellId leaf);

  /// Calls visit(entry) for every entry within `radius` of `p`, and for some others. @param leaf the leaf that holds p.
  template <class Visit>
  void visit_near(geom::Point p, double radius, sizing::QuadCellId leaf, const Visit& visit) const;

 private:
  struct Levels {
    std::uint8_t own = 0;     ///< Buckets of a leaf of level k have the side root / 2^k.
    std::uint8_t lowest = 0;  ///< Of the leaves that share a corner.
    std::uint8_t highest = 0;
  };
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

template <class Visit>
void NodeGrid::visit_near(geom::Point p, double radius, sizing::QuadCellId leaf, const Visit& visit) const {
  const Levels levels = levels_[leaf.index()];
  for (std::uint32_t level = levels.lowest; level <= levels.highest; ++level) {
    const double scale = scale_[level];
    const auto x0 = static_cast<std::int64_t>((p.x - radius - origin_.x) * scale);
    const auto x1 = static_cast<std::int64_t>((p.x + radius - origin_.x) * scale);
    const auto y0 = static_cast<std::int64_t>((p.y - radius - origin_.y) * scale);
    const auto y1 = static_cast<std::int64_t>((p.y + radius - origin_.y) * scale);
    for (std::int64_t y = y0; y <= y1; ++y) {
      for (std::int64_t x = x0; x <= x1; ++x) {
        for (std::uint32_t k = first_[bucket(level, x, y)]; k != none; k = entries_[k].next) visit(entries_[k]);
      }
    }
  }
}

}  // namespace dobra::mesh::front
