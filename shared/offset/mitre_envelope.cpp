#include "shared/offset/mitre_envelope.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include "shared/offset/lower_envelope.h"

namespace dobra::offset {

using geom::Point;
using geom::Vector;

namespace {

/// What a part of the curve is parallel to: the line of a segment, the arc about its end, or the bevel there.
enum class Kind : std::uint32_t { Line, Arc, Bevel };
constexpr std::uint32_t site_of(Kind kind, std::size_t segment) {
  return static_cast<std::uint32_t>(4 * segment) + static_cast<std::uint32_t>(kind);
}
constexpr std::uint32_t cap_site = 0xffffffffU;
constexpr Kind kind_of(std::uint32_t site) { return static_cast<Kind>(site % 4); }
constexpr std::size_t segment_of(std::uint32_t site) { return site / 4; }

/// Places along and across the forward axis.
struct Axis {
  Vector forward;
  [[nodiscard]] double x(Point p) const { return forward.x * p.x + forward.y * p.y; }
  [[nodiscard]] double y(Point p) const { return forward.x * p.y - forward.y * p.x; }
  [[nodiscard]] Point point(double x, double y) const {
    return {forward.x * x - forward.y * y, forward.y * x + forward.x * y};
  }
};

/// The lower boundary of a mitre: foot, tip or both ends of a bevel, foot.
struct Kite {
  std::array<Point, 4> at;  ///< Without a bevel the tip stands twice.
  bool bevelled;
  std::size_t corner;
  double lowest;  ///< Place of the tip across the axis.
};

class MitreEnvelope {
 public:
  MitreEnvelope(Stacked& stacked, const BaseCurve& base, Vector forward, double distance, const Filling& filling)
      : curve_(stacked), base_(base), axis_{forward}, d_(distance), filling_(filling), touching_(touching(base, distance)), parts_(stacked.edges.size()) {}

  bool run();

 private:
  struct Edit {
    std::size_t first, last;  ///< These parts go ...
    std::size_t from, to;     ///< ... and these added ones take their place.
  };

  // Kites.
  [[nodiscard]] Kite kite(std::size_t corner) const;
  [[nodiscard]] bool in_pill(const Kite& kite, std::size_t segment) const;
  std::vector<Span> lowest_kites();
  std::vector<Span> other_kites();
  [[nodiscard]] bool is_above_curve(const Kite& kite, std::size_t& hint) const;
  [[nodiscard]] bool is_above_part(Point p, std::size_t k) const;
  static std::uint64_t bit(std::size_t corner) { return std::uint64_t{1} << (corner % 64); }
  template <class Use> void for_each_cut(Use&& use) const {
    for (std::size_t word = 0; word < curve_.cut.size(); ++word) {
      for (std::uint64_t bits = curve_.cut[word]; bits != 0; bits &= bits - 1) {
        use(word * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
      }
    }
  }
  void add_spans(const Kite& kite, std::vector<Span>& spans) const;

  // The curve of the pills, with caps.
  void add_caps();
  [[nodiscard]] double x_of(std::size_t k) const { return axis_.x(curve_.points[k]); }
  [[nodiscard]] std::size_t part_at(double x, std::size_t hint) const;
  [[nodiscard]] std::uint32_t site(std::size_t k) const;
  [[nodiscard]] Point centre(std::uint32_t site) const {
    return site == cap_site ? base_.points[0] : base_.points[segment_of(site) + 1];
  }

  // Laying the kites over it.
  void overlay(const std::vector<Span>& kites);
  void compare(const Span& w, std::size_t k, double x0, double x1);
  void compare_with_line(const Span& w, std::size_t k, double x0, double x1);
  void compare_with_arc(const Span& w, std::size_t k, double x0, double x1);
  void take_kite(const Span& w, std::size_t k, double x, const Point* at = nullptr);
  void take_curve(std::size_t k, double x, const Point* at = nullptr);
  [[nodiscard]] static OffsetEdge edge_of(std::uint32_t site) {
    const std::size_t segment = segment_of(site);
    return kind_of(site) == Kind::Line ? OffsetEdge::line(segment) : OffsetEdge::arc(segment | mitred);
  }
  void insert(Point p, OffsetEdge edge) {
    added_points_.push_back(p);
    added_edges_.push_back(edge);
  }
  void apply_edits();
  [[nodiscard]] bool is_short(Point p, Point q) const;
  [[nodiscard]] bool has_short_step(std::size_t from, std::size_t to) const;
  void drop_short_steps();

  // Where sites meet.
  struct Line {
    Point on;
    Vector along;
  };
  [[nodiscard]] Line line(std::uint32_t site) const;
  [[nodiscard]] Point meet(std::uint32_t a, std::uint32_t b, double x, double y) const;
  [[nodiscard]] bool natural_meet(std::uint32_t a, std::uint32_t b, Point& at) const;

  Stacked& curve_;
  const BaseCurve& base_;
  const Axis axis_;
  const double d_;
  const Filling& filling_;
  const double touching_;
  std::size_t parts_;
  double first_x_ = std::numeric_limits<double>::infinity();  // where the first kite that may be visible starts
  std::vector<Edit> edits_;
  std::vector<Point> added_points_;
  std::vector<OffsetEdge> added_edges_;
  bool on_kite_ = false;
  Span last_{};  // the span taken last
};

Kite MitreEnvelope::kite(std::size_t corner) const {
  const double t = base_.half_tans[corner];
  const bool bevelled = filling_.of(t) != Fill::Mitre;
  const double beyond = bevelled ? quarter_of(t) : t;  // of the feet, in D
  const Point tip = tip_at(base_, corner, d_, beyond);
  const Point end = bevelled ? bevel_end(base_, corner, d_, beyond) : tip;
  return {{foot_before(base_, corner, d_), tip, end, foot_after(base_, corner, d_)}, bevelled, corner, std::min(axis_.y(tip), axis_.y(end))};
}

/// Pills are convex, so what has its corners in one lies in it.
bool MitreEnvelope::in_pill(const Kite& kite, std::size_t segment) const {
  const Vector u = base_.headings[segment];
  const Point p = base_.points[segment];
  const double span = base_.spans[segment];
  for (const std::size_t k : {1, 2, 0, 3}) {  // the tip is what comes out as a rule
    const Vector to = kite.at[k] - p;
    const double h = geom::cross(u, to);
    const double s = geom::dot(u, to);
    const double beyond = s < 0 ? s : std::max(0.0, s - span);
    if (!(h * h + beyond * beyond < d_ * d_)) return false;
  }
  return true;
}

/// Drops the kites that a pill hides, and makes the envelope of the lowest ones, one from each stretch of the axis and each
/// few kites.
std::vector<Span> MitreEnvelope::lowest_kites() {
  LowerEnvelope envelope(touching_);
  std::vector<Span> spans;
  constexpr double stretch = 0.25;  // of D
  constexpr int few = 8;
  constexpr int patience = 8;  // looking for another pill costs more than trying the last one again
  std::size_t killer = 0;
  std::size_t hint = 0;
  int failures = 0;
  int seen = few;
  double end = -std::numeric_limits<double>::infinity();
  std::optional<Kite> lowest;
  const auto release = [&] {
    if (!lowest) return;
    curve_.cut[lowest->corner / 64] &= ~bit(lowest->corner);
    add_spans(*lowest, spans);
    envelope.add(spans);
  };
  for_each_cut([&](std::size_t corner) {
    const Kite made = kite(corner);
    bool hidden = in_pill(made, killer);
    if (!hidden && failures++ % patience == 0 && parts_ > 0) {
      hint = part_at(axis_.x(made.at[1]), hint);
      killer = curve_.edges[hint].base_edge() & ~mitred;
      hidden = in_pill(made, killer);
    }
    if (hidden) {
      failures = 0;
      curve_.cut[corner / 64] &= ~bit(corner);
      return;
    }
    first_x_ = std::min(first_x_, axis_.x(made.at[0]));
    const double x = axis_.x(base_.points[corner]);
    if (x > end && ++seen > few) {
      release();
      lowest = made;
      seen = 1;
      end = x + stretch * d_;
    } else if (made.lowest < lowest->lowest) {
      lowest = made;
    }
  });
  release();
  return envelope.finish();
}

/// The envelope of those that are left and come out below the curve.
std::vector<Span> MitreEnvelope::other_kites() {
  LowerEnvelope envelope(touching_);
  std::vector<Span> spans;
  std::size_t hint = 0;
  for_each_cut([&](std::size_t corner) {
    const Kite made = kite(corner);
    if (is_above_curve(made, hint)) return;
    add_spans(made, spans);
    envelope.add(spans);
  });
  curve_.cut = {};
  return envelope.finish();
}

/// False if it is not, or if it would take long to tell. The kite is convex, and so are the parts of the curve: their corners
/// tell; and its feet are on pills.
bool MitreEnvelope::is_above_curve(const Kite& kite, std::size_t& hint) const {
  constexpr std::size_t patience = 64;
  hint = part_at(axis_.x(kite.at[1]), hint);
  if (!is_above_part(kite.at[1], hint)) return false;
  const auto below = [&](std::size_t k, std::size_t arm) {
    return geom::cross(kite.at[arm + 1] - kite.at[arm], curve_.points[k] - kite.at[arm]) <= 0;
  };
  const double start = axis_.x(kite.at[0]);
  for (std::size_t k = hint; x_of(k) >= start; --k) {
    if (!below(k, 0)) return false;
    if (k == 0 || k + patience < hint) return false;
  }
  std::size_t k = hint + 1;
  for (std::size_t arm = kite.bevelled ? 1 : 2; arm < 3; ++arm) {
    const double end = axis_.x(kite.at[arm + 1]);
    for (; k <= parts_ && x_of(k) <= end; ++k) {
      if (!below(k, arm)) return false;
    }
    if (k > parts_ || k > hint + patience) return false;
    if (arm == 1 && !is_above_part(kite.at[2], k - 1)) return false;
  }
  return true;
}

/// @pre p is between the ends of part k, along the axis.
bool MitreEnvelope::is_above_part(Point p, std::size_t k) const {
  const std::uint32_t of = site(k);
  if (of == cap_site || kind_of(of) == Kind::Arc) {
    const Vector to = p - centre(of);
    return geom::length_squared(to) <= d_ * d_ || geom::cross(axis_.forward, to) >= 0;
  }
  return geom::cross(curve_.points[k + 1] - curve_.points[k], p - curve_.points[k]) >= 0;
}

void MitreEnvelope::add_spans(const Kite& kite, std::vector<Span>& spans) const {
  spans.clear();
  const auto add = [&](Point a, Point b, std::uint32_t of) {
    const Span s{axis_.x(a), axis_.y(a), axis_.x(b), axis_.y(b), of};
    if (s.x1 > s.x0 && (spans.empty() || spans.back().x1 <= s.x0)) spans.push_back(s);
  };
  add(kite.at[0], kite.at[1], site_of(Kind::Line, kite.corner - 1));
  if (kite.bevelled) add(kite.at[1], kite.at[2], site_of(Kind::Bevel, kite.corner - 1));
  add(kite.at[2], kite.at[3], site_of(Kind::Line, kite.corner));
}

void MitreEnvelope::add_caps() {
  const std::size_t last = base_.segment_count() - 1;
  if (parts_ == 0 || first_x_ < x_of(0)) {
    curve_.points.insert(curve_.points.begin(), base_.points[0] - d_ * axis_.forward);
    curve_.edges.insert(curve_.edges.begin(), OffsetEdge::arc(start_cap));
  }
  curve_.points.push_back(curve_.tip);
  curve_.edges.push_back(OffsetEdge::arc(last));
  curve_.points.push_back(base_.points[last + 1] + d_ * axis_.forward);
  parts_ = curve_.edges.size();
}

/// The last part that starts at x or before it (else the first), looked for from `hint` on in growing steps.
std::size_t MitreEnvelope::part_at(double x, std::size_t hint) const {
  std::size_t low = hint;
  std::size_t high = hint + 1;
  std::size_t step = 1;
  if (x_of(low) <= x) {
    while (high < parts_ && x_of(high) <= x) {
      low = high;
      high = std::min(parts_, high + step);
      step *= 2;
    }
  } else {
    while (low > 0 && x_of(low) > x) {
      high = low;
      low -= std::min(low, step);
      step *= 2;
    }
  }
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (x_of(middle) <= x ? low : high) = middle;
  }
  return low;
}

std::uint32_t MitreEnvelope::site(std::size_t k) const {
  const OffsetEdge edge = curve_.edges[k];
  if (edge == OffsetEdge::arc(start_cap)) return cap_site;
  const std::uint32_t segment = edge.base_edge() & ~mitred;
  if (!edge.is_arc()) return site_of(Kind::Line, segment);
  return site_of(edge.base_edge() == segment ? Kind::Arc : Kind::Bevel, segment);
}

MitreEnvelope::Line MitreEnvelope::line(std::uint32_t site) const {
  const std::size_t segment = segment_of(site);
  const Vector u = base_.headings[segment];
  if (kind_of(site) == Kind::Line) return {base_.points[segment] + d_ * geom::right_of(u), u};
  // Turned by half the angle: the sum of both directions would lose digits near a U-turn.
  const double t = base_.half_tans[segment + 1];
  const double cosine = 1 / std::sqrt(1 + t * t);
  const Vector along = cosine * u + (t * cosine) * geom::left_of(u);
  return {base_.points[segment + 1] + d_ * geom::right_of(along), along};
}

/// The places where one kite's own sites meet have formulas of their own, however small the turn.
bool MitreEnvelope::natural_meet(std::uint32_t a, std::uint32_t b, Point& at) const {
  const std::size_t i = segment_of(a) + 1;
  const bool next = segment_of(b) == i;
  if (kind_of(a) == Kind::Line && kind_of(b) == Kind::Line && next && base_.turn[i] == Turn::Outer &&
      filling_.of(base_.half_tans[i]) == Fill::Mitre) {
    at = tip_at(base_, i, d_, base_.half_tans[i]);
    return true;
  }
  if (kind_of(a) == Kind::Line && kind_of(b) == Kind::Bevel && segment_of(b) + 1 == i) {
    at = bevel_start(base_, i, d_, quarter_of(base_.half_tans[i]));
    return true;
  }
  if (kind_of(a) == Kind::Bevel && kind_of(b) == Kind::Line && next) {
    at = bevel_end(base_, i, d_, quarter_of(base_.half_tans[i]));
    return true;
  }
  return false;
}

/// Where two lines meet, known to be near (x, y) along and across the axis.
Point MitreEnvelope::meet(std::uint32_t a, std::uint32_t b, double x, double y) const {
  Point at;
  if (natural_meet(a, b, at)) return at;
  const Line first = line(a);
  const Line second = line(b);
  const double sine = geom::cross(first.along, second.along);
  const Point near = axis_.point(x, y);
  if (!(std::abs(sine) > 1e-9)) return near;
  // From the near place, so that little is left to round.
  const double off_first = geom::cross(first.along, near - first.on);
  const double off_second = geom::cross(second.along, near - second.on);
  return near - (off_first / sine) * second.along + (off_second / sine) * first.along;
}

void MitreEnvelope::compare(const Span& w, std::size_t k, double x0, double x1) {
  const std::uint32_t own = site(k);
  if (own == w.site) return take_curve(k, x0);
  if (own != cap_site && kind_of(own) == Kind::Arc) {
    const std::size_t i = segment_of(own);
    const std::size_t j = segment_of(w.site);
    const bool touches = i == j || (kind_of(w.site) == Kind::Line && j == i + 1);
    if (touches && i + 1 < base_.segment_count()) return take_kite(w, k, x0);  // a mitre is below its own arc
  }
  if (kind_of(own) == Kind::Line || kind_of(own) == Kind::Bevel) return compare_with_line(w, k, x0, x1);
  compare_with_arc(w, k, x0, x1);
}

void MitreEnvelope::compare_with_line(const Span& w, std::size_t k, double x0, double x1) {
  const Span own{x_of(k), axis_.y(curve_.points[k]), x_of(k + 1), axis_.y(curve_.points[k + 1]), 0};
  const double before = w.at(x0) - own.at(x0);
  const double after = w.at(x1) - own.at(x1);
  if (before >= -touching_ && after >= -touching_) return take_curve(k, x0);
  if (before <= touching_ && after <= touching_) return take_kite(w, k, x0);
  const double x = std::clamp(x0 + (x1 - x0) * (before / (before - after)), x0, x1);
  const double y = w.at(x);
  if (before < 0) {
    const Point at = meet(w.site, site(k), x, y);
    take_kite(w, k, x0);
    take_curve(k, x, &at);
  } else {
    const Point at = meet(site(k), w.site, x, y);
    take_curve(k, x0);
    take_kite(w, k, x, &at);
  }
}

/// The arc is lower between the places where the line enters its disc and leaves it.
void MitreEnvelope::compare_with_arc(const Span& w, std::size_t k, double x0, double x1) {
  const Point c = centre(site(k));
  const Line own = line(w.site);
  const double off = geom::cross(own.along, c - own.on);
  if (off >= d_ - touching_) return take_kite(w, k, x0);
  const double half = std::sqrt(std::max(0.0, (d_ - off) * (d_ + off)));
  const Point middle = c - off * geom::left_of(own.along);
  const Point in = middle - half * own.along;
  const Point out = middle + half * own.along;
  const double margin = touching_ * std::min(d_ / half, 1e9);  // the nearer to touching, the less certain are these places
  // Through the upper half of the circle lines come from above, or leave upwards.
  const bool comes = geom::cross(axis_.forward, in - c) > 0 || axis_.x(in) <= x0 + margin;
  const bool leaves = geom::cross(axis_.forward, out - c) > 0 || axis_.x(out) >= x1 - margin;
  if ((!comes && axis_.x(in) >= x1 - margin) || (!leaves && axis_.x(out) <= x0 + margin)) return take_kite(w, k, x0);
  if (comes) {
    take_curve(k, x0);
  } else {
    take_kite(w, k, x0);
    take_curve(k, axis_.x(in), &in);
  }
  if (!leaves) take_kite(w, k, axis_.x(out), &out);
}

/// From x on, within part k, the kite is lower. `at`: where it crosses that part, if it does so there.
void MitreEnvelope::take_kite(const Span& w, std::size_t k, double x, const Point* at) {
  if (on_kite_) {
    if (last_.site != w.site) insert(meet(last_.site, w.site, x, w.at(x)), edge_of(w.site));
    last_ = w;
    return;
  }
  on_kite_ = true;
  last_ = w;
  const std::size_t start = added_points_.size();
  if (at != nullptr) {
    edits_.push_back({k + 1, k + 1, start, start});
    return insert(*at, edge_of(w.site));
  }
  if (x <= x_of(k)) {
    edits_.push_back({k, k, start, start});
    if (k == 0 || site(k - 1) != w.site) insert(curve_.points[k], edge_of(w.site));
    return;
  }
  edits_.push_back({k + 1, k + 1, start, start});
  insert(axis_.point(x, w.at(x)), edge_of(w.site));
}

/// From x on part k of the curve is lower, or nothing else is there.
void MitreEnvelope::take_curve(std::size_t k, double x, const Point* at) {
  if (!on_kite_) return;
  on_kite_ = false;
  Edit& edit = edits_.back();
  edit.last = k + 1;
  if (at != nullptr) {
    insert(*at, curve_.edges[k]);
  } else if (x <= x_of(k)) {
    if (site(k) != last_.site) edit.last = k;
  } else {
    insert(axis_.point(x, last_.at(x)), curve_.edges[k]);
  }
  edit.to = added_points_.size();
}

void MitreEnvelope::overlay(const std::vector<Span>& kites) {
  std::size_t k = 0;
  double x = 0;
  for (const Span& w : kites) {
    if (on_kite_ && w.x0 > x) take_curve(k, x);
    x = w.x0;
    k = part_at(x, k);
    while (x < w.x1) {
      const double end = k + 1 < parts_ ? std::min(w.x1, x_of(k + 1)) : w.x1;
      if (end > x) compare(w, k, x, end);
      x = std::max(x, end);
      if (k + 1 < parts_ && x_of(k + 1) <= x) ++k;
    }
  }
  if (on_kite_) take_curve(k, x);
  apply_edits();
}

/// Moves what stays: to the left from left to right, then to the right from right to left, so that nothing is overwritten.
void MitreEnvelope::apply_edits() {
  if (edits_.empty()) return;
  struct Block {
    std::size_t first, last, to;
  };
  std::vector<Block> blocks;
  blocks.reserve(edits_.size());
  std::size_t to = edits_.front().first;
  for (std::size_t e = 0; e < edits_.size(); ++e) {
    const std::size_t last = e + 1 < edits_.size() ? edits_[e + 1].first : parts_;
    to += edits_[e].to - edits_[e].from;
    blocks.push_back({edits_[e].last, last, to});
    to += last - edits_[e].last;
  }
  const Point end = curve_.points.back();
  curve_.points.pop_back();
  if (to > parts_) {
    curve_.points.resize(to);
    curve_.edges.resize(to);
  }
  const auto move = [&](const Block& block) {
    const auto first = static_cast<std::ptrdiff_t>(block.first);
    const auto last = static_cast<std::ptrdiff_t>(block.last);
    const auto target = static_cast<std::ptrdiff_t>(block.to);
    const auto shift = [&](auto& in) {
      if (target < first) std::move(in.begin() + first, in.begin() + last, in.begin() + target);
      if (target > first) std::move_backward(in.begin() + first, in.begin() + last, in.begin() + target + (last - first));
    };
    shift(curve_.points);
    shift(curve_.edges);
  };
  for (const Block& block : blocks) {
    if (block.to < block.first) move(block);
  }
  for (std::size_t b = blocks.size(); b-- > 0;) {
    if (blocks[b].to > blocks[b].first) move(blocks[b]);
  }
  for (std::size_t e = 0; e < edits_.size(); ++e) {
    const std::size_t at = blocks[e].to - (edits_[e].to - edits_[e].from);
    for (std::size_t k = edits_[e].from; k < edits_[e].to; ++k) {
      curve_.points[at + k - edits_[e].from] = added_points_[k];
      curve_.edges[at + k - edits_[e].from] = added_edges_[k];
    }
  }
  curve_.points.resize(to);
  curve_.edges.resize(to);
  curve_.points.push_back(end);
  for (std::size_t e = 0; e < edits_.size(); ++e) {
    if (!has_short_step(blocks[e].to - (edits_[e].to - edits_[e].from), blocks[e].to)) continue;
    drop_short_steps();
    break;
  }
  parts_ = curve_.edges.size();
  edits_.clear();
  added_points_.clear();
  added_edges_.clear();
}

/// True if a step within the added points `from` .. `to`, or to the ones next to them, is within rounding.
bool MitreEnvelope::has_short_step(std::size_t from, std::size_t to) const {
  for (std::size_t k = from == 0 ? 0 : from - 1; k < to && k + 1 < curve_.points.size(); ++k) {
    if (is_short(curve_.points[k], curve_.points[k + 1])) return true;
  }
  return false;
}

bool MitreEnvelope::is_short(Point p, Point q) const {
  const double rounding = 1e-15 * std::max({base_.size, d_, std::abs(q.x), std::abs(q.y)});
  return std::abs(q.x - p.x) <= rounding && std::abs(q.y - p.y) <= rounding;
}

/// Where lines coincide, rounding alone says where one goes over into the other: its steps are taken out.
void MitreEnvelope::drop_short_steps() {
  std::size_t kept = 0;
  for (std::size_t k = 1; k < curve_.points.size(); ++k) {
    const Point p = curve_.points[k];
    if (!is_short(curve_.points[kept], p)) curve_.points[++kept] = p;
    if (k < curve_.edges.size()) curve_.edges[kept] = curve_.edges[k];
  }
  curve_.points.resize(kept + 1);
  curve_.edges.resize(kept);
}

bool MitreEnvelope::run() {
  const std::vector<Span> lowest = lowest_kites();
  if (std::isinf(first_x_)) return false;  // all are hidden
  add_caps();
  overlay(lowest);
  overlay(other_kites());
  return true;
}

}  // namespace

bool add_cut_mitres(Stacked& stacked, const BaseCurve& base, Vector forward, double distance, const Filling& filling) {
  return MitreEnvelope(stacked, base, forward, distance, filling).run();
}

}  // namespace dobra::offset
