#include "quebra/domain/junctions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"

// 1. Chords of all curves. 2. Ends of internal lines and cracks, and named points, that lie on another curve. 3. Pairs
// of chords that meet: refined to the true curves. 4. Sorted.

namespace quebra::domain {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::At;
using dobra::geom::Box;
using dobra::geom::IntersectionKind;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Segment;
using dobra::geom::Vector;

struct Chord {
  Segment segment;
  std::size_t curve = 0;
  std::size_t number = 0;  ///< Along the curve.
  double s_from = 0.0, s_to = 0.0;
};

bool straight(const sketch::Curve& curve) { return std::holds_alternative<Polyline>(curve.shape); }

class Finder {
 public:
  Finder(Domain& domain, const std::vector<Place>& places, double tolerance)
      : domain_(domain), places_(places), tolerance_(tolerance) {
    std::vector<Box> boxes;
    const std::vector<std::uint8_t> lone = domain.lone_circles(tolerance);
    for (std::size_t c = 0; c < domain.curves.size(); ++c) {
      lengths_.push_back(length(domain.curves[c]));
      if (lone[c] != 0) {  // meets nothing
        counts_.push_back(0);
        continue;
      }
      const sketch::Trace along = trace(domain.curves[c]);
      counts_.push_back(along.line.segment_count());
      double sagitta = 0.0;
      if (!straight(domain.curves[c]))
        sagitta = 0.25 * sketch::trace_turn.radians() * lengths_[c] / static_cast<double>(counts_[c]);
      for (std::size_t i = 0; i < along.line.segment_count(); ++i) {
        chords_.push_back({along.line.segment(i), c, i, along.s[i], along.s[i + 1]});
        Box box = along.line.segment(i).box();
        const Vector rim{sagitta + tolerance, sagitta + tolerance};
        box.add(box.low - rim);
        box.add(box.high + rim);
        boxes.push_back(box);
      }
    }
    index_ = dobra::geom::SpatialIndex(boxes);
  }

  Result<void> run() {
    for (std::size_t c = 0; c < domain_.curves.size(); ++c) {
      if (bounds(domain_.curves[c]) || closed(domain_.curves[c])) continue;
      settle_on_others(c, 0.0);
      settle_on_others(c, lengths_[c]);
    }
    for (sketch::NamedPoint& named : domain_.points) named.at = settle(named.at);
    for (const auto& [i, j] : index_.overlapping_pairs()) DOBRA_TRY_VOID(meet(chords_[i], chords_[j]));
    auto& junctions = domain_.junctions;
    std::stable_sort(junctions.begin(), junctions.end(), [](const Junction& a, const Junction& b) {
      return std::pair{a.curve, a.s} < std::pair{b.curve, b.s};
    });
    return {};
  }

 private:
  /// The distance along a curve that is nearest to p, from s on.
  [[nodiscard]] double nearest(std::size_t curve, double s, Point p) const {
    const sketch::Curve& c = domain_.curves[curve];
    if (straight(c)) return s;
    for (int step = 0; step < 20; ++step) {
      const double ahead = dot(p - point(c, s), direction(c, s));
      s = std::clamp(s + ahead, 0.0, lengths_[curve]);
      if (std::abs(ahead) <= 1e-15 * lengths_[curve]) break;
    }
    return s;
  }
  [[nodiscard]] double nearest_of(const Chord& chord, Point p) const {
    return nearest(chord.curve, chord.s_from + nearest_fraction(chord.segment, p) * (chord.s_to - chord.s_from), p);
  }

  /// The distance along the chord's curve that is nearest to p, if that is within the tolerance.
  [[nodiscard]] std::optional<double> nearest(const Chord& chord, Point p) const {
    const double s = nearest_of(chord, p);
    if (distance(point(domain_.curves[chord.curve], s), p) > tolerance_) return std::nullopt;
    return s;
  }

  /// How the direction of a curve turns with s, by differences.
  [[nodiscard]] Vector turning(std::size_t curve, double s) const {
    const double step = 1e-5 * lengths_[curve];
    const double from = std::max(s - step, 0.0), to = std::min(s + step, lengths_[curve]);
    return (direction(domain_.curves[curve], to) - direction(domain_.curves[curve], from)) / (to - from);
  }

  /// Distances along both curves where they touch without crossing, away from their ends: Newton's method to where they
  /// are parallel, one right above the other.
  [[nodiscard]] std::optional<std::array<double, 2>> contact(const Chord& a, const Chord& b) const {
    const sketch::Curve& one = domain_.curves[a.curve];
    const sketch::Curve& two = domain_.curves[b.curve];
    double s = nearest_of(a, midpoint(b.segment.from, b.segment.to)), t = nearest_of(b, point(one, s));
    for (int step = 0; step < 30; ++step) {
      const Vector u = direction(one, s), v = direction(two, t), gap = point(two, t) - point(one, s);
      const double parallel = cross(u, v), above = dot(gap, u);
      const Vector du = turning(a.curve, s), dv = turning(b.curve, t);
      // Of both by s and t.
      const double ps = cross(du, v), pt = cross(u, dv), as = dot(gap, du) - 1.0, at = dot(v, u);
      const double determinant = ps * at - pt * as;
      if (!(std::abs(determinant) > 1e-9 * (std::abs(ps) + std::abs(pt)))) return std::nullopt;
      const double ds = (pt * above - at * parallel) / determinant, dt = (as * parallel - ps * above) / determinant;
      s = std::clamp(s + ds, 0.0, lengths_[a.curve]);
      t = std::clamp(t + dt, 0.0, lengths_[b.curve]);
      if (std::abs(ds) + std::abs(dt) < 1e-14 * (lengths_[a.curve] + lengths_[b.curve])) break;
    }
    constexpr double rounding = 1e-5, tangent = 1e-6;  // of the tolerance; sine
    if (distance(point(one, s), point(two, t)) > rounding * tolerance_) return std::nullopt;
    if (std::abs(cross(direction(one, s), direction(two, t))) > tangent) return std::nullopt;
    if (end_near(a.curve, s) && end_near(b.curve, t) && !(closed(one) && closed(two))) return std::nullopt;
    return std::array{s, t};
  }

  void settle_on_others(std::size_t curve, double s) {
    const Point p = point(domain_.curves[curve], s);
    index_.for_each_overlapping(Segment{p, p}.box(), [&](std::size_t i) {
      if (chords_[i].curve == curve) return;
      if (const auto at = nearest(chords_[i], p)) put(chords_[i].curve, *at, p);
    });
  }

  /// A named point on a curve is a node of it, or the end or vertex that lies there.
  Point settle(Point p) {
    std::optional<Point> result;
    index_.for_each_overlapping(Segment{p, p}.box(), [&](std::size_t i) {
      const auto at = nearest(chords_[i], p);
      if (!at) return;
      if (!result) result = known(chords_[i].curve, *at).value_or(p);
      put(chords_[i].curve, *at, *result);
    });
    return result.value_or(p);
  }

  Error crossing(const Chord& a, const Chord& b, Point at) const {
    const sketch::Curve& one = domain_.curves[a.curve];
    const sketch::Curve& two = domain_.curves[b.curve];
    const std::string what = a.curve == b.curve
                                 ? fmt::format("curve '{}' crosses or touches itself", one.name)
                                 : fmt::format("curves '{}' and '{}' cross or overlap", one.name, two.name);
    Place place = places_[std::max(a.curve, b.curve)];
    place.x = at.x;
    place.y = at.y;
    return {ErrorCode::SelfIntersection, what + "; curves may meet only at their ends", place};
  }

  [[nodiscard]] bool follow_each_other(const Chord& a, const Chord& b) const {
    if (a.curve != b.curve) return false;
    const std::size_t gap = std::max(a.number, b.number) - std::min(a.number, b.number);
    return gap == 1 || (closed(domain_.curves[a.curve]) && gap + 1 == counts_[a.curve]);
  }

  Result<void> meet(const Chord& a, const Chord& b) {
    const bool both_bound = bounds(domain_.curves[a.curve]) && bounds(domain_.curves[b.curve]);
    if (both_bound && a.curve != b.curve && !(straight(domain_.curves[a.curve]) && straight(domain_.curves[b.curve]))) {
      if (const auto s = contact(a, b)) {
        join(a, b, *s, point(domain_.curves[a.curve], (*s)[0]));
        return {};
      }
    }
    const auto meeting = intersect(a.segment, b.segment);
    if (meeting.kind == IntersectionKind::None) return {};
    const Point at = meeting.start.point;
    if (meeting.kind == IntersectionKind::Overlap) return crossing(a, b, at);
    const bool at_ends = meeting.start.on_first != At::Interior && meeting.start.on_second != At::Interior;
    // Loops may touch in a vertex; chords of one curve meet in the vertex between them.
    if (at_ends && (both_bound || follow_each_other(a, b) || (is_end(a.curve, at) && is_end(b.curve, at)))) return {};
    if (both_bound || a.curve == b.curve) return crossing(a, b, at);
    const auto s = refined(a, b, at);
    if (!s) return {};
    const bool exact = straight(domain_.curves[a.curve]) && straight(domain_.curves[b.curve]);
    join(a, b, *s, exact ? at : point(domain_.curves[a.curve], (*s)[0]));
    return {};
  }

  /// Both curves pass one point where they meet: an end, junction or vertex of one of them if there is any, `at` if
  /// not.
  void join(const Chord& a, const Chord& b, const std::array<double, 2>& s, Point at) {
    auto p = end_near(a.curve, s[0]);
    if (!p) p = end_near(b.curve, s[1]);
    if (!p) p = known(a.curve, s[0]);
    if (!p) p = known(b.curve, s[1]);
    put(a.curve, s[0], p.value_or(at));
    put(b.curve, s[1], p.value_or(at));
  }

  [[nodiscard]] bool is_end(std::size_t curve, Point p) const {
    const sketch::Curve& c = domain_.curves[curve];
    return !closed(c) && (point(c, 0.0) == p || point(c, lengths_[curve]) == p);
  }

  /// Distances along both curves where they truly meet; nothing where only their chords do.
  [[nodiscard]] std::optional<std::array<double, 2>> refined(const Chord& a, const Chord& b, Point at) const {
    const auto along = [&](const Chord& chord) {
      return chord.s_from + nearest_fraction(chord.segment, at) * (chord.s_to - chord.s_from);
    };
    return meeting(domain_.curves[a.curve], along(a), domain_.curves[b.curve], along(b), tolerance_);
  }

  [[nodiscard]] std::optional<Point> end_near(std::size_t curve, double s) const {
    for (const double end : {0.0, lengths_[curve]}) {
      if (std::abs(end - s) <= tolerance_) return point(domain_.curves[curve], end);
    }
    return std::nullopt;
  }

  /// The end, junction or vertex of a curve within the tolerance of distance s.
  [[nodiscard]] std::optional<Point> known(std::size_t curve, double s) const {
    if (const auto end = end_near(curve, s)) return end;
    for (const Junction& junction : domain_.junctions) {
      if (junction.curve == curve && std::abs(junction.s - s) <= tolerance_) return junction.at;
    }
    const auto corner = corner_near(curve, s);
    return corner ? std::optional(point(domain_.curves[curve], *corner)) : std::nullopt;
  }

  [[nodiscard]] std::optional<double> corner_near(std::size_t curve, double s) const {
    const std::vector<double> all = corners(domain_.curves[curve]);
    const auto above = std::lower_bound(all.begin(), all.end(), s - tolerance_);
    return above != all.end() && *above <= s + tolerance_ ? std::optional(*above) : std::nullopt;
  }

  /// Makes the curve pass p at distance s, unless it has a node there already.
  void put(std::size_t curve, double s, Point p) {
    if (end_near(curve, s)) return;
    for (const Junction& junction : domain_.junctions) {
      if (junction.curve == curve && std::abs(junction.s - s) <= tolerance_) return;
    }
    domain_.junctions.push_back({curve, corner_near(curve, s).value_or(s), p});
  }

  Domain& domain_;
  const std::vector<Place>& places_;
  double tolerance_;
  std::vector<Chord> chords_;
  std::vector<double> lengths_;
  std::vector<std::size_t> counts_;
  dobra::geom::SpatialIndex index_;
};

}  // namespace

Result<void> find_junctions(Domain& domain, const std::vector<Place>& places, double tolerance) {
  return Finder(domain, places, tolerance).run();
}

std::vector<double> places_on(const Domain& domain, std::size_t c, dobra::geom::Point p) {
  std::vector<double> places;
  const sketch::Curve& curve = domain.curves[c];
  if (point(curve, 0.0) == p) places.push_back(0.0);
  if (point(curve, length(curve)) == p) places.push_back(length(curve));
  for (const Junction& junction : domain.junctions) {
    if (junction.curve == c && junction.at == p) places.push_back(junction.s);
  }
  return places;
}

std::vector<std::size_t> cracks_through(const Domain& domain, dobra::geom::Point p) {
  std::vector<std::size_t> cracks;
  std::size_t ways = 0;  // along cracks, away from the point, and one along the boundary
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const sketch::Curve& curve = domain.curves[c];
    if (curve.role == sketch::Role::Internal) continue;
    const auto places = places_on(domain, c, p);
    if (places.empty()) continue;
    if (curve.role != sketch::Role::Crack) {
      ways += 1;  // two curves of a corner, or the two ends of one: more than one is as good
      continue;
    }
    cracks.push_back(c);
    const bool inside =
        std::any_of(places.begin(), places.end(), [&](double s) { return s > 0.0 && s < length(curve); });
    ways += inside ? 2 : 1;
  }
  return ways > 1 ? cracks : std::vector<std::size_t>{};
}

}  // namespace quebra::domain
