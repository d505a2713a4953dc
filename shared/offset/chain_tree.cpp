#include "shared/offset/chain_tree.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace dobra::offset {

namespace {

/// Monotone in the angle of u, 0 .. 4, anticlockwise from +x: a diamond's arc length.
double diamond_angle(Flat u) {
  const double t = u.y / (std::abs(u.x) + std::abs(u.y));
  return u.x >= 0 ? (t >= 0 ? t : 4 + t) : 2 - t;
}

/// True if some 34 of the 64 bits in a row are clear: with the spare bits the directions span less than half a turn.
/// Opposite points of the diamond are 32 bits apart, so that sectors need not be equal.
bool fits_half_plane(std::uint64_t directions) {
  std::uint64_t clear = ~directions;
  for (const int run : {1, 2, 4, 8, 16}) clear &= std::rotr(clear, run);  // then 32 in a row
  clear &= std::rotr(clear, 1);
  return clear != 0;
}

float below(double x) { return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity()); }
float above(double x) { return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity()); }

template <class A, class B>
bool overlap(const A& a, const B& b) {
  return a.low_x <= b.high_x && b.low_x <= a.high_x && a.low_y <= b.high_y && b.low_y <= a.high_y;
}

}  // namespace

std::uint64_t ChainTree::directions_of(Flat u, Flat v) {
  const auto first = static_cast<int>(diamond_angle(u) * 16) - 1;
  auto last = static_cast<int>(diamond_angle(v) * 16) + 1;
  if (last < first) last += 64;
  const int width = std::min(64, last - first + 1);
  const std::uint64_t bits = width >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
  return std::rotl(bits, (first + 64) % 64);
}

ChainTree::ChainTree(std::size_t count, const std::function<Item(std::size_t)>& item, double margin) : count_(count) {
  while (leaves_ * leaf_size < count) leaves_ *= 2;
  const float far = std::numeric_limits<float>::infinity();
  nodes_.assign(2 * leaves_, Node{far, far, -far, -far, 0, true, false});
  boxes_.resize(count);
  linked_.resize(count);
  const auto grow = [](Node& node, const auto& box) {
    node.low_x = std::min(node.low_x, box.low_x);
    node.low_y = std::min(node.low_y, box.low_y);
    node.high_x = std::max(node.high_x, box.high_x);
    node.high_y = std::max(node.high_y, box.high_y);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Item it = item(i);
    boxes_[i] = {below(it.low.x - margin), below(it.low.y - margin), above(it.high.x + margin), above(it.high.y + margin)};
    linked_[i] = it.linked;
    Node& leaf = nodes_[leaves_ + i / leaf_size];
    grow(leaf, boxes_[i]);
    leaf.directions |= it.directions;
    if (i % leaf_size == 0) {
      leaf.linked = it.linked;
    } else {
      leaf.connected = leaf.connected && it.linked;
    }
  }
  for (std::size_t i = leaves_ - 1; i > 0; --i) {
    const Node& left = nodes_[2 * i];
    const Node& right = nodes_[2 * i + 1];
    Node& node = nodes_[i];
    grow(node, left);
    grow(node, right);
    node.directions = left.directions | right.directions;
    node.linked = left.linked;
    node.connected = left.connected && right.connected && (right.linked || right.low_x > right.high_x);
  }
}

void ChainTree::for_each_pair(const std::function<void(std::size_t, std::size_t)>& visit) const {
  if (count_ > 1) self(1, leaves_, visit);
}

void ChainTree::self(std::size_t node, std::size_t size, const std::function<void(std::size_t, std::size_t)>& visit) const {
  const Node& n = nodes_[node];
  if (n.connected && fits_half_plane(n.directions)) return;
  if (is_leaf(node)) return items(node, node, visit);
  self(2 * node, size / 2, visit);
  self(2 * node + 1, size / 2, visit);
  pair(2 * node, 2 * node + 1, visit);
}

/// True if b goes on where a ends: b's first leaf comes after a's last one.
bool ChainTree::follows(std::size_t a, std::size_t b) const {
  std::size_t last = a + 1;
  std::size_t first = b;
  while (last - 1 < leaves_) last = 2 * last;  // one past the last leaf
  while (first < leaves_) first = 2 * first;
  return last == first;
}

void ChainTree::pair(std::size_t a, std::size_t b, const std::function<void(std::size_t, std::size_t)>& visit) const {
  const Node& m = nodes_[a];
  const Node& n = nodes_[b];
  if (!overlap(m, n)) return;
  if (n.linked && m.connected && n.connected && fits_half_plane(m.directions | n.directions) && follows(a, b)) return;
  const bool leaf_a = is_leaf(a);
  const bool leaf_b = is_leaf(b);
  if (leaf_a && leaf_b) return items(a, b, visit);
  const auto area = [](const Node& x) { return (x.high_x - x.low_x) + (x.high_y - x.low_y); };
  if (leaf_b || (!leaf_a && area(m) > area(n))) {
    pair(2 * a, b, visit);
    pair(2 * a + 1, b, visit);
  } else {
    pair(a, 2 * b, visit);
    pair(a, 2 * b + 1, visit);
  }
}

void ChainTree::items(std::size_t a, std::size_t b, const std::function<void(std::size_t, std::size_t)>& visit) const {
  const std::size_t first_a = (a - leaves_) * leaf_size;
  const std::size_t first_b = (b - leaves_) * leaf_size;
  for (std::size_t i = first_a; i < std::min(first_a + leaf_size, count_); ++i) {
    if (!overlap(boxes_[i], nodes_[b])) continue;
    for (std::size_t j = std::max(i + 1, first_b); j < std::min(first_b + leaf_size, count_); ++j) {
      if (j == i + 1 && linked_[j]) continue;
      if (overlap(boxes_[i], boxes_[j])) visit(i, j);
    }
  }
}

}  // namespace dobra::offset
