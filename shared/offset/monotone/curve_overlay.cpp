#include "shared/offset/monotone/curve_overlay.h"

#include <algorithm>

namespace dobra::offset::monotone {

using geom::Point;
using geom::Vector;

CurveOverlay::CurveOverlay(Stacked& stacked, const BaseCurve& base, Vector forward, double distance,
                           const JoinRule& joins)
    : curve_(stacked), base_(base), axis_{forward}, d_(distance), joins_(joins), touching_(touching(base, distance)) {
  const std::size_t last = base_.segment_count() - 1;
  curve_.points.push_back(curve_.tip);
  curve_.edges.push_back(OffsetEdge::arc(last));
  curve_.points.push_back(base_.points[last + 1] + d_ * axis_.forward);
  parts_ = curve_.edges.size();
}

void CurveOverlay::take_off_caps() {
  curve_.points.resize(parts_ - 1);
  curve_.edges.pop_back();
  --parts_;
}

std::size_t CurveOverlay::part_at(double x, std::size_t hint) const {
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

std::uint32_t CurveOverlay::site(std::size_t k) const {
  const OffsetEdge edge = curve_.edges[k];
  if (edge == OffsetEdge::arc(start_cap)) return cap_site;
  const std::uint32_t segment = edge.base_edge() & ~mitred;
  if (!edge.is_arc()) return site_of(SiteKind::Line, segment);
  return site_of(edge.base_edge() == segment ? SiteKind::Arc : SiteKind::Bevel, segment);
}

CurveOverlay::Line CurveOverlay::line(std::uint32_t site) const {
  const std::size_t segment = segment_of(site);
  const Vector u = base_.headings[segment];
  if (kind_of(site) == SiteKind::Line) return {base_.points[segment] + d_ * geom::right_of(u), u};
  // Turned by half the angle: the sum of both directions would lose digits near a U-turn.
  const double t = base_.half_tans[segment + 1];
  const double cosine = 1 / std::sqrt(1 + t * t);
  const Vector along = cosine * u + (t * cosine) * geom::left_of(u);
  return {base_.points[segment + 1] + d_ * geom::right_of(along), along};
}

/// The places where one quad's own sites meet have formulas of their own, however small the turn.
bool CurveOverlay::natural_meet(std::uint32_t a, std::uint32_t b, Point& at) const {
  const std::size_t i = segment_of(a) + 1;
  const bool next = segment_of(b) == i;
  if (kind_of(a) == SiteKind::Line && kind_of(b) == SiteKind::Line && next && base_.turn[i] == Turn::Outer &&
      joins_.of(base_.half_tans[i]) == CornerKind::Mitre) {
    at = tip_at(base_, i, d_, base_.half_tans[i]);
    return true;
  }
  if (kind_of(a) == SiteKind::Line && kind_of(b) == SiteKind::Bevel && segment_of(b) + 1 == i) {
    at = bevel_start(base_, i, d_, quarter_of(base_.half_tans[i]));
    return true;
  }
  if (kind_of(a) == SiteKind::Bevel && kind_of(b) == SiteKind::Line && next) {
    at = bevel_end(base_, i, d_, quarter_of(base_.half_tans[i]));
    return true;
  }
  return false;
}

/// Where two lines meet, known to be near (x, y) along and across the axis.
Point CurveOverlay::meet(std::uint32_t a, std::uint32_t b, double x, double y) const {
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

CurveOverlay::Part CurveOverlay::part(std::size_t k) const {
  return {k, site(k), x_of(k), axis_.y(curve_.points[k]), x_of(k + 1), axis_.y(curve_.points[k + 1])};
}

CurveOverlay::Part CurveOverlay::part_after(const Part& own) const {
  const Point end = curve_.points[own.k + 2];
  return {own.k + 1, site(own.k + 1), own.x1, own.y1, axis_.x(end), axis_.y(end)};
}

void CurveOverlay::compare(const Span& w, const Part& own, double x0, double x1) {
  if (own.site == w.site) return take_curve(own, x0);
  if (own.site == cap_site || kind_of(own.site) == SiteKind::Arc) {
    const std::size_t i = segment_of(own.site);
    const std::size_t j = segment_of(w.site);
    const bool touches = i == j || (kind_of(w.site) == SiteKind::Line && j == i + 1);
    if (touches && i + 1 < base_.segment_count()) return take_quad(w, own, x0);  // a mitre is below its own arc
    return compare_with_arc(w, own, x0, x1);
  }
  compare_with_line(w, own, x0, x1);
}

void CurveOverlay::compare_with_line(const Span& w, const Part& own, double x0, double x1) {
  const double before = w.at(x0) - own.at(x0);
  const double after = w.at(x1) - own.at(x1);
  if (before >= -touching_ && after >= -touching_) return take_curve(own, x0);
  if (before <= touching_ && after <= touching_) return take_quad(w, own, x0);
  const double x = std::clamp(x0 + (x1 - x0) * (before / (before - after)), x0, x1);
  const double y = w.at(x);
  if (before < 0) {
    const Point at = meet(w.site, own.site, x, y);
    take_quad(w, own, x0);
    take_curve(own, x, &at);
  } else {
    const Point at = meet(own.site, w.site, x, y);
    take_curve(own, x0);
    take_quad(w, own, x, &at);
  }
}

/// The arc is lower between the places where the line enters its disc and leaves it.
void CurveOverlay::compare_with_arc(const Span& w, const Part& own, double x0, double x1) {
  const Point c = centre(own.site);
  const Line over = line(w.site);
  const double off = geom::cross(over.along, c - over.on);
  if (off >= d_ - touching_) return take_quad(w, own, x0);
  const double half = std::sqrt(std::max(0.0, (d_ - off) * (d_ + off)));
  const double margin =
      touching_ * std::min(d_ / half, 1e9);  // the nearer to touching, the less certain are these places
  const double ahead = geom::dot(axis_.forward, over.along);
  const double aside = geom::cross(axis_.forward, over.along);
  const double middle = axis_.x(c) + off * aside;
  const double in = middle - half * ahead;
  const double out = middle + half * ahead;
  // Through the upper half of the circle lines come from above, or leave upwards.
  const bool comes = -half * aside > off * ahead || in <= x0 + margin;
  const bool leaves = half * aside > off * ahead || out >= x1 - margin;
  if ((!comes && in >= x1 - margin) || (!leaves && out <= x0 + margin)) return take_quad(w, own, x0);
  const auto place = [&](double along) { return c - off * geom::left_of(over.along) + along * over.along; };
  if (comes) {
    take_curve(own, x0);
  } else {
    const Point at = place(-half);
    take_quad(w, own, x0);
    take_curve(own, in, &at);
  }
  if (!leaves) {
    const Point at = place(half);
    take_quad(w, own, out, &at);
  }
}

void CurveOverlay::enter_quad(const Span& w, const Part& own, double x, const Point* at) {
  const std::size_t start = added_points_.size();
  const bool at_start = at == nullptr && x <= own.x0;
  const std::size_t first = at_start ? own.k : own.k + 1;
  edits_.push_back({first, first, start, start});
  if (at != nullptr) {
    insert(*at, edge_of(w.site));
  } else if (!at_start) {
    insert(axis_.point(x, w.at(x)), edge_of(w.site));
  } else if (own.k == 0 || site(own.k - 1) != w.site) {
    insert(curve_.points[own.k], edge_of(w.site));
  }
}

void CurveOverlay::leave_quad(const Part& own, double x, const Point* at) {
  Edit& edit = edits_.back();
  edit.last = own.k + 1;
  if (at != nullptr) {
    insert(*at, curve_.edges[own.k]);
  } else if (x <= own.x0) {
    if (own.site != quad_->site) edit.last = own.k;
  } else {
    insert(axis_.point(x, quad_->at(x)), curve_.edges[own.k]);
  }
  edit.to = added_points_.size();
  quad_ = nullptr;
}

void CurveOverlay::lay(const std::vector<Span>& pieces) {
  if (pieces.empty()) return;
  if (pieces.front().x0 < x_of(0)) {
    curve_.points.insert(curve_.points.begin(), base_.points[0] - d_ * axis_.forward);
    curve_.edges.insert(curve_.edges.begin(), OffsetEdge::arc(start_cap));
    ++parts_;
  }
  Part own = part(0);
  double x = -std::numeric_limits<double>::infinity();
  for (const Span& w : pieces) {
    if (w.x0 > x) {
      take_curve(own, x);
      x = w.x0;
      own = part(part_at(x, own.k));
    }
    while (x < w.x1) {
      const bool ends = own.k + 1 < parts_ && own.x1 <= w.x1;
      const double end = ends ? own.x1 : w.x1;
      if (end > x) compare(w, own, x, end);
      x = std::max(x, end);
      if (ends) own = part_after(own);
    }
  }
  take_curve(own, x);
  apply_edits();
}

/// Moves what stays: to the left from left to right, then to the right from right to left, so that nothing is
/// overwritten.
void CurveOverlay::apply_edits() {
  if (edits_.empty()) return;
  struct Moved {
    std::size_t first, last, to;
  };
  std::vector<Moved> moves;
  moves.reserve(edits_.size());
  std::size_t to = edits_.front().first;
  for (std::size_t e = 0; e < edits_.size(); ++e) {
    const std::size_t last = e + 1 < edits_.size() ? edits_[e + 1].first : parts_;
    to += edits_[e].to - edits_[e].from;
    moves.push_back({edits_[e].last, last, to});
    to += last - edits_[e].last;
  }
  const Point end = curve_.points.back();
  curve_.points.pop_back();
  if (to > parts_) {
    curve_.points.resize(to);
    curve_.edges.resize(to);
  }
  const auto move = [&](const Moved& moved) {
    const auto first = static_cast<std::ptrdiff_t>(moved.first);
    const auto last = static_cast<std::ptrdiff_t>(moved.last);
    const auto target = static_cast<std::ptrdiff_t>(moved.to);
    const auto shift = [&](auto& in) {
      if (target < first) std::move(in.begin() + first, in.begin() + last, in.begin() + target);
      if (target > first)
        std::move_backward(in.begin() + first, in.begin() + last, in.begin() + target + (last - first));
    };
    shift(curve_.points);
    shift(curve_.edges);
  };
  for (const Moved& moved : moves) {
    if (moved.to < moved.first) move(moved);
  }
  for (std::size_t b = moves.size(); b-- > 0;) {
    if (moves[b].to > moves[b].first) move(moves[b]);
  }
  for (std::size_t e = 0; e < edits_.size(); ++e) {
    const std::size_t at = moves[e].to - (edits_[e].to - edits_[e].from);
    for (std::size_t k = edits_[e].from; k < edits_[e].to; ++k) {
      curve_.points[at + k - edits_[e].from] = added_points_[k];
      curve_.edges[at + k - edits_[e].from] = added_edges_[k];
    }
  }
  curve_.points.resize(to);
  curve_.edges.resize(to);
  curve_.points.push_back(end);
  for (std::size_t e = 0; e < edits_.size(); ++e) {
    if (!has_short_step(moves[e].to - (edits_[e].to - edits_[e].from), moves[e].to)) continue;
    drop_short_steps();
    break;
  }
  parts_ = curve_.edges.size();
  edits_.clear();
  added_points_.clear();
  added_edges_.clear();
}

/// True if a step within the added points `from` .. `to`, or to the ones next to them, is within rounding.
bool CurveOverlay::has_short_step(std::size_t from, std::size_t to) const {
  for (std::size_t k = from == 0 ? 0 : from - 1; k < to && k + 1 < curve_.points.size(); ++k) {
    if (is_short(curve_.points[k], curve_.points[k + 1])) return true;
  }
  return false;
}

bool CurveOverlay::is_short(Point p, Point q) const {
  const double rounding = 1e-15 * std::max({base_.size, d_, std::abs(q.x), std::abs(q.y)});
  return std::abs(q.x - p.x) <= rounding && std::abs(q.y - p.y) <= rounding;
}

/// Where lines coincide, rounding alone says where one goes over into the other: its steps are taken out.
void CurveOverlay::drop_short_steps() {
  std::size_t kept = 0;
  for (std::size_t k = 1; k < curve_.points.size(); ++k) {
    const Point p = curve_.points[k];
    if (!is_short(curve_.points[kept], p)) curve_.points[++kept] = p;
    if (k < curve_.edges.size()) curve_.edges[kept] = curve_.edges[k];
  }
  curve_.points.resize(kept + 1);
  curve_.edges.resize(kept);
}

}  // namespace dobra::offset::monotone
