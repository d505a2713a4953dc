#pragma once
// The segments of one polyline under a balanced tree in the order of the line: nearest segment that satisfies a
// condition. A node is the chord of its part of the line and how far that part goes from it. On a smooth line that is a
// far narrower bound than a box, so that a query opens a few nodes a level even where a fine line is far away (boxes of
// geom::SpatialIndex open the whole stretch that is about equally near); and a query takes no memory. Built in O(n log
// n).

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "shared/geom/polyline.h"

namespace recon::core {

class SegmentTree {
 public:
  SegmentTree() = default;
  explicit SegmentTree(std::vector<dobra::geom::Segment> segments);

  struct Nearest {
    std::size_t index = 0;
    double distance = std::numeric_limits<double>::infinity();
  };

  /// The nearest segment to p for which accept(index) holds; of equally near ones the first. Nothing if none is
  /// accepted.
  template <class Accept>
  [[nodiscard]] std::optional<Nearest> nearest(dobra::geom::Point p, Accept&& accept) const;

  [[nodiscard]] std::size_t size() const { return segments_.size(); }
  [[nodiscard]] const dobra::geom::Segment& segment(std::size_t i) const { return segments_[i]; }

 private:
  struct Node {
    dobra::geom::Segment chord;
    double reach = -1.0;  ///< Greatest distance of the part from its chord, m; negative if there are no segments.
  };
  template <class Accept>
  void search(dobra::geom::Point p, std::optional<Nearest>& best, Accept&& accept) const;
  /// Not above the distance from p to any segment of the node.
  static double gap(const Node& node, dobra::geom::Point p);

  std::vector<dobra::geom::Segment> segments_;
  std::vector<Node> nodes_;  ///< Node k has the children 2k and 2k + 1; leaves_ + i is segment i.
  std::size_t leaves_ = 0;
};

template <class Accept>
std::optional<SegmentTree::Nearest> SegmentTree::nearest(dobra::geom::Point p, Accept&& accept) const {
  std::optional<Nearest> best;
  search(p, best, [](std::size_t) { return true; });
  if (!best || accept(best->index)) return best;
  // Mostly a neighbour is accepted. Without that limit a search would look through whole branches in which none is.
  const std::size_t first = best->index < 2 ? 0 : best->index - 2;
  const std::size_t last = std::min(best->index + 3, segments_.size());
  best.reset();
  for (std::size_t i = first; i < last; ++i) {
    const double distance = dobra::geom::distance(segments_[i], p);
    if ((!best || distance < best->distance) && accept(i)) best = Nearest{i, distance};
  }
  search(p, best, accept);
  // The caller may take note in accept(): the last one that it accepts is the one returned.
  if (best) accept(best->index);
  return best;
}

template <class Accept>
void SegmentTree::search(dobra::geom::Point p, std::optional<Nearest>& best, Accept&& accept) const {
  if (segments_.empty()) return;
  std::array<std::size_t, 128> stack{};
  std::size_t depth = 0;
  stack[depth++] = 1;
  while (depth > 0) {
    const std::size_t node = stack[--depth];
    if (best && gap(nodes_[node], p) > best->distance) continue;
    if (node >= leaves_) {
      const std::size_t index = node - leaves_;
      if (index >= segments_.size()) continue;
      const double distance = dobra::geom::distance(segments_[index], p);
      const bool nearer = !best || distance < best->distance || (distance == best->distance && index < best->index);
      if (nearer && accept(index)) best = Nearest{index, distance};
      continue;
    }
    const std::size_t left = 2 * node;
    const bool left_first = gap(nodes_[left], p) <= gap(nodes_[left + 1], p);
    stack[depth++] = left_first ? left + 1 : left;
    stack[depth++] = left_first ? left : left + 1;
  }
}

}  // namespace recon::core
