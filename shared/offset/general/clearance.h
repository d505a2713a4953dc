#pragma once
// What all distances share about a base, besides its segments: the kind of each corner on the right side; boxes of
// blocks of 16 segments and of their offset directions, which give the box of a block's offset pieces at any D; a tree
// of boxes that finds what of the base is nearer to a point than r. Neighbours in a chain are neighbours in space, so
// nothing needs sorting. Decisions are taken elsewhere (validity.h).

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "shared/offset/general/outline.h"
#include "shared/offset/kernel/box_tree_search.h"

namespace dobra::offset::general {

/// Box of the raw outline at distance d, given those of the base and of (outline - base) / D.
inline FloatBox outline_box(const FloatBox& base, const FloatBox& by, double d, double margin) {
  return {{base.low_x + d * by.low_x, base.low_y + d * by.low_y},
          {base.high_x + d * by.high_x, base.high_y + d * by.high_y},
          margin};
}

/// 16 segments in a row, with the corners at both ends of each.
struct Block {
  static constexpr std::uint32_t size = 16;
  FloatBox points;
  FloatBox right, left;      ///< Of (raw outline - base) / D on either side.
  std::uint64_t directions;  ///< Of the right side; see ChainTree.
  std::uint64_t absent;      ///< Pieces that the right side does not have, four bits a segment, by SiteKind.
  /// Of its first arcs, four bits a segment.
  [[nodiscard]] std::uint64_t arcs() const { return (~absent >> 1) & 0x1111111111111111; }
  std::uint32_t piece_count;  ///< Those that it has.
  double plain_below;  ///< Below this distance line follows line there, or an arc of at most a right angle between.
  /// Box of all pieces of the raw outline on one side.
  [[nodiscard]] FloatBox box(bool on_left, double d, double margin) const {
    return outline_box(points, on_left ? left : right, d, margin);
  }
};

class Clearance {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// @param base must outlive this.  @cost O(n).
  Clearance(const BaseCurve& base, const OffsetOptions& options);

  [[nodiscard]] const std::vector<CornerKind>& corners() const { return corners_; }
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  /// True if some corner has a mitre on the right side.
  [[nodiscard]] bool has_mitres() const { return !mitres_.empty(); }
  /// A corner has a mitre, perhaps cut across.
  [[nodiscard]] bool is_mitre(std::size_t corner) const {
    return corners_[corner] == CornerKind::Mitre || corners_[corner] == CornerKind::Tangent;
  }
  /// A corner's mitre reaches far beyond the stadia beside it.
  [[nodiscard]] bool is_long(std::size_t corner) const {
    return corners_[corner] == CornerKind::Tangent ||
           (corners_[corner] == CornerKind::Mitre && base_.half_tans[corner] > 0.5);
  }
  [[nodiscard]] bool has_long_mitres() const { return has_long_mitres_; }
  /// An upper bound of the error of places of the outline at distance d, in doubles. The tips of mitres grow with their
  /// half tangents.
  [[nodiscard]] double margin(double d) const { return 1e-14 * (base_.size + d * (1 + greatest_mitre_)); }

  /// A leaf is four segments in a row. leaves_of: the leaves of a block. left_box: a box of all that the outline at
  /// distance d has on the left side of a leaf, but caps.
  static constexpr std::size_t leaf_size = 4;
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> leaves_of(std::uint32_t block) const {
    constexpr auto many = static_cast<std::uint32_t>(Block::size / leaf_size);
    return {block * many, std::min((block + 1) * many, static_cast<std::uint32_t>(left_.size()))};
  }
  [[nodiscard]] FloatBox left_box(std::uint32_t leaf, double d, double margin) const {
    return outline_box(tree_.box(leaf), left_[leaf], d, margin);
  }

  /// The directions of a block (or of it and the next one), corners at both ends included, lie within less than half a
  /// turn, so connected parts of its right side do not meet each other. Known only where Block::directions are too
  /// coarse to tell.
  [[nodiscard]] bool bends_little(std::size_t block) const { return (bends_[block] & 1) != 0; }
  [[nodiscard]] bool bends_little_with_next(std::size_t block) const { return (bends_[block] & 2) != 0; }

  /// Computes what is_alone and is_harmless answer. Worth its cost where several distances share it.
  /// @param least, greatest  distances.  @cost some 0.3 us a segment where the base keeps far from itself.
  void find_gaps(double least, double greatest);
  /// The outline of a block at distance d, on either side, meets the outline of no other block but the two beside it.
  [[nodiscard]] bool is_alone(std::size_t block, double d) const { return !gaps_.empty() && d < gaps_[block].alone; }
  /// The outline on the left side of a block meets nothing on the right side of the base; nor does the outline on its
  /// right side, as far as that is connected. Caps do not count.
  [[nodiscard]] bool is_harmless(std::size_t block, double d) const {
    return !gaps_.empty() && d < gaps_[block].harmless;
  }

  /// The greatest of these distances at which a straight way leads out from both ends of the base, D from all else; 0
  /// if there is none. Where there is one, there are such ways at all smaller distances.
  /// @pre the base is open  @cost O(log n) a distance
  [[nodiscard]] double find_escape_rays(std::span<const double> distances) const;
  /// The outline at distance d on the left side of the base cuts nothing valid on the right, but for caps.
  [[nodiscard]] bool parts_sides(double d) const { return d <= parted_up_to_; }
  /// @pre there are ways out at d, the base does not meet itself, and there are no mitres. (If left and right met at a
  /// valid place, the disc about it would hold none of the base and close a loop with it round one end, which has a way
  /// out.)
  void part_sides(double d) { parted_up_to_ = d; }

  /// Doubles are exact enough to tell on which side of a simple contour the free places of the outline at distance d
  /// are.
  [[nodiscard]] bool tells_sides(double d) const { return !has_mitres() || 100 * margin(d) < d; }

  /// Some mitres reach so far that places cut from their lines in doubles are off.
  [[nodiscard]] bool has_far_mitres() const { return greatest_mitre_ > 16; }

  /// A segment nearer to q than r, by doubles; none if there is none.
  [[nodiscard]] std::uint32_t find_nearer(Flat q, double r) const;

  /// The step before a mitre of the outline that holds q, on the inner side of all its outer lines at distance r, by
  /// doubles; none if there is none.
  /// @pre no segment is nearer to q than r, but for roundings
  [[nodiscard]] std::uint32_t find_mitre(Flat q, const Outline& outline, double r) const;

  /// Segments that may be nearer to q than `reach`, until visit(segment) returns true.
  template <class Visit>
  bool any_near(Flat q, double reach, Visit&& visit) const {
    return tree_.any_within(q, reach, [&](std::size_t leaf) { return any_of_leaf(leaf, visit); });
  }
  /// Segments whose boxes may overlap this one.
  template <class Visit>
  void each_in(const FloatBox& box, Visit&& visit) const {
    const auto go_on = [&](std::size_t i) {
      visit(i);
      return false;
    };
    tree_.any_held([&](const FloatBox& own) { return own.overlaps(box); },
                   [&](std::size_t leaf) { return any_of_leaf(leaf, go_on); });
  }
  /// Ends of segments whose mitre may hold q at distance d, until visit(segment) returns true.
  /// @pre no segment is nearer to q than d, but for those that do not count there, and for roundings
  template <class Visit>
  bool any_mitre(Flat q, double d, Visit&& visit) const {
    if (mitres_.empty()) return false;
    const auto if_mitre = [&](std::size_t i) {
      return base_.has_after(i) && is_mitre(base_.end_index(i)) && visit(static_cast<std::uint32_t>(i));
    };
    return tree_.any_held(mitres_, q, d, [&](std::size_t leaf) { return any_of_leaf(leaf, if_mitre); });
  }

 private:
  void add_block(std::size_t first, std::size_t last);
  [[nodiscard]] std::uint64_t absent_pieces(std::size_t first, std::size_t last) const;
  [[nodiscard]] double plain_below(std::size_t first, std::size_t last) const;
  [[nodiscard]] bool within_half_turn(std::size_t first, std::size_t last) const;
  void add_mitres(const OffsetOptions& options);
  [[nodiscard]] double squared_distance(std::size_t segment, Flat p) const;
  /// Segments of a leaf, until visit(segment) returns true.
  template <class Visit>
  bool any_of_leaf(std::size_t leaf, Visit&& visit) const {
    const std::size_t end = std::min((leaf + 1) * leaf_size, base_.segment_count());
    for (std::size_t i = leaf * leaf_size; i < end; ++i) {
      if (visit(i)) return true;
    }
    return false;
  }

  /// Distances up to which a block is what is_alone and is_harmless say.
  struct Gaps {
    double alone = 0;
    double harmless = 0;
  };
  [[nodiscard]] bool has_escape_ray(bool from_last, double d) const;
  [[nodiscard]] double squared_gap_of(std::size_t i, std::size_t j) const;
  [[nodiscard]] std::pair<double, double> gaps_about(std::size_t block, double floor, double ceiling) const;

  const BaseCurve& base_;
  std::vector<CornerKind> corners_;
  std::vector<Block> blocks_;
  BoxTree tree_;                     // of leaves
  std::vector<FloatBox> left_;       // of the same leaves; as Block::left
  BoxTree mitres_;                   // of (mitre outside its corner's disc - corner) / D, of the same leaves, if any
  std::vector<std::uint8_t> bends_;  // of blocks, by bits: see bends_little
  std::vector<Gaps> gaps_;           // of blocks; empty where nobody asked
  double parted_up_to_ = 0;          // a distance
  double greatest_mitre_ = 0;        // half tangent
  bool has_long_mitres_ = false;
};

}  // namespace dobra::offset::general
