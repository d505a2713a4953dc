#pragma once
// How long a treated offset curve is, all pieces together, by brute force in O(n^3): each raw parallel, mitre edge,
// bevel at distance D and arc is cut at all crossings with all others and with the left side and the caps; each part
// counts if nothing hides its middle, and once if several parts coincide.
//
// Ties are decided, not guessed: what long doubles leave open is asked again with a hundred digits, for D (1 + 2^-100)
// in place of D (what just touches itself counts as closed). What is still equal then is the same by construction.

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "shared/geom/polyline.h"
#include "shared/geom/predicates.h"
#include "shared/offset/offset.h"
#include "tests/support/offset_oracle.h"

namespace dobra::support {

namespace detail {

using Digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                             boost::multiprecision::et_off>;

template <class T>
struct Vec {
  T x = 0, y = 0;
  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec operator*(const T& f, const Vec& a) { return {f * a.x, f * a.y}; }
};
template <class T>
T dot(const Vec<T>& a, const Vec<T>& b) {
  return a.x * b.x + a.y * b.y;
}
template <class T>
T cross(const Vec<T>& a, const Vec<T>& b) {
  return a.x * b.y - a.y * b.x;
}
inline long double root(long double a) { return std::sqrt(a); }
/// Three steps of Newton's method from a long double; Boost's own goes bit by bit.
inline Digits root(const Digits& a) {
  if (a <= 0) return 0;
  Digits inverse = 1 / std::sqrt(static_cast<long double>(a));
  for (int step = 0; step < 3; ++step) inverse = inverse * (3 - a * inverse * inverse) / 2;
  return a * inverse;
}
template <class T>
T size(const Vec<T>& a) {
  return root(dot(a, a));
}
template <class T>
Vec<T> right(const Vec<T>& a) {
  return {a.y, -a.x};
}
using Quick = Vec<long double>;
using Exact = Vec<Digits>;
inline Quick quick(const Exact& a) { return {static_cast<long double>(a.x), static_cast<long double>(a.y)}; }
inline Quick quick(const Quick& a) { return a; }

/// A part of the raw outline, in either arithmetic.
template <class T>
struct RawPart {
  Vec<T> a, b, centre;
};
struct Raw {
  bool wanted, arc;
  long double span;  ///< Length, or angle of an arc, anticlockwise.
  RawPart<Digits> exact;
  RawPart<long double> quick;
  template <class T>
  [[nodiscard]] const RawPart<T>& in() const {
    if constexpr (std::is_same_v<T, long double>) {
      return quick;
    } else {
      return exact;
    }
  }
};
template <class T>
struct MitreSides {
  Vec<T> at, first, last, middle;  ///< Corner; normals of the segments, and of the tangent bevel.
};
struct Mitre {
  bool tangent;
  MitreSides<Digits> exact;
  MitreSides<long double> quick;
};

}  // namespace detail

class LengthOracle {
 public:
  /// @param base  without repeated points; ends lengthened if they are to be.  Joins that keep distance D: not Bevel.
  LengthOracle(const geom::Polyline& base, double distance, const offset::OffsetOptions& options)
      : d_(distance), exact_d_(Digits(distance) * (1 + ldexp(Digits(1), -100))), options_(options), base_(base) {
    if (options.side == offset::Side::LeftOfTravel) {
      for (geom::Point& p : base_.points) p.y = -p.y;
    }
    simple_ = base_.closed && crossings(base_) == 0;
    anticlockwise_ = simple_ && geom::signed_area(base_) > 0;
    build();
  }

  [[nodiscard]] double length() const {
    long double sum = 0;
    for (std::size_t i = 0; i < raw_.size(); ++i) {
      if (raw_[i].wanted) sum += free_part(i);
    }
    return static_cast<double>(sum);
  }

 private:
  using Digits = detail::Digits;
  using Exact = detail::Exact;
  using Quick = detail::Quick;
  using Raw = detail::Raw;

  Exact p(std::size_t i) const { return {base_.points[i].x, base_.points[i].y}; }
  Quick quick_p(std::size_t i) const { return {base_.points[i].x, base_.points[i].y}; }
  std::size_t next(std::size_t i) const { return i + 1 == base_.points.size() ? 0 : i + 1; }

  // The raw outline.
  void build() {
    const std::size_t n = base_.segment_count();
    for (std::size_t i = 0; i < n; ++i) {
      const Exact u = p(next(i)) - p(i);
      along_.push_back((1 / size(u)) * u);
    }
    std::vector<Digits> before(n, 0);
    std::vector<Digits> behind(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      if (base_.closed || i + 1 < n) corner(i, next(i) % n, behind[i], before[next(i) % n]);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Exact& u = along_[i];
      const Exact out = exact_d_ * right(u);
      line(true, p(i) + out - before[i] * u, p(next(i)) + out + behind[i] * u);
      line(false, p(i) - out, p(next(i)) - out);
    }
    if (base_.closed) return;
    const Digits back = -1;
    arc(false, p(n), right(along_[n - 1]), back * right(along_[n - 1]), std::acos(-1.0L));
    arc(false, p(0), back * right(along_[0]), right(along_[0]), std::acos(-1.0L));
  }
  void corner(std::size_t i, std::size_t j, Digits& behind, Digits& before) {
    const Exact& u = along_[i];
    const Exact& v = along_[j];
    const auto turn = geom::orient2d(base_.points[i], base_.points[j], base_.points[next(j)]);
    const Digits cosine = dot(u, v);
    const Digits sine = abs(cross(u, v));
    const bool back = turn == geom::Sign::Zero && cosine < 0;
    if (turn == geom::Sign::Zero && !back) return;
    const long double angle =
        back ? std::acos(-1.0L) : std::atan2(static_cast<long double>(sine), static_cast<long double>(cosine));
    if (turn == geom::Sign::Negative) return arc(false, p(j), Digits(-1) * right(v), Digits(-1) * right(u), angle);
    if (back) arc(false, p(j), right(u), right(v), angle);
    const Digits half = back         ? Digits(0)
                        : cosine > 0 ? Digits(sine / (1 + cosine))
                                     : Digits((1 - cosine) / sine);  // tan(angle / 2)
    const Digits secant = detail::root(Digits(1 + half * half));
    const bool tips = options_.join == offset::Join::Bisector || options_.join == offset::Join::Mitre;
    const bool mitre = !back && tips && secant <= Digits(options_.tip_limit()) * (1 + Digits(1e-14));
    const bool tangent = !mitre && tips && options_.beyond_tip_limit() == offset::BeyondLimit::TangentBevel;
    if (!mitre && !tangent) return arc(true, p(j), right(u), right(v), angle);
    const Exact middle = back ? u : (1 / secant) * (right(u) + half * u);
    mitres_.push_back(
        {tangent, {p(j), right(u), right(v), middle}, {quick(p(j)), quick(right(u)), quick(right(v)), quick(middle)}});
    before = behind = exact_d_ * (mitre ? half : back ? Digits(1) : Digits(half / (1 + secant)));
    if (tangent) {
      const Exact foot = p(j) + exact_d_ * middle;
      line(true, foot + behind * right(middle), foot - behind * right(middle));
    }
  }
  void line(bool wanted, const Exact& a, const Exact& b) {
    raw_.push_back({wanted, false, static_cast<long double>(size(b - a)), {a, b, {}}, {quick(a), quick(b), {}}});
  }
  void arc(bool wanted, const Exact& centre, const Exact& from, const Exact& to, long double angle) {
    const Exact a = centre + exact_d_ * from;
    const Exact b = centre + exact_d_ * to;
    raw_.push_back({wanted, true, angle, {a, b, centre}, {quick(a), quick(b), quick(centre)}});
  }

  // Places along a part of it.
  template <class T>
  detail::Vec<T> point(const Raw& r, long double t) const {
    const detail::RawPart<T>& part = r.in<T>();
    if (!r.arc) return part.a + T(t / r.span) * (part.b - part.a);
    const T c = std::cos(t);
    const T s = std::sin(t);
    const detail::Vec<T> u = part.a - part.centre;
    const detail::Vec<T> turned = c * u - s * right(u);
    return part.centre + T(size(u) / size(turned)) * turned;  // on the circle, to the last digit
  }
  template <class T>
  static long double where(const Raw& r, const detail::Vec<T>& q) {
    const detail::RawPart<T>& part = r.in<T>();
    if (!r.arc) return r.span > 0 ? static_cast<long double>(dot(q - part.a, part.b - part.a)) / r.span : 0;
    const Quick u = quick(part.a - part.centre);
    const Quick w = quick(q - part.centre);
    const long double angle = std::atan2(cross(u, w), dot(u, w));
    return angle < -1e-9L ? angle + 2 * std::acos(-1.0L) : angle;
  }
  /// Places of r where s meets it, or nearly does: a cut too many does no harm.
  /// @return false if T has too few digits to say.
  template <class T>
  bool cut(const Raw& r, const Raw& s, const T& d, std::vector<long double>& cuts) const {
    using V = detail::Vec<T>;
    using std::abs;
    constexpr bool is_quick = std::is_same_v<T, long double>;
    const detail::RawPart<T>& e = r.in<T>();
    const detail::RawPart<T>& f = s.in<T>();
    const auto keep = [&](const V& q) {
      const long double t = where(r, q);
      if (t > 0 && t < r.span && near(s, where(s, q))) cuts.push_back(t);
    };
    if (!r.arc && !s.arc) {
      const V u = e.b - e.a;
      const V v = f.b - f.a;
      const T det = cross(u, v);
      const bool shallow = det * det < T(1e-12) * dot(u, u) * dot(v, v);
      if (is_quick && shallow && gap_of(r, s) < 1e-6L * (d_ + size(quick(u)) + size(quick(v)))) return false;
      if (det != 0) keep(e.a + T(cross(f.a - e.a, v) / det) * u);
      keep(f.a);
      keep(f.b);
    } else if (r.arc && s.arc) {
      const V w = f.centre - e.centre;
      const T far = dot(w, w);
      const T half = d * d - far / 4;
      if (is_quick && abs(half) < T(1e-9) * d * d) return false;
      if (far == 0 || half < -T(1e-60) * d * d) return true;
      if (is_quick && far < T(1e-12) * d * d) return false;
      const V aside = T(half > 0 ? T(detail::root(T(half / far))) : T(0)) * right(w);  // or tangent
      keep(e.centre + T(0.5) * w + aside);
      keep(e.centre + T(0.5) * w - aside);
    } else {
      const detail::RawPart<T>& l = r.arc ? f : e;
      const V centre = r.arc ? e.centre : f.centre;
      const V u = T(1 / size(l.b - l.a)) * (l.b - l.a);
      const V foot = l.a + dot(centre - l.a, u) * u;
      const T half = d * d - dot(foot - centre, foot - centre);
      if (is_quick && abs(half) < T(1e-9) * d * d) return false;
      if (half < -T(1e-60) * d * d) return true;
      const T aside = half > 0 ? T(detail::root(half)) : T(0);
      keep(foot + aside * u);
      keep(foot - aside * u);
    }
    return true;
  }
  /// True if the place that where() says is on s or next to an end of it.
  static bool near(const Raw& s, long double t) {
    if (s.arc) return t < s.span + 1e-6L || t > 2 * std::acos(-1.0L) - 1e-6L;
    const long double slack = 1e-6L * (s.span + size(s.quick.a));
    return t > -slack && t < s.span + slack;
  }
  /// Least distance of the ends of one line from the other.
  static long double gap_of(const Raw& r, const Raw& s) {
    const auto off = [](const Raw& on, const Quick& q) {
      const Quick u = on.quick.b - on.quick.a;
      return size(u) == 0 ? size(q - on.quick.a) : std::abs(cross(u, q - on.quick.a)) / size(u);
    };
    return std::min(std::min(off(r, s.quick.a), off(r, s.quick.b)), std::min(off(s, r.quick.a), off(s, r.quick.b)));
  }

  // What hides a place.
  [[nodiscard]] bool hidden(std::size_t i, long double t) const {
    const Raw& r = raw_[i];
    const Quick q = point<long double>(r, t);
    const long double slack = 1e-11L * d_ + 1e-15L * size(q);
    std::vector<std::size_t> near;  // segments, mitres, other parts that long doubles cannot tell from a tie
    for (std::size_t j = 0; j < base_.segment_count(); ++j) {
      const Quick a = quick_p(j);
      const Quick u = quick_p(next(j)) - a;
      const long double gap = size(a + std::clamp<long double>(dot(q - a, u) / dot(u, u), 0, 1) * u - q) - d_;
      if (gap < -slack) return true;
      if (gap <= slack) near.push_back(j);
    }
    const std::size_t segments = near.size();
    for (std::size_t k = 0; k < mitres_.size(); ++k) {
      const long double depth = depth_in(mitres_[k].quick, mitres_[k].tangent, q, static_cast<long double>(d_));
      if (depth > slack) return true;
      if (depth > -slack) near.push_back(k);
    }
    const std::size_t mitres = near.size();
    for (std::size_t k = 0; k < i; ++k) {
      if (raw_[k].wanted && raw_[k].arc == r.arc && off(raw_[k], q) < slack) near.push_back(k);
    }
    if (near.empty()) return false;
    const Exact e = point<Digits>(r, t);
    for (std::size_t k = 0; k < near.size(); ++k) {
      const std::size_t j = near[k];
      if (k < segments ? nearer_than_d(j, e)
          : k < mitres ? depth_in(mitres_[j].exact, mitres_[j].tangent, e, exact_d_) > same_
                       : coincide(r, raw_[j], e)) {
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool nearer_than_d(std::size_t j, const Exact& q) const {
    const Exact u = p(next(j)) - p(j);
    const Exact w = q - p(j);
    const Digits s = dot(w, u);
    const Digits all = dot(u, u);
    const Digits limit = exact_d_ * exact_d_ * (1 - same_);
    if (s <= 0) return dot(w, w) < limit;
    if (s >= all) return dot(q - p(next(j)), q - p(next(j))) < limit;
    const Digits c = cross(u, w);
    return c * c < limit * all;
  }
  /// Least distance of q from any side of a mitre, if q is inside; negative outside.
  template <class T>
  static T depth_in(const detail::MitreSides<T>& m, bool tangent, const detail::Vec<T>& q, const T& d) {
    const detail::Vec<T> w = q - m.at;
    T depth = std::min(T(d - dot(m.first, w)), T(d - dot(m.last, w)));
    if (tangent) depth = std::min(depth, T(d - dot(m.middle, w)));
    return std::min({depth, cross(m.first, w), cross(w, m.last), dot(w, m.middle)});
  }
  static long double off(const Raw& r, const Quick& q) {
    if (r.arc) return std::abs(size(q - r.quick.centre) - size(r.quick.a - r.quick.centre));
    const Quick u = r.quick.b - r.quick.a;
    const long double whole = dot(u, u);
    if (whole == 0) return size(q - r.quick.a);
    return size(r.quick.a + std::clamp<long double>(dot(q - r.quick.a, u) / whole, 0, 1) * u - q);
  }
  /// True if `e`, on r, is on s too and r and s run the same way there.
  [[nodiscard]] bool coincide(const Raw& r, const Raw& s, const Exact& e) const {
    if (r.arc) {
      if (size(r.exact.centre - s.exact.centre) > same_ * exact_d_) return false;
      const Exact w = e - s.exact.centre;
      const Exact from = s.exact.a - s.exact.centre;
      const Exact to = s.exact.b - s.exact.centre;
      return cross(from, w) > 0 && cross(w, to) > 0;  // at most half a turn
    }
    const Exact u = s.exact.b - s.exact.a;
    const Exact w = e - s.exact.a;
    const Digits whole = dot(u, u);
    const Digits t = dot(w, u);
    return t > 0 && t < whole && abs(cross(u, w)) <= same_ * whole && dot(u, r.exact.b - r.exact.a) > 0;
  }
  /// The tip of a mitre, through a thin part of a simple contour, is on the wrong side and does not count.
  [[nodiscard]] bool pokes_through(const Quick& q) const {
    if (!simple_) return false;
    const geom::Side side = geom::locate(base_, {static_cast<double>(q.x), static_cast<double>(q.y)});
    return side == (anticlockwise_ ? geom::Side::Inside : geom::Side::Outside);
  }

  [[nodiscard]] long double free_part(std::size_t i) const {
    const Raw& r = raw_[i];
    std::vector<long double> cuts{0, r.span};
    for (std::size_t j = 0; j < raw_.size(); ++j) {
      if (j != i && !cut<long double>(r, raw_[j], d_, cuts)) cut<Digits>(r, raw_[j], exact_d_, cuts);
    }
    std::sort(cuts.begin(), cuts.end());
    long double sum = 0;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const long double part = cuts[k + 1] - cuts[k];
      if (part < 1e-17L * r.span) continue;  // the same crossing twice
      const long double middle = 0.5L * (cuts[k] + cuts[k + 1]);
      if (!hidden(i, middle) && !pokes_through(point<long double>(r, middle))) sum += part;
    }
    return r.arc ? d_ * sum : sum;
  }

  long double d_;
  Digits exact_d_;  ///< A little more than d_.
  Digits same_ = Digits("1e-70");
  offset::OffsetOptions options_;
  geom::Polyline base_;
  bool simple_ = false;
  bool anticlockwise_ = false;
  std::vector<Exact> along_;
  std::vector<Raw> raw_;
  std::vector<detail::Mitre> mitres_;
};

}  // namespace dobra::support
