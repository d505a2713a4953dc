#pragma once
// Finds the pairs of pieces of a chain that may meet. A tree of boxes over the chain in its own order; each node also knows the
// directions that occur in it, as 64 bits of 5.6 degrees: a connected part whose directions fit in an open half-plane cannot
// meet itself, so that smooth curves are dismissed near the root. Source: [volino1994collision] (normal cones).

#include <functional>
#include <vector>

#include "shared/offset/real.h"

namespace dobra::offset {

class ChainTree {
 public:
  struct Item {
    Flat low, high;             ///< Box.
    std::uint64_t directions;   ///< See directions_of.
    bool linked;                ///< Starts where the item before ends.
  };
  /// The bits of all directions from u anticlockwise to v, less than half a turn, with a bit to spare on both sides.
  static std::uint64_t directions_of(Flat u, Flat v);

  /// @param item  the i-th item. @cost O(n).
  ChainTree(std::size_t count, const std::function<Item(std::size_t)>& item, double margin);

  /// Calls visit(i, j), i < j, for all pairs of items with boxes nearer than the margin, but for linked neighbours and for
  /// parts that cannot meet by their directions.
  void for_each_pair(const std::function<void(std::size_t, std::size_t)>& visit) const;

 private:
  static constexpr std::size_t leaf_size = 8;
  struct Node {
    float low_x, low_y, high_x, high_y;
    std::uint64_t directions = 0;
    bool connected = true;    // all items in it but the first are linked to the one before
    bool linked = false;      // its first item is
  };
  struct Box {
    float low_x, low_y, high_x, high_y;
  };
  void self(std::size_t node, std::size_t size, const std::function<void(std::size_t, std::size_t)>& visit) const;
  void pair(std::size_t a, std::size_t b, const std::function<void(std::size_t, std::size_t)>& visit) const;
  void items(std::size_t a, std::size_t b, const std::function<void(std::size_t, std::size_t)>& visit) const;
  [[nodiscard]] bool is_leaf(std::size_t node) const { return node >= leaves_; }
  [[nodiscard]] bool follows(std::size_t a, std::size_t b) const;

  std::size_t count_;
  std::size_t leaves_ = 1;  // a power of two
  std::vector<Node> nodes_;  // heap order
  std::vector<Box> boxes_;
  std::vector<bool> linked_;
};

}  // namespace dobra::offset
