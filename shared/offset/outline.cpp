#include "shared/offset/outline.h"

#include "shared/offset/high.h"

namespace dobra::offset {

std::vector<Corner> right_corners(const BaseCurve& base, const OffsetOptions& options) {
  std::vector<Corner> corners(base.points.size(), Corner::Straight);
  for (std::size_t at = 0; at < corners.size(); ++at) {
    if (base.turn[at] == Turn::Straight) continue;
    corners[at] = Corner::Meet;
    if (base.turn[at] == Turn::Inner) continue;
    const Fill fill = fill_of(base, at, options);
    corners[at] = fill == Fill::Mitre ? Corner::Mitre : fill == Fill::Tangent ? Corner::Tangent : Corner::Arc;
  }
  return corners;
}

template <class T> T Outline::half_tan_as(std::uint32_t step) const {
  if constexpr (std::is_same_v<T, double>) {
    return half_tan(step);
  } else {
    return is_cap(step) ? std::numeric_limits<T>::infinity() : base_.half_tan_as<T>(corner_point(step));
  }
}

template <class T> VecOf<T> Outline::line_end(std::uint32_t step) const {
  const T d = distance_as<T>(d_);
  const VecOf<T> p = to<T>(step);
  const VecOf<T> u = along<T>(step);
  const VecOf<T> foot = p + d * right_of(u);
  switch (corner(step)) {
    case Corner::Straight: return p + d * normal<T>(after(step));
    case Corner::Meet: return foot - T(d * half_tan_as<T>(step)) * u;
    case Corner::Mitre: return foot + T(d * half_tan_as<T>(step)) * u;
    case Corner::Tangent: return foot + T(d * quarter_tan(half_tan_as<T>(step))) * u;
    default: return foot;
  }
}
template <class T> VecOf<T> Outline::line_start(std::uint32_t step) const {
  const std::uint32_t previous = before(step);
  const T d = distance_as<T>(d_);
  const VecOf<T> u = along<T>(step);
  const VecOf<T> foot = from<T>(step) + d * right_of(u);
  switch (corner(previous)) {
    case Corner::Meet:
    case Corner::Mitre: return line_end<T>(previous);
    case Corner::Tangent: return foot - T(d * quarter_tan(half_tan_as<T>(previous))) * u;
    default: return foot;
  }
}
template <class T> VecOf<T> Outline::middle_of_turn(std::uint32_t step) const {
  const VecOf<T> u = along<T>(step);
  if (std::isinf(half_tan(step))) return u;
  // Turned by a left turn's half: exact enough near a U-turn too, where the two normals cancel.
  const T t = half_tan_as<T>(step);
  const T c = 1 / root(T(1 + t * t));
  return c * right_of(u) + T(t * c) * u;
}
template <class T> VecOf<T> Outline::natural_start(Site s) const {
  const T d = distance_as<T>(d_);
  switch (s.role) {
    case Role::Line: return line_start<T>(s.step);
    case Role::Bevel: return line_end<T>(s.step);
    case Role::Arc: return to<T>(s.step) + d * normal<T>(s.step);
    default: return to<T>(s.step) + d * middle_of_turn<T>(s.step);
  }
}
template <class T> VecOf<T> Outline::natural_end(Site s) const {
  const T d = distance_as<T>(d_);
  switch (s.role) {
    case Role::Line: return line_end<T>(s.step);
    case Role::Bevel: return line_start<T>(after(s.step));
    case Role::Arc:
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

Flat Outline::start_of(Site s) const { return Ends(*this).start_of(s); }
Flat Outline::end_of(Site s) const { return Ends(*this).end_of(s); }

bool Outline::deep_in_mitre(Flat q, std::uint32_t step, bool at_end, double margin) const {
  const std::uint32_t at = at_end ? step : before(step);
  if (at >= n_ || is_cap(at)) return false;
  const Corner kind = corner(at);
  if (kind != Corner::Mitre && kind != Corner::Tangent) return false;
  const double limit = d_ - margin;
  const Flat v = along<double>(at_end ? after(step) : at);
  // Between the two normals and below the other line.
  if ((at_end ? dot(q, v) >= -margin : dot(q, v) <= margin) || dot(q, right_of(v)) >= limit) return false;
  if (kind == Corner::Mitre) return true;
  return dot(q, middle_of_turn<double>(at)) < limit;
}

}  // namespace dobra::offset
