#pragma once
// A tree of boxes over items in a row, four children a node, so that one node fills a line of the cache and is tested
// at once. Neighbours in a chain are neighbours in space: nothing is sorted. The searches are in box_tree_search.h.

#include <algorithm>
#include <vector>

#include "shared/offset/kernel/float_box.h"

namespace dobra::offset {
inline namespace kernel {

class BoxTree {
 public:
  static constexpr std::size_t width = 4;

  BoxTree() = default;
  /// @param boxes  at least one.  @cost O(n), 21 bytes a box.
  explicit BoxTree(const std::vector<FloatBox>& boxes);

  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] FloatBox box(std::size_t item) const { return child(levels_[0].first + item / width, item % width); }

  /// Items whose boxes may come within `reach` of q, until visit(item) returns true; of the children of a node the
  /// nearest first.
  template <class Visit>
  bool any_within(Flat q, double reach, Visit&& visit) const;
  /// Items whose boxes, and those of the nodes above, pass holds(box), until visit(item) returns true.
  template <class Holds, class Visit>
  bool any_held(const Holds& holds, Visit&& visit) const;
  /// The same, beginning with those next to an item: what is near is found soon. Not the item itself, nor those of its
  /// node.
  template <class Holds, class Visit>
  bool any_held_from(std::size_t item, const Holds& holds, Visit&& visit) const;
  /// Items whose box, grown by d times that of another tree over as many items, may hold q, until visit(item) returns
  /// true.
  template <class Visit>
  bool any_held(const BoxTree& other, Flat q, double d, Visit&& visit) const;

 private:
  using Four = float __attribute__((vector_size(16)));
  struct Node {
    Four low_x, low_y, high_x, high_y;
  };
  struct Level {
    std::size_t first;  ///< Its first node.
    std::size_t items;  ///< Children of all its nodes.
  };
  struct Open {
    std::size_t level, node;  ///< The node counts from the first of its level.
  };
  static constexpr std::size_t deepest = 3 * 32;  // of what is open: three brothers a level

  [[nodiscard]] FloatBox child(std::size_t node, std::size_t k) const {
    const Node& n = nodes_[node];
    FloatBox box;
    box.low_x = n.low_x[k];
    box.low_y = n.low_y[k];
    box.high_x = n.high_x[k];
    box.high_y = n.high_y[k];
    return box;
  }
  [[nodiscard]] std::size_t children(Open at) const {
    return std::min(width, levels_[at.level].items - width * at.node);
  }
  template <class Holds, class Visit>
  bool any_below(Open top, const Holds& holds, Visit& visit) const;

  float greatest_ = 0;  // coordinate of a box
  std::vector<Node> nodes_;
  std::vector<Level> levels_;  // from the items up
};

}  // namespace kernel
}  // namespace dobra::offset
