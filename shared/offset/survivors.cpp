#include "shared/offset/survivors.h"

#include <algorithm>
#include <optional>

namespace dobra::offset {

namespace {

class Pass {
 public:
  explicit Pass(const Outline& outline)
      : outline_(outline), d_(outline.distance()), margin_(1e-14 * (outline.base().size + outline.distance())) {}

  std::vector<Piece> run();

 private:
  void walk(std::uint32_t first, std::uint32_t last);
  void add_corner(std::uint32_t step, const Outline::Junction& junction);
  void add_line(std::uint32_t step, const Outline::Junction& before, const Outline::Junction& after);
  void add(Piece piece);
  void close(std::size_t bottom);
  void cut(Piece& tail, Piece& head) const;
  [[nodiscard]] bool in_pill(const Piece& piece, std::uint32_t step) const;
  [[nodiscard]] bool buried(const Piece& piece, const Piece& other) const;
  [[nodiscard]] bool deep(Flat p, std::uint32_t step) const { return outline_.deep_inside(p, step, margin_); }
  [[nodiscard]] Flat centre(const Piece& arc) const { return outline_.to<double>(arc.site.step); }
  [[nodiscard]] std::optional<Flat> crossing(const Piece& tail, const Piece& head) const;
  [[nodiscard]] bool in_range(const Piece& piece, Flat p) const;
  [[nodiscard]] bool holds_end(const Piece& holder, Flat p) const;

  const Outline& outline_;
  const double d_;
  const double margin_;
  std::vector<Piece> pieces_;
  std::size_t bottom_ = 0;                    // of the walk under way
  std::uint32_t previous_ = Piece::none;      // the raw piece before, packed, if it ends where the next one starts
};

std::vector<Piece> Pass::run() {
  const std::uint32_t steps = outline_.step_count();
  pieces_.reserve(std::min<std::size_t>(steps, 4096));
  if (outline_.two_walks()) {
    walk(0, steps / 2);
    walk(steps / 2, steps);
  } else {
    walk(0, steps);
  }
  return std::move(pieces_);
}

void Pass::walk(std::uint32_t first, std::uint32_t last) {
  bottom_ = pieces_.size();
  previous_ = Piece::none;
  Outline::Junction before = outline_.junction(outline_.before(first));
  for (std::uint32_t step = first; step < last; ++step) {
    const Outline::Junction after = outline_.junction(step);
    add_line(step, before, after);
    add_corner(step, after);
    before = after;
  }
  const bool open_ended = !outline_.base().closed && last == outline_.base().segment_count();
  if (open_ended) {  // without the left side the other cap is still due
    previous_ = Piece::none;
    const auto cap = static_cast<std::uint32_t>(2 * last - 1);
    add_corner(cap, outline_.junction(cap));
  }
  if (pieces_.size() > bottom_) close(bottom_);
}

void Pass::add_line(std::uint32_t step, const Outline::Junction& before, const Outline::Junction& after) {
  Piece line;
  line.site = {step, Role::Line};
  line.a = before.start;
  line.b = after.end;
  bool dead = false;
  const Flat u = outline_.along<double>(step);
  const double size = dot(line.b - line.a, u);
  if (size <= margin_) {
    // Cut from both sides beyond its middle: every point of it is nearer than D to one neighbour or the other.
    dead = size < -margin_ || !(dot(outline_.natural_end<Real>(line.site) - outline_.natural_start<Real>(line.site),
                                    outline_.along<Real>(step)) > Real(3.5e-18L) * (outline_.base().size + d_));
  }
  dead = dead || (before.kind == Outline::Corner::Apart && in_pill(line, outline_.before(step))) ||
         (after.kind == Outline::Corner::Apart && in_pill(line, outline_.after(step)));
  if (!dead) add(line);
  previous_ = after.kind == Outline::Corner::Apart ? Piece::none : packed(line.site);
}

void Pass::add_corner(std::uint32_t step, const Outline::Junction& junction) {
  const auto add_role = [&](Role role, Flat a, Flat b) {
    Piece piece;
    piece.site = {step, role};
    piece.a = a;
    piece.b = b;
    add(piece);
    previous_ = packed(piece.site);
  };
  if (junction.kind == Outline::Corner::Tangent) {
    add_role(Role::Bevel, junction.end, junction.start);
  } else if (junction.kind == Outline::Corner::Arc) {
    if (outline_.splits_arc(step)) {
      const Flat middle = outline_.natural_end<double>({step, Role::Arc});
      add_role(Role::Arc, junction.end, middle);
      add_role(Role::SecondArc, middle, junction.start);
    } else {
      add_role(Role::Arc, junction.end, junction.start);
    }
  }
}

/// Both ends deep in the pill, and for an arc the crossing of its end tangents too.
bool Pass::in_pill(const Piece& piece, std::uint32_t step) const {
  if (!deep(piece.a, step) || !deep(piece.b, step)) return false;
  if (piece.is_line()) return true;
  const Flat c = centre(piece);
  const Flat sum = (piece.a - c) + (piece.b - c);
  return deep(c + (2 * d_ * d_ / dot(sum, sum)) * sum, step);
}

bool Pass::buried(const Piece& piece, const Piece& other) const {
  // The disc of a corner lies in the pills beside it.
  return in_pill(piece, other.site.step) ||
         (other.site.role != Role::Line && !outline_.is_cap(other.site.step) && in_pill(piece, outline_.after(other.site.step)));
}

/// True if p lies deep in the pill of the line, or the disc of the arc.
bool Pass::holds_end(const Piece& holder, Flat p) const {
  if (holder.is_line()) return deep(p, holder.site.step);
  const Flat q = p - centre(holder);
  return dot(q, q) < (d_ - margin_) * (d_ - margin_);
}

bool Pass::in_range(const Piece& piece, Flat p) const {
  if (piece.is_line()) {
    const Flat whole = piece.b - piece.a;
    const double t = dot(p - piece.a, whole);
    return t > 0 && t < dot(whole, whole);
  }
  const Flat c = centre(piece);
  return cross(piece.a - c, p - c) > 0 && cross(p - c, piece.b - c) > 0;
}

/// Where the tail, going on, enters the pill (disc) of the head, if that is on the head itself.
std::optional<Flat> Pass::crossing(const Piece& tail, const Piece& head) const {
  Flat p;
  if (tail.is_line() && head.is_line()) {
    const Flat u = head.b - head.a;
    const double before = cross(u, tail.a - head.a);
    const double after = cross(u, tail.b - head.a);
    if (!(before < 0 && after > 0)) return std::nullopt;
    p = tail.a + (before / (before - after)) * (tail.b - tail.a);
  } else if (tail.is_line()) {
    const Flat u = unit(tail.b - tail.a);
    const Flat to = centre(head) - tail.a;
    const double across = cross(u, to);
    if (!(std::abs(across) < d_)) return std::nullopt;
    p = tail.a + (dot(u, to) - std::sqrt((d_ - across) * (d_ + across))) * u;
  } else if (head.is_line()) {
    const Flat u = unit(head.b - head.a);
    const Flat to = centre(tail) - head.a;
    const double across = cross(u, to);
    if (!(std::abs(across) < d_)) return std::nullopt;
    p = head.a + (dot(u, to) + std::sqrt((d_ - across) * (d_ + across))) * u;
  } else {
    const Flat c = centre(tail);
    const Flat to = centre(head) - c;
    const double gap = length(to);
    if (!(gap > margin_ && gap < 2 * d_)) return std::nullopt;
    p = c + 0.5 * to + (std::sqrt((d_ - 0.5 * gap) * (d_ + 0.5 * gap)) / gap) * right_of(to);
  }
  if (!in_range(tail, p) || !in_range(head, p)) return std::nullopt;
  return p;
}

/// Cuts both where they cross, if what that removes lies in the other's pill.
void Pass::cut(Piece& tail, Piece& head) const {
  if (tail.site.role == Role::Bevel || head.site.role == Role::Bevel) return;
  if (!holds_end(head, tail.b) || !holds_end(tail, head.a)) return;
  const std::optional<Flat> p = crossing(tail, head);
  if (!p) return;
  // An arc may leave a convex set and come back: its middle must be in it as well.
  const auto middle_held = [&](const Piece& arc, Flat a, Flat b, const Piece& holder) {
    if (arc.is_line()) return true;
    const Flat c = centre(arc);
    const Flat sum = (a - c) + (b - c);
    const Flat m = c + (d_ / length(sum)) * sum;
    return holder.is_line() ? outline_.deep_inside(m, holder.site.step, 0) : dot(m - centre(holder), m - centre(holder)) <= d_ * d_;
  };
  if (!middle_held(tail, *p, tail.b, head) || !middle_held(head, head.a, *p, tail)) return;
  tail.b = *p;
  tail.cut_b = packed(head.site);
  head.a = *p;
  head.cut_a = packed(tail.site);
  head.linked = true;
}

void Pass::add(Piece piece) {
  while (pieces_.size() > bottom_ && piece.site.role == Role::Line && in_pill(pieces_.back(), piece.site.step)) {
    pieces_.pop_back();
  }
  piece.linked = false;
  if (pieces_.size() > bottom_) {
    Piece& tail = pieces_.back();
    if (previous_ != Piece::none && packed(tail.site) == previous_ && tail.cut_b == Piece::none) {
      piece.linked = true;
    } else {
      if (buried(piece, tail)) return;
      cut(tail, piece);
    }
  }
  pieces_.push_back(piece);
}

/// The seam of the walk: its last pieces and its first ones.
void Pass::close(std::size_t bottom) {
  std::size_t first = bottom;
  bool popped = true;
  while (popped && pieces_.size() - first > 1) {
    popped = false;
    Piece& head = pieces_[first];
    Piece& tail = pieces_.back();
    if (head.site.role == Role::Line && in_pill(tail, head.site.step)) {
      pieces_.pop_back();
      popped = true;
    } else if (tail.site.role == Role::Line && in_pill(head, tail.site.step)) {
      ++first;
      popped = true;
    }
  }
  pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(bottom), pieces_.begin() + static_cast<std::ptrdiff_t>(first));
  Piece& head = pieces_[bottom];
  Piece& tail = pieces_.back();
  head.linked = false;
  if (pieces_.size() - bottom < 2) return;
  if (previous_ != Piece::none && packed(tail.site) == previous_ && tail.cut_b == Piece::none &&
      head.cut_a == Piece::none && head.site == Site{outline_.after(unpacked(previous_).step), Role::Line}) {
    head.linked = true;
  } else if (head.cut_a == Piece::none && tail.cut_b == Piece::none) {
    cut(tail, head);
  }
  if (bottom > 0) head.linked = false;  // only scissors, whose seam nobody asks for
}

}  // namespace

std::vector<Piece> survivors(const Outline& outline) { return Pass(outline).run(); }

}  // namespace dobra::offset
