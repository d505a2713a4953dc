#include "shared/offset/general/outline.h"

#include "shared/offset/kernel/high.h"

namespace dobra::offset::general {

std::vector<CornerKind> right_corners(const BaseCurve& base, const OffsetOptions& options) {
  std::vector<CornerKind> corners(base.points.size(), CornerKind::Straight);
  for (std::size_t at = 0; at < corners.size(); ++at) {
    if (base.turn[at] == Turn::Straight) continue;
    corners[at] = base.turn[at] == Turn::Inner ? CornerKind::Meet : outer_corner(base, at, options);
  }
  return corners;
}

template <class T>
T Outline::half_tan_as(std::uint32_t step) const {
  if constexpr (std::is_same_v<T, double>) {
    return half_tan(step);
  } else {
    return is_cap(step) ? std::numeric_limits<T>::infinity() : base_.half_tan_as<T>(corner_point(step));
  }
}

template <class T>
T Outline::overshoot(std::uint32_t step, CornerKind kind) const {
  switch (kind) {
    case CornerKind::Meet:
      return -half_tan_as<T>(step);
    case CornerKind::Mitre:
      return half_tan_as<T>(step);
    case CornerKind::Tangent:
      return quarter_tan(half_tan_as<T>(step));
    default:
      return 0;
  }
}
template <class T>
VecOf<T> Outline::line_end(std::uint32_t step) const {
  const T d = distance_as<T>(d_);
  const CornerKind kind = corner(step);
  if (kind == CornerKind::Straight) return to<T>(step) + d * normal<T>(after(step));
  const VecOf<T> u = along<T>(step);
  return to<T>(step) + d * right_of(u) + T(d * overshoot<T>(step, kind)) * u;
}
template <class T>
VecOf<T> Outline::line_start(std::uint32_t step) const {
  const std::uint32_t previous = before(step);
  const CornerKind kind = corner(previous);
  if (kind == CornerKind::Meet || kind == CornerKind::Mitre) return line_end<T>(previous);
  const T d = distance_as<T>(d_);
  const VecOf<T> u = along<T>(step);
  return from<T>(step) + d * right_of(u) - T(d * overshoot<T>(previous, kind)) * u;
}
template <class T>
VecOf<T> Outline::middle_of_turn(std::uint32_t step) const {
  const VecOf<T> u = along<T>(step);
  if (std::isinf(half_tan(step))) return u;
  // Turned by a left turn's half: exact enough near a U-turn too, where the two normals cancel.
  const T t = half_tan_as<T>(step);
  const T c = 1 / root(T(1 + t * t));
  return c * right_of(u) + T(t * c) * u;
}
template <class T>
VecOf<T> Outline::natural_start(Site s) const {
  const T d = distance_as<T>(d_);
  switch (s.kind) {
    case SiteKind::Line:
      return line_start<T>(s.step);
    case SiteKind::Bevel:
      return line_end<T>(s.step);
    case SiteKind::Arc:
      return to<T>(s.step) + d * normal<T>(s.step);
    default:
      return to<T>(s.step) + d * middle_of_turn<T>(s.step);
  }
}
template <class T>
VecOf<T> Outline::natural_end(Site s) const {
  const T d = distance_as<T>(d_);
  switch (s.kind) {
    case SiteKind::Line:
      return line_end<T>(s.step);
    case SiteKind::Bevel:
      return line_start<T>(after(s.step));
    case SiteKind::Arc:
      if (splits_arc(s.step)) return to<T>(s.step) + d * middle_of_turn<T>(s.step);
      [[fallthrough]];
    default:
      return is_cap(s.step) ? to<T>(s.step) - d * normal<T>(s.step) : to<T>(s.step) + d * normal<T>(after(s.step));
  }
}
template VecOf<Real> Outline::natural_start<Real>(Site) const;
template VecOf<Real> Outline::natural_end<Real>(Site) const;
template VecOf<High> Outline::natural_start<High>(Site) const;
template VecOf<High> Outline::natural_end<High>(Site) const;
template VecOf<Real> Outline::line_end<Real>(std::uint32_t) const;
template VecOf<double> Outline::middle_of_turn<double>(std::uint32_t) const;
template VecOf<Real> Outline::middle_of_turn<Real>(std::uint32_t) const;
template VecOf<High> Outline::middle_of_turn<High>(std::uint32_t) const;

Outline::Junction Outline::junction(std::uint32_t step) const {
  const CornerKind kind = corner(step);
  if (kind == CornerKind::Mitre && half_tan(step) > 16) {  // so far that a rounded direction misses
    const Flat tip = flat(line_end<Real>(step));
    return {kind, tip, tip};
  }
  const Flat p = to<double>(step);
  const Flat u = along<double>(step);
  const double reach = d_ * overshoot<double>(step, kind);
  const Flat end = p + d_ * right_of(u) + reach * u;
  if (kind == CornerKind::Meet || kind == CornerKind::Mitre) return {kind, end, end};
  const Flat v = along<double>(after(step));
  const Flat start = p + d_ * right_of(v) - reach * v;
  return {kind, kind == CornerKind::Straight ? start : end, start};
}

Flat Outline::start_of(Site s) const { return Ends(*this).start_of(s); }
Flat Outline::end_of(Site s) const { return Ends(*this).end_of(s); }

Flat Outline::Ends::other_start_of(Site s) {
  if (s.kind == SiteKind::Line) return at(outline_.before(s.step)).start;
  if (s.kind == SiteKind::SecondArc) return outline_.centre(s) + outline_.d_ * outline_.middle_of_turn<double>(s.step);
  return at(s.step).end;
}

Flat Outline::Ends::end_of(Site s) {
  if (s.kind == SiteKind::Line) return at(s.step).end;
  if (s.kind == SiteKind::Arc && outline_.splits_arc(s.step)) {
    return outline_.centre(s) + outline_.d_ * outline_.middle_of_turn<double>(s.step);
  }
  return at(s.step).start;
}

bool Outline::deep_in_mitre(Flat q, std::uint32_t step, bool at_end, double margin) const {
  const std::uint32_t at = at_end ? step : before(step);
  if (at >= n_ || is_cap(at)) return false;
  const CornerKind kind = corners_[base_.end_index(at)];
  if (kind != CornerKind::Mitre && kind != CornerKind::Tangent) return false;
  const double limit = d_ - margin;
  const Flat v = along<double>(at_end ? after(step) : at);
  // Between the two normals and below the other line.
  if ((at_end ? dot(q, v) >= -margin : dot(q, v) <= margin) || dot(q, right_of(v)) >= limit) return false;
  if (kind == CornerKind::Mitre) return true;
  return dot(q, middle_of_turn<double>(at)) < limit;
}

}  // namespace dobra::offset::general
