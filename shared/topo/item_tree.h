#pragma once
// Where things are, while they come and go: a loose quadtree over numbered boxes that grows and splits as needed.
// A box sits in the cell that holds its centre, at a level whose cells are at least as large as the box, so that it
// lies within twice that cell. Unlike a grid it needs no cell size, hence works at any scale and mixture of sizes.
// Source: [ulrich2000loose].

#include <cstdint>
#include <vector>

#include "shared/geom/box.h"
#include "shared/geom/segment.h"

namespace dobra::topo {

class ItemTree {
 public:
  /// @pre `item` is not in the tree; the box is finite.  @cost O(depth), depth about log of (extent / spacing).
  void insert(std::uint32_t item, const geom::Box& box);
  void erase(std::uint32_t item);

  /// Calls visit(item) for every item whose box overlaps `box`. The tree must not change meanwhile.
  template <class Visit>
  void visit(const geom::Box& box, Visit&& visit) const {
    if (root_ != none) walk(root_, [&](const geom::Box& cell) { return cell.overlaps(box); }, visit);
  }
  /// Calls visit(item) for every item whose box meets `segment` (a few that only come near it are given too).
  template <class Visit>
  void visit(const geom::Segment& segment, Visit&& visit) const {
    const geom::Box box = segment.box();
    const auto meets = [&](const geom::Box& cell) { return cell.overlaps(box) && near_line(segment, cell); };
    if (root_ != none) walk(root_, meets, visit);
  }
  /// Calls limit = visit(item) for items whose box meets the upward ray from p below height `limit`, lower cells first.
  template <class Visit>
  void visit_above(geom::Point p, double limit, Visit&& visit) const {
    if (root_ != none) climb(root_, p, limit, visit);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  struct Node {
    geom::Point centre;
    double half = 0.0;
    std::uint32_t parent = none;
    std::uint32_t child[4] = {none, none, none, none};
    std::uint32_t first = none;   ///< Head of the list of items kept here.
    std::uint32_t kept = 0;       ///< Items kept here.
    std::uint32_t total = 0;      ///< Items kept here and below.
    bool split = false;
    [[nodiscard]] geom::Box loose() const {
      return {{centre.x - 2.0 * half, centre.y - 2.0 * half}, {centre.x + 2.0 * half, centre.y + 2.0 * half}};
    }
  };
  struct Item {
    geom::Box box;
    std::uint32_t node = none;
    std::uint32_t next = none;
    std::uint32_t previous = none;
  };

  static bool near_line(const geom::Segment& segment, const geom::Box& cell);
  void grow(const geom::Box& box);
  std::uint32_t descend(std::uint32_t node, const geom::Box& box);
  void place(std::uint32_t node, std::uint32_t item);
  void unplace(std::uint32_t item);
  void split(std::uint32_t node);

  template <class Meets, class Visit>
  void walk(std::uint32_t at, const Meets& meets, Visit& visit) const {
    const Node& node = nodes_[at];
    if (node.total == 0 || !meets(node.loose())) return;
    for (std::uint32_t i = node.first; i != none; i = items_[i].next) {
      if (meets(items_[i].box)) visit(i);
    }
    for (const std::uint32_t child : node.child) {
      if (child != none) walk(child, meets, visit);
    }
  }
  template <class Visit>
  void climb(std::uint32_t at, geom::Point p, double& limit, Visit& visit) const {
    const Node& node = nodes_[at];
    const geom::Box loose = node.loose();
    if (node.total == 0 || p.x < loose.low.x || p.x > loose.high.x || loose.high.y < p.y || loose.low.y > limit) return;
    for (std::uint32_t i = node.first; i != none; i = items_[i].next) {
      const geom::Box& box = items_[i].box;
      if (box.low.x <= p.x && p.x <= box.high.x && box.high.y >= p.y && box.low.y <= limit) limit = visit(i);
    }
    for (const int quarter : {0, 1, 2, 3}) {  // 0 and 1 are the lower two
      if (node.child[quarter] != none) climb(node.child[quarter], p, limit, visit);
    }
  }

  std::vector<Node> nodes_;
  std::vector<Item> items_;
  std::uint32_t root_ = none;
};

}  // namespace dobra::topo
