#include "recon/core/segment_tree.h"

#include <algorithm>
#include <bit>

namespace recon::core {

SegmentTree::SegmentTree(std::vector<dobra::geom::Segment> segments)
    : segments_(std::move(segments)), leaves_(std::bit_ceil(segments_.size())) {
  if (segments_.empty()) return;
  nodes_.resize(2 * leaves_);
  for (std::size_t width = leaves_, node = 1; width > 0; width /= 2) {
    for (std::size_t first = 0; first < leaves_; first += width, ++node) {
      const std::size_t end = std::min(first + width, segments_.size());
      if (first >= end) continue;
      nodes_[node] = {{segments_[first].from, segments_[end - 1].to}, 0.0};
      // The distance to a chord is convex along a segment, so its ends are the farthest points.
      for (std::size_t i = first; i + 1 < end; ++i) {
        nodes_[node].reach = std::max(nodes_[node].reach, dobra::geom::distance(nodes_[node].chord, segments_[i].to));
      }
    }
  }
}

double SegmentTree::gap(const Node& node, dobra::geom::Point p) {
  if (node.reach < 0.0) return std::numeric_limits<double>::infinity();
  // Rounded down a little, so that a part is never passed over that holds a segment at exactly the limit.
  return dobra::geom::distance(node.chord, p) * (1.0 - 1e-13) - node.reach * (1.0 + 1e-13);
}

}  // namespace recon::core
