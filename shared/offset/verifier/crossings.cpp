// Check b: edges meet at their common vertices only.

#include <algorithm>
#include <array>
#include <limits>

#include "shared/geom/intersect.h"
#include "shared/offset/verifier/exact.h"
#include "shared/offset/verifier/model.h"

namespace dobra::offset::verifier {

namespace {

/// An edge as it is drawn, measured along.
class Path {
 public:
  Path(const SeenEdge& edge, long double radius) : edge_(edge), radius_(radius) {
    direction_ = edge.arc ? edge.a - edge.centre : unit(edge.b - edge.a);
    whole_ = at(edge.b);
  }
  [[nodiscard]] bool is_arc() const { return edge_.arc; }
  [[nodiscard]] Wide start() const { return edge_.a; }
  [[nodiscard]] Wide direction() const { return direction_; }
  [[nodiscard]] Wide centre() const { return edge_.centre; }
  [[nodiscard]] long double whole() const { return whole_; }
  /// Of p, from the start: a length, or an angle.
  [[nodiscard]] long double at(Wide p) const {
    if (!edge_.arc) return dot(direction_, p - edge_.a);
    const Wide w = p - edge_.centre;
    const long double angle = std::atan2(cross(direction_, w), dot(direction_, w));
    return angle < -1 ? angle + 2 * 3.14159265358979323846L : angle;
  }
  [[nodiscard]] Wide point(long double t) const {
    if (!edge_.arc) return edge_.a + t * direction_;
    return edge_.centre + std::cos(t) * direction_ + std::sin(t) * Wide{-direction_.y, direction_.x};
  }
  [[nodiscard]] bool has(Wide p) const {
    if (edge_.arc) return in_sector(edge_.centre, edge_.a, edge_.b, p);
    const long double t = at(p);
    return t >= 0 && t <= whole_;
  }
  /// How far p is off the whole line or circle.
  [[nodiscard]] long double off(Wide p) const {
    return edge_.arc ? std::abs(size(p - edge_.centre) - radius_) : std::abs(cross(direction_, p - edge_.a));
  }

 private:
  const SeenEdge& edge_;
  long double radius_;
  Wide direction_;
  long double whole_ = 0;
};

/// Places where an arc meets a line or another arc of the same radius.
std::vector<Wide> meetings(const Path& e, const Path& f, long double radius) {
  std::vector<Wide> found;
  const auto keep = [&](Wide p) {
    if (e.has(p) && f.has(p)) found.push_back(p);
  };
  if (e.is_arc() && f.is_arc()) {
    const Wide between = f.centre() - e.centre();
    const long double squared = dot(between, between);
    const long double half = radius * radius - squared / 4;
    if (squared == 0 || half < 0) return found;
    const Wide aside = std::sqrt(half / squared) * Wide{-between.y, between.x};
    keep(e.centre() + 0.5L * between + aside);
    keep(e.centre() + 0.5L * between - aside);
    return found;
  }
  const Path& line = e.is_arc() ? f : e;
  const Path& arc = e.is_arc() ? e : f;
  const Wide foot = line.start() + dot(line.direction(), arc.centre() - line.start()) * line.direction();
  const long double squared = radius * radius - dot(foot - arc.centre(), foot - arc.centre());
  if (squared < 0) return found;
  keep(foot + std::sqrt(squared) * line.direction());
  keep(foot - std::sqrt(squared) * line.direction());
  return found;
}

/// How far `e` departs from `f` on both sides of each meeting, the least of them: what would have to move to undo it.
long double depth(const Path& e, const Path& f, const std::vector<Wide>& meeting, std::size_t which) {
  std::vector<long double> stops{0, e.whole()};
  for (const Wide p : meeting) stops.push_back(e.at(p));
  std::sort(stops.begin(), stops.end());
  const long double here = e.at(meeting[which]);
  const auto departs = [&](long double from, long double to) {
    return std::max({f.off(e.point(from)), f.off(e.point(0.5L * (from + to))), f.off(e.point(to))});
  };
  const auto after = std::upper_bound(stops.begin(), stops.end(), here);
  const auto at = std::lower_bound(stops.begin(), stops.end(), here);
  const long double before = at == stops.begin() ? here : *(at - 1);
  const long double next = after == stops.end() ? here : *after;
  return std::min(departs(before, here), departs(here, next));
}

class CrossingCheck {
 public:
  CrossingCheck(const Model& model, const OffsetCurve& curve, Verification& found)
      : model_(model), curve_(curve), found_(found) {}

  void operator()(const SeenEdge& e, const SeenEdge& f) {
    allowed_ = 4 * std::max(e.rounding, f.rounding);
    if (!e.arc && !f.arc) return lines(e, f);
    if (e.arc && f.arc && size(e.centre - f.centre) == 0) return one_circle(e, f);
    const Path p(e, model_.d);
    const Path q(f, model_.d);
    judge(p, q, meetings(p, q, model_.d), e);
  }

 private:
  [[nodiscard]] bool neighbours(const SeenEdge& e, const SeenEdge& f) const {
    if (e.piece != f.piece) return false;
    const std::size_t low = std::min(e.edge, f.edge);
    const std::size_t high = std::max(e.edge, f.edge);
    const OffsetPiece& piece = curve_.pieces[e.piece];
    return high == low + 1 || (piece.closed && low == 0 && high + 1 == piece.edges.size());
  }
  void judge(const Path& p, const Path& q, const std::vector<Wide>& meeting, const SeenEdge& e) {
    for (std::size_t k = 0; k < meeting.size(); ++k) {
      const long double deep = std::min(depth(p, q, meeting, k), depth(q, p, meeting, k));
      if (deep > allowed_) report(FindingKind::Crossing, e, meeting[k], deep);
    }
  }
  void lines(const SeenEdge& e, const SeenEdge& f) {
    // To the paper's subdivision two that differ by rounding are two.
    if (!model_.paper && !neighbours(e, f) && along_each_other(e, f)) return;
    const geom::Intersection meet = geom::intersect({narrow(e.a), narrow(e.b)}, {narrow(f.a), narrow(f.b)});
    if (meet.kind == geom::IntersectionKind::None) return;
    if (meet.kind == geom::IntersectionKind::Overlap)
      return overlap(e, f, wide(meet.start.point), wide(meet.end.point));
    if (neighbours(e, f) || !meet.start.proper()) return;
    judge(Path(e, model_.d), Path(f, model_.d), {wide(meet.start.point)}, e);
  }
  /// The same boundary twice: two lines the same way that differ by no more than rounding.
  bool along_each_other(const SeenEdge& e, const SeenEdge& f) {
    const Path p(e, model_.d);
    const Wide step = f.b - f.a;
    if (dot(p.direction(), step) < 0.999999L * size(step)) return false;
    const long double from = std::max(0.0L, p.at(f.a));
    const long double to = std::min(p.whole(), p.at(f.b));
    if (to - from < 1000 * allowed_ || allowed_ > 1e-6L * model_.d) return false;  // so far out that rounding hides it
    const Path q(f, model_.d);
    if (std::max(q.off(p.point(from)), q.off(p.point(to))) > allowed_) return false;
    report(FindingKind::Touching, e, p.point(from), to - from);
    return true;
  }
  /// Opposite ways with room between them, two lines may fall together when they are rounded.
  void overlap(const SeenEdge& e, const SeenEdge& f, Wide from, Wide to) {
    const long double long_by = size(to - from);
    if (long_by <= allowed_) return;
    if (dot(e.b - e.a, f.b - f.a) < 0 && (room_between(e, f) || room_beyond(e, f, from) || room_beyond(e, f, to)))
      return;
    report(FindingKind::Touching, e, from, long_by);
  }
  /// Between their two base segments, at one end of the slit at least: where it narrows by less than a rounding, the
  /// end of the free part cannot be told from the rounded edges. True if it cannot be told at all.
  [[nodiscard]] bool room_between(const SeenEdge& e, const SeenEdge& f) const {
    if (e.segment == Model::none || f.segment == Model::none) return false;
    return room_beside(e.segment, f.segment) || room_beside(f.segment, e.segment);
  }
  /// True if an end of j is more than 2 D from segment i, and none less by more than a rounding.
  [[nodiscard]] bool room_beside(std::size_t i, std::size_t j) const {
    const auto place = [&](std::size_t k) { return model_.places[k]; };
    bool some = false;
    for (const std::size_t end : {j, model_.end_index(j)}) {
      const Wide p = wide(place(end));
      const Wide q = model_.nearest(i, p);
      const long double more = size(q - p) - 2 * model_.d;
      if (more < -1e-15L * model_.d - 4 * allowed_) return false;
      if (some) continue;
      const double d = static_cast<double>(model_.d);
      const bool at_end = size(q - model_.from(i)) == 0 || size(q - model_.to(i)) == 0;
      some = more > 1e-15L * model_.d ||
             (at_end ? between_points(narrow(q), place(end), d)
                     : beside_line(place(i), place(model_.end_index(i)), place(end), d)) != Room::None;
    }
    return some;
  }
  /// At a place where both lines go on to the tips of mitres, beyond the ends of their segments: slits that are closed
  /// by less than a rounding may open there. True if it cannot be told.
  [[nodiscard]] bool room_beyond(const SeenEdge& e, const SeenEdge& f, Wide place) const {
    if (e.segment == Model::none || f.segment == Model::none) return false;
    const Wide from = model_.from(e.segment);
    const Wide along = unit(model_.to(e.segment) - from);
    const Wide first = model_.from(f.segment) - from;
    const Wide second = model_.to(f.segment) - from;
    const long double near = dot(along, first);
    const long double far = dot(along, second);
    const long double at = dot(along, place - from);
    const auto [low, high] = std::minmax({0.0L, dot(along, model_.to(e.segment) - from), near, far});
    if (near == far || (at >= low && at <= high)) return false;
    const long double least = std::min(std::abs(cross(along, first)), std::abs(cross(along, second))) - 2 * model_.d;
    if (least < -1e-15L * model_.d - 4 * allowed_) return false;
    const long double part = (at - near) / (far - near);
    const long double room = std::abs(cross(along, (1 - part) * first + part * second)) - 2 * model_.d;
    return room >
           -16 * std::numeric_limits<long double>::epsilon() * (1 + std::abs(part)) * (size(first) + size(second));
  }
  void one_circle(const SeenEdge& e, const SeenEdge& f) {
    const Path p(e, model_.d);
    long double from = p.at(f.a);
    long double to = p.at(f.b);
    if (to < from) std::swap(from, to);
    const long double both = std::min(to, p.whole()) - std::max(from, 0.0L);
    if (both * model_.d > allowed_) report(FindingKind::Touching, e, p.point(std::max(from, 0.0L)), both * model_.d);
  }
  void report(FindingKind kind, const SeenEdge& e, Wide place, long double measured) {
    if (kind == FindingKind::Touching && model_.coarse()) return;
    found_.findings.push_back(
        {kind, model_.user(place), static_cast<double>(measured), static_cast<double>(allowed_), e.piece, e.edge});
  }

  const Model& model_;
  const OffsetCurve& curve_;
  Verification& found_;
  long double allowed_ = 0;  // for the pair at hand
};

}  // namespace

void check_crossings(const Model& model, const OffsetCurve& curve, const std::vector<SeenEdge>& edges,
                     Verification& found, const base::Progress& progress) {
  std::vector<geom::Box> boxes;
  boxes.reserve(edges.size());
  for (const SeenEdge& edge : edges) {
    // An arc that fits no corner has no centre to be drawn about.
    boxes.push_back(edge.segment == Model::none && edge.arc ? geom::Box{} : box_of(edge));
  }
  const BoxTree tree(boxes);
  CrossingCheck check(model, curve, found);
  for (std::size_t i = 0; i < edges.size() && !progress.cancelled(); ++i) {
    if (boxes[i].empty()) continue;
    tree.each([&](const geom::Box& box) { return box.overlaps(boxes[i]); },
              [&](std::size_t j) {
                if (j > i) check(edges[i], edges[j]);
                return false;
              });
  }
}

}  // namespace dobra::offset::verifier
