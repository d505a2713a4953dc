#pragma once
// A static index over boxes: which items overlap a box, which is nearest to a point, which pairs overlap.
// Packed R-tree filled by sort-tile-recursive, in flat arrays; built once, then only read (from any number of threads).
// Page: docs/algorithms/spatial_index.md. Source: [leutenegger1997str], [hjaltason1999browsing].

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "shared/geom/box.h"

namespace dobra::geom {

/// What the visitor of a query wants next.
enum class Visit { Continue, Stop };

class SpatialIndex {
 public:
  struct Nearest {
    std::size_t item;
    double distance;
  };

  SpatialIndex() = default;
  /// Item i has boxes[i]; empty boxes are never found.  @cost O(n log n).
  explicit SpatialIndex(std::span<const Box> boxes);

  [[nodiscard]] std::size_t size() const { return item_count_; }
  /// Box of all items.
  [[nodiscard]] Box box() const { return nodes_.empty() ? Box{} : nodes_.back().box; }

  /// Calls visitor(item) for every item whose closed box overlaps `query`, in the order of the tree: the same for the
  /// same boxes, but not by number. The visitor returns nothing, or Visit.  @cost O(log n + found) for boxes that
  /// overlap little.
  template <std::invocable<std::size_t> Visitor>
  void for_each_overlapping(const Box& query, Visitor&& visitor) const {
    if (nodes_.empty()) return;
    std::vector<std::uint32_t> open{root()};
    while (!open.empty()) {
      const Node node = nodes_[open.back()];
      open.pop_back();
      if (!node.box.overlaps(query)) continue;
      if (node.count == 0) {
        if (call(visitor, node.first) == Visit::Stop) return;
        continue;
      }
      for (std::uint32_t i = node.count; i-- > 0;) open.push_back(node.first + i);
    }
  }

  /// Numbers of those items in ascending order.
  [[nodiscard]] std::vector<std::size_t> overlapping(const Box& query) const;

  /// All pairs i < j whose closed boxes overlap, in ascending order.  @cost O(n log n + pairs log pairs) as above.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> overlapping_pairs() const;

  /// The item with the least distance(item) not above `limit`; the lowest number among equals; nothing if there is
  /// none.
  /// @param distance  exact distance from p to an item, not below the distance to its box but for rounding.
  /// @cost            O(log n) calls for items that are spread out.
  template <std::invocable<std::size_t> Distance>
  [[nodiscard]] std::optional<Nearest> nearest(Point p, Distance&& distance,
                                               double limit = std::numeric_limits<double>::infinity()) const {
    struct Open {
      double bound;
      std::uint32_t node;
      bool operator<(const Open& other) const { return std::pair{bound, node} > std::pair{other.bound, other.node}; }
    };
    std::optional<Nearest> best;
    std::priority_queue<Open> open;
    if (!nodes_.empty()) open.push({bound(nodes_[root()].box, p), root()});
    while (!open.empty()) {
      const Open next = open.top();
      open.pop();
      if (next.bound > (best ? best->distance : limit)) break;
      const Node node = nodes_[next.node];
      for (std::uint32_t i = 0; i < node.count; ++i) {
        open.push({bound(nodes_[node.first + i].box, p), node.first + i});
      }
      if (node.count > 0) continue;
      const Nearest candidate{node.first, distance(static_cast<std::size_t>(node.first))};
      if (!(candidate.distance <= limit)) continue;
      if (!best || std::pair{candidate.distance, candidate.item} < std::pair{best->distance, best->item}) {
        best = candidate;
      }
    }
    return best;
  }

 private:
  struct Node {
    Box box;
    std::uint32_t first;  // first child node; the item for a leaf
    std::uint32_t count;  // children; 0 for a leaf
  };

  [[nodiscard]] std::uint32_t root() const { return static_cast<std::uint32_t>(nodes_.size() - 1); }
  /// Distance from p to the box, less what rounding may have added to it.
  static double bound(const Box& box, Point p);
  template <class Visitor>
  static Visit call(Visitor& visitor, std::size_t item) {
    if constexpr (std::is_void_v<std::invoke_result_t<Visitor&, std::size_t>>) {
      visitor(item);
      return Visit::Continue;
    } else {
      return visitor(item);
    }
  }

  std::vector<Node> nodes_;  // level by level, leaves first, the root last
  std::size_t item_count_ = 0;
};

}  // namespace dobra::geom
