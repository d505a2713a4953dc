#pragma once
// Quadtrees and octrees as sets: a box is empty, full, or cut into 2^D equal ones, down to a depth at which what is
// neither is `partial`. Numbers are exact as long as halves of the box are. Page: docs/algorithms/partition.md.
// Source: [samet1984quadtree].

#include <array>
#include <cstdint>
#include <vector>

#include "shared/base/check.h"

namespace dobra::solid::partition {

enum class Fill : std::uint8_t {
  Empty,
  Full,
  Partial,  ///< The boundary passes; how much is full is not known.
  Split     ///< Has children.
};

enum class SetOperation : std::uint8_t { Union, Intersection, Difference };

/// Of two parts of space that are both homogeneous or partial.
Fill combined(Fill a, Fill b, SetOperation operation);

template <std::size_t D>
struct Box {
  std::array<double, D> low{}, high{};
  friend bool operator==(const Box&, const Box&) = default;
};

/// A volume is between these.
struct Bounds {
  double low = 0.0, high = 0.0;
};

template <std::size_t D>
class Orthtree {
 public:
  static constexpr std::uint32_t children = 1U << D;
  static constexpr std::uint32_t none = 0xffffffffU;
  using Node = std::uint32_t;

  /// One leaf. @pre the box has a volume
  explicit Orthtree(const Box<D>& box, Fill fill = Fill::Empty) : box_(box) {
    nodes_.push_back({fill, 0, none, none, {}});
  }

  /// From the top down. @param fill  says what a box is, Empty, Full or Partial; what is partial is cut again until the
  /// depth is reached.
  template <class FillOf>
  static Orthtree from_top(const Box<D>& box, int depth, FillOf&& fill) {
    Orthtree tree(box);
    tree.build(0, depth, fill);
    return tree;
  }
  /// From the bottom up: 2^depth leaves a side, merged where all children are alike.
  /// @param fill  of the leaf with these numbers along the axes.
  template <class FillAt>
  static Orthtree from_bottom(const Box<D>& box, int depth, FillAt&& fill) {
    Orthtree tree(box);
    tree.gather(0, depth, fill);
    return tree;
  }

  [[nodiscard]] const Box<D>& box() const { return box_; }
  [[nodiscard]] Box<D> box(Node n) const;
  [[nodiscard]] Fill fill(Node n) const { return nodes_[n].fill; }
  [[nodiscard]] int level(Node n) const { return nodes_[n].level; }
  /// Child i is in the upper half along axis k if bit k of i is set.
  [[nodiscard]] Node child(Node n, std::uint32_t i) const { return nodes_[n].first_child + i; }
  [[nodiscard]] bool is_leaf(Node n) const { return nodes_[n].fill != Fill::Split; }
  [[nodiscard]] std::size_t node_count() const { return nodes_.size(); }
  /// In depth-first order.
  [[nodiscard]] std::vector<Node> leaves() const;
  [[nodiscard]] std::size_t count(Fill fill) const;

  /// The leaf that holds a point of the box; of several the one in the upper half.  @cost O(depth)
  [[nodiscard]] Node leaf_at(const std::array<double, D>& p) const;
  /// The node of the same size beside it, or a greater leaf there; none outside. It is found by way of the common
  /// ancestor.  @param way  -1, 0 or 1 along each axis.  @cost O(depth)
  [[nodiscard]] Node beside(Node n, const std::array<int, D>& way) const;
  /// All leaves that touch a node in a side, an edge or a corner, ascending.
  [[nodiscard]] std::vector<Node> neighbours(Node n) const;

  /// Of what is full, and with what is partial.
  [[nodiscard]] Bounds volume() const;

  /// By walking both at once; children that become alike are merged.  @pre equal boxes  @cost O(nodes of both)
  friend Orthtree combine(const Orthtree& a, const Orthtree& b, SetOperation operation) {
    DOBRA_CHECK(a.box_ == b.box_);
    Orthtree tree(a.box_);
    tree.merge_in(0, a, 0, b, 0, operation);
    return tree;
  }
  /// Equal leaves in equal places.
  friend bool operator==(const Orthtree& a, const Orthtree& b) { return a.box_ == b.box_ && a.alike(0, b, 0); }

 private:
  struct Record {
    Fill fill;
    std::uint8_t level;
    Node parent, first_child;
    std::array<std::uint32_t, D> at;  // among the nodes of its level
  };

  [[nodiscard]] double size(std::size_t axis) const { return box_.high[axis] - box_.low[axis]; }
  void split(Node n);
  void settle(Node n);
  void copy(Node n, const Orthtree& other, Node from, bool turned);
  [[nodiscard]] bool alike(Node n, const Orthtree& other, Node m) const;
  void collect(Node n, const std::array<int, D>& way, std::vector<Node>& found) const;
  void merge_in(Node n, const Orthtree& a, Node from_a, const Orthtree& b, Node from_b, SetOperation operation);

  template <class FillOf>
  void build(Node n, int depth, FillOf& fill) {
    nodes_[n].fill = fill(box(n));
    if (nodes_[n].fill != Fill::Partial || depth == 0) return;
    split(n);
    for (std::uint32_t i = 0; i < children; ++i) build(child(n, i), depth - 1, fill);
    settle(n);
  }
  template <class FillAt>
  void gather(Node n, int depth, FillAt& fill) {
    if (depth == 0) {
      nodes_[n].fill = fill(nodes_[n].at);
      return;
    }
    split(n);
    for (std::uint32_t i = 0; i < children; ++i) gather(child(n, i), depth - 1, fill);
    settle(n);
  }

  Box<D> box_;
  std::vector<Record> nodes_;
};

extern template class Orthtree<2>;
extern template class Orthtree<3>;
using Quadtree = Orthtree<2>;
using Octree = Orthtree<3>;

}  // namespace dobra::solid::partition
