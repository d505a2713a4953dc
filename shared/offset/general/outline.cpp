#include "shared/offset/general/outline.h"

#include "shared/offset/general/outline_ends.h"
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
VecOf<T> Outline::line_end(std::uint32_t step) const {
  const T d = distance_as<T>(d_);
  const VecOf<T> p = to<T>(step);
  const VecOf<T> u = along<T>(step);
  const VecOf<T> foot = p + d * right_of(u);
  switch (corner(step)) {
    case CornerKind::Straight:
      return p + d * normal<T>(after(step));
    case CornerKind::Meet:
      return foot - T(d * half_tan_as<T>(step)) * u;
    case CornerKind::Mitre:
      return foot + T(d * half_tan_as<T>(step)) * u;
    case CornerKind::Tangent:
      return foot + T(d * quarter_tan(half_tan_as<T>(step))) * u;
    default:
      return foot;
  }
}
template <class T>
VecOf<T> Outline::line_start(std::uint32_t step) const {
  const std::uint32_t previous = before(step);
  const T d = distance_as<T>(d_);
  const VecOf<T> u = along<T>(step);
  const VecOf<T> foot = from<T>(step) + d * right_of(u);
  switch (corner(previous)) {
    case CornerKind::Meet:
    case CornerKind::Mitre:
      return line_end<T>(previous);
    case CornerKind::Tangent:
      return foot - T(d * quarter_tan(half_tan_as<T>(previous))) * u;
    default:
      return foot;
  }
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
  if (step + 1 < n_ && corners_[step + 1] <= CornerKind::Meet) {  // what is asked for most, without the detours
    const std::size_t at = step + 1;
    const Flat p = flat(base_.points[at]);
    const Flat next = p + d_ * right_of(flat(base_.headings[at]));
    if (corners_[at] == CornerKind::Straight) return {CornerKind::Straight, next, next};
    const Flat u = flat(base_.headings[step]);
    const Flat foot = p + d_ * right_of(u);
    const double t = base_.half_tans[at];
    if (!meets(d_, t, base_.spans[step], base_.spans[at])) return {CornerKind::Apart, foot, next};
    const Flat meet = foot - (d_ * t) * u;
    return {CornerKind::Meet, meet, meet};
  }
  const CornerKind kind = corner(step);
  const Flat p = to<double>(step);
  const Flat u = along<double>(step);
  const Flat foot = p + d_ * right_of(u);
  if (kind == CornerKind::Meet || kind == CornerKind::Mitre) {
    const double t = half_tan(step);
    if (kind == CornerKind::Mitre && t > 16) {  // so far that a rounded direction misses
      const Flat tip = flat(line_end<Real>(step));
      return {kind, tip, tip};
    }
    const double reach = d_ * t;
    const Flat meet = foot + (kind == CornerKind::Meet ? -reach : reach) * u;
    return {kind, meet, meet};
  }
  const Flat v = along<double>(after(step));
  const Flat next = p + d_ * right_of(v);
  if (kind == CornerKind::Straight) return {kind, next, next};
  if (kind != CornerKind::Tangent) return {kind, foot, next};
  const double t = half_tan(step);
  const double q = d_ * (std::isinf(t) ? 1 : t / (1 + std::sqrt(1 + t * t)));
  return {kind, foot + q * u, next - q * v};
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
