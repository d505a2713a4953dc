#pragma once
// The segments of one polyline under a balanced tree in the order of the line: nearest segment that satisfies a
// condition. A node is the chord of its part of the line and how far that part goes from it. On a smooth line that is a
// far narrower bound than a box, so that a query opens a few nodes a level even where a fine line is far away (boxes of
// geom::SpatialIndex open the whole stretch that is about equally near); and a query takes no memory. A caller that
// knows a near segment lets the tree only confirm it: one look at the sibling on each level. Built in O(n).

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "shared/geom/polyline.h"

namespace dobra::geom {

class SegmentTree {
 public:
  SegmentTree() = default;
  explicit SegmentTree(std::vector<Segment> segments);

  struct Nearest {
    std::size_t index = 0;
    double squared = std::numeric_limits<double>::infinity();  ///< Distance squared, m2.
    [[nodiscard]] double distance() const { return std::sqrt(squared); }
    /// Nearer, or equally near and earlier on the line: the order that makes results independent of where a search
    /// began.
    [[nodiscard]] bool before(const Nearest& other) const {
      return squared < other.squared || (squared == other.squared && index < other.index);
    }
  };

  /// The nearest segment to p for which accept(index) holds; of equally near ones the first. Nothing if none is
  /// accepted.
  template <class Accept>
  [[nodiscard]] std::optional<Nearest> nearest(Point p, Accept&& accept) const;

  /// The same where segment `known` is accepted and near: what is nearer, or `known` itself.  @pre accept(known).
  template <class Accept>
  [[nodiscard]] Nearest nearest_from(std::size_t known, Point p, Accept&& accept) const;

  [[nodiscard]] std::size_t size() const { return segments_.size(); }
  [[nodiscard]] const Segment& segment(std::size_t i) const { return segments_[i]; }
  /// Of p to segment i, m2.
  [[nodiscard]] double squared_distance(std::size_t i, Point p) const {
    return squared_distance(nodes_[leaves_ + i], p);
  }

 private:
  struct Node {
    Point from;
    Vector along;          ///< From the first point of the part to its last.
    double inverse = 0.0;  ///< 1 / |along|^2; 0 for a chord of no length.
    double reach = -1.0;   ///< Greatest distance of the part from its chord, m; negative if there are no segments.
  };
  static Node node_of(Point from, Point to);
  static double squared_distance(const Node& node, Point p) {
    const Vector d = p - node.from;
    const double t = std::clamp(dot(d, node.along) * node.inverse, 0.0, 1.0);
    const Vector rest = d - t * node.along;
    return length_squared(rest);
  }
  /// May a segment of the node be as near as `radius`? Rounded so that none at exactly that distance is passed over.
  static bool may_hold(const Node& node, Point p, double radius) {
    if (node.reach < 0.0) return false;
    const double limit = radius + node.reach;
    return squared_distance(node, p) * (1.0 - 1e-12) <= limit * limit * (1.0 + 1e-12);
  }
  template <class Accept>
  void search(std::size_t root, Point p, std::optional<Nearest>& best, Accept&& accept) const;

  std::vector<Segment> segments_;
  std::vector<Node> nodes_;  ///< Node k has the children 2k and 2k + 1; leaves_ + i is segment i.
  std::size_t leaves_ = 0;
};

template <class Accept>
std::optional<SegmentTree::Nearest> SegmentTree::nearest(Point p, Accept&& accept) const {
  std::optional<Nearest> best;
  if (segments_.empty()) return best;
  search(1, p, best, [](std::size_t) { return true; });
  if (accept(best->index)) return best;
  // Mostly a neighbour is accepted. Without that limit a search would look through whole branches in which none is.
  const std::size_t first = best->index < 2 ? 0 : best->index - 2;
  const std::size_t last = std::min(best->index + 3, segments_.size());
  best.reset();
  for (std::size_t i = first; i < last; ++i) {
    const Nearest candidate{i, squared_distance(i, p)};
    if ((!best || candidate.before(*best)) && accept(i)) best = candidate;
  }
  search(1, p, best, accept);
  return best;
}

template <class Accept>
SegmentTree::Nearest SegmentTree::nearest_from(std::size_t known, Point p, Accept&& accept) const {
  std::optional<Nearest> best = Nearest{known, squared_distance(known, p)};
  double radius = best->distance();
  for (std::size_t node = leaves_ + known; node > 1; node /= 2) {
    if (!may_hold(nodes_[node ^ 1], p, radius)) continue;
    search(node ^ 1, p, best, accept);
    radius = best->distance();
  }
  return *best;
}

template <class Accept>
void SegmentTree::search(std::size_t root, Point p, std::optional<Nearest>& best, Accept&& accept) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<std::size_t, 128> stack{};
  std::size_t depth = 0;
  stack[depth++] = root;
  double radius = best ? best->distance() : infinity;
  while (depth > 0) {
    const std::size_t node = stack[--depth];
    if (!may_hold(nodes_[node], p, radius)) continue;
    if (node >= leaves_) {
      const Nearest candidate{node - leaves_, squared_distance(nodes_[node], p)};
      if ((!best || candidate.before(*best)) && accept(candidate.index)) {
        best = candidate;
        radius = best->distance();
      }
      continue;
    }
    const std::size_t left = 2 * node;
    const bool left_first =
        nodes_[left + 1].reach < 0.0 || squared_distance(nodes_[left], p) <= squared_distance(nodes_[left + 1], p);
    stack[depth++] = left_first ? left + 1 : left;
    stack[depth++] = left_first ? left : left + 1;
  }
}

}  // namespace dobra::geom
