#include "shared/geom/segment_tree.h"

#include <algorithm>
#include <bit>

namespace dobra::geom {

SegmentTree::Node SegmentTree::node_of(Point from, Point to) {
  Node node;
  node.from = from;
  node.along = to - from;
  const double squared = length_squared(node.along);
  node.inverse = squared > 0.0 ? 1.0 / squared : 0.0;
  node.reach = 0.0;
  return node;
}

SegmentTree::SegmentTree(std::vector<Segment> segments)
    : segments_(std::move(segments)), leaves_(std::bit_ceil(segments_.size())) {
  if (segments_.empty()) return;
  nodes_.resize(2 * leaves_);
  for (std::size_t i = 0; i < segments_.size(); ++i) nodes_[leaves_ + i] = node_of(segments_[i].from, segments_[i].to);
  std::size_t width = 1;
  for (std::size_t level = leaves_ / 2; level > 0; level /= 2) {
    width *= 2;
    for (std::size_t first = 0, node = level; first < segments_.size(); first += width, ++node) {
      const Node& left = nodes_[2 * node];
      const Node& right = nodes_[2 * node + 1];
      const std::size_t end = std::min(first + width, segments_.size());
      nodes_[node] = node_of(segments_[first].from, segments_[end - 1].to);
      if (right.reach < 0.0) {
        nodes_[node].reach = left.reach;  // the same part under the same chord
        continue;
      }
      // The distance to a chord is convex along another chord: nothing of a child is farther than the farther end of
      // its chord and what it reaches beyond that. Both chords begin or end with this one: what is between remains.
      nodes_[node].reach = std::sqrt(squared_distance(nodes_[node], right.from)) + std::max(left.reach, right.reach);
    }
  }
}

}  // namespace dobra::geom
