#pragma once
// What all distances share about a base, besides its segments: what its corners are on the right side, boxes of blocks of 16
// segments and of their offset directions (from which the box of a block's offset pieces at any D follows at once), and a tree of
// boxes that tells what of the base is nearer to a point than r. Neighbours in a chain are neighbours in space, so nothing needs
// sorting. Boxes prune in float, rounded outwards; decisions are taken in Real.

#include <vector>

#include "shared/offset/chain_tree.h"
#include "shared/offset/outline.h"

namespace dobra::offset {

/// 16 segments in a row, with the corners at both ends of each.
struct Block {
  static constexpr std::uint32_t size = 16;
  FloatBox points;
  FloatBox right, left;       ///< Of (raw outline - base) / D on either side.
  std::uint64_t directions;   ///< Of the right side; see ChainTree.
  /// Box of all pieces of the raw outline on one side.
  [[nodiscard]] FloatBox box(bool on_left, double d, double margin) const {
    const FloatBox& w = on_left ? left : right;
    return {{points.low_x + d * w.low_x, points.low_y + d * w.low_y}, {points.high_x + d * w.high_x, points.high_y + d * w.high_y}, margin};
  }
};

class Clearance {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// @param base must outlive this.  @cost O(n).
  Clearance(const BaseCurve& base, const OffsetOptions& options);

  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  /// True if some corner has a mitre on the right side.
  [[nodiscard]] bool has_mitres() const { return !mitre_boxes_.empty(); }

  /// True if some point of the base is nearer to q than r.
  [[nodiscard]] bool nearer_than(Vec q, Real r) const;
  /// A segment nearer to q than r, by doubles; none if there is none.
  [[nodiscard]] std::uint32_t find_nearer(Flat q, double r) const;

  /// True if q lies in a mitre of the outline, nearer than r to all its outer lines' own side.
  [[nodiscard]] bool in_mitre(Vec q, const Outline& outline, Real r) const;
  /// The step before such a mitre, by doubles; none if there is none.
  [[nodiscard]] std::uint32_t find_mitre(Flat q, const Outline& outline, double r) const;

 private:
  static constexpr std::size_t leaf_size = 8;
  void add_block(std::size_t first, std::size_t last);
  void add_mitres(const OffsetOptions& options);
  [[nodiscard]] bool nearer_in_leaf(std::size_t leaf, Vec q, Real r) const;
  [[nodiscard]] bool nearer(std::size_t segment, Vec q, Real squared) const;
  [[nodiscard]] double squared_distance(std::size_t segment, Flat p) const;
  [[nodiscard]] bool in_mitre_at(std::uint32_t step, Vec q, const Outline& outline, Real r) const;
  /// Leaves whose box comes within `reach` of q, until visit returns true; the nearer child first.
  template <class Visit>
  bool any_leaf(Flat q, double reach, Visit&& visit) const;
  /// Ends of segments whose mitre may hold q, until visit returns true.
  template <class Visit>
  bool any_mitre(Flat q, double d, Visit&& visit) const;

  const BaseCurve& base_;
  std::vector<Corner> corners_;
  std::vector<Block> blocks_;
  std::size_t leaves_ = 1;               // a power of two
  std::vector<FloatBox> boxes_;          // heap order: children of i are 2i and 2i + 1; root is 1
  std::vector<FloatBox> mitre_boxes_;    // of (mitre - corner) / D; empty if there is none
};

}  // namespace dobra::offset
