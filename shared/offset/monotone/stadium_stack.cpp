#include "shared/offset/monotone/stadium_stack.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace dobra::offset::monotone {

using geom::Point;
using geom::Vector;

JoinRule::JoinRule(const OffsetOptions& options) {
  if (options.join == Join::Round || options.join == Join::Bevel) return;
  mitre_below_ = std::numeric_limits<double>::infinity();
  const double limit = options.tip_limit();
  if (limit < 1e150) mitre_below_ = std::sqrt(limit * limit * (1 + 1e-14) - 1);  // as outer_corner says
  if (options.beyond_tip_limit() == BeyondLimit::TangentBevel) beyond_ = CornerKind::Tangent;
}

namespace {

class StadiumStack {
 public:
  StadiumStack(const BaseCurve& base, Vector forward, double distance, const JoinRule& joins, StadiaLeft& left)
      : base_(base),
        d_(distance),
        joins_(joins),
        touching_(touching(base, distance)),
        forward_(forward),
        cap_(base.points[0] - distance * forward),
        left_(left) {}

  Stacked run();

 private:
  /// The last part: a line of `segment`, or the arc about `centre`.
  struct Tail {
    Point start;
    std::uint32_t segment;
    bool is_arc;
    Point centre;
  };

  void reserve();
  void note_cut_before();
  void add_left(std::size_t block);
  void add_line(std::size_t i);
  void add_after_gap(std::size_t i);
  void add_disc(std::size_t i);
  void push_last_disc();
  // In line, so that the tail stays in registers: a fifth of the time of hidden segments.
  [[gnu::always_inline]] inline void add_entered(std::size_t i, const Tail& tail, Point end);
  void add_segment(std::size_t i);
  void add_outer_corner(std::size_t i);
  void add_under_tail(std::size_t i);
  void add_regular(std::size_t first, std::size_t last);
  void add_mitres(std::size_t first, std::size_t last);
  void add_arcs(std::size_t first, std::size_t last);
  void add_any(std::size_t first, std::size_t last);
  [[nodiscard]] bool regular(std::size_t block) const {
    return d_ < base_.blocks[block].regular_below && left_[block] == base_.blocks[block].sites;
  }
  [[nodiscard]] bool all_mitres(std::size_t block) const {
    return !joins_.only_arcs() && joins_.of(base_.blocks[block].greatest_outer) == CornerKind::Mitre;
  }
  [[nodiscard]] std::size_t outer_count(std::size_t first, std::size_t last) const {
    std::size_t found = 0;
    for (std::size_t i = first; i < last; ++i) found += base_.turn[i] == Turn::Outer;
    return found;
  }
  template <class Inside>
  Tail pop_hidden(const Inside& inside, Point& end);
  [[nodiscard, gnu::always_inline]] inline Point entry(const Tail& tail, Point end, Point disc) const;
  [[nodiscard]] std::optional<Point> above_start(const Tail& tail, Point disc) const;
  [[nodiscard]] bool reaches(const Tail& tail, Point disc) const;
  /// What links the tail with a new stadium may be left out, so that all above the stadium counts, not only what is in
  /// it.
  /// @param first  where the stadium starts whose end the disc is.
  [[nodiscard]] bool in_disc_or_above(Point at, Point disc, Point first) const {
    const Vector to = at - disc;
    return geom::length_squared(to) < d_ * (d_ + 2 * touching_) ||
           (geom::cross(forward_, to) >= 0 && begins_before(first, at));
  }
  [[nodiscard]] bool begins_before(Point first, Point at) const { return geom::dot(forward_, at - first) > -d_; }
  void hide_line(std::size_t i) { left_[i / BaseCurve::block_size] &= ~BaseCurve::line_bit(i); }
  void hide_corner(std::size_t i) { left_[i / BaseCurve::block_size] &= ~BaseCurve::corner_bit(i); }

  static constexpr std::size_t batch = 64;  // regular segments that are added at a time

  void push(Point p, OffsetEdge edge) {
    made_.repeats |= !made_.points.empty() && p == made_.points.back();
    made_.points.push_back(p);
    made_.edges.push_back(edge);
  }
  void pop() {
    made_.points.pop_back();
    made_.edges.pop_back();
  }
  /// Segment i ends the envelope with its whole line.
  void finish_line(std::size_t i) {
    made_.tip = base_.points[i + 1] + d_ * geom::right_of(base_.headings[i]);
    on_foot_ = true;
  }
  void note_cut(std::size_t corner) { made_.cut[corner / 64] |= std::uint64_t{1} << (corner % 64); }
  /// @pre an outer corner.
  void note_cut_mitre(std::size_t corner) {
    if (joins_.of(base_.half_tans[corner]) != CornerKind::Arc) note_cut(corner);
  }

  const BaseCurve& base_;
  const double d_;
  const JoinRule& joins_;
  const double touching_;
  const Vector forward_;
  const Point cap_;  // start of the arc about the first point, which is below all on the stack
  StadiaLeft& left_;
  Stacked made_{};
  std::size_t next_ = 0;  // the point whose disc ends the envelope so far
  bool on_foot_ = true;   // the tip is the end of the last segment's own line
  bool natural_ = false;  // that line also starts where its corner says
};

/// Nearly exact where little is hidden, so that nothing is copied; grown as needed where much is.
void StadiumStack::reserve() {
  constexpr std::size_t size = BaseCurve::block_size;
  const std::size_t count = base_.segment_count();
  std::size_t points = 0;
  for (std::size_t b = 0; b < base_.blocks.size(); ++b) {
    const std::size_t last = std::min(count, (b + 1) * size);
    if (!regular(b)) {
      points += static_cast<std::size_t>(std::popcount(left_[b] & 0xffffU)) / 4;
    } else {
      points += last - b * size;
      if (!all_mitres(b)) points += outer_count(b * size, last);
    }
  }
  made_.points.reserve(points + 2 * batch + 1);  // the overhang of a batch, and the tip
  made_.edges.reserve(points + 2 * batch + 1);
}

Stacked StadiumStack::run() {
  constexpr std::size_t size = BaseCurve::block_size;
  const std::size_t count = base_.segment_count();
  reserve();
  if (!joins_.only_arcs()) note_cut_before();
  // What regular parts leave is above rounding (see measure_blocks), and so are their arcs, with few exceptions.
  made_.repeats = d_ > 100 * base_.size || d_ * base_.least_outer < 1e-13 * (base_.size + d_);
  for (std::size_t b = 0; b * size < count;) {
    std::size_t i = b * size;
    if (!regular(b++)) {
      add_left(b - 1);
      continue;
    }
    while (b * size < count && regular(b)) ++b;
    const std::size_t last = std::min(b * size, count);
    do add_line(i++);
    while (i < last && !natural_);
    if (i < last) add_regular(i, last);
  }
  made_.repeats |= !made_.points.empty() && made_.tip == made_.points.back();
  // The ends are always looked at.
  left_.front() |= BaseCurve::line_bit(0);
  left_.back() |= BaseCurve::line_bit(count - 1);
  return std::move(made_);
}

/// The corners that a smaller distance has hidden.
void StadiumStack::note_cut_before() {
  made_.cut.assign(base_.segment_count() / 64 + 1, 0);
  for (std::size_t b = 0; b < left_.size(); ++b) {
    for (std::uint32_t bits = (base_.blocks[b].sites & ~left_[b]) >> BaseCurve::block_size; bits != 0;
         bits &= bits - 1) {
      const std::size_t corner = b * BaseCurve::block_size + static_cast<std::size_t>(std::countr_zero(bits));
      note_cut_mitre(corner);
    }
  }
}

void StadiumStack::add_left(std::size_t block) {
  const std::uint32_t left = left_[block];
  for (std::uint32_t bits = (left | left >> BaseCurve::block_size) & 0xffffU; bits != 0; bits &= bits - 1) {
    const std::size_t i = block * BaseCurve::block_size + static_cast<std::size_t>(std::countr_zero(bits));
    if ((left & BaseCurve::line_bit(i)) != 0) {
      add_line(i);
    } else if (i != next_) {
      add_disc(i);
    }
  }
}

void StadiumStack::add_line(std::size_t i) {
  if (i == next_) {
    add_segment(i);
  } else {
    add_after_gap(i);
  }
  next_ = i + 1;
}

/// Segments that leave each other a part of their lines: the tail needs no look.
void StadiumStack::add_regular(std::size_t first, std::size_t last) {
  while (first < last) {
    const std::size_t stop = std::min(last, (first / batch + 1) * batch);
    bool plain = true;
    for (std::size_t b = first / BaseCurve::block_size; b * BaseCurve::block_size < stop; ++b)
      plain = plain && all_mitres(b);
    if (plain) {
      add_mitres(first, stop);
    } else if (joins_.only_arcs()) {
      add_arcs(first, stop);
    } else {
      add_any(first, stop);
    }
    first = stop;
  }
  finish_line(last - 1);
  next_ = last;
}

void StadiumStack::add_mitres(std::size_t first, std::size_t last) {
  static constexpr double sign[] = {0.0, 1.0, -1.0};  // of a Turn
  static constexpr std::uint32_t mark[] = {0U, mitred, 0U};
  const std::size_t size = made_.points.size();
  made_.points.resize(size + last - first);
  made_.edges.resize(size + last - first);
  Point* const point = made_.points.data() + size - first;
  OffsetEdge* const edge = made_.edges.data() + size - first;
  for (std::size_t i = first; i < last; ++i) {
    const auto turn = static_cast<std::size_t>(base_.turn[i]);
    point[i] = tip_at(base_, i, d_, sign[turn] * base_.half_tans[i]);
    edge[i] = OffsetEdge::line(static_cast<std::uint32_t>(i) | mark[turn]);
  }
}

void StadiumStack::add_arcs(std::size_t first, std::size_t last) {
  static constexpr double sign[] = {0.0, 0.0, -1.0};  // of a Turn; an outer corner starts at its foot
  const std::size_t size = made_.points.size();
  const std::size_t end = size + (last - first) + outer_count(first, last);
  made_.points.resize(end + 1);
  made_.edges.resize(end + 1);
  Point* point = made_.points.data() + size;
  OffsetEdge* edge = made_.edges.data() + size;
  for (std::size_t i = first; i < last; ++i) {
    // The second foot is overwritten if there is none: no branch, as turns cannot be foretold.
    const bool outer = base_.turn[i] == Turn::Outer;
    point[0] = tip_at(base_, i, d_, sign[static_cast<std::size_t>(base_.turn[i])] * base_.half_tans[i]);
    edge[0] = outer ? OffsetEdge::arc(i - 1) : OffsetEdge::line(i);
    point[1] = foot_after(base_, i, d_);
    edge[1] = OffsetEdge::line(i);
    point += 1 + outer;
    edge += 1 + outer;
  }
  made_.points.resize(end);
  made_.edges.resize(end);
}

void StadiumStack::add_any(std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    const double t = base_.half_tans[i];
    if (base_.turn[i] != Turn::Outer) {
      push(tip_at(base_, i, d_, -t), OffsetEdge::line(i));
    } else {
      made_.tip = foot_before(base_, i, d_);
      add_outer_corner(i);
    }
  }
}

/// The end of the last line is on the envelope, or the arc that follows it is.
void StadiumStack::add_outer_corner(std::size_t i) {
  const CornerKind fill = joins_.of(base_.half_tans[i]);
  if (on_foot_ && fill == CornerKind::Mitre) {
    push(tip_at(base_, i, d_, base_.half_tans[i]), OffsetEdge::line(i | mitred));
  } else if (on_foot_ && fill == CornerKind::Tangent) {
    const double quarter = quarter_of(base_.half_tans[i]);
    push(bevel_start(base_, i, d_, quarter), OffsetEdge::arc((i - 1) | mitred));
    push(bevel_end(base_, i, d_, quarter), OffsetEdge::line(i | mitred));
  } else {
    if (fill != CornerKind::Arc) note_cut(i);
    push(made_.tip, OffsetEdge::arc(i - 1));
    push(foot_after(base_, i, d_), OffsetEdge::line(i));
  }
}

void StadiumStack::add_segment(std::size_t i) {
  const Vector u = base_.headings[i];
  const Point p = base_.points[i];
  natural_ = true;
  if (i == 0) {
    push(p + d_ * geom::right_of(u), OffsetEdge::line(i));
    return finish_line(i);
  }
  const Turn turn = base_.turn[i];
  if (turn == Turn::Outer) {
    if (!on_foot_ && geom::dot(made_.tip - p, u) > -touching_) {
      note_cut_mitre(i);
      return add_under_tail(i);
    }
    add_outer_corner(i);
    return finish_line(i);
  }
  if (!on_foot_) return add_under_tail(i);
  if (turn == Turn::Inner) {
    // The two lines meet on the bisector, if it is within both.
    const double back = d_ * base_.half_tans[i];
    const Vector before = base_.headings[i - 1];
    const Point meet = made_.tip - back * before;
    const bool at_mitre = (made_.edges.back().base_edge() & mitred) != 0;
    const Point start = at_mitre ? foot_after(base_, i - 1, d_) : made_.points.back();
    if (back > base_.spans[i] - touching_ || geom::dot(meet - start, before) <= touching_) return add_under_tail(i);
    push(meet, OffsetEdge::line(i));
    return finish_line(i);
  }
  push(p + d_ * geom::right_of(u), OffsetEdge::line(i));
  finish_line(i);
}

/// Takes off what starts inside; `end` becomes the end of the tail that is left.
template <class Inside>
StadiumStack::Tail StadiumStack::pop_hidden(const Inside& inside, Point& end) {
  while (!made_.edges.empty()) {
    const OffsetEdge edge = made_.edges.back();
    const std::uint32_t segment = edge.base_edge() & ~mitred;
    if (edge.base_edge() == segment) {
      const Point start = made_.points.back();
      if (!inside(start)) return {start, segment, edge.is_arc(), base_.points[segment + 1]};
      end = start;
      edge.is_arc() ? hide_corner(segment + 1) : hide_line(segment);
      pop();
      continue;
    }
    // A corner: its line starts at the second foot, its arc at the first.
    const Point second = foot_after(base_, segment, d_);
    if (!inside(second)) return {second, segment, false, {}};
    end = second;
    hide_line(segment);
    const Point first = foot_before(base_, segment, d_);
    note_cut(segment);
    pop();
    if (joins_.of(base_.half_tans[segment]) == CornerKind::Tangent) pop();
    if (!inside(first)) {
      push(first, OffsetEdge::arc(segment - 1));
      return {first, segment - 1, true, base_.points[segment]};
    }
    hide_corner(segment);
    end = first;
  }
  return {cap_, 0, true, base_.points[0]};
}

/// The arc about the last point, which nothing that follows at once takes over.
void StadiumStack::push_last_disc() {
  if (base_.turn[next_] == Turn::Outer) note_cut_mitre(next_);
  push(made_.tip, OffsetEdge::arc(next_ - 1));
}

/// What came just before is known to be hidden: the tail goes on about its last disc and may enter the stadium
/// anywhere.
void StadiumStack::add_after_gap(std::size_t i) {
  natural_ = false;
  const Vector u = base_.headings[i];
  const Point p = base_.points[i];
  push_last_disc();
  const auto inside = [&](Point at) {
    const double s = geom::dot(at - p, u);
    if (s < 0) return in_disc_or_above(at, p, p);
    if (s > base_.spans[i]) return in_disc_or_above(at, base_.points[i + 1], p);
    return begins_before(p, at) && geom::dot(at - p, geom::right_of(u)) - d_ < touching_;
  };
  Point end = made_.tip;
  const Tail tail = pop_hidden(inside, end);
  if (base_.turn[i] == Turn::Outer) note_cut_mitre(i);
  const auto enter_disc = [&](Point in) {
    push(in, OffsetEdge::arc(i - 1));
    push(foot_after(base_, i, d_), OffsetEdge::line(i));
    finish_line(i);
  };
  if (const auto above = above_start(tail, p)) return enter_disc(*above);
  if (reaches(tail, p)) {
    const Point in = entry(tail, end, p);
    if (geom::dot(in - p, u) <= -touching_) return enter_disc(in);
  }
  hide_corner(i);
  add_entered(i, tail, end);
}

/// Of a segment that is hidden itself; what came just before is too.
void StadiumStack::add_disc(std::size_t i) {
  const Point p = base_.points[i];
  push_last_disc();
  Point end = made_.tip;
  const Tail tail = pop_hidden([&](Point at) { return in_disc_or_above(at, p, p); }, end);
  made_.tip = above_start(tail, p).value_or(entry(tail, end, p));
  on_foot_ = false;
  next_ = i;
}

/// Where what links the tail with a disc is left out the disc may start below it: then the tail goes on to the place
/// above that start. What is left out is hidden by stadia to come, and so will that place be.
std::optional<Point> StadiumStack::above_start(const Tail& tail, Point disc) const {
  const Point start = disc - d_ * forward_;
  const double x = geom::dot(forward_, start - tail.start);
  if (x < 0) return std::nullopt;
  Point above;
  if (tail.is_arc) {
    const double along = std::min(geom::dot(forward_, start - tail.centre), d_);
    above = tail.centre + along * forward_ + std::sqrt((d_ - along) * (d_ + along)) * geom::right_of(forward_);
  } else {
    const Vector u = base_.headings[tail.segment];
    above = tail.start + (x / geom::dot(forward_, u)) * u;
  }
  if (geom::cross(forward_, above - start) > 0) return above;
  return std::nullopt;
}

/// The new segment's own start is hidden: its stadium appears at the first place where the tail enters it.
void StadiumStack::add_under_tail(std::size_t i) {
  natural_ = false;
  if (base_.turn[i] == Turn::Outer) hide_corner(i);
  const Vector u = base_.headings[i];
  const Vector n = geom::right_of(u);
  const Point p = base_.points[i];
  const double span = base_.spans[i];
  // The tail is outside the disc about p, so only line and far disc of the stadium count.
  const auto inside = [&](Point at) {
    const double s = geom::dot(at - p, u);
    if (s > span) return in_disc_or_above(at, base_.points[i + 1], p);
    return s > 0 && geom::dot(at - p, n) - d_ < touching_ && begins_before(p, at);
  };
  Point end = made_.tip;
  const Tail tail = pop_hidden(inside, end);
  add_entered(i, tail, end);
}

/// The tail enters the stadium of segment i on its line or on its far disc.
void StadiumStack::add_entered(std::size_t i, const Tail& tail, Point end) {
  const Vector u = base_.headings[i];
  const Vector n = geom::right_of(u);
  const Point p = base_.points[i];
  const double span = base_.spans[i];
  const auto beyond = [&](Point at) { return geom::dot(at - p, n) - d_; };
  const auto cut_at = [&](Point cut) {
    push(cut, OffsetEdge::line(i));
    finish_line(i);
  };
  if (tail.is_arc) {
    // Circle and stadium cross twice at most; of the two places on the line this is where an anticlockwise arc enters.
    const Vector to = tail.centre - p;
    const double gap = d_ - geom::dot(to, n);
    if (gap <= d_) {
      const double s = geom::dot(to, u) + std::sqrt(std::max(0.0, (d_ - gap) * (d_ + gap)));
      if (s <= span - touching_) return cut_at(p + std::max(0.0, s) * u + d_ * n);
    }
  } else if (const double start_beyond = beyond(tail.start); start_beyond >= 0) {
    const double end_beyond = std::min(0.0, beyond(end));
    const double t = start_beyond > 0 ? start_beyond / (start_beyond - end_beyond) : 0.0;
    const Point cut = tail.start + t * (end - tail.start);
    if (geom::dot(cut - p, u) <= span - touching_) return cut_at(cut);
  }
  hide_line(i);
  made_.tip = entry(tail, end, base_.points[i + 1]);
  on_foot_ = false;
}

bool StadiumStack::reaches(const Tail& tail, Point disc) const {
  if (tail.is_arc) return geom::length_squared(disc - tail.centre) <= 4 * d_ * d_;
  return std::abs(geom::cross(base_.headings[tail.segment], disc - tail.start)) <= d_;
}

/// Where the tail, which ends inside the disc of radius D about `disc`, enters it.
Point StadiumStack::entry(const Tail& tail, Point end, Point disc) const {
  if (tail.is_arc) {
    const Vector to = disc - tail.centre;
    const double gap = std::sqrt(geom::length_squared(to));
    const double height = std::sqrt(std::max(0.0, (d_ - 0.5 * gap) * (d_ + 0.5 * gap)));
    return tail.centre + 0.5 * to + (height / gap) * geom::right_of(to);
  }
  const Vector along = base_.headings[tail.segment];
  const Vector to = disc - tail.start;
  const double across = geom::cross(along, to);
  const double foot = geom::dot(along, to);
  const double t = foot - std::sqrt(std::max(0.0, (d_ - across) * (d_ + across)));
  return tail.start + std::clamp(t, 0.0, std::max(0.0, geom::dot(end - tail.start, along))) * along;
}

}  // namespace

StadiaLeft all_stadia(const BaseCurve& base) {
  StadiaLeft all;
  all.reserve(base.blocks.size());
  for (const BaseCurve::SiteBlock& block : base.blocks) all.push_back(block.sites);
  return all;
}

Stacked stack_stadia(const BaseCurve& base, Vector forward, double distance, const JoinRule& joins, StadiaLeft& left) {
  return StadiumStack(base, forward, distance, joins, left).run();
}

}  // namespace dobra::offset::monotone
