#include "shared/offset/general/validity.h"

#include <algorithm>
#include <type_traits>

#include "shared/geom/predicates.h"

namespace dobra::offset::general {

namespace {

/// Of a place that is this far outside.
template <class T>
Place place_of(const T& outside, double error) {
  if (outside < -error) return Place::Inside;
  return outside > error || std::is_same_v<T, High> ? Place::Free : Place::Doubtful;
}

/// The squared distance from the segment 0 v to q.
template <class T>
T squared_distance(const VecOf<T>& v, const VecOf<T>& q) {
  const T along = dot(q, v);
  if (!(along > 0)) return dot(q, q);
  const T whole = dot(v, v);
  if (along >= whole) return dot(q - v, q - v);
  const T across = cross(v, q);
  return across * across / whole;
}

}  // namespace

Validity::Validity(const Outline& outline, const Clearance& clearance)
    : outline_(outline), clearance_(clearance), margin_(clearance.margin(outline.distance())) {}

template <class T>
Place Validity::near_segment(std::size_t segment, const VecOf<T>& q, const T& d, double error) const {
  const BaseCurve& base = outline_.base();
  const auto squared = [&]<class S>(const VecOf<S>& p) {
    const VecOf<S> from{base.start(segment).x, base.start(segment).y};
    const VecOf<S> to{base.end(segment).x, base.end(segment).y};
    return squared_distance(to - from, p - from);
  };
  const double rough = squared(Flat{static_cast<double>(q.x), static_cast<double>(q.y)});
  const double reach = outline_.distance();
  const double margin = margin_ + error;
  if (rough > (reach + margin) * (reach + margin)) return Place::Free;
  if (reach > margin && rough < (reach - margin) * (reach - margin)) return Place::Inside;
  return place_of(T(squared(q) - d * d), error * (2 * reach + error));
}

template <class T>
Place Validity::in_mitre(std::uint32_t step, const VecOf<T>& q, const T& d, double error) const {
  const Flat near = Flat{static_cast<double>(q.x), static_cast<double>(q.y)} - outline_.to<double>(step);
  const Flat u = outline_.along<double>(step);
  const Flat v = outline_.along<double>(outline_.after(step));
  const double margin = 10 * margin_ + error;
  const double limit = outline_.distance() + margin;
  if (dot(near, u) < -margin || dot(near, v) > margin || dot(near, right_of(u)) > limit ||
      dot(near, right_of(v)) > limit) {
    return Place::Free;
  }
  const VecOf<T> to = q - outline_.to<T>(step);
  const VecOf<T> n = outline_.normal<T>(step);
  const VecOf<T> m = outline_.normal<T>(outline_.after(step));
  // Below its outer lines and between the two normals; beyond those the stadia begin.
  T outside = std::max(dot(n, to), dot(m, to));
  if (outline_.corner(step) == CornerKind::Tangent)
    outside = std::max(outside, dot(outline_.middle_of_turn<T>(step), to));
  outside = std::max({T(outside - d), T(-cross(n, to)), T(-cross(to, m))});
  return place_of(outside, error);
}

template <class T>
Place Validity::of(const VecOf<T>& q, Site own, double error) const {
  const T d = distance_as<T>(outline_.distance());
  const Flat p{static_cast<double>(q.x), static_cast<double>(q.y)};
  const std::uint32_t behind = own.kind == SiteKind::Line ? outline_.before(own.step) : own.step;
  const bool caps = own.kind != SiteKind::Line && outline_.is_cap(own.step);
  const std::size_t first = outline_.segment(own.step);
  const std::size_t second = own.kind == SiteKind::Line || caps ? first : outline_.segment(outline_.after(own.step));
  Place worst = Place::Free;
  const auto settles = [&](Place place) {
    if (place != Place::Free) worst = place;
    return place == Place::Inside;
  };
  if (clearance_.any_near(p, outline_.distance() + margin_ + error, [&](std::size_t segment) {
        return segment != first && segment != second && settles(near_segment(segment, q, d, error));
      })) {
    return Place::Inside;
  }
  if (clearance_.any_mitre(p, outline_.distance(), [&](std::uint32_t step) {
        return step != behind && step != own.step && settles(in_mitre(step, q, d, error));
      })) {
    return Place::Inside;
  }
  return worst;
}

/// What is parallel to a segment, or about a corner, is on the base's right side if nothing is nearer. So is what lies
/// in a mitre, unless the way to it from its corner crosses the base: exact for the rounded place, which is as free as
/// the place itself.
bool Validity::pokes_through(Flat q, Site own) const {
  const BaseCurve& base = outline_.base();
  std::size_t corner = base.end_index(own.step);
  if (own.kind == SiteKind::Line) {
    const double s = dot(q - outline_.from<double>(own.step), outline_.along<double>(own.step));
    if (s >= 0 && s <= outline_.span(own.step)) return false;
    if (s < 0) corner = own.step;
  } else if (own.kind != SiteKind::Bevel) {
    return false;
  }
  const geom::Point c = base.points[corner];
  const geom::Point p{q.x, q.y};
  // Nothing is nearer than D to the place itself: only the rest of the way may cross the base.
  const Flat back = flat(c) - q;
  const Flat far = q + std::min(1.0, 0.99 * outline_.distance() / length(back)) * back;
  FloatBox way(flat(c), flat(c), 0);
  way.add(FloatBox(far, far, 0));
  bool across = false;
  clearance_.each_in(way, [&](std::size_t i) {
    if (i == corner || base.end_index(i) == corner) return;
    const geom::Point a = base.start(i);
    const geom::Point b = base.end(i);
    if ((geom::orient2d(c, p, a) == geom::Sign::Positive) == (geom::orient2d(c, p, b) == geom::Sign::Positive)) return;
    across ^= geom::orient2d(a, b, c) != geom::orient2d(a, b, p);
  });
  return across;
}

template Place Validity::of<Real>(const Vec&, Site, double) const;
template Place Validity::of<High>(const VecOf<High>&, Site, double) const;

}  // namespace dobra::offset::general
