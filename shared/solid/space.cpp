#include "shared/solid/space.h"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <tuple>

#include "shared/base/check.h"
#include "shared/solid/plane_crossing.h"

namespace dobra::solid {
namespace {

using geom::Point3;
using geom::Sign;
using geom::Vector3;

constexpr double unit = DBL_EPSILON;    // twice the error of one rounding, hence room in every bound below
constexpr double least_bound = 1e-280;  // below it products may have lost bits to underflow

Dyadic3 exact(Point3 p) { return {Dyadic(p.x), Dyadic(p.y), Dyadic(p.z)}; }

std::uint64_t hash_of(Point3 p) {
  std::uint64_t hash = 0x9e3779b97f4a7c15U;
  for (const double value : {p.x, p.y, p.z}) {
    hash ^= std::bit_cast<std::uint64_t>(value);
    hash *= 0xff51afd7ed558ccdU;
    hash ^= hash >> 32;
  }
  return hash;
}

double absolute(double value) { return std::abs(value); }

Homogeneous exact_coefficients(const Plane& plane) {
  if (plane.constant) return {exact(plane.through[0]), Dyadic(*plane.constant)};
  const Dyadic3 origin = exact(plane.through[0]);
  const Dyadic3 normal = cross(exact(plane.through[1]) - origin, exact(plane.through[2]) - origin);
  return {normal, -dot(normal, origin)};
}

/// The place on the line a-b that divides it as the values at its ends say, which have opposite signs.
Homogeneous divided(const Homogeneous& a, const Homogeneous& b, const Dyadic& at_a, const Dyadic& at_b) {
  return {a.place * at_b - b.place * at_a, a.weight * at_b - b.weight * at_a};
}

/// Where a line through two places meets a plane.
Homogeneous crossing(const Homogeneous& a, const Homogeneous& b, const Homogeneous& c) {
  return divided(a, b, dot(c.place, a.place) + c.weight * a.weight, dot(c.place, b.place) + c.weight * b.weight);
}

Homogeneous with_positive_weight(Homogeneous place) {
  if (place.weight.sign() == Sign::Negative) {
    for (Dyadic& value : place.place) value = -value;
    place.weight = -place.weight;
  }
  return place;
}

}  // namespace

Space::Space() : slots_(64, nothing) {}

PointId Space::add(Point3 place) {
  return find_or_add({place.x + 0.0, place.y + 0.0, place.z + 0.0}, nullptr);  // one zero
}

PointId Space::add(Homogeneous place) {
  place = with_positive_weight(std::move(place));
  const Point3 near{rounded_quotient(place.place[0], place.weight), rounded_quotient(place.place[1], place.weight),
                    rounded_quotient(place.place[2], place.weight)};
  const Dyadic3 back = exact(near) * place.weight;
  const Dyadic3 rest = back - place.place;
  if (rest[0].zero() && rest[1].zero() && rest[2].zero()) return find_or_add(near, nullptr);
  const Implicit exact = std::make_shared<const Homogeneous>(std::move(place));
  return find_or_add(near, &exact);
}

PointId Space::add(const Space& other, PointId point) {
  const std::uint32_t kept = other.exact_[point.index()];
  return find_or_add(other.rounded(point), kept == nothing ? nullptr : &other.places_[kept]);
}

PointId Space::find_or_add(Point3 rounded, const Implicit* exact) {
  if (2 * (rounded_.size() + 1) > slots_.size()) resize_slots(2 * slots_.size());
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t at = hash_of(rounded) & mask;; at = (at + 1) & mask) {
    const std::uint32_t number = slots_[at];
    if (number == nothing) {
      slots_[at] = static_cast<std::uint32_t>(rounded_.size());
      rounded_.push_back(rounded);
      exact_.push_back(exact == nullptr ? nothing : static_cast<std::uint32_t>(places_.size()));
      if (exact != nullptr) places_.push_back(*exact);
      return PointId(rounded_.size() - 1);
    }
    if (rounded_[number] == rounded && same(number, exact)) return PointId(number);
  }
}

bool Space::same(std::uint32_t number, const Implicit* exact) const {
  // A place of doubles never stands as an exact one, so that the kinds differ where the places do.
  if ((exact_[number] == nothing) != (exact == nullptr)) return false;
  if (exact == nullptr) return true;
  const Implicit& kept = places_[exact_[number]];
  const auto* crossing = std::get_if<Crossing>(&kept);
  const auto* other = std::get_if<Crossing>(exact);
  if (crossing != nullptr && other != nullptr && *crossing == *other) return true;
  const Homogeneous own = place(kept);
  const Homogeneous theirs = place(*exact);
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(own.place[i] * theirs.weight - theirs.place[i] * own.weight).zero()) return false;
  }
  return true;
}

void Space::reserve(std::size_t points, std::size_t planes) {
  rounded_.reserve(points);
  exact_.reserve(points);
  planes_.reserve(planes);
  if (const std::size_t wanted = std::bit_ceil(2 * (points + 1)); wanted > slots_.size()) resize_slots(wanted);
}

void Space::resize_slots(std::size_t count) {
  slots_.assign(count, nothing);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = 0; i < rounded_.size(); ++i) {
    std::size_t at = hash_of(rounded_[i]) & mask;
    while (slots_[at] != nothing) at = (at + 1) & mask;
    slots_[at] = static_cast<std::uint32_t>(i);
  }
}

PlaneId Space::add(const Plane& plane) {
  KeptPlane kept{plane, {}, {}, nullptr};
  if (plane.constant) {
    kept.normal = plane.through[0] - Point3{};
  } else {
    const Vector3 a = plane.through[1] - plane.through[0];
    const Vector3 b = plane.through[2] - plane.through[0];
    kept.normal = cross(a, b);
    const double scale = 4.0 * unit;
    kept.error = {scale * (absolute(a.y * b.z) + absolute(a.z * b.y)),
                  scale * (absolute(a.z * b.x) + absolute(a.x * b.z)),
                  scale * (absolute(a.x * b.y) + absolute(a.y * b.x))};
  }
  planes_.push_back(std::move(kept));
  return PlaneId(planes_.size() - 1);
}

Homogeneous Space::place(PointId p) const {
  const std::uint32_t kept = exact_[p.index()];
  if (kept != nothing) return place(places_[kept]);
  return {exact(rounded_[p.index()]), Dyadic(1.0)};
}

Homogeneous Space::place(const Implicit& implicit) {
  if (const auto* kept = std::get_if<0>(&implicit)) return **kept;
  const auto& [a, b, plane] = std::get<Crossing>(implicit);
  return with_positive_weight(crossing({exact(a), Dyadic(1.0)}, {exact(b), Dyadic(1.0)}, exact_coefficients(plane)));
}

const Homogeneous& Space::coefficients(PlaneId q) const {
  const KeptPlane& plane = planes_[q.index()];
  if (!plane.exact) plane.exact = std::make_unique<Homogeneous>(exact_coefficients(plane.given));
  return *plane.exact;
}

Sign Space::normal_sign(PlaneId q, int axis) const {
  const KeptPlane& plane = planes_[q.index()];
  const double value = axis == 0 ? plane.normal.x : axis == 1 ? plane.normal.y : plane.normal.z;
  const double error = axis == 0 ? plane.error.x : axis == 1 ? plane.error.y : plane.error.z;
  if (plane.given.constant || absolute(value) > std::max(error, least_bound)) return geom::sign_of(value);
  return normal(q)[static_cast<std::size_t>(axis)].sign();
}

Projection Space::projection(PlaneId q) const {
  const Vector3 n = planes_[q.index()].normal;
  std::array<int, 3> axes{0, 1, 2};
  const std::array<double, 3> size{absolute(n.x), absolute(n.y), absolute(n.z)};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](int a, int b) { return size[static_cast<std::size_t>(a)] > size[static_cast<std::size_t>(b)]; });
  for (const int axis : axes) {
    const Sign sign = normal_sign(q, axis);
    if (sign == Sign::Zero) continue;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    return sign == Sign::Positive ? Projection{u, v} : Projection{v, u};
  }
  DOBRA_CHECK(false);  // the three points of a plane are not collinear
  return {};
}

Sign Space::side(PlaneId q, PointId p) const {
  return side(q, rounded_[p.index()], is_exact(p), [&] { return place(p); });
}

Sign Space::side(PlaneId q, Point3 p) const {
  return side(q, p, true, [&] { return Homogeneous{{Dyadic(p.x), Dyadic(p.y), Dyadic(p.z)}, Dyadic(1.0)}; });
}

template <class Exact>
Sign Space::side(PlaneId q, Point3 at, bool is_exact, Exact&& exact) const {
  const KeptPlane& plane = planes_[q.index()];
  if (!plane.given.constant && is_exact) {
    const auto& through = plane.given.through;
    if (at == through[0] || at == through[1] || at == through[2]) return Sign::Zero;
  }
  const Vector3 r = plane.given.constant ? at - Point3{} : at - plane.given.through[0];
  const Vector3 n = plane.normal;
  const double value = dot(n, r) + plane.given.constant.value_or(0.0);
  const double sizes = absolute(n.x * r.x) + absolute(n.y * r.y) + absolute(n.z * r.z);
  double bound = 4.0 * unit * (sizes + absolute(plane.given.constant.value_or(0.0)));
  bound += plane.error.x * absolute(r.x) + plane.error.y * absolute(r.y) + plane.error.z * absolute(r.z);
  if (!is_exact) bound += unit * (absolute(n.x * at.x) + absolute(n.y * at.y) + absolute(n.z * at.z));
  if (absolute(value) > std::max(1.01 * bound, least_bound)) return geom::sign_of(value);
  const Homogeneous& c = coefficients(q);
  const Homogeneous there = exact();
  return (dot(c.place, there.place) + c.weight * there.weight).sign();
}

bool Space::coplanar(PlaneId a, PlaneId b) const {
  const Plane& other = plane(b);
  if (!other.constant && !plane(a).constant) {
    // Most pairs are told apart by one of the points in doubles.
    const KeptPlane& own = planes_[a.index()];
    for (const Point3& p : other.through) {
      const Vector3 r = p - own.given.through[0];
      const double bound =
          5.0 * unit * (absolute(own.normal.x * r.x) + absolute(own.normal.y * r.y) + absolute(own.normal.z * r.z)) +
          1.01 * (own.error.x * absolute(r.x) + own.error.y * absolute(r.y) + own.error.z * absolute(r.z));
      if (absolute(dot(own.normal, r)) > std::max(bound, least_bound)) return false;
    }
    for (const Point3& p : other.through) {
      if (apart_in_doubles(own.given, p)) return false;
    }
  }
  const Homogeneous& c = coefficients(a);
  const Homogeneous& d = coefficients(b);
  const Dyadic3 turned = cross(c.place, d.place);
  if (!turned[0].zero() || !turned[1].zero() || !turned[2].zero()) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(c.place[i] * d.weight - d.place[i] * c.weight).zero()) return false;
  }
  return true;
}

Dyadic Space::exact_orient(Projection onto, PointId a, PointId b, PointId c) const {
  const auto u = static_cast<std::size_t>(onto.u);
  const auto v = static_cast<std::size_t>(onto.v);
  const Homogeneous p = place(a);
  const Homogeneous q = place(b);
  const Homogeneous r = place(c);
  return p.place[u] * (q.place[v] * r.weight - r.place[v] * q.weight) -
         p.place[v] * (q.place[u] * r.weight - r.place[u] * q.weight) +
         p.weight * (q.place[u] * r.place[v] - r.place[u] * q.place[v]);
}

Sign Space::orient(Projection onto, PointId a, PointId b, PointId c) const {
  if (a == b || b == c || a == c) return Sign::Zero;
  const geom::Point p{coordinate(a, onto.u), coordinate(a, onto.v)};
  const geom::Point q{coordinate(b, onto.u), coordinate(b, onto.v)};
  const geom::Point r{coordinate(c, onto.u), coordinate(c, onto.v)};
  if (is_exact(a) && is_exact(b) && is_exact(c)) return geom::orient2d(p, q, r);
  const double pu = p.x - r.x;
  const double pv = p.y - r.y;
  const double qu = q.x - r.x;
  const double qv = q.y - r.y;
  const double value = pu * qv - pv * qu;
  const double size =
      std::max({absolute(p.x), absolute(p.y), absolute(q.x), absolute(q.y), absolute(r.x), absolute(r.y)});
  const double slip = unit * size;  // of each difference, because the points are rounded
  const double bound = 4.0 * unit * (absolute(pu * qv) + absolute(pv * qu)) +
                       1.01 * slip * (absolute(pu) + absolute(pv) + absolute(qu) + absolute(qv)) + 3.0 * slip * slip;
  if (absolute(value) > std::max(bound, least_bound)) return geom::sign_of(value);
  if (on_one_edge(a, b, c)) return Sign::Zero;
  return exact_orient(onto, a, b, c).sign();
}

bool Space::on_one_edge(PointId a, PointId b, PointId c) const {
  const Crossing* edge = nullptr;
  for (const PointId p : {a, b, c}) {
    const std::uint32_t kept = exact_[p.index()];
    if (kept == nothing) continue;
    const auto* own = std::get_if<Crossing>(&places_[kept]);
    if (own == nullptr) return false;
    if (edge == nullptr) edge = own;
    if (own->a != edge->a || own->b != edge->b) return false;
  }
  if (edge == nullptr) return false;
  for (const PointId p : {a, b, c}) {
    const Point3 at = rounded_[p.index()];
    if (is_exact(p) && at != edge->a && at != edge->b) return false;
  }
  return true;
}

bool Space::collinear(PointId a, PointId b, PointId c) const {
  return orient({0, 1}, a, b, c) == Sign::Zero && orient({1, 2}, a, b, c) == Sign::Zero &&
         orient({2, 0}, a, b, c) == Sign::Zero;
}

std::strong_ordering Space::compare(int axis, PointId a, PointId b) const {
  const double own = coordinate(a, axis);
  const double other = coordinate(b, axis);
  if (own < other) return std::strong_ordering::less;  // rounding keeps the order
  if (own > other) return std::strong_ordering::greater;
  if (a == b || (is_exact(a) && is_exact(b))) return std::strong_ordering::equal;
  const auto i = static_cast<std::size_t>(axis);
  const Homogeneous p = place(a);
  const Homogeneous q = place(b);
  return static_cast<int>((p.place[i] * q.weight - q.place[i] * p.weight).sign()) <=> 0;
}

std::strong_ordering Space::compare(Projection onto, PointId a, PointId b) const {
  const std::strong_ordering first = compare(onto.u, a, b);
  return first != std::strong_ordering::equal ? first : compare(onto.v, a, b);
}

std::size_t Space::Hash::operator()(const EdgeAndPlane& key) const {
  std::uint64_t hash = (std::uint64_t{key.a.index()} << 32U) ^ key.b.index();
  hash = (hash ^ (hash >> 29U)) * 0xff51afd7ed558ccdU + key.plane.index();
  return (hash ^ (hash >> 32U)) * 0x9e3779b97f4a7c15U;
}

PointId Space::meet(PointId a, PointId b, PlaneId q) {
  if (b < a) std::swap(a, b);
  const EdgeAndPlane key{a, b, q};
  if (const auto known = crossings_.find(key); known != crossings_.end()) return known->second;
  const PointId added = add_crossing(a, b, q);
  crossings_.emplace(key, added);
  return added;
}

PointId Space::add_crossing(PointId a, PointId b, PlaneId q) {
  if (is_exact(a) && is_exact(b)) {
    const Point3 from = rounded(a);
    const Point3 to = rounded(b);
    const auto found = crossing_in_doubles(plane(q), from, to);
    if (found && found->rounded) {
      const Point3& near = found->at;
      const bool forwards = std::tie(from.x, from.y, from.z) < std::tie(to.x, to.y, to.z);
      const Implicit implicit = Crossing{forwards ? from : to, forwards ? to : from, plane(q)};
      return find_or_add({near.x + 0.0, near.y + 0.0, near.z + 0.0}, &implicit);
    }
  }
  return add(crossing(place(a), place(b), coefficients(q)));
}

PointId Space::meet(PlaneId a, PlaneId b, PlaneId c) {
  const Homogeneous& p = coefficients(a);
  const Homogeneous& q = coefficients(b);
  const Homogeneous& r = coefficients(c);
  const Dyadic3 qr = cross(q.place, r.place);
  const Dyadic3 rp = cross(r.place, p.place);
  const Dyadic3 pq = cross(p.place, q.place);
  return add(Homogeneous{qr * (-p.weight) + rp * (-q.weight) + pq * (-r.weight), dot(p.place, qr)});
}

PointId Space::meet(Projection onto, PointId a, PointId b, PointId c, PointId d) {
  return add(divided(place(a), place(b), exact_orient(onto, c, d, a), exact_orient(onto, c, d, b)));
}

Homogeneous Space::middle(PointId a, PointId b) const {
  const Homogeneous p = place(a);
  const Homogeneous q = place(b);
  return {p.place * q.weight + q.place * p.weight, p.weight * q.weight * Dyadic(2.0)};
}

}  // namespace dobra::solid
