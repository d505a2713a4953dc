#include "recon/section/stretches.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>

#include "shared/base/parallel.h"
#include "shared/geom/spatial_index.h"

namespace recon::section {

namespace {

/// Parts nearer than this are not apart: far more than all rounding, here and in the subdivision, where vertices draw
/// to themselves what passes within 2^-51 of the greatest coordinate, and more where rounding lets much cross.
/// Infinite where squares of coordinates leave the range of doubles.
double margin_for(double greatest) {
  return greatest > 0x1p-200 && greatest < 0x1p200 ? 0x1p-32 * greatest : std::numeric_limits<double>::infinity();
}

std::uint8_t runs_of(geom::Vector v) {
  return static_cast<std::uint8_t>((v.x > 0.0 ? 1 : 0) + (v.x < 0.0 ? 2 : 0) + (v.y > 0.0 ? 4 : 0) +
                                   (v.y < 0.0 ? 8 : 0));
}

}  // namespace

Stretches::Tree Stretches::tree_of(const geom::Polyline& line) {
  Tree tree;
  const std::vector<geom::Point>& points = line.points;
  tree.segments = static_cast<std::uint32_t>(line.segment_count());
  tree.closed = line.closed;
  if (tree.segments == 0) return tree;
  tree.leaves = std::bit_ceil((tree.segments + leaf_size - 1) / leaf_size);
  tree.nodes.resize(2 * tree.leaves);
  const auto chord = [&](Node& node, std::size_t first, std::size_t last) {
    node.first = static_cast<std::uint32_t>(first);
    node.last = static_cast<std::uint32_t>(last);
    node.from = points[first];
    node.to = points[last == points.size() ? 0 : last];
    node.length = geom::distance(node.from, node.to);
  };
  for (std::size_t leaf = 0; leaf * leaf_size < tree.segments; ++leaf) {
    Node& node = tree.nodes[tree.leaves + leaf];
    const std::size_t last = std::min<std::size_t>((leaf + 1) * leaf_size, tree.segments);
    chord(node, leaf * leaf_size, last);
    node.runs = 15;
    node.box.add(node.from);
    const geom::Segment whole{node.from, node.to};
    double farthest = 0.0;
    for (std::size_t i = node.first; i < last; ++i) {
      const geom::Segment segment = line.segment(i);
      node.box.add(segment.to);
      node.runs &= runs_of(segment.vector());
      const geom::Point near = geom::interpolate(node.from, node.to, geom::nearest_fraction(whole, segment.to));
      farthest = std::max(farthest, geom::length_squared(segment.to - near));
    }
    node.reach = std::sqrt(farthest);
  }
  for (std::size_t k = tree.leaves; k-- > 1;) {
    const Node& left = tree.nodes[2 * k];
    const Node& right = tree.nodes[2 * k + 1];
    Node& node = tree.nodes[k];
    if (left.last == 0) continue;
    if (right.last == 0) {
      node = left;
      continue;
    }
    chord(node, left.first, right.last);
    node.box = left.box;
    node.box.add(right.box);
    node.runs = left.runs & right.runs;
    // The distance to a chord is convex along another chord; both chords begin or end with this one.
    node.reach = geom::distance(geom::Segment{node.from, node.to}, right.from) + std::max(left.reach, right.reach);
  }
  return tree;
}

namespace {

/// In the frame of a chord: does the other part lie beside it or beyond an end, `room` away from the chord?
bool lies_off(geom::Point from, geom::Point to, double length, geom::Point p, geom::Point q, double room) {
  const geom::Vector u = to - from;
  const double across_p = geom::cross(u, p - from);
  const double across_q = geom::cross(u, q - from);
  const double far = room * length;
  if (std::min(across_p, across_q) > far || std::max(across_p, across_q) < -far) return true;
  const double along_p = geom::dot(u, p - from);
  const double along_q = geom::dot(u, q - from);
  return std::min(along_p, along_q) > far + length * length || std::max(along_p, along_q) < -far;
}

}  // namespace

void Stretches::cut_within(Tree& tree, std::size_t node, double margin) {
  if (tree.nodes[node].last == 0 || tree.nodes[node].runs != 0) return;
  tree.nodes[node].cut = true;
  if (tree.is_leaf(node)) return;
  cut_within(tree, 2 * node, margin);
  cut_within(tree, 2 * node + 1, margin);
  cut_between(tree, 2 * node, tree, 2 * node + 1, margin);
}

void Stretches::cut_between(Tree& a, std::size_t in_a, Tree& b, std::size_t in_b, double margin) {
  Node& one = a.nodes[in_a];
  Node& other = b.nodes[in_b];
  if (!one.box.grown(margin).overlaps(other.box)) return;  // also where a half has no segments
  const auto follows = [](const Tree& tree, const Node& before, const Node& after) {
    return before.last == after.first || (tree.closed && before.last == tree.segments && after.first == 0);
  };
  if (&a == &b && (follows(a, one, other) || follows(a, other, one))) {
    if ((one.runs & other.runs) != 0) return;
  } else {
    const double room = one.reach + other.reach + margin;
    if (lies_off(one.from, one.to, one.length, other.from, other.to, room) ||
        lies_off(other.from, other.to, other.length, one.from, one.to, room)) {
      return;
    }
  }
  if (a.is_leaf(in_a) && b.is_leaf(in_b)) {
    one.cut = other.cut = true;
    return;
  }
  const bool into_one = b.is_leaf(in_b) || (!a.is_leaf(in_a) && one.length + one.reach >= other.length + other.reach);
  if (into_one) {
    one.cut = true;
    cut_between(a, 2 * in_a, b, in_b, margin);
    cut_between(a, 2 * in_a + 1, b, in_b, margin);
  } else {
    other.cut = true;
    cut_between(a, in_a, b, 2 * in_b, margin);
    cut_between(a, in_a, b, 2 * in_b + 1, margin);
  }
}

void Stretches::add(std::span<const geom::Polyline> lines) {
  const std::size_t old = trees_.size();
  std::vector<Tree> made =
      dobra::base::parallel_map<Tree>(lines.size(), [&](std::size_t i) { return tree_of(lines[i]); });
  std::move(made.begin(), made.end(), std::back_inserter(trees_));
  std::vector<geom::Box> boxes;
  for (const Tree& tree : trees_) {
    boxes.push_back(tree.segments == 0 ? geom::Box{} : tree.nodes[1].box);
    if (boxes.back().empty()) continue;
    const auto [low, high] = boxes.back();
    greatest_ = std::max({greatest_, std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
  }
  const double margin = margin_for(greatest_);
  if (!std::isfinite(margin)) return cut_all();
  for (geom::Box& box : boxes) {
    if (!box.empty()) box = box.grown(margin);
  }
  for (std::size_t i = old; i < trees_.size(); ++i) {
    if (trees_[i].segments > 0) cut_within(trees_[i], 1, margin);
  }
  for (const auto& [i, j] : geom::SpatialIndex(boxes).overlapping_pairs()) {
    if (j >= old) cut_between(trees_[i], 1, trees_[j], 1, margin);
  }
}

void Stretches::cut_all() {
  for (Tree& tree : trees_) {
    for (Node& node : tree.nodes) node.cut = true;
  }
}

void Stretches::collect(const Tree& tree, std::size_t node, std::vector<Stretch>& stretches) {
  const Node& part = tree.nodes[node];
  if (part.last == 0) return;
  if (!part.cut) {
    stretches.push_back({part.first, part.last});
  } else if (!tree.is_leaf(node)) {
    collect(tree, 2 * node, stretches);
    collect(tree, 2 * node + 1, stretches);
  } else {
    for (std::uint32_t i = part.first; i < part.last; ++i) stretches.push_back({i, i + 1});
  }
}

std::vector<Stretch> Stretches::of(std::size_t line) const {
  std::vector<Stretch> stretches;
  if (trees_[line].segments > 0) collect(trees_[line], 1, stretches);
  return stretches;
}

}  // namespace recon::section
