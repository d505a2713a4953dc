#pragma once
// The searches of BoxTree: templates, so that what is asked of each item is inline.

#include <cmath>
#include <utility>

#include "shared/offset/kernel/box_tree.h"

namespace dobra::offset {
inline namespace kernel {

template <class Holds, class Visit>
bool BoxTree::any_held(const Holds& holds, Visit&& visit) const {
  return any_below({levels_.size() - 1, 0}, holds, visit);
}

template <class Visit>
bool BoxTree::any_within(Flat q, double reach, Visit&& visit) const {
  // Floats: what they may be wrong by is added to the reach.
  const double around = std::abs(q.x) + std::abs(q.y);
  const float limit = static_cast<float>((1 + 1e-6) * (reach + 4e-7 * around) + 1e-37);
  const float squared = limit * limit * 1.000001F;
  const auto x = static_cast<float>(q.x);
  const auto y = static_cast<float>(q.y);
  const Four zero{};
  Open open[deepest];
  float gaps[deepest];
  std::size_t count = 0;
  Open at{levels_.size() - 1, 0};
  for (;;) {
    const Node& n = nodes_[levels_[at.level].first + at.node];
    const Four left = n.low_x - x;
    const Four right = x - n.high_x;
    const Four below = n.low_y - y;
    const Four above = y - n.high_y;
    Four across = left > right ? left : right;
    Four along = below > above ? below : above;
    across = across > zero ? across : zero;
    along = along > zero ? along : zero;
    const Four gap = across * across + along * along;
    const std::size_t from = count;
    for (std::size_t k = 0, end = children(at); k < end; ++k) {
      if (!(gap[k] <= squared)) continue;
      open[count] = {at.level, width * at.node + k};
      gaps[count] = gap[k];
      if (count > from && gaps[count] > gaps[count - 1]) {  // the nearest stays the last
        std::swap(open[count], open[count - 1]);
        std::swap(gaps[count], gaps[count - 1]);
      }
      ++count;
    }
    // Items are looked at when they are taken off, in their turn.
    for (;;) {
      if (count == 0) return false;
      const Open next = open[--count];
      if (next.level > 0) {
        at = {next.level - 1, next.node};
        break;
      }
      if (visit(next.node)) return true;
    }
  }
}

template <class Holds, class Visit>
bool BoxTree::any_below(Open top, const Holds& holds, Visit& visit) const {
  Open open[deepest];
  std::size_t count = 0;
  open[count++] = top;
  while (count > 0) {
    const Open at = open[--count];
    const std::size_t node = levels_[at.level].first + at.node;
    for (std::size_t k = children(at); k-- > 0;) {
      if (at.level > 0 && holds(child(node, k))) open[count++] = {at.level - 1, width * at.node + k};
    }
    if (at.level > 0) continue;
    for (std::size_t k = 0; k < children(at); ++k) {
      if (holds(child(node, k)) && visit(width * at.node + k)) return true;
    }
  }
  return false;
}

template <class Holds, class Visit>
bool BoxTree::any_held_from(std::size_t item, const Holds& holds, Visit&& visit) const {
  Open from{0, item / width};
  while (from.level + 1 < levels_.size()) {
    const Open up{from.level + 1, from.node / width};
    for (std::size_t k = 0; k < children(up); ++k) {
      const std::size_t other = width * up.node + k;
      if (other == from.node || !holds(child(levels_[up.level].first + up.node, k))) continue;
      if (any_below({from.level, other}, holds, visit)) return true;
    }
    from = up;
  }
  return false;
}

template <class Visit>
bool BoxTree::any_held(const BoxTree& other, Flat q, double d, Visit&& visit) const {
  const auto x = static_cast<float>(q.x);
  const auto y = static_cast<float>(q.y);
  const auto scale = static_cast<float>(d);
  // Far above what roundings, of doubles and of floats, make of any sum; without end where one might leave the range of
  // floats: that holds everything.
  const float slack = 4e-7F * (greatest_ + scale * other.greatest_ + std::abs(x) + std::abs(y)) + 1e-37F;
  const float low_x = x - slack;
  const float low_y = y - slack;
  const float high_x = x + slack;
  const float high_y = y + slack;
  Open open[deepest];
  std::size_t count = 0;
  open[count++] = {levels_.size() - 1, 0};
  while (count > 0) {
    const Open at = open[--count];
    const std::size_t node = levels_[at.level].first + at.node;
    const Node& n = nodes_[node];
    const Node& w = other.nodes_[node];
    // What is not there is an inverted box without end.
    const auto out = (n.low_x + scale * w.low_x > high_x) | (n.high_x + scale * w.high_x < low_x) |
                     (n.low_y + scale * w.low_y > high_y) | (n.high_y + scale * w.high_y < low_y) |
                     (w.low_x > w.high_x);
    for (std::size_t k = 0, end = children(at); k < end; ++k) {
      if (out[k]) continue;
      if (at.level > 0) {
        open[count++] = {at.level - 1, width * at.node + k};
      } else if (visit(width * at.node + k)) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace kernel
}  // namespace dobra::offset
