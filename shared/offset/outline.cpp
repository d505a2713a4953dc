#include "shared/offset/outline.h"

namespace dobra::offset {

Outline::Corner Outline::corner(std::uint32_t step) const {
  if (is_cap(step)) return Corner::Arc;
  const std::size_t at = corner_point(step);
  Turn turn = base_.turn[at];
  if (turn == Turn::Straight) return Corner::Straight;
  const double t = base_.half_tans[at];
  if (step >= n_ && !std::isinf(t)) turn = turn == Turn::Outer ? Turn::Inner : Turn::Outer;
  if (turn == Turn::Inner) {
    // Beyond the bisector each line is nearer than D to the other segment, provided that this reaches so far.
    return d_ * t <= span(step) && d_ * t <= span(after(step)) ? Corner::Meet : Corner::Apart;
  }
  if (step >= n_) return Corner::Arc;
  switch (fill_of(base_, at, options_)) {
    case Fill::Mitre: return Corner::Mitre;
    case Fill::Tangent: return Corner::Tangent;
    case Fill::Arc: break;
  }
  return Corner::Arc;
}

template <> double Outline::half_tan_as<double>(std::uint32_t step) const { return half_tan(step); }
template <> Real Outline::half_tan_as<Real>(std::uint32_t step) const {
  return is_cap(step) ? std::numeric_limits<Real>::infinity() : base_.half_tan(corner_point(step));
}

template <class T> VecOf<T> Outline::line_end(std::uint32_t step) const {
  const T d = d_;
  const VecOf<T> p = to<T>(step);
  const VecOf<T> u = along<T>(step);
  const VecOf<T> foot = p + d * right_of(u);
  switch (corner(step)) {
    case Corner::Straight: return p + d * normal<T>(after(step));
    case Corner::Meet: return foot - (d * half_tan_as<T>(step)) * u;
    case Corner::Mitre: return foot + (d * half_tan_as<T>(step)) * u;
    case Corner::Tangent: return foot + (d * static_cast<T>(quarter_tan(half_tan_as<T>(step)))) * u;
    default: return foot;
  }
}
template <class T> VecOf<T> Outline::line_start(std::uint32_t step) const {
  const std::uint32_t previous = before(step);
  const T d = d_;
  const VecOf<T> u = along<T>(step);
  const VecOf<T> foot = from<T>(step) + d * right_of(u);
  switch (corner(previous)) {
    case Corner::Meet:
    case Corner::Mitre: return line_end<T>(previous);
    case Corner::Tangent: return foot - (d * static_cast<T>(quarter_tan(half_tan_as<T>(previous)))) * u;
    default: return foot;
  }
}
template <class T> VecOf<T> Outline::middle_of_turn(std::uint32_t step) const {
  const VecOf<T> u = along<T>(step);
  if (std::isinf(half_tan(step))) return u;
  // Turned by a left turn's half: exact enough near a U-turn too, where the two normals cancel.
  const T t = half_tan_as<T>(step);
  const T c = 1 / std::sqrt(1 + t * t);
  return c * right_of(u) + (t * c) * u;
}
template <class T> VecOf<T> Outline::natural_start(Site s) const {
  const T d = d_;
  switch (s.role) {
    case Role::Line: return line_start<T>(s.step);
    case Role::Bevel: return line_end<T>(s.step);
    case Role::Arc: return to<T>(s.step) + d * normal<T>(s.step);
    default: return to<T>(s.step) + d * middle_of_turn<T>(s.step);
  }
}
template <class T> VecOf<T> Outline::natural_end(Site s) const {
  const T d = d_;
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
template VecOf<double> Outline::natural_start<double>(Site) const;
template VecOf<double> Outline::natural_end<double>(Site) const;
template VecOf<Real> Outline::natural_start<Real>(Site) const;
template VecOf<Real> Outline::natural_end<Real>(Site) const;
template VecOf<Real> Outline::middle_of_turn<Real>(std::uint32_t) const;

Outline::Junction Outline::junction(std::uint32_t step) const {
  const Flat p = to<double>(step);
  const Flat u = along<double>(step);
  const Flat v = along<double>(after(step));
  const Flat foot = p + d_ * right_of(u);
  const Flat next = p + d_ * right_of(v);
  const Corner kind = corner(step);
  const double reach = d_ * half_tan(step);
  switch (kind) {
    case Corner::Straight: return {kind, next, next};
    case Corner::Meet: return {kind, foot - reach * u, foot - reach * u};
    case Corner::Mitre: return {kind, foot + reach * u, foot + reach * u};
    case Corner::Tangent: {
      const double q = d_ * static_cast<double>(quarter_tan(half_tan(step)));
      return {kind, foot + q * u, next - q * v};
    }
    default: return {kind, foot, next};
  }
}

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
  const double t = half_tan(at);
  const Flat w = std::isinf(t) ? along<double>(at) : unit(right_of(along<double>(step)) + right_of(v));
  return dot(q, w) < limit;
}

}  // namespace dobra::offset
