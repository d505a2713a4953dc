#include "shared/offset/general/pairs.h"

#include <algorithm>
#include <optional>

#include "shared/offset/general/outline_ends.h"

namespace dobra::offset::general {

namespace {
constexpr std::uint32_t few = 12;              // pieces of a group whose own boxes and directions are looked at
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
  if (wanted_ == 0) return {};
  if (clearance_.has_long_mitres()) find_parts();
  make_groups();
  cache_.resize(std::min<std::size_t>(128, groups_.size()));
  const ChainTree tree = crowd_tree();
  pair_own(tree);
  pair_alone();
  if (!progress_.cancelled()) pair_cutters(tree, known, found);
  return std::move(pairs_);
}

Pairing::PieceHull Pairing::hull(Site site, std::uint32_t piece, Flat a, Flat b) const {
  PieceHull made{{}, site, piece, a, b, a};
  Flat low{std::min(a.x, b.x), std::min(a.y, b.y)};
  Flat high{std::max(a.x, b.x), std::max(a.y, b.y)};
  if (made.is_arc()) {
    // The end tangents meet outside the arc: arcs are at most a right angle.
    const double d = outline_.distance();
    const Flat c = outline_.centre(site);
    const Flat sum = (a - c) + (b - c);
    const Flat m = c + (2 * d * d / dot(sum, sum)) * sum;
    low = {std::min(low.x, m.x), std::min(low.y, m.y)};
    high = {std::max(high.x, m.x), std::max(high.y, m.y)};
    made.m = m;
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

/// See ChainTree.
std::uint64_t Pairing::directions_of(const PieceHull& p) const {
  if (p.site.kind == SiteKind::Bevel) return ~std::uint64_t{0};
  const Flat u = outline_.along<double>(p.site.step);
  if (!p.is_arc()) return ChainTree::directions_of(u, u);
  const Flat c = outline_.centre(p.site);
  return ChainTree::directions_of(left_of(p.a - c), left_of(p.b - c));
}

void Pairing::make_groups() {
  const auto& blocks = clearance_.blocks();
  const auto& pieces = chain_.pieces;
  const double d = outline_.distance();
  const bool places_tell = 100 * margin_ < d;  // which way an arc's ends point, far better than to a bit
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
    const bool parted = part != parts_.end() && part->piece < last;
    if (last - first < few || parted) {
      leaf.box = {};
      std::uint64_t directions = 0;
      each_hull({first, last}, [&](const PieceHull& p) {
        leaf.box.add(p.box);
        directions |= directions_of(p);
      });
      if (!parted && places_tell) leaf.directions &= directions;
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

/// All of q lies within the arc's circle.
bool Pairing::in_disc(const PieceHull& arc, const PieceHull& q) const {
  const Flat c = outline_.centre(arc.site);
  const double limit = outline_.distance() - margin_;
  const auto inside = [&](Flat p) { return dot(p - c, p - c) < limit * limit; };
  return limit > 0 && inside(q.a) && inside(q.b) && (!q.is_arc() || inside(q.m));
}

bool Pairing::apart(const PieceHull& p, const PieceHull& q) const {
  return beyond_an_edge(p, q) || beyond_an_edge(q, p) || (p.is_arc() && in_disc(p, q)) || (q.is_arc() && in_disc(q, p));
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

/// The pieces of a step of the other side, line and what is at its end.
void Pairing::add_cutters(std::uint32_t step, const Outline::Junction& before, const Outline::Junction& after,
                          const Buried& known) {
  const auto add = [&](SiteKind kind, Flat a, Flat b) {
    const Site site{step, kind};
    if (!known.holds(site)) cutters_.hulls.push_back(hull(site, none, a, b));
  };
  if (step >= base_.segment_count()) {
    const double size = dot(after.end - before.start, outline_.along<double>(step));
    if (!known.holds({step, SiteKind::Line}) && !is_overcut(outline_, step, size, 0.1 * margin_))
      add(SiteKind::Line, before.start, after.end);
  }
  if (after.kind != CornerKind::Arc) return;
  if (outline_.splits_arc(step)) {
    const Flat middle = outline_.end_of({step, SiteKind::Arc});
    add(SiteKind::Arc, after.end, middle);
    add(SiteKind::SecondArc, middle, after.start);
  } else {
    add(SiteKind::Arc, after.end, after.start);
  }
}

/// What the other side has along four segments, but for the caps.
void Pairing::make_cutters(std::uint32_t leaf, const Buried& known) {
  constexpr auto size = static_cast<std::uint32_t>(Clearance::leaf_size);
  const auto n = static_cast<std::uint32_t>(base_.segment_count());
  cutters_.hulls.clear();
  met_.fill(0);
  const std::uint32_t low = 2 * n - std::min(n, (leaf + 1) * size);
  const std::uint32_t high = 2 * n - leaf * size;
  Outline::Junction before = outline_.junction(outline_.before(low));
  for (std::uint32_t step = low; step < high; ++step) {
    const Outline::Junction after = outline_.junction(step);
    add_cutters(step, before, after, known);
    before = after;
    if (!outline_.is_cap(step)) continue;
    std::erase_if(cutters_.hulls,
                  [&](const PieceHull& p) { return p.site.step == step && p.site.kind != SiteKind::Line; });
  }
  add_runs(cutters_);
}

/// False of cutters that lie in U: they cut nothing valid.
bool Pairing::judge(PieceHull& hull, Buried* found) {
  if (hull.piece != none) return hull.piece != buried;
  hull.piece = witnesses_.covers(hull.site, hull.a, hull.b) ? buried : open;
  if (hull.piece == open) return true;
  if (found != nullptr) found->add(hull.site, witnesses_.witness());
  return false;
}

/// Of a run that comes near many pieces: what is left of it has a smaller box.
void Pairing::judge_run(std::size_t run, Buried* found) {
  cutters_.runs[run] = {};
  const std::size_t last = std::min(run_size * (run + 1), cutters_.hulls.size());
  for (std::size_t k = run_size * run; k < last; ++k) {
    if (judge(cutters_.hulls[k], found)) cutters_.runs[run].add(cutters_.hulls[k].box);
  }
  cutters_.box = {};
  for (std::size_t k = 0; k < cutters_.run_count(); ++k) cutters_.box.add(cutters_.runs[k]);
}

void Pairing::cut_with(const Bunch& near, Buried* found) {
  constexpr std::uint8_t patience = 3;
  each_overlap(cutters_, near, [&](std::size_t i0, std::size_t i1, std::size_t j0, std::size_t j1) {
    std::uint8_t& met = met_[i0 / run_size];
    if (met < patience && ++met == patience) judge_run(i0 / run_size, found);
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
        if (!judge(p, found)) continue;
        if (p.piece == open) {
          p.piece = static_cast<std::uint32_t>(chain_.pieces.size());
          chain_.pieces.push_back(Piece(p.site));
        }
        pairs_.emplace_back(q.piece, p.piece);
      }
    }
  });
}

/// Around a block, if it bends little, its two sides lie on two sides of a strip: what is to the right (left) of the
/// base at distance D lies as far across the chord as some base point and D times the cosine of the greatest turn from
/// it, or further.
bool Pairing::sides_apart(std::uint32_t block) const {
  const auto n = static_cast<std::uint32_t>(base_.segment_count());
  const std::uint32_t first = block > 0 ? (block - 1) * Block::size : 0;
  const std::uint32_t last = std::min(n, (block + 2) * Block::size);
  const Flat chord = flat(base_.end(last - 1)) - flat(base_.start(first));
  if (!(dot(chord, chord) > 0)) return false;
  const Flat across = right_of(unit(chord));
  const Flat origin = flat(base_.start(first));
  double low = 0;
  double high = 0;
  double cosine = 1;
  for (std::uint32_t i = first; i < last; ++i) {
    const double at = dot(flat(base_.end(i)) - origin, across);
    low = std::min(low, at);
    high = std::max(high, at);
    cosine = std::min(cosine, dot(right_of(flat(base_.headings[i])), across));
  }
  for (const bool before : {true, false}) {
    if (before ? !base_.has_before(first) : !base_.has_after(last - 1)) continue;
    const Flat beyond = flat(base_.headings[before ? base_.before(first) : base_.after(last - 1)]);
    cosine = std::min(cosine, dot(right_of(beyond), across));
  }
  return high - low + margin_ < 2 * outline_.distance() * cosine;
}

/// Blocks whose other side comes near a group: block, group; in order.
Pairing::Pairs Pairing::near_blocks(const ChainTree& tree, const Buried& known) const {
  const auto& blocks = clearance_.blocks();
  const double d = outline_.distance();
  std::vector<ChainTree::Leaf> leaves;
  std::vector<std::uint32_t> of_leaf;
  for (std::uint32_t k = 0; k < blocks.size(); ++k) {
    if (clearance_.is_harmless(k, d) || clearance_.is_alone(k, d) || known.holds_left_of(k)) continue;
    leaves.push_back({blocks[k].box(true, d, margin_), 0, false, false});
    of_leaf.push_back(k);
  }
  Pairs near;
  ChainTree(leaves).for_each_overlap(
      tree, [&](std::size_t leaf, std::size_t group) { near.emplace_back(of_leaf[leaf], crowd_[group]); });
  // What is alone has only neighbours.
  const auto count = static_cast<std::uint32_t>(blocks.size());
  const auto add = [&](std::uint32_t k, std::uint32_t g) {
    if (clearance_.is_harmless(k, d) || known.holds_left_of(k) || !(alone_[g] || clearance_.is_alone(k, d))) return;
    if (blocks[k].box(true, d, margin_).overlaps(leaves_[g].box)) near.emplace_back(k, g);
  };
  for (std::uint32_t g = 0; g < groups_.size(); ++g) {
    const std::uint32_t own = block_of(g);
    if (own > 0) add(own - 1, g);
    add(own, g);
    if (own + 1 < count) add(own + 1, g);
    if (!base_.closed || count < 3) continue;
    if (own == 0) add(count - 1, g);
    if (own + 1 == count) add(0, g);
  }
  std::sort(near.begin(), near.end());
  return near;
}

void Pairing::cut_by_caps(const ChainTree& tree, const Buried& known, Buried* found) {
  const auto n = static_cast<std::uint32_t>(base_.segment_count());
  for (const std::uint32_t step : {n - 1, 2 * n - 1}) {
    cutters_.hulls.clear();
    add_cutters(step, outline_.junction(outline_.before(step)), outline_.junction(step), known);
    std::erase_if(cutters_.hulls, [](const PieceHull& p) { return p.site.kind == SiteKind::Line; });
    met_.fill(0);
    add_runs(cutters_);
    tree.for_each_overlap(cutters_.box, [&](std::size_t i) { cut_with(cached(crowd_[i]), found); });
    const std::uint32_t block = outline_.segment(step) / Block::size;
    const auto before = [&](const Group& group) { return chain_.pieces[group.first].step() / Block::size + 1 < block; };
    const auto first = std::ranges::partition_point(groups_, before) - groups_.begin();
    for (auto g = static_cast<std::size_t>(first); g < groups_.size() && block_of(g) <= block + 1; ++g) {
      if (alone_[g]) cut_with(cached(g), found);
    }
  }
}

void Pairing::pair_cutters(const ChainTree& tree, const Buried& known, Buried* found) {
  if (outline_.sides() == Outline::Sides::Right) return;
  if (!base_.closed) cut_by_caps(tree, known, found);
  if (clearance_.parts_sides(outline_.distance())) return;
  const Pairs near = near_blocks(tree, known);
  std::size_t asked = 0;
  for (auto first = near.begin(); first != near.end();) {
    const std::uint32_t block = first->first;
    const auto last = std::find_if(first, near.end(), [&](const auto& pair) { return pair.first != block; });
    std::optional<bool> apart;
    const auto parted = [&](std::uint32_t group) {
      if (block_of(group) + 1 < block || block_of(group) > block + 1) return false;
      if (!apart) apart = sides_apart(block);
      return *apart;
    };
    const auto [low, high] = clearance_.leaves_of(block);
    std::uint32_t left = high - low;
    for (std::uint32_t leaf = low; leaf < high; ++leaf) {
      const FloatBox around = clearance_.left_box(leaf, outline_.distance(), margin_);
      bool made = false;
      for (auto pair = first; pair != last; ++pair) {
        if (++asked % 1024 == 0 && progress_.cancelled()) return;
        const std::uint32_t group = pair->second;
        if (!around.overlaps(leaves_[group].box) || parted(group)) continue;
        const Bunch& pieces = cached(group);
        if (!made) {
          if (!pieces.overlaps(around)) continue;
          make_cutters(leaf, known);
          made = true;
        }
        cut_with(pieces, found);
        if (!cutters_.box.empty()) continue;
        --left;
        break;
      }
    }
    if (left == 0 && found != nullptr) found->add_left_of(block);
    first = last;
  }
}

}  // namespace dobra::offset::general
