// Step 1: which pieces may meet. Pieces of the right side are grouped by the 16 steps that they belong to; where a group is nearly
// complete its box follows from its block (clearance.h) without looking at any piece.

#include <algorithm>

#include "shared/offset/sections.h"

namespace dobra::offset {

namespace {
constexpr std::uint32_t none = 0xffffffffU;
constexpr std::uint32_t few = 8;  // pieces of a group whose own boxes are looked at
}  // namespace

FloatBox Trimmer::box(Site s, Flat a, Flat b) const {
  const double d = outline_.distance();
  const double margin = 1e-13 * (base_.size + d);
  Flat low{std::min(a.x, b.x), std::min(a.y, b.y)};
  Flat high{std::max(a.x, b.x), std::max(a.y, b.y)};
  if (s.role == Role::Arc || s.role == Role::SecondArc) {
    // The end tangents meet outside the arc: arcs are at most a right angle.
    const Flat c = outline_.centre(s);
    const Flat sum = (a - c) + (b - c);
    const Flat m = c + (2 * d * d / dot(sum, sum)) * sum;
    low = {std::min(low.x, m.x), std::min(low.y, m.y)};
    high = {std::max(high.x, m.x), std::max(high.y, m.y)};
  }
  return {low, high, margin};
}

void Trimmer::add_items(const Group& group, std::vector<Item>& items) const {
  for (std::uint32_t k = group.first; k < group.last; ++k) items.push_back({box(pieces_[k].site(), start(k), end(k)), k});
}

std::vector<ChainTree::Leaf> Trimmer::make_groups() {
  const auto& blocks = clearance_.blocks();
  const double d = outline_.distance();
  const double margin = 1e-13 * (base_.size + d);
  groups_.clear();
  std::vector<ChainTree::Leaf> leaves;
  for (std::uint32_t first = 0; first < wanted_;) {
    const std::uint32_t block = pieces_[first].step() / Block::size;
    std::uint32_t last = first + 1;
    bool connected = true;
    for (; last < wanted_ && pieces_[last].step() / Block::size == block; ++last) connected = connected && pieces_[last].linked();
    ChainTree::Leaf leaf{blocks[block].box(false, d, margin), blocks[block].directions, connected, pieces_[first].linked() && first > 0};
    if (last - first < few) {
      leaf.box = {};
      for (std::uint32_t k = first; k < last; ++k) leaf.box.add(box(pieces_[k].site(), start(k), end(k)));
    }
    leaves.push_back(leaf);
    groups_.push_back({first, last});
    first = last;
  }
  return leaves;
}

void Trimmer::find_pairs(const Buried& known, Buried* found) {
  const ChainTree tree(make_groups());
  pair_own(tree);
  if (progress_.cancelled()) return;
  pair_scissors(tree, known, found);
}

void Trimmer::pair_own(const ChainTree& tree) {
  std::vector<Item> first;
  std::vector<Item> second;
  std::size_t loaded = groups_.size();
  tree.for_each_pair([&](std::size_t a, std::size_t b) {
    if (loaded != a) {
      first.clear();
      add_items(groups_[a], first);
      loaded = a;
    }
    second.clear();
    if (a != b) add_items(groups_[b], second);
    for (const Item& p : first) {
      for (const Item& q : a == b ? first : second) {
        if (!p.box.overlaps(q.box) || q.piece <= p.piece) continue;
        if (q.piece == p.piece + 1 && pieces_[q.piece].linked()) continue;
        pairs_.emplace_back(p.piece, q.piece);
      }
    }
  });
}

/// The pieces of a step of the other side, line and what is at its end: add(site, a, b).
template <class Add>
void Trimmer::each_scissor(std::uint32_t step, const Add& add) const {
  const double margin = 1e-14 * (base_.size + outline_.distance());
  const Outline::Junction after = outline_.junction(step);
  if (step >= base_.segment_count()) {
    const Outline::Junction before = outline_.junction(outline_.before(step));
    const double size = dot(after.end - before.start, outline_.along<double>(step));
    if (!is_overcut(outline_, step, size, margin)) add(Site{step, Role::Line}, before.start, after.end);
  }
  if (after.kind != Corner::Arc) return;
  if (outline_.splits_arc(step)) {
    const Flat middle = outline_.end_of({step, Role::Arc});
    add(Site{step, Role::Arc}, after.end, middle);
    add(Site{step, Role::SecondArc}, middle, after.start);
  } else {
    add(Site{step, Role::Arc}, after.end, after.start);
  }
}

void Trimmer::pair_scissors(const ChainTree& tree, const Buried& known, Buried* found) {
  if (outline_.sides() == Outline::Sides::Right) return;
  Cover cover(outline_, clearance_);
  const double d = outline_.distance();
  const auto n = static_cast<std::uint32_t>(base_.segment_count());
  std::vector<Item> near;  // of the curve
  const auto load = [&](const FloatBox& box) {
    near.clear();
    tree.for_each_overlap(box, [&](std::size_t i) { add_items(groups_[i], near); });
    return !near.empty();
  };
  const auto try_piece = [&](Site site, Flat a, Flat b) {
    if (known.holds(site)) return;
    const FloatBox own = box(site, a, b);
    std::uint32_t made = none;
    for (const Item& item : near) {
      if (!item.box.overlaps(own)) continue;
      if (made == none) {
        if (cover.covers(site, a, b)) {
          if (found != nullptr) found->add(site, cover.killer());
          return;
        }
        made = static_cast<std::uint32_t>(pieces_.size());
        pieces_.push_back(Piece(site));
      }
      pairs_.emplace_back(item.piece, made);
    }
  };
  if (!base_.closed) {
    for (const std::uint32_t step : {n - 1, 2 * n - 1}) {
      const Flat c = outline_.to<double>(step);
      if (!load(FloatBox(c, c, d * (1 + 1e-12)))) continue;
      each_scissor(step, [&](Site site, Flat a, Flat b) {
        if (site.role != Role::Line) try_piece(site, a, b);
      });
    }
  }
  const auto& blocks = clearance_.blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (b % 256 == 0 && progress_.cancelled()) return;
    if (!load(blocks[b].box(true, d, 1e-13 * (base_.size + d)))) continue;
    const auto last = std::min<std::uint32_t>(n, static_cast<std::uint32_t>(b + 1) * Block::size);
    for (auto s = static_cast<std::uint32_t>(b) * Block::size; s < last; ++s) {
      const std::uint32_t step = 2 * n - 1 - s;
      each_scissor(step, [&](Site site, Flat p, Flat q) {
        if (site.role == Role::Line || !outline_.is_cap(step)) try_piece(site, p, q);
      });
    }
  }
}

}  // namespace dobra::offset
