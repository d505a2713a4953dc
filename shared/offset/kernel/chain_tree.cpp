#include "shared/offset/kernel/chain_tree.h"

#include <bit>

namespace dobra::offset {
inline namespace kernel {

namespace {

/// Monotone in the angle of u, 0 .. 4, anticlockwise from +x: a diamond's arc length.
double diamond_angle(Flat u) {
  const double t = u.y / (std::abs(u.x) + std::abs(u.y));
  return u.x >= 0 ? (t >= 0 ? t : 4 + t) : 2 - t;
}

}  // namespace

/// True if some 34 of the 64 bits in a row are clear: with the spare bits the directions span less than half a turn.
/// Opposite points of the diamond are 32 bits apart, so that sectors need not be equal.
bool ChainTree::fits_half_plane(std::uint64_t directions) {
  std::uint64_t clear = ~directions;
  for (const int run : {1, 2, 4, 8, 16}) clear &= std::rotr(clear, run);  // then 32 in a row
  clear &= std::rotr(clear, 1);
  return clear != 0;
}

std::uint64_t ChainTree::directions_of(Flat u, Flat v) {
  const double from = diamond_angle(u);
  const double to = diamond_angle(v);
  if (!(from >= 0 && to >= 0)) return ~std::uint64_t{0};  // no number: a segment at the end of the range of doubles
  const auto first = static_cast<int>(from * 16) - 1;
  auto last = static_cast<int>(to * 16) + 1;
  if (last < first) last += 64;
  const int width = std::min(64, last - first + 1);
  const std::uint64_t bits = width >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
  return std::rotl(bits, (first + 64) % 64);
}

void ChainTree::build(std::size_t node, std::size_t first, std::size_t last, const std::vector<Leaf>& leaves) {
  if (last - first == 1) {
    nodes_[node] = leaves[first];
    return;
  }
  const Range here{node, first, last};
  build(here.left().node, here.left().first, here.left().last, leaves);
  build(here.right().node, here.right().first, here.right().last, leaves);
  const Node& left = nodes_[here.left().node];
  const Node& right = nodes_[here.right().node];
  Node& made = nodes_[node];
  made = left;
  made.box.add(right.box);
  made.directions |= right.directions;
  made.connected = left.connected && right.connected && right.linked;
}

}  // namespace kernel
}  // namespace dobra::offset
