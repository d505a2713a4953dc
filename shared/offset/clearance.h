#pragma once
// What all distances share about a base, besides its segments: what its corners are on the right side, boxes of blocks of 16
// segments and of their offset directions (from which the box of a block's offset pieces at any D follows at once), and a tree of
// boxes that tells what of the base is nearer to a point than r. Neighbours in a chain are neighbours in space, so nothing needs
// sorting. Decisions are not taken here (validity.h).

#include <algorithm>
#include <utility>
#include <vector>

#include "shared/offset/block.h"
#include "shared/offset/outline.h"

namespace dobra::offset {

class Clearance {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  /// @param base must outlive this.  @cost O(n).
  Clearance(const BaseCurve& base, const OffsetOptions& options);

  [[nodiscard]] const std::vector<Corner>& corners() const { return corners_; }
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  /// True if some corner has a mitre on the right side.
  [[nodiscard]] bool has_mitres() const { return !mitre_boxes_.empty(); }
  /// Above what places of the outline at distance d, in doubles, are wrong by: the tips of mitres grow with their half tangents.
  [[nodiscard]] double margin(double d) const { return 1e-14 * (base_.size + d * (1 + greatest_mitre_)); }

  /// Finds out what is_alone and is_harmless tell. Worth its cost where several distances share it.
  /// @param least, greatest  distances.  @cost some 0.3 us a segment where the base keeps far from itself.
  void find_gaps(double least, double greatest);
  /// What the outline has on either side of a block at distance d meets no such thing of other blocks but the two beside it.
  [[nodiscard]] bool is_alone(std::size_t block, double d) const { return !gaps_.empty() && d < gaps_[block].alone; }
  /// What it has on the left side of a block meets nothing on the right side of the base, nor does what it has on the right side,
  /// as far as that is connected. Caps do not count.
  [[nodiscard]] bool is_harmless(std::size_t block, double d) const { return !gaps_.empty() && d < gaps_[block].harmless; }

  /// Some mitres reach so far that what is cut in doubles of their lines is not at its place.
  [[nodiscard]] bool has_far_mitres() const { return greatest_mitre_ > 16; }

  /// A segment nearer to q than r, by doubles; none if there is none.
  [[nodiscard]] std::uint32_t find_nearer(Flat q, double r) const;

  /// The step before a mitre of the outline that holds q, nearer than r to all its outer lines' own side, by doubles; none if there
  /// is none.
  [[nodiscard]] std::uint32_t find_mitre(Flat q, const Outline& outline, double r) const;

  /// Segments that may be nearer to q than `reach`, until visit(segment) returns true.
  template <class Visit>
  bool any_near(Flat q, double reach, Visit&& visit) const;
  /// Ends of segments whose mitre may hold q at distance d, until visit(segment) returns true.
  template <class Visit>
  bool any_mitre(Flat q, double d, Visit&& visit) const;

 private:
  static constexpr std::size_t leaf_size = 8;
  void add_block(std::size_t first, std::size_t last);
  void add_mitres(const OffsetOptions& options);
  [[nodiscard]] double squared_distance(std::size_t segment, Flat p) const;
  /// Leaves whose box comes within `reach` of q, until visit returns true; the nearer child first.
  template <class Visit>
  bool any_leaf(Flat q, double reach, Visit&& visit) const;

  /// Distances up to which a block is what is_alone and is_harmless say.
  struct Gaps {
    double alone = 0;
    double harmless = 0;
  };
  [[nodiscard]] double squared_gap_of(std::size_t i, std::size_t j) const;
  [[nodiscard]] bool bends_little(std::size_t first, std::size_t last) const;
  [[nodiscard]] std::pair<double, double> gaps_about(std::size_t block, double floor, double ceiling) const;

  const BaseCurve& base_;
  std::vector<Corner> corners_;
  std::vector<Block> blocks_;
  std::size_t leaves_ = 1;               // a power of two
  std::vector<FloatBox> boxes_;          // heap order: children of i are 2i and 2i + 1; root is 1
  std::vector<FloatBox> mitre_boxes_;    // of (mitre - corner) / D; empty if there is none
  std::vector<Gaps> gaps_;               // of blocks; empty where nobody asked
  double greatest_mitre_ = 0;            // half tangent
};

template <class Visit>
bool Clearance::any_leaf(Flat p, double reach, Visit&& visit) const {
  const double limit = reach * reach;
  const auto squared_gap = [&](const FloatBox& box) {
    const double x = std::max({box.low_x - p.x, 0.0, p.x - box.high_x});
    const double y = std::max({box.low_y - p.y, 0.0, p.y - box.high_y});
    return x * x + y * y;
  };
  struct Open {
    std::size_t node;
    double gap;
  };
  Open open[128];
  std::size_t count = 0;
  const auto push = [&](std::size_t node, double gap) {
    if (gap <= limit) open[count++] = {node, gap};
  };
  push(1, squared_gap(boxes_[1]));
  while (count > 0) {
    const std::size_t node = open[--count].node;
    if (node >= leaves_) {
      if (visit(node - leaves_)) return true;
      continue;
    }
    // The nearer child first: if there is something near, it is found soon.
    const double left = squared_gap(boxes_[2 * node]);
    const double right = squared_gap(boxes_[2 * node + 1]);
    if (left <= right) {
      push(2 * node + 1, right);
      push(2 * node, left);
    } else {
      push(2 * node, left);
      push(2 * node + 1, right);
    }
  }
  return false;
}

template <class Visit>
bool Clearance::any_near(Flat q, double reach, Visit&& visit) const {
  return any_leaf(q, reach, [&](std::size_t leaf) {
    const std::size_t end = std::min((leaf + 1) * leaf_size, base_.segment_count());
    for (std::size_t i = leaf * leaf_size; i < end; ++i) {
      if (visit(i)) return true;
    }
    return false;
  });
}

template <class Visit>
bool Clearance::any_mitre(Flat q, double d, Visit&& visit) const {
  if (mitre_boxes_.empty()) return false;
  const double margin = 1e-13 * (base_.size + d);
  const auto may_hold = [&](std::size_t node) {
    const FloatBox& p = boxes_[node];
    const FloatBox& w = mitre_boxes_[node];
    return (q.x >= p.low_x + d * w.low_x - margin) & (q.x <= p.high_x + d * w.high_x + margin) &
           (q.y >= p.low_y + d * w.low_y - margin) & (q.y <= p.high_y + d * w.high_y + margin);
  };
  std::size_t open[64];
  std::size_t count = 0;
  if (may_hold(1)) open[count++] = 1;
  while (count > 0) {
    const std::size_t node = open[--count];
    if (node < leaves_) {
      if (may_hold(2 * node + 1)) open[count++] = 2 * node + 1;
      if (may_hold(2 * node)) open[count++] = 2 * node;
      continue;
    }
    const std::size_t first = (node - leaves_) * leaf_size;
    const std::size_t end = std::min(first + leaf_size, base_.segment_count());
    for (std::size_t i = first; i < end; ++i) {
      if (!base_.has_after(i)) continue;
      const Corner kind = corners_[base_.end_index(i)];
      if (kind != Corner::Mitre && kind != Corner::Tangent) continue;
      if (visit(static_cast<std::uint32_t>(i))) return true;
    }
  }
  return false;
}

}  // namespace dobra::offset
