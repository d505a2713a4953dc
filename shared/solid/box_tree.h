#pragma once
// A tree of boxes in space over facets: which pairs come near each other, and which a line along x meets.
// Halved at the median of the longer side. Building O(n log n).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "shared/solid/soup.h"

namespace dobra::solid {

struct Box3 {
  std::array<double, 3> low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::infinity()};
  std::array<double, 3> high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()};

  void include(const Box3& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], other.low[i]);
      high[i] = std::max(high[i], other.high[i]);
    }
  }
  void grow(double by) {
    for (std::size_t i = 0; i < 3; ++i) low[i] -= by, high[i] += by;
  }
  /// Room for what rounding hides.
  void include(const Space& space, PointId p) {
    constexpr double far = std::numeric_limits<double>::infinity();
    const bool exact = space.is_exact(p);
    for (std::size_t i = 0; i < 3; ++i) {
      const double value = space.coordinate(p, static_cast<int>(i));
      low[i] = std::min(low[i], exact ? value : std::nextafter(value, -far));
      high[i] = std::max(high[i], exact ? value : std::nextafter(value, far));
    }
  }
  [[nodiscard]] bool overlaps(const Box3& other) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (low[i] > other.high[i] || other.low[i] > high[i]) return false;
    }
    return true;
  }
};

class BoxTree {
 public:
  /// Over the facets [first, end) of the soup.
  /// @param room  by how much the box of each of them is grown; empty: by nothing
  BoxTree(const Soup& soup, std::uint32_t first, std::uint32_t end, std::span<const double> room = {}) {
    std::vector<Box3> boxes(end - first);
    std::vector<Middle> middles;
    middles.reserve(end - first);
    for (std::uint32_t f = first; f < end; ++f) {
      Box3& box = boxes[f - first];
      for (const PointId p : soup.corners_of(soup.facets[f])) box.include(soup.space, p);
      if (!room.empty()) box.grow(room[f - first]);
      middles.push_back({{box.low[0] + box.high[0], box.low[1] + box.high[1], box.low[2] + box.high[2]}, f - first});
    }
    nodes_.reserve(boxes.size());
    if (!boxes.empty()) build(boxes, middles, 0, static_cast<std::uint32_t>(boxes.size()));
    items_.reserve(boxes.size());
    for (const Middle& m : middles) items_.push_back({first + m.number, boxes[m.number]});
  }

  [[nodiscard]] bool empty() const { return items_.empty(); }
  [[nodiscard]] const Box3& box() const { return nodes_[0].box; }

  /// Calls visit(f, g) for the pairs of a facet here and one there whose boxes overlap.
  template <class Visit>
  void pairs(const BoxTree& other, Visit&& visit) const {
    if (!empty() && !other.empty()) pairs(0, other, 0, visit);
  }
  /// The same within this tree, each pair once.
  template <class Visit>
  void inner_pairs(Visit&& visit) const {
    if (!empty()) inner(0, visit);
  }
  /// Calls visit(f) for the facets whose boxes `wanted(box)`; a box that holds a wanted one is wanted.
  template <class Wanted, class Visit>
  void select(Wanted&& wanted, Visit&& visit) const {
    if (!empty()) select(0, wanted, visit);
  }

 private:
  static constexpr std::uint32_t leaf_size = 4;
  struct Item {
    std::uint32_t facet;
    Box3 box;
  };
  struct Node {
    Box3 box;
    std::uint32_t first, end;
    std::uint32_t left, right;  // none in a leaf
  };

  /// Of a box, twice its middle; what is moved about while the tree is built.
  struct Middle {
    std::array<double, 3> twice;
    std::uint32_t number;
  };

  std::uint32_t build(const std::vector<Box3>& boxes, std::vector<Middle>& middles, std::uint32_t first,
                      std::uint32_t end) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, first, end, none, none});
    Box3 box;
    for (std::uint32_t i = first; i < end; ++i) box.include(boxes[middles[i].number]);
    nodes_[index].box = box;
    if (end - first <= leaf_size) return index;
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (box.high[i] - box.low[i] > box.high[axis] - box.low[axis]) axis = i;
    }
    const std::uint32_t half = (first + end) / 2;
    std::nth_element(middles.begin() + first, middles.begin() + half, middles.begin() + end,
                     [&](const Middle& a, const Middle& b) {
                       return a.twice[axis] != b.twice[axis] ? a.twice[axis] < b.twice[axis] : a.number < b.number;
                     });
    const std::uint32_t left = build(boxes, middles, first, half);
    const std::uint32_t right = build(boxes, middles, half, end);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
  }

  template <class Visit>
  void pairs(std::uint32_t own, const BoxTree& other, std::uint32_t theirs, Visit& visit) const {
    const Node& a = nodes_[own];
    const Node& b = other.nodes_[theirs];
    if (!a.box.overlaps(b.box)) return;
    if (a.left == none && b.left == none) {
      for (std::uint32_t i = a.first; i < a.end; ++i) {
        for (std::uint32_t j = b.first; j < b.end; ++j) {
          if (items_[i].box.overlaps(other.items_[j].box)) visit(items_[i].facet, other.items_[j].facet);
        }
      }
    } else if (b.left == none || (a.left != none && a.end - a.first >= b.end - b.first)) {
      pairs(a.left, other, theirs, visit);
      pairs(a.right, other, theirs, visit);
    } else {
      pairs(own, other, b.left, visit);
      pairs(own, other, b.right, visit);
    }
  }

  template <class Visit>
  void inner(std::uint32_t own, Visit& visit) const {
    const Node& node = nodes_[own];
    if (node.left == none) {
      for (std::uint32_t i = node.first; i < node.end; ++i) {
        for (std::uint32_t j = i + 1; j < node.end; ++j) {
          if (items_[i].box.overlaps(items_[j].box)) visit(items_[i].facet, items_[j].facet);
        }
      }
      return;
    }
    inner(node.left, visit);
    inner(node.right, visit);
    pairs(node.left, *this, node.right, visit);
  }

  template <class Wanted, class Visit>
  void select(std::uint32_t own, Wanted& wanted, Visit& visit) const {
    const Node& node = nodes_[own];
    if (!wanted(node.box)) return;
    if (node.left == none) {
      for (std::uint32_t i = node.first; i < node.end; ++i) {
        if (wanted(items_[i].box)) visit(items_[i].facet);
      }
      return;
    }
    select(node.left, wanted, visit);
    select(node.right, wanted, visit);
  }

  std::vector<Item> items_;
  std::vector<Node> nodes_;
};

}  // namespace dobra::solid
