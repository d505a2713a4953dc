#include "recon/core/segment_tree.h"

#include <algorithm>
#include <bit>

namespace recon::core {

SegmentTree::Node SegmentTree::node_of(dobra::geom::Point from, dobra::geom::Point to) {
  Node node;
  node.from = from;
  node.along = to - from;
  const double squared = dobra::geom::length_squared(node.along);
  node.inverse = squared > 0.0 ? 1.0 / squared : 0.0;
  node.reach = 0.0;
  return node;
}

SegmentTree::SegmentTree(std::vector<dobra::geom::Segment> segments)
    : segments_(std::move(segments)), leaves_(std::bit_ceil(segments_.size())) {
  if (segments_.empty()) return;
  nodes_.resize(2 * leaves_);
  for (std::size_t width = leaves_, node = 1; width > 0; width /= 2) {
    for (std::size_t first = 0; first < leaves_; first += width, ++node) {
      const std::size_t end = std::min(first + width, segments_.size());
      if (first >= end) continue;
      nodes_[node] = node_of(segments_[first].from, segments_[end - 1].to);
      // The distance to a chord is convex along a segment, so its ends are the farthest points.
      double squared = 0.0;
      for (std::size_t i = first; i + 1 < end; ++i)
        squared = std::max(squared, squared_distance(nodes_[node], segments_[i].to));
      nodes_[node].reach = std::sqrt(squared);
    }
  }
}

}  // namespace recon::core
