#include "shared/offset/general/pairs.h"

#include <algorithm>

namespace dobra::offset::general {

namespace {
constexpr std::uint32_t few = 12;              // pieces of a group whose own boxes are looked at
constexpr std::uint32_t buried = 0xfffffffeU;  // cutters that need not be made
constexpr std::uint32_t open = 0xfffffffdU;    // cutters that are needed where they meet something
}  // namespace

Pairing::Pairing(const Outline& outline, const Clearance& clearance, Candidates& chain, WitnessSearch& witnesses,
                 const base::Progress& progress)
    : outline_(outline),
      clearance_(clearance),
      base_(outline.base()),
      chain_(chain),
      witnesses_(witnesses),
      progress_(progress),
      wanted_(static_cast<std::uint32_t>(chain.pieces.size())),
      margin_(10 * clearance.margin(outline.distance())) {}

Pairing::Pairs Pairing::run(const Buried& known, Buried* found) {
  known_ = &known;
  found_ = found;
  if (wanted_ == 0) return {};
  if (clearance_.has_long_mitres()) find_parts();
  make_groups();
  cache_.resize(std::min<std::size_t>(128, groups_.size()));
  const ChainTree tree = crowd_tree();
  pair_own(tree);
  pair_alone();
  if (!progress_.cancelled()) pair_cutters(tree);
  return std::move(pairs_);
}

Pairing::PieceHull Pairing::hull(Site site, std::uint32_t piece, Flat a, Flat b) const {
  PieceHull made{{}, site, piece, a, b, a};
  Flat low{std::min(a.x, b.x), std::min(a.y, b.y)};
  Flat high{std::max(a.x, b.x), std::max(a.y, b.y)};
  if (made.is_arc()) {
    // The end tangents meet outside the arc: arcs are at most a right angle.
    made.m = witnesses_.tangent_corner(site, a, b);
    low = {std::min(low.x, made.m.x), std::min(low.y, made.m.y)};
    high = {std::max(high.x, made.m.x), std::max(high.y, made.m.y)};
  }
  made.box = FloatBox(low, high, margin_);
  return made;
}

/// A line that reaches far to the tip of a mitre: it crosses very many others, most of them in vain.
bool Pairing::is_long(const Piece& piece) const {
  if (piece.site().kind != SiteKind::Line) return false;
  const auto far = [&](std::uint32_t step) {
    return !outline_.is_cap(step) && clearance_.is_long(outline_.corner_point(step));
  };
  return far(outline_.before(piece.step())) || far(piece.step());
}

void Pairing::find_parts() {
  Outline::Ends ends(outline_);
  for (std::uint32_t k = 0; k < wanted_; ++k) {
    const Piece& p = chain_.pieces[k];
    if (!is_long(p)) continue;
    Part part{k, false, chain_.start(ends, p), chain_.end(ends, p)};
    const Flat a = part.a;
    const Flat b = part.b;
    part.empty = !witnesses_.shorten(part.a, part.b);
    if (part.empty || part.a.x != a.x || part.a.y != a.y || part.b.x != b.x || part.b.y != b.y) parts_.push_back(part);
  }
}

/// A linked piece starts where the one before it ends; its start is had more easily.
template <class Visit>
void Pairing::each_hull(const Group& group, const Visit& visit) const {
  Flat end{};
  Outline::Ends ends(outline_);
  auto part = std::ranges::lower_bound(parts_, group.first, {}, &Part::piece);
  for (std::uint32_t k = group.first; k < group.last; ++k) {
    const Piece& p = chain_.pieces[k];
    const Flat start = k > group.first && p.linked() ? end : chain_.start(ends, p);
    const bool goes_on = k + 1 < wanted_ && chain_.pieces[k + 1].linked();
    end = goes_on ? chain_.start(ends, chain_.pieces[k + 1]) : chain_.end(ends, p);
    if (part == parts_.end() || part->piece != k) {
      visit(hull(p.site(), k, start, end));
      continue;
    }
    if (!part->empty) visit(hull(p.site(), k, part->a, part->b));
    ++part;
  }
}

void Pairing::make_groups() {
  const auto& blocks = clearance_.blocks();
  const auto& pieces = chain_.pieces;
  const double d = outline_.distance();
  for (std::uint32_t first = 0; first < wanted_;) {
    const std::uint32_t block = pieces[first].step() / Block::size;
    std::uint32_t last = std::min(wanted_, first + blocks[block].piece_count);  // if it has all of them
    if (pieces[last - 1].step() / Block::size != block) {
      for (last = first + 1; pieces[last].step() / Block::size == block;) ++last;
    }
    const bool connected = next_gap(pieces.data(), first + 1, last) == last;
    ChainTree::Leaf leaf{blocks[block].box(false, d, margin_), blocks[block].directions, connected,
                         pieces[first].linked() && first > 0};
    const auto part = std::ranges::lower_bound(parts_, first, {}, &Part::piece);
    if (last - first < few || (part != parts_.end() && part->piece < last)) {
      leaf.box = {};
      each_hull({first, last}, [&](const PieceHull& p) { leaf.box.add(p.box); });
    }
    leaves_.push_back(leaf);
    alone_.push_back(clearance_.is_alone(block, d));
    groups_.push_back({first, last});
    first = last;
  }
}

void Pairing::add_runs(Bunch& bunch) {
  bunch.box = {};
  for (std::size_t k = 0; k < bunch.hulls.size(); ++k) {
    FloatBox& box = bunch.runs[k / run_size];
    if (k % run_size == 0) box = {};
    box.add(bunch.hulls[k].box);
    bunch.box.add(bunch.hulls[k].box);
  }
}

void Pairing::load(std::size_t group, Bunch& bunch) const {
  if (bunch.group == group) return;
  bunch.group = group;
  bunch.hulls.clear();
  bunch.hulls.reserve(groups_[group].last - groups_[group].first);
  each_hull(groups_[group], [&](const PieceHull& p) { bunch.hulls.push_back(p); });
  add_runs(bunch);
}

const Pairing::Bunch& Pairing::cached(std::size_t group) {
  Bunch* bunch = &cache_[group % cache_.size()];
  if (bunch == latest_ && bunch->group != group) bunch = &spare_;
  load(group, *bunch);
  latest_ = bunch;
  return *bunch;
}

template <class Visit>
void Pairing::each_overlap(const Bunch& p, const Bunch& q, const Visit& visit) {
  for (std::size_t i = 0; i < p.run_count(); ++i) {
    if (!p.runs[i].overlaps(q.box)) continue;
    for (std::size_t j = &p == &q ? i : 0; j < q.run_count(); ++j) {
      if (!p.runs[i].overlaps(q.runs[j])) continue;
      visit(run_size * i, std::min(run_size * (i + 1), p.hulls.size()), run_size * j,
            std::min(run_size * (j + 1), q.hulls.size()));
    }
  }
}

/// All of q lies beyond the line of one of p's edges, where p is not.
bool Pairing::beyond_an_edge(const PieceHull& p, const PieceHull& q) const {
  const auto separates = [&](Flat from, Flat to, Flat third) {
    const Flat along = to - from;
    const double limit = margin_ * (std::abs(along.x) + std::abs(along.y));
    const double own = cross(along, third - from);
    const double low = std::min(own, 0.0) - limit;
    const double high = std::max(own, 0.0) + limit;
    const double at_a = cross(along, q.a - from);
    const double at_b = cross(along, q.b - from);
    const double at_m = q.is_arc() ? cross(along, q.m - from) : at_a;
    return (at_a < low && at_b < low && at_m < low) || (at_a > high && at_b > high && at_m > high);
  };
  if (separates(p.a, p.b, p.m)) return true;
  return p.is_arc() && (separates(p.a, p.m, p.b) || separates(p.m, p.b, p.a));
}

bool Pairing::apart(const PieceHull& p, const PieceHull& q) const {
  return beyond_an_edge(p, q) || beyond_an_edge(q, p);
}

ChainTree Pairing::crowd_tree() {
  std::vector<ChainTree::Leaf> leaves;
  for (std::uint32_t g = 0; g < groups_.size(); ++g) {
    if (alone_[g]) continue;
    leaves.push_back(leaves_[g]);
    leaves.back().linked = leaves.back().linked && !alone_[g - 1];
    crowd_.push_back(g);
  }
  return ChainTree(leaves);
}

void Pairing::pair_groups(std::size_t a, std::size_t b) {
  const Bunch& first = cached(a);
  const Bunch& second = a == b ? first : cached(b);
  each_overlap(first, second, [&](std::size_t i0, std::size_t i1, std::size_t j0, std::size_t j1) {
    for (std::size_t i = i0; i < i1; ++i) {
      const PieceHull& p = first.hulls[i];
      for (std::size_t j = j0; j < j1; ++j) {
        const PieceHull& q = second.hulls[j];
        if (!p.box.overlaps(q.box) || q.piece <= p.piece) continue;
        if (q.piece == p.piece + 1 && chain_.pieces[q.piece].linked()) continue;
        if (!apart(p, q)) pairs_.emplace_back(p.piece, q.piece);
      }
    }
  });
}

void Pairing::pair_own(const ChainTree& tree) {
  std::size_t asked = 0;
  bool stop = false;
  tree.for_each_pair([&](std::size_t a, std::size_t b) {
    if (++asked % 1024 == 0) stop = stop || progress_.cancelled();
    if (!stop && !goes_straight_on(crowd_[a], crowd_[b])) pair_groups(crowd_[a], crowd_[b]);
  });
}

/// They are a connected part (or one is) that bends too little to meet itself.
bool Pairing::goes_straight_on(std::size_t a, std::size_t b) const {
  if (!leaves_[a].connected) return false;
  if (a == b) return clearance_.bends_little(block_of(a));
  return b == a + 1 && leaves_[b].connected && leaves_[b].linked && block_of(b) == block_of(a) + 1 &&
         clearance_.bends_little_with_next(block_of(a));
}

/// Those that nothing but their neighbours may meet.
void Pairing::pair_alone() {
  const std::size_t count = groups_.size();
  const auto pair = [&](std::size_t g, std::size_t h) {
    const ChainTree::Leaf& own = leaves_[g];
    const ChainTree::Leaf& next = leaves_[h];
    if (own.connected && next.connected && (g == h || next.linked)) {
      if (ChainTree::fits_half_plane(own.directions | next.directions)) return;
      const double d = outline_.distance();
      if (clearance_.is_harmless(block_of(g), d) && clearance_.is_harmless(block_of(h), d)) return;
    }
    if (own.box.overlaps(next.box)) pair_groups(g, h);
  };
  for (std::size_t g = 0; g < count; ++g) {
    if (alone_[g]) pair(g, g);
    if (g + 1 < count && (alone_[g] || alone_[g + 1]) && block_of(g + 1) == block_of(g) + 1) pair(g, g + 1);
  }
  const std::size_t blocks = clearance_.blocks().size();
  if (!base_.closed || blocks < 3 || !(alone_.front() || alone_.back())) return;
  if (block_of(0) == 0 && block_of(count - 1) + 1 == blocks) pair_groups(0, count - 1);
}

/// What is at the end of a step of the other side, or about an end of the base.
void Pairing::add_corner_cutters(std::uint32_t step, const Outline::Junction& junction) {
  if (junction.kind != CornerKind::Arc) return;
  const bool split = outline_.splits_arc(step);
  const Flat middle = split ? outline_.end_of({step, SiteKind::Arc}) : junction.start;
  add_cutter({step, SiteKind::Arc}, junction.end, middle);
  if (split) add_cutter({step, SiteKind::SecondArc}, middle, junction.start);
}

/// What the other side has along four segments, but for the caps.
void Pairing::make_cutters(std::uint32_t leaf) {
  constexpr auto many = static_cast<std::uint32_t>(Clearance::leaf_size);
  const auto n = static_cast<std::uint32_t>(base_.segment_count());
  cutters_.group = leaf;
  cutters_.hulls.clear();
  const std::uint32_t low = 2 * n - std::min(n, (leaf + 1) * many);
  const std::uint32_t high = 2 * n - leaf * many;
  Outline::Junction before = outline_.junction(outline_.before(low));
  for (std::uint32_t step = low; step < high; ++step) {
    const Outline::Junction after = outline_.junction(step);
    const double size = dot(after.end - before.start, outline_.along<double>(step));
    if (!is_overcut(outline_, step, size, 0.1 * margin_)) add_cutter({step, SiteKind::Line}, before.start, after.end);
    if (!outline_.is_cap(step)) add_corner_cutters(step, after);
    before = after;
  }
  add_runs(cutters_);
}

/// False of cutters that lie in U: they cut nothing valid.
bool Pairing::is_needed(PieceHull& cutter) {
  if (cutter.piece != none) return cutter.piece != buried;
  cutter.piece = witnesses_.covers(cutter.site, cutter.a, cutter.b) ? buried : open;
  if (cutter.piece == buried && found_ != nullptr) found_->add(cutter.site);
  return cutter.piece == open;
}

void Pairing::cut_with(const Bunch& near) {
  each_overlap(cutters_, near, [&](std::size_t i0, std::size_t i1, std::size_t j0, std::size_t j1) {
    for (std::size_t i = i0; i < i1; ++i) {
      PieceHull& p = cutters_.hulls[i];
      for (std::size_t j = j0; j < j1 && p.piece != buried; ++j) {
        const PieceHull& q = near.hulls[j];
        if (!p.box.overlaps(q.box) || apart(p, q)) continue;
        // Where an end of the base begins or ends, line and cap only touch.
        if (p.is_arc() && q.site.kind == SiteKind::Line && outline_.is_cap(p.site.step) &&
            (q.site.step == p.site.step || q.site.step == outline_.after(p.site.step))) {
          continue;
        }
        if (!is_needed(p)) continue;
        if (p.piece == open) {
          p.piece = static_cast<std::uint32_t>(chain_.pieces.size());
          chain_.pieces.push_back(Piece(p.site));
        }
        pairs_.emplace_back(q.piece, p.piece);
      }
    }
  });
}

/// Blocks whose other side comes near a group: block, group; in order.
Pairing::Pairs Pairing::near_blocks(const ChainTree& tree) const {
  const auto& blocks = clearance_.blocks();
  const double d = outline_.distance();
  std::vector<ChainTree::Leaf> leaves;
  std::vector<std::uint32_t> of_leaf;
  for (std::uint32_t k = 0; k < blocks.size(); ++k) {
    if (clearance_.is_harmless(k, d) || clearance_.is_alone(k, d)) continue;
    leaves.push_back({blocks[k].box(true, d, margin_), 0, false, false});
    of_leaf.push_back(k);
  }
  Pairs near;
  ChainTree(leaves).for_each_overlap(
      tree, [&](std::size_t leaf, std::size_t group) { near.emplace_back(of_leaf[leaf], crowd_[group]); });
  // What is alone has only neighbours.
  const auto count = static_cast<std::uint32_t>(blocks.size());
  const auto add = [&](std::uint32_t k, std::uint32_t g) {
    if (clearance_.is_harmless(k, d) || !(alone_[g] || clearance_.is_alone(k, d))) return;
    if (blocks[k].box(true, d, margin_).overlaps(leaves_[g].box)) near.emplace_back(k, g);
  };
  for (std::uint32_t g = 0; g < groups_.size(); ++g) {
    const std::uint32_t own = block_of(g);
    const bool round = base_.closed && count > 2;
    add(own, g);
    if (own > 0 || round) add((own + count - 1) % count, g);
    if (own + 1 < count || round) add((own + 1) % count, g);
  }
  std::sort(near.begin(), near.end());
  return near;
}

void Pairing::cut_by_caps() {
  const auto n = static_cast<std::uint32_t>(base_.segment_count());
  for (const std::uint32_t step : {n - 1, 2 * n - 1}) {
    cutters_.hulls.clear();
    add_corner_cutters(step, outline_.junction(step));
    add_runs(cutters_);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (leaves_[g].box.overlaps(cutters_.box)) cut_with(cached(g));
    }
  }
}

void Pairing::pair_cutters(const ChainTree& tree) {
  if (outline_.sides() == Outline::Sides::Right) return;
  if (!base_.closed) cut_by_caps();
  if (clearance_.parts_sides(outline_.distance())) return;
  const Pairs near = near_blocks(tree);
  std::size_t asked = 0;
  for (auto first = near.begin(); first != near.end();) {
    const std::uint32_t block = first->first;
    const auto last = std::find_if(first, near.end(), [&](const auto& pair) { return pair.first != block; });
    const auto [low, high] = clearance_.leaves_of(block);
    for (std::uint32_t leaf = low; leaf < high; ++leaf) {
      const FloatBox around = clearance_.left_box(leaf, outline_.distance(), margin_);
      cutters_.group = none;
      for (auto pair = first; pair != last; ++pair) {
        if (++asked % 1024 == 0 && progress_.cancelled()) return;
        const std::uint32_t group = pair->second;
        if (!around.overlaps(leaves_[group].box)) continue;
        if (cutters_.group != leaf) make_cutters(leaf);
        cut_with(cached(group));
      }
    }
    first = last;
  }
}

}  // namespace dobra::offset::general
