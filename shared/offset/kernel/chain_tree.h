#pragma once
// Finds the parts of a chain that may meet. A tree of boxes over the chain in its own order; each node also knows the
// directions that occur in it, as 64 bits of 5.6 degrees: a connected part whose directions fit in an open half-plane
// cannot meet itself, so that smooth curves are dismissed near the root. Source: [volino1994collision] (normal cones).

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "shared/offset/kernel/float_box.h"

namespace dobra::offset {
inline namespace kernel {

class ChainTree {
 public:
  /// Some items in a row.
  struct Leaf {
    FloatBox box;
    std::uint64_t directions;  ///< See directions_of.
    bool connected;            ///< Each item but the first starts where the one before ends.
    bool linked;               ///< The first one too.
  };
  /// The bits of all directions from u anticlockwise to v, less than half a turn, with a bit to spare on both sides.
  static std::uint64_t directions_of(Flat u, Flat v);
  /// All of them lie in an open half-plane.
  static bool fits_half_plane(std::uint64_t directions);

  /// In the order of the chain. @cost O(n).
  explicit ChainTree(const std::vector<Leaf>& leaves) : count_(leaves.size()) {
    if (count_ == 0) return;
    nodes_.resize(2 * count_ - 1);
    build(0, 0, count_, leaves);
  }

  /// Calls visit(i, j), i <= j, for all leaves with items that may meet: boxes that overlap, and directions that do not
  /// rule it out.
  template <class Visit>
  void for_each_pair(Visit&& visit) const {
    if (count_ > 0) self({0, 0, count_}, visit);
  }

  /// Calls visit(i, j) for all pairs of a leaf here and one of another tree with boxes that overlap.
  template <class Visit>
  void for_each_overlap(const ChainTree& other, Visit&& visit) const {
    if (count_ > 0 && other.count_ > 0) across({0, 0, count_}, other, {0, 0, other.count_}, visit);
  }

 private:
  using Node = Leaf;
  /// A node and its leaves. The left child is stored next to it, the right one after all of the left one's nodes.
  struct Range {
    std::size_t node, first, last;
    [[nodiscard]] bool is_leaf() const { return last - first == 1; }
    [[nodiscard]] Range left() const { return {node + 1, first, (first + last) / 2}; }
    [[nodiscard]] Range right() const { return {node + 2 * ((first + last) / 2 - first), (first + last) / 2, last}; }
  };
  void build(std::size_t node, std::size_t first, std::size_t last, const std::vector<Leaf>& leaves);

  template <class Visit>
  void self(Range a, Visit& visit) const {
    const Node& n = nodes_[a.node];
    if (n.connected && fits_half_plane(n.directions)) return;
    if (a.is_leaf()) {
      visit(a.first, a.first);
      return;
    }
    self(a.left(), visit);
    self(a.right(), visit);
    pair(a.left(), a.right(), visit);
  }

  template <class Visit>
  void pair(Range a, Range b, Visit& visit) const {
    const Node& m = nodes_[a.node];
    const Node& n = nodes_[b.node];
    if (!m.box.overlaps(n.box)) return;
    if (a.last == b.first && n.linked && m.connected && n.connected && fits_half_plane(m.directions | n.directions))
      return;
    if (a.is_leaf() && b.is_leaf()) {
      visit(a.first, b.first);
    } else if (b.is_leaf() || (!a.is_leaf() && m.box.size() > n.box.size())) {
      pair(a.left(), b, visit);
      pair(a.right(), b, visit);
    } else {
      pair(a, b.left(), visit);
      pair(a, b.right(), visit);
    }
  }

  template <class Visit>
  void across(Range a, const ChainTree& other, Range b, Visit& visit) const {
    const FloatBox& m = nodes_[a.node].box;
    const FloatBox& n = other.nodes_[b.node].box;
    if (!m.overlaps(n)) return;
    if (a.is_leaf() && b.is_leaf()) {
      visit(a.first, b.first);
    } else if (b.is_leaf() || (!a.is_leaf() && m.size() > n.size())) {
      across(a.left(), other, b, visit);
      across(a.right(), other, b, visit);
    } else {
      across(a, other, b.left(), visit);
      across(a, other, b.right(), visit);
    }
  }

  std::size_t count_;
  std::vector<Node> nodes_;
};

}  // namespace kernel
}  // namespace dobra::offset
