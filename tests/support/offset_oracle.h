#pragma once
// Judges offset curves by brute force: plain distances and exact crossings, no code shared with the engine.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "shared/geom/intersect.h"
#include "shared/geom/polyline.h"
#include "shared/geom/predicates.h"
#include "shared/offset/offset.h"

namespace dobra::support {

/// Distance of two segments that do not cross; 0 if they do.
inline double segment_distance(const geom::Segment& a, const geom::Segment& b) {
  if (geom::intersect(a, b).kind != geom::IntersectionKind::None) return 0.0;
  return std::min({geom::distance(a, b.from), geom::distance(a, b.to), geom::distance(b, a.from), geom::distance(b, a.to)});
}

/// Least distance of any point of `curve` (vertices and edges) from `base`.
inline double least_distance(const geom::Polyline& curve, const geom::Polyline& base) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.segment_count(); ++i) {
    const geom::Segment s = curve.segment(i);
    const geom::Box box = s.box();
    for (std::size_t j = 0; j < base.segment_count(); ++j) {
      const geom::Segment t = base.segment(j);
      if (!box.grown(least).overlaps(t.box())) continue;
      least = std::min(least, segment_distance(s, t));
    }
  }
  return least;
}

/// A curve may touch itself where the input makes distances equal exactly (integer grids).
enum class Touching { Counted, Allowed };

/// Pairs of segments that meet other than neighbours do at their common point.
inline std::size_t crossings(const geom::Polyline& curve, Touching touching = Touching::Counted) {
  std::size_t found = 0;
  const std::size_t count = curve.segment_count();
  for (std::size_t i = 0; i < count; ++i) {
    const geom::Segment s = curve.segment(i);
    const geom::Box box = s.box();
    for (std::size_t j = i + 1; j < count; ++j) {
      const geom::Segment t = curve.segment(j);
      if (!box.overlaps(t.box())) continue;
      const geom::Intersection meet = geom::intersect(s, t);
      if (meet.kind == geom::IntersectionKind::None) continue;
      if (touching == Touching::Allowed && meet.kind == geom::IntersectionKind::Point && !meet.start.proper()) continue;
      const bool neighbours = j == i + 1 || (curve.closed && i == 0 && j + 1 == count);
      if (!neighbours || meet.kind == geom::IntersectionKind::Overlap) ++found;
    }
  }
  return found;
}

inline double distance_to_any(const std::vector<geom::Polyline>& curves, geom::Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& curve : curves) least = std::min(least, geom::distance(curve, p));
  return least;
}

/// Points at distance D on the right side of the base, off its segments, from which no part of the base is nearer: each of
/// them lies on the true offset curve.
inline std::vector<geom::Point> true_points(const geom::Polyline& base, double distance, int per_segment) {
  std::vector<geom::Point> points;
  for (std::size_t i = 0; i < base.segment_count(); ++i) {
    const geom::Segment s = base.segment(i);
    if (s.from == s.to) continue;
    const geom::Vector out = distance * geom::normalised(geom::right_of(s.vector()));
    for (int k = 0; k < per_segment; ++k) {
      const geom::Point p = geom::interpolate(s.from, s.to, (k + 0.5) / per_segment) + out;
      if (geom::distance(base, p) >= distance * (1.0 - 1e-10)) points.push_back(p);
    }
  }
  return points;
}

/// The whole answer by brute force, O(n^3), for open and closed bases: how long the treated curve is, all pieces together.
/// Each raw parallel, mitre edge, bevel at distance D and arc is cut at all crossings with all others and with the left side
/// and the caps; each part counts if nothing hides its middle.
struct FreeLength {
  double certain = 0;
  double doubtful = 0;  ///< Parts that coincide with others within 1e-11 D, and parts shorter than 1e-10 D.
};

class LengthOracle {
 public:
  /// @param base  without repeated points; ends lengthened if they are to be.  Joins that keep distance D: not Bevel.
  LengthOracle(const geom::Polyline& base, double distance, const offset::OffsetOptions& options)
      : d_(distance), options_(options), base_(base) {
    if (options.side == offset::Side::LeftOfTravel) {
      for (geom::Point& p : base_.points) p.y = -p.y;
    }
    simple_ = base_.closed && crossings(base_) == 0;
    anticlockwise_ = simple_ && geom::signed_area(base_) > 0;
    build();
  }

  [[nodiscard]] FreeLength length() const {
    FreeLength sum;
    for (std::size_t i = 0; i < raw_.size(); ++i) {
      if (raw_[i].wanted) add(i, sum);
    }
    return sum;
  }

 private:
  struct V {
    long double x = 0, y = 0;
    friend V operator+(V a, V b) { return {a.x + b.x, a.y + b.y}; }
    friend V operator-(V a, V b) { return {a.x - b.x, a.y - b.y}; }
    friend V operator*(long double f, V a) { return {f * a.x, f * a.y}; }
  };
  static long double dot(V a, V b) { return a.x * b.x + a.y * b.y; }
  static long double cross(V a, V b) { return a.x * b.y - a.y * b.x; }
  static long double size(V a) { return std::hypot(a.x, a.y); }
  static V right(V a) { return {a.y, -a.x}; }
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  struct Raw {
    bool wanted, arc;
    V a, b, centre;
    long double angle;  ///< Of an arc, anticlockwise.
    std::size_t segment, corner;  ///< That it is parallel to; corner of an arc, bevel.
  };
  struct Mitre {
    V at, first, last, middle;
    bool tangent;
    std::size_t corner;
  };

  V p(std::size_t i) const { return {base_.points[i].x, base_.points[i].y}; }
  std::size_t next(std::size_t i) const { return i + 1 == base_.points.size() ? 0 : i + 1; }
  V along(std::size_t i) const {
    const V u = p(next(i)) - p(i);
    return (1 / size(u)) * u;
  }
  void line(bool wanted, V a, V b, std::size_t segment, std::size_t corner = none) {
    raw_.push_back({wanted, false, a, b, {}, 0, segment, corner});
  }
  void arc(bool wanted, V centre, V normal, long double angle, std::size_t corner) {
    const V end = std::cos(angle) * normal + std::sin(angle) * V{-normal.y, normal.x};
    raw_.push_back({wanted, true, centre + d_ * normal, centre + d_ * end, centre, angle, none, corner});
  }
  void build() {
    const std::size_t n = base_.segment_count();
    std::vector<long double> before(n, 0);
    std::vector<long double> behind(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      if (!base_.closed && i + 1 == n) break;
      corner(i, next(i) % n, behind[i], before[next(i) % n]);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const V u = along(i);
      const V out = d_ * right(u);
      line(true, p(i) + out - before[i] * u, p(next(i)) + out + behind[i] * u, i);
      line(false, p(i) - out, p(next(i)) - out, i);
    }
    if (base_.closed) return;
    const long double pi = std::acos(-1.0L);
    arc(false, p(n), right(along(n - 1)), pi, n);
    arc(false, p(0), -1 * right(along(0)), pi, 0);
  }
  void corner(std::size_t i, std::size_t j, long double& behind, long double& before) {
    const V u = along(i);
    const V v = along(j);
    const auto turn = geom::orient2d(base_.points[i], base_.points[j], base_.points[next(j)]);
    const bool back = turn == geom::Sign::Zero && dot(u, v) < 0;
    if (turn == geom::Sign::Zero && !back) return;
    const long double angle = back ? std::acos(-1.0L) : std::atan2(std::abs(cross(u, v)), dot(u, v));
    const V middle = std::cos(angle / 2) * right(u) + std::sin(angle / 2) * u;
    if (turn == geom::Sign::Negative) return arc(false, p(j), -1 * right(v), angle, j);
    if (back) arc(false, p(j), right(u), angle, j);
    const bool short_mitre = 1 / std::cos(angle / 2) <= options_.mitre_limit * (1 + 1e-14L);
    const bool mitre = !back && (options_.join == offset::Join::Bisector || (options_.join == offset::Join::Mitre && short_mitre));
    const bool tangent = !mitre && (options_.join == offset::Join::Bisector ||
                                    (options_.join == offset::Join::Mitre && options_.beyond_limit == offset::BeyondLimit::TangentBevel));
    if (!mitre && !tangent) return arc(true, p(j), right(u), angle, j);
    mitres_.push_back({p(j), right(u), right(v), middle, tangent, j});
    before = behind = d_ * std::tan(mitre ? angle / 2 : angle / 4);
    if (tangent) {
      const V along_bevel{-middle.y, middle.x};
      line(true, p(j) + d_ * middle - behind * along_bevel, p(j) + d_ * middle + behind * along_bevel, none, j);
    }
  }
  static long double span(const Raw& r) { return r.arc ? r.angle : size(r.b - r.a); }
  V point(const Raw& r, long double t) const {
    if (!r.arc) return r.a + (t / size(r.b - r.a)) * (r.b - r.a);
    const V u = r.a - r.centre;
    return r.centre + std::cos(t) * u + std::sin(t) * V{-u.y, u.x};
  }
  static long double where(const Raw& r, V q) {
    if (!r.arc) return dot(q - r.a, r.b - r.a) / size(r.b - r.a);
    const V u = r.a - r.centre;
    const V w = q - r.centre;
    const long double angle = std::atan2(cross(u, w), dot(u, w));
    return angle < -1e-9L ? angle + 2 * std::acos(-1.0L) : angle;
  }
  /// Places of r where the whole line or circle of s meets it: a cut too many does no harm.
  void cut(const Raw& r, const Raw& s, std::vector<long double>& cuts) const {
    const auto keep = [&](V q) {
      const long double t = where(r, q);
      if (t > 0 && t < span(r)) cuts.push_back(t);
    };
    if (!r.arc && !s.arc) {
      const V u = r.b - r.a;
      const V v = s.b - s.a;
      const long double det = cross(u, v);
      if (det != 0) keep(r.a + (cross(s.a - r.a, v) / det) * u);
      keep(s.a);
      keep(s.b);
    } else if (r.arc && s.arc) {
      const V w = s.centre - r.centre;
      const long double half = d_ * d_ - dot(w, w) / 4;
      if (dot(w, w) == 0 || half < 0) return;
      const V aside = std::sqrt(half / dot(w, w)) * V{-w.y, w.x};
      keep(r.centre + 0.5L * w + aside);
      keep(r.centre + 0.5L * w - aside);
    } else {
      const Raw& l = r.arc ? s : r;
      const Raw& c = r.arc ? r : s;
      const V u = (1 / size(l.b - l.a)) * (l.b - l.a);
      const V foot = l.a + dot(c.centre - l.a, u) * u;
      const long double half = d_ * d_ - dot(foot - c.centre, foot - c.centre);
      if (half < 0) return keep(foot);
      keep(foot + std::sqrt(half) * u);
      keep(foot - std::sqrt(half) * u);
    }
  }
  enum class Sight { Free, Doubtful, Hidden };
  Sight look(const Raw& r, V q) const {
    const long double slack = 1e-11L * d_;
    Sight sight = Sight::Free;
    const long double s = r.segment == none ? 0 : std::clamp<long double>(dot(q - p(r.segment), along(r.segment)), 0, size(p(next(r.segment)) - p(r.segment)));
    const V foot = r.segment == none ? p(r.corner) : p(r.segment) + s * along(r.segment);
    for (std::size_t j = 0; j < base_.segment_count(); ++j) {
      const V u = p(next(j)) - p(j);
      const V near = p(j) + std::clamp<long double>(dot(q - p(j), u) / dot(u, u), 0, 1) * u;
      const long double gap = size(q - near) - d_;
      if (gap < -slack) return Sight::Hidden;
      if (j == r.segment || gap > slack) continue;
      const bool incident = r.segment == none && (j == r.corner || next(j) == r.corner);
      if (!incident && size(near - foot) > 1e-6L * d_) sight = Sight::Doubtful;
      if (incident || size(near - foot) > 1e-6L * d_) continue;
      // The same place: of two that coincide on one side the first counts.
      const bool same_way = r.segment != none && dot(u, along(r.segment)) > 0;
      if (same_way && j < r.segment && std::abs(cross(u, along(r.segment))) < 1e-9L * size(u)) return Sight::Hidden;
      const bool parallel = r.segment != none && std::abs(cross(u, along(r.segment))) <= 1e-9L * size(u);
      if (!parallel || (!same_way && std::abs(gap) > 1e-18L * d_)) sight = Sight::Doubtful;  // whose left faces q: the nearer wins
    }
    for (const Mitre& m : mitres_) {
      const V w = q - m.at;
      if (cross(m.first, w) < 0 || cross(w, m.last) < 0 || dot(w, m.middle) < 0) continue;
      long double out = std::max(dot(m.first, w), dot(m.last, w));
      if (m.tangent) out = std::max(out, dot(m.middle, w));
      if (out < d_ - slack) return Sight::Hidden;
      const bool own = m.corner == r.corner || (r.segment != none && (m.corner == r.segment || m.corner == next(r.segment)));
      if (out < d_ + slack && !own) sight = Sight::Doubtful;
    }
    return sight;
  }
  void add(std::size_t i, FreeLength& sum) const {
    const Raw& r = raw_[i];
    std::vector<long double> cuts{0, span(r)};
    for (std::size_t j = 0; j < raw_.size(); ++j) {
      if (j != i) cut(r, raw_[j], cuts);
    }
    for (const std::size_t at : {r.segment, r.segment == none ? none : next(r.segment)}) {  // natural ends
      if (at != none && !r.arc) cuts.push_back(std::clamp<long double>(where(r, p(at)), 0, span(r)));
    }
    std::sort(cuts.begin(), cuts.end());
    const long double unit = r.arc ? d_ : 1;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const long double part = unit * (cuts[k + 1] - cuts[k]);
      if (part == 0) continue;
      const Sight sight = look(r, point(r, 0.5L * (cuts[k] + cuts[k + 1])));
      if (sight == Sight::Hidden || pokes_through(point(r, 0.5L * (cuts[k] + cuts[k + 1])))) continue;
      (part < 1e-10L * d_ || sight == Sight::Doubtful ? sum.doubtful : sum.certain) += static_cast<double>(part);
    }
  }

  /// The tip of a mitre, through a thin part of a simple contour, is on the wrong side and does not count.
  bool pokes_through(V q) const {
    if (!simple_) return false;
    const geom::Side side = geom::locate(base_, {static_cast<double>(q.x), static_cast<double>(q.y)});
    return side == (anticlockwise_ ? geom::Side::Inside : geom::Side::Outside);
  }

  long double d_;
  offset::OffsetOptions options_;
  geom::Polyline base_;
  bool simple_ = false;
  bool anticlockwise_ = false;
  std::vector<Raw> raw_;
  std::vector<Mitre> mitres_;
};

/// Closed contours of the file formats in data/contours: "n m", points, edges (.txt) or points only (.dat).
inline std::vector<geom::Polyline> read_contours(const std::string& path) {
  std::ifstream in(path);
  std::vector<geom::Polyline> contours;
  if (path.ends_with(".dat")) {
    geom::Polyline contour{{}, true};
    geom::Point p;
    while (in >> p.x >> p.y) contour.points.push_back(p);
    contours.push_back(geom::without_repeated_points(contour));
    return contours;
  }
  std::size_t points = 0;
  std::size_t edges = 0;
  in >> points >> edges;
  std::vector<geom::Point> at(points);
  for (auto& p : at) in >> p.x >> p.y;
  geom::Polyline contour{{}, true};
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t k = 0; k < edges; ++k) {
    std::size_t a = 0;
    std::size_t b = 0;
    in >> a >> b;
    if (contour.points.empty()) first = a;
    if (!contour.points.empty() && a != last) {
      contour = {{}, true};
      first = a;
    }
    contour.points.push_back(at[a]);
    last = b;
    if (b == first) {
      contours.push_back(contour);
      contour.points.clear();
    }
  }
  return contours;
}

}  // namespace dobra::support
