#include "shared/offset/general/candidates.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "shared/offset/kernel/high.h"

namespace dobra::offset::general {

bool is_overcut(const Outline& outline, std::uint32_t step, double size, double margin) {
  if (size > margin) return false;
  if (size < -margin) return true;
  const Site line{step, SiteKind::Line};
  return !(dot(outline.natural_end<High>(line) - outline.natural_start<High>(line), outline.along<High>(step)) > 0);
}

namespace {

class StackPass {
 public:
  StackPass(const Outline& outline, const Clearance& clearance, WitnessSearch& witnesses, const Buried& known,
            Buried* found, const base::Progress& progress)
      : outline_(outline),
        blocks_(clearance.blocks()),
        d_(outline.distance()),
        witnesses_(witnesses),
        margin_(witnesses_.margin()),
        known_(known),
        found_(found),
        progress_(progress) {}

  Candidates run();

 private:
  void walk();
  [[nodiscard]] std::uint32_t glide_blocks(std::uint32_t step);
  [[nodiscard]] std::uint32_t glide(std::uint32_t step, std::uint64_t dead);
  void append(std::uint32_t step, bool arc);
  void add_line(std::uint32_t step, const Outline::Junction& before, const Outline::Junction& after);
  void add_corner(std::uint32_t step, const Outline::Junction& junction, std::uint64_t dead);
  void add(Site site, Flat a, Flat b);
  /// The raw piece before is the last one, and whole.
  [[nodiscard]] bool goes_on() const {
    return previous_ != Piece::none && !made_.pieces.empty() && packed(made_.pieces.back().site()) == previous_ &&
           made_.pieces.back().trim_b == Piece::none;
  }
  void place_tail() {
    if (placed_) return;
    tail_a_ = start(made_.pieces.back());
    tail_b_ = end(made_.pieces.back());
    placed_ = true;
  }
  void push(Piece piece, Flat a, Flat b);
  void close();
  void bury(Site site) const {
    if (found_ == nullptr) return;
    const bool tips = site.kind == SiteKind::Line && !known_.for_ever(site);
    found_->add(site, tips && witnesses_.tips_stay(site.step, known_.greatest()));
  }
  [[nodiscard]] bool kills(std::uint32_t step, Site site, Flat a, Flat b);
  [[nodiscard]] bool is_dead_line(Site site, Flat a, Flat b, CornerKind before, CornerKind after);
  [[nodiscard]] bool buried_by_tail(Site site, Flat a, Flat b);
  /// What is left of a piece, with all that a cut asks for.
  struct Part {
    Site site;
    bool line;
    Flat a, b;
    Flat centre;  ///< Of an arc.
  };
  [[nodiscard]] Part part(Site site, Flat a, Flat b) const {
    const bool line = is_line(site);
    return {site, line, a, b, line ? Flat{} : outline_.centre(site)};
  }
  [[nodiscard]] Part part(const Piece& p) const { return part(p.site(), start(p), end(p)); }
  std::optional<Flat> cut(Piece& tail, const Part& left_of_tail, Piece& head, const Part& left_of_head);
  [[nodiscard]] std::optional<Flat> place_of_cut(const Part& tail, const Part& head) const;
  [[nodiscard]] std::optional<Flat> crossing(const Part& tail, const Part& head) const;
  [[nodiscard]] bool in_range(const Part& part, Flat p) const;
  [[nodiscard]] bool holds(const Part& holder, Flat p, double margin) const;
  [[nodiscard]] Flat start(const Piece& p) const { return made_.start(outline_, p); }
  [[nodiscard]] Flat end(const Piece& p) const { return made_.end(outline_, p); }
  static bool is_line(Site s) { return s.kind == SiteKind::Line || s.kind == SiteKind::Bevel; }

  const Outline& outline_;
  const std::vector<Block>& blocks_;
  const double d_;
  WitnessSearch& witnesses_;
  const double margin_;
  const Buried& known_;
  Buried* const found_;
  const base::Progress& progress_;
  Candidates made_;
  Flat tail_a_, tail_b_;  // of the last piece, once it is placed
  bool placed_ = false;
  std::uint32_t previous_ = Piece::none;  // the raw piece before, packed, if it ends where the next one starts
};

Candidates StackPass::run() {
  std::size_t most = 0;
  for (std::size_t i = 0; i < blocks_.size(); ++i) most += 64 - static_cast<std::size_t>(std::popcount(known_.word(i)));
  made_.pieces.reserve(most);
  walk();
  if (progress_.cancelled()) return {};
  if (!made_.pieces.empty()) close();
  return std::move(made_);
}

void StackPass::walk() {
  const auto count = static_cast<std::uint32_t>(outline_.base().segment_count());
  Outline::Junction before{};
  bool stale = true;
  std::uint64_t dead = 0;
  for (std::uint32_t step = 0; step < count; ++step, dead >>= 4) {
    if (step % 16 == 0) {
      if (step % 4096 == 0 && progress_.cancelled()) return;
      if (const std::uint32_t next = glide_blocks(step); next > step) {
        step = next - 1;
        stale = true;
        continue;
      }
      dead = known_.word(step / 16);
    }
    if ((dead & 15) == 15) {
      previous_ = Piece::none;
      stale = true;
      continue;
    }
    if (const std::uint32_t next = glide(step, dead); next > step) {
      dead >>= 4 * (next - 1 - step);
      step = next - 1;
      stale = true;
      continue;
    }
    const Outline::Junction after = outline_.junction(step);
    if ((dead & 1) == 0) {
      if (stale) before = outline_.junction(outline_.before(step));
      add_line(step, before, after);
    } else {
      previous_ = Piece::none;
    }
    if (after.kind >= CornerKind::Tangent && !outline_.is_cap(step)) add_corner(step, after, dead);
    before = after;
    stale = false;
  }
}

void StackPass::append(std::uint32_t step, bool arc) {
  made_.pieces.push_back(Piece::linked_to({step, SiteKind::Line}));
  if (arc) made_.pieces.push_back(Piece::linked_to({step, SiteKind::Arc}));
  placed_ = false;
}

/// Where line follows line, or an arc between, and inner corners leave a length of each line, nothing needs a look:
/// pushes all that up to the end of a block, without their places. The first step that is not so, or whose end is not.
std::uint32_t StackPass::glide(std::uint32_t step, std::uint64_t dead) {
  if (!goes_on()) return step;
  const std::uint32_t last = (step / Block::size + 1) * Block::size;
  for (; step < last && (dead & 1) == 0 && outline_.plain_length(step) > margin_; ++step, dead >>= 4) {
    const bool arc = outline_.corner(step) == CornerKind::Arc;
    if (arc && (dead & 2) != 0) break;
    append(step, arc);
  }
  previous_ = packed(made_.pieces.back().site());
  return step;
}

/// The same for whole blocks, all of whose pieces are there.
std::uint32_t StackPass::glide_blocks(std::uint32_t step) {
  if (!goes_on()) return step;
  for (const std::uint32_t first = step; step / Block::size < blocks_.size();) {
    const Block& block = blocks_[step / Block::size];
    if (!(d_ < block.plain_below) || known_.word(step / Block::size) != block.absent) break;
    if (step > first && step % 4096 == 0) break;  // progress is to be asked
    std::uint64_t arcs = block.arcs();
    for (const std::uint32_t last = step + Block::size; step < last; ++step, arcs >>= 4) append(step, (arcs & 1) != 0);
  }
  previous_ = packed(made_.pieces.back().site());
  return step;
}

/// One step's set buries it.
bool StackPass::kills(std::uint32_t step, Site site, Flat a, Flat b) {
  if (!witnesses_.in_set(site, a, b, step)) return false;
  witnesses_.remember(step);
  return true;
}

bool StackPass::is_dead_line(Site site, Flat a, Flat b, CornerKind before, CornerKind after) {
  const std::uint32_t step = site.step;
  const double size = dot(b - a, outline_.along<double>(step));
  if (is_overcut(outline_, step, size, margin_)) {
    if (found_ != nullptr) found_->add(site);
    return true;
  }
  // The tip of a mitre is seldom in a stadium beside it.
  const bool near = before != CornerKind::Mitre && after != CornerKind::Mitre;
  const bool dead = near && ((before == CornerKind::Apart && kills(outline_.before(step), site, a, b)) ||
                             (after == CornerKind::Apart && kills(outline_.after(step), site, a, b)));
  if (dead) bury(site);
  return dead;
}

inline void StackPass::add_line(std::uint32_t step, const Outline::Junction& before, const Outline::Junction& after) {
  const Site line{step, SiteKind::Line};
  const Flat a = before.start;
  const Flat b = after.end;
  if (!is_dead_line(line, a, b, before.kind, after.kind)) add(line, a, b);
  previous_ = after.kind == CornerKind::Apart ? Piece::none : packed(line);
}

void StackPass::add_corner(std::uint32_t step, const Outline::Junction& junction, std::uint64_t dead) {
  const auto add_kind = [&](SiteKind kind, Flat a, Flat b) {
    const Site site{step, kind};
    if ((dead >> static_cast<std::uint32_t>(kind)) & 1U) {
      previous_ = Piece::none;
      return;
    }
    if (goes_on()) {
      push(Piece::linked_to(site), a, b);
    } else {
      add(site, a, b);
    }
    previous_ = packed(site);
  };
  if (junction.kind == CornerKind::Tangent) {
    add_kind(SiteKind::Bevel, junction.end, junction.start);
  } else if (outline_.splits_arc(step)) {
    const Flat middle = outline_.end_of({step, SiteKind::Arc});
    add_kind(SiteKind::Arc, junction.end, middle);
    add_kind(SiteKind::SecondArc, middle, junction.start);
  } else {
    add_kind(SiteKind::Arc, junction.end, junction.start);
  }
}

/// True if p lies nearer than D - margin to the line's segment, or in the disc of the arc.
inline bool StackPass::holds(const Part& holder, Flat p, double margin) const {
  if (!(margin < d_)) return false;
  if (holder.line) return outline_.deep_inside(p, holder.site.step, margin);
  const Flat q = p - holder.centre;
  return dot(q, q) < (d_ - margin) * (d_ - margin);
}

/// True if p is between the ends, and so far from both that they keep their order.
inline bool StackPass::in_range(const Part& part, Flat p) const {
  const double slack = 16 * margin_;
  if (part.line) {
    const Flat whole = part.b - part.a;
    const double t = dot(p - part.a, whole);
    const double least = slack * (std::abs(whole.x) + std::abs(whole.y));
    return t > least && t < dot(whole, whole) - least;
  }
  const Flat c = part.centre;
  return cross(part.a - c, p - c) > slack * d_ && cross(p - c, part.b - c) > slack * d_;
}

/// Where the tail, going on, enters the stadium (disc) of the head, if that is on the head itself.
inline std::optional<Flat> StackPass::crossing(const Part& tail, const Part& head) const {
  Flat p;
  if (tail.line && head.line) {
    const Flat u = head.b - head.a;
    const double before = cross(u, tail.a - head.a);
    const double after = cross(u, tail.b - head.a);
    if (!(before < 0 && after > 0)) return std::nullopt;
    p = tail.a + (before / (before - after)) * (tail.b - tail.a);
  } else if (tail.line || head.line) {
    const Part& line = tail.line ? tail : head;
    const Flat u = unit(line.b - line.a);
    const Flat to = (tail.line ? head : tail).centre - line.a;
    const double across = cross(u, to);
    if (!(std::abs(across) < d_)) return std::nullopt;
    const double half = std::sqrt((d_ - across) * (d_ + across));
    p = line.a + (dot(u, to) + (tail.line ? -half : half)) * u;
  } else {
    const Flat to = head.centre - tail.centre;
    const double gap = length(to);
    if (!(gap > margin_ && gap < 2 * d_)) return std::nullopt;
    p = tail.centre + 0.5 * to + (std::sqrt((d_ - 0.5 * gap) * (d_ + 0.5 * gap)) / gap) * right_of(to);
  }
  if (!in_range(tail, p) || !in_range(head, p)) return std::nullopt;
  return p;
}

/// Where both are cut, if what that removes lies in the other's stadium.
std::optional<Flat> StackPass::place_of_cut(const Part& tail, const Part& head) const {
  if (tail.site.kind == SiteKind::Bevel || head.site.kind == SiteKind::Bevel) return std::nullopt;
  if (!holds(head, tail.b, margin_) || !holds(tail, head.a, margin_)) return std::nullopt;
  const std::optional<Flat> p = crossing(tail, head);
  if (!p) return std::nullopt;
  // An arc may leave a convex set and come back: its middle must be in it as well. A disc of the same radius it leaves
  // for more than half a turn.
  const auto middle_held = [&](const Part& arc, Flat a, Flat b, const Part& holder) {
    if (arc.line || !holder.line) return true;
    const Flat c = arc.centre;
    const Flat sum = (a - c) + (b - c);
    return holds(holder, c + (d_ / length(sum)) * sum, 0);
  };
  if (!middle_held(tail, *p, tail.b, head) || !middle_held(head, head.a, *p, tail)) return std::nullopt;
  return p;
}

std::optional<Flat> StackPass::cut(Piece& tail, const Part& left_of_tail, Piece& head, const Part& left_of_head) {
  const std::optional<Flat> p = place_of_cut(left_of_tail, left_of_head);
  if (!p) return p;
  tail.trim_b = static_cast<std::uint32_t>(made_.trims.size());
  made_.trims.push_back({*p, packed(head.site())});
  head.trim_a = static_cast<std::uint32_t>(made_.trims.size());
  made_.trims.push_back({*p, packed(tail.site())});
  head.link(true);
  return p;
}

void StackPass::push(Piece piece, Flat a, Flat b) {
  made_.pieces.push_back(piece);
  tail_a_ = a;
  tail_b_ = b;
  placed_ = true;
}

/// The disc of a corner lies in the stadia beside it.
bool StackPass::buried_by_tail(Site site, Flat a, Flat b) {
  const Site tail = made_.pieces.back().site();
  return kills(tail.step, site, a, b) || (tail.kind != SiteKind::Line && kills(outline_.after(tail.step), site, a, b));
}

void StackPass::add(Site site, Flat a, Flat b) {
  auto& pieces = made_.pieces;
  Piece head(site);
  head.link(goes_on());
  while (!head.linked() && !pieces.empty()) {
    place_tail();
    Piece& tail = pieces.back();
    if (witnesses_.deep(tail_a_, site.step)) {
      if (!kills(site.step, tail.site(), tail_a_, tail_b_)) break;
      bury(tail.site());
      pieces.pop_back();
      placed_ = false;
    } else if (const std::optional<Flat> p = cut(tail, part(tail.site(), tail_a_, tail_b_), head, part(site, a, b))) {
      a = *p;
    } else {
      break;
    }
  }
  if (!head.linked()) {
    if (!pieces.empty() && buried_by_tail(site, a, b)) return bury(site);
    if (witnesses_.covers(site, a, b)) return bury(site);
  }
  push(head, a, b);
}

/// The seam of the walk: its last pieces and its first ones.
void StackPass::close() {
  auto& pieces = made_.pieces;
  std::size_t first = 0;
  bool popped = true;
  while (popped && pieces.size() - first > 1) {
    popped = false;
    const Piece head = pieces[first];
    const Piece tail = pieces.back();
    if (head.site().kind == SiteKind::Line && kills(head.step(), tail.site(), start(tail), end(tail))) {
      pieces.pop_back();
      popped = true;
    } else if (tail.site().kind == SiteKind::Line && kills(tail.step(), head.site(), start(head), end(head))) {
      ++first;
      popped = true;
    }
  }
  pieces.erase(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(first));
  Piece& head = pieces.front();
  Piece& tail = pieces.back();
  head.link(false);
  if (pieces.size() < 2) return;
  const bool whole = head.trim_a == Piece::none && tail.trim_b == Piece::none;
  if (previous_ != Piece::none && packed(tail.site()) == previous_ && whole &&
      head.site() == Site{outline_.after(unpacked(previous_).step), SiteKind::Line}) {
    head.link(true);
  } else if (whole) {
    cut(tail, part(tail), head, part(head));
  }
}

}  // namespace

Candidates candidates(const Outline& outline, const Clearance& clearance, WitnessSearch& witnesses, const Buried& known,
                      Buried* found, const base::Progress& progress) {
  return StackPass(outline, clearance, witnesses, known, found, progress).run();
}

}  // namespace dobra::offset::general
