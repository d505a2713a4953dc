#pragma once
// Where segments are, while they come and go: a loose quadtree over numbered segments (points are segments of length 0)
// that grows and splits as needed. A segment sits in the cell that holds its centre, at a level whose cells are at
// least as large as its box. Unlike a grid it needs no cell size, hence works at any scale and mixture of sizes. Every
// cell also knows the box of what it holds, which on curves is far smaller than the cell. Source: [ulrich2000loose].

#include <cmath>
#include <cstdint>
#include <vector>

#include "shared/geom/box.h"
#include "shared/geom/segment.h"

namespace dobra::topo {

class ItemTree {
 public:
  /// @pre `item` is not in the tree; the segment is finite.  @cost O(depth), depth about log of (extent / spacing).
  void insert(std::uint32_t item, const geom::Segment& segment);
  void erase(std::uint32_t item);

  /// Calls visit(item, segment) for every item whose box overlaps `box`. The tree must not change meanwhile.
  template <class Visit>
  void visit(const geom::Box& box, Visit&& visit) const {
    if (root_ != none)
      walk(
          root_, [&](const geom::Box& other) { return other.overlaps(box); }, visit);
  }
  /// The same for every item whose box comes within `margin` of `near` (a few that are a little farther are given too).
  template <class Visit>
  void visit(const geom::Segment& near, double margin, Visit&& visit) const {
    const Strip strip(near, margin);
    if (root_ != none)
      walk(
          root_, [&](const geom::Box& other) { return strip.meets(other); }, visit);
  }
  /// Calls limit = visit(item, segment) for items whose box meets the upward ray from p below height `limit`, lower
  /// cells first.
  template <class Visit>
  void visit_above(geom::Point p, double limit, Visit&& visit) const {
    if (root_ != none) climb(root_, p, limit, visit);
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  struct Node {
    geom::Box bounds;            ///< Of all items kept here and below, and perhaps of some that are gone.
    std::uint32_t child = none;  ///< The first of four in a row: lower left, lower right, upper left, upper right.
    std::uint32_t first = none;  ///< Head of the list of items kept here.
    std::uint32_t kept = 0;
  };
  struct Item {
    geom::Segment segment;
    std::uint32_t node = none;
    std::uint32_t next = none;
    std::uint32_t previous = none;
  };
  /// The square of a node; only known on the way down.
  struct Cell {
    geom::Point centre;
    double half = 0.0;
    [[nodiscard]] int quarter(geom::Point p) const { return (p.x >= centre.x ? 1 : 0) + (p.y >= centre.y ? 2 : 0); }
    [[nodiscard]] Cell child(int quarter) const {
      const double h = 0.5 * half;
      return {{centre.x + (quarter % 2 == 1 ? h : -h), centre.y + (quarter / 2 == 1 ? h : -h)}, h};
    }
  };
  /// All that is near a segment.
  class Strip {
   public:
    Strip(const geom::Segment& s, double margin);
    /// Comparisons are such that an overflow counts as near.
    [[nodiscard]] bool meets(const geom::Box& other) const {
      if (!other.overlaps(box_)) return false;
      const geom::Vector to = other.centre() - from_;
      const double reach =
          0.5 * (std::abs(along_.x) * (other.high.y - other.low.y) + std::abs(along_.y) * (other.high.x - other.low.x));
      const double left = along_.x * to.y;
      const double right = along_.y * to.x;
      return !(std::abs(left - right) > reach + slack_ + 1e-12 * (std::abs(left) + std::abs(right) + reach));
    }

   private:
    geom::Box box_;
    geom::Point from_;
    geom::Vector along_;
    double slack_;
  };

  void grow(const geom::Box& box);
  void move_root_into(std::uint32_t slot);
  void place(std::uint32_t node, std::uint32_t item);
  void unplace(std::uint32_t item);
  void split(std::uint32_t node, const Cell& cell);

  template <class Meets, class Visit>
  void walk(std::uint32_t at, const Meets& meets, Visit& visit) const {
    const Node& node = nodes_[at];
    if (!meets(node.bounds)) return;
    for (std::uint32_t i = node.first; i != none; i = items_[i].next) {
      if (meets(items_[i].segment.box())) visit(i, items_[i].segment);
    }
    if (node.child == none) return;
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter) walk(node.child + quarter, meets, visit);
  }
  template <class Visit>
  void climb(std::uint32_t at, geom::Point p, double& limit, Visit& visit) const {
    const Node& node = nodes_[at];
    const auto misses = [&](const geom::Box& box) {
      return p.x < box.low.x || p.x > box.high.x || box.high.y < p.y || box.low.y > limit;
    };
    if (misses(node.bounds)) return;
    for (std::uint32_t i = node.first; i != none; i = items_[i].next) {
      if (!misses(items_[i].segment.box())) limit = visit(i, items_[i].segment);
    }
    if (node.child == none) return;
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter) climb(node.child + quarter, p, limit, visit);
  }

  std::vector<Node> nodes_;
  std::vector<Item> items_;
  std::uint32_t root_ = none;
  Cell root_cell_;
};

}  // namespace dobra::topo
