// 1. For each end, the nearest place on each line that it may be moved onto; the nearest one counts that folds nothing
// and crosses nothing. 2. Moves that spoil each other are left out, both of them. 3. All that are left are done at
// once, on the lines as they were: so no move depends on another one.

#include "shared/io/formats/snap_ends.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"

namespace dobra::io::formats {
namespace {

using geom::Point;
using geom::Polyline;
using geom::Segment;

constexpr double same_place = 1e-6;  // of the tolerance

struct PartId {
  std::size_t feature = 0;
  std::size_t part = 0;
  auto operator<=>(const PartId&) const = default;
};

struct Side {
  PartId part;
  std::size_t number = 0;
};

/// A place on a line.
struct Foot {
  Side side;
  Point at;
  double distance = 0.0;
};

struct Move {
  PartId part;
  bool front = false;
  std::size_t dropped = 0;  ///< Vertices that follow the end and go.
  Point from;
  Point at;
  Point before;  ///< The vertex that the end follows then.
  Side onto;
  [[nodiscard]] Segment last() const { return {before, at}; }
};

/// The points of a line from one of its ends on.
class Tail {
 public:
  Tail(const Polyline& line, bool front) : points_(line.points), front_(front) {}
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] Point operator[](std::size_t i) const { return points_[index(i)]; }
  [[nodiscard]] std::size_t index(std::size_t i) const { return front_ ? i : points_.size() - 1 - i; }
  /// The side between points i and i + 1, towards the end.
  [[nodiscard]] Segment side(std::size_t i) const { return {(*this)[i + 1], (*this)[i]}; }
  /// Where that side stands, counted from the end.
  [[nodiscard]] std::size_t from_end(std::size_t side) const { return front_ ? side : points_.size() - 2 - side; }

 private:
  const std::vector<Point>& points_;
  bool front_;
};

class Snapping {
 public:
  Snapping(const std::vector<lines::Feature>& features, const RepairOptions& options)
      : features_(features), options_(options), reach_(*options.snap) {
    std::vector<geom::Box> boxes;
    for (std::size_t f = 0; f < features.size(); ++f) {
      if (features[f].type != lines::FeatureType::Lines) continue;
      for (std::size_t k = 0; k < features[f].parts.size(); ++k) {
        const Polyline& line = features[f].parts[k];
        for (std::size_t s = 0; s < line.segment_count(); ++s) {
          boxes.push_back(line.segment(s).box());
          sides_.push_back({{f, k}, s});
        }
      }
    }
    index_ = geom::SpatialIndex(boxes);
  }

  std::vector<Move> moves() const {
    std::vector<Move> found;
    for (std::size_t f = 0; f < features_.size(); ++f) {
      if (features_[f].type != lines::FeatureType::Lines) continue;
      for (std::size_t k = 0; k < features_[f].parts.size(); ++k) {
        for (const bool front : {true, false}) {
          if (const auto move = move_of({f, k}, front)) found.push_back(*move);
        }
      }
    }
    leave_out_what_spoils(found);
    return found;
  }

  /// Other ends that lie on the side that the move takes along, from its place on.
  std::vector<Point> passengers(const Move& move) const {
    std::vector<Point> points;
    if (move.dropped > 0) return points;
    const Segment old{move.before, move.from};
    const double near = std::max(options_.on_line, 1e-9 * reach_);
    for (std::size_t f = 0; f < features_.size(); ++f) {
      if (f == move.part.feature || features_[f].type != lines::FeatureType::Lines || features_[f].kind == "fault")
        continue;
      for (const Polyline& line : features_[f].parts) {
        if (line.closed || line.points.empty()) continue;
        for (const Point p : {line.points.front(), line.points.back()}) {
          const double past = std::min(geom::distance(p, old.from), geom::distance(p, old.to));
          if (past > std::max(near, reach_) && geom::distance(old, p) <= near) points.push_back(p);
        }
      }
    }
    geom::sort_along({move.from, move.before}, points);
    return points;
  }

 private:
  [[nodiscard]] const Polyline& line(PartId id) const { return features_[id.feature].parts[id.part]; }
  [[nodiscard]] Segment segment(const Side& side) const { return line(side.part).segment(side.number); }

  [[nodiscard]] bool may(std::size_t own, std::size_t onto) const {
    const lines::Feature &a = features_[own], &b = features_[onto];
    if (own == onto) return false;
    return options_.may_snap ? options_.may_snap(a, b) : a.kind != "fault" && b.kind == "fault";
  }
  /// Lines that nothing may cross that did not do so; pins and the like may be crossed.
  [[nodiscard]] bool bounds(std::size_t feature) const {
    const std::string& kind = features_[feature].kind;
    return kind.empty() || kind == "horizon" || kind == "fault";
  }

  /// Calls visitor(side) for every side near.
  template <class Visitor>
  void near(const geom::Box& box, Visitor&& visitor) const {
    index_.for_each_overlapping(box, [&](std::size_t i) { visitor(sides_[i]); });
  }
  [[nodiscard]] double from_line(PartId part, Point p) const {
    double nearest = INFINITY;
    near(geom::Box{p, p}.grown(reach_), [&](const Side& side) {
      if (side.part == part) nearest = std::min(nearest, geom::distance(segment(side), p));
    });
    return nearest;
  }

  [[nodiscard]] std::optional<Move> move_of(PartId own, bool front) const {
    const Polyline& line = this->line(own);
    if (line.closed || line.points.size() < 2) return std::nullopt;
    const Tail tail(line, front);
    const Point end = tail[0];
    std::map<PartId, Foot> nearest;
    near(geom::Box{end, end}.grown(reach_), [&](const Side& side) {
      if (!may(own.feature, side.part.feature)) return;
      const Segment s = segment(side);
      Foot foot{side, geom::interpolate(s.from, s.to, geom::nearest_fraction(s, end)), 0.0};
      for (const Point vertex : {s.from, s.to}) {
        if (geom::distance(vertex, foot.at) <= same_place * reach_) foot.at = vertex;
      }
      foot.distance = geom::distance(foot.at, end);
      if (foot.distance >= reach_ || are_two_ends(own.feature, foot)) return;
      const auto [known, is_new] = nearest.try_emplace(side.part, foot);
      if (!is_new && before(foot, known->second)) known->second = foot;
    });
    std::vector<Foot> feet;
    for (const auto& [part, foot] : nearest) feet.push_back(foot);
    std::stable_sort(feet.begin(), feet.end(), before);
    if (feet.empty() || feet.front().distance <= options_.on_line) return std::nullopt;
    if (options_.first_crossing) sort_by_crossing(tail, feet);
    for (const Foot& foot : feet) {
      auto move = cut_back(tail, foot);
      if (!move) move = moved_to(own, tail, foot);
      if (!move) continue;
      move->part = own;
      move->front = front;
      return move;
    }
    return std::nullopt;
  }
  /// Ends that lie side by side are no place where one line ends on the other; but a horizon may end at a fault's tip.
  [[nodiscard]] bool are_two_ends(std::size_t own, const Foot& foot) const {
    const Polyline& other = line(foot.side.part);
    if (other.closed || (features_[own].kind != "fault" && features_[foot.side.part.feature].kind == "fault"))
      return false;
    return geom::distance(foot.at, other.points.front()) < reach_ ||
           geom::distance(foot.at, other.points.back()) < reach_;
  }
  static bool before(const Foot& a, const Foot& b) {
    return std::tuple(a.distance, a.at.x, a.at.y) < std::tuple(b.distance, b.at.x, b.at.y);
  }

  /// Lines that are crossed before the end come first, the one that is crossed first before all.
  void sort_by_crossing(const Tail& tail, std::vector<Foot>& feet) const {
    std::map<PartId, double> ways;
    for (const Foot& foot : feet) ways[foot.side.part] = way_to_crossing(tail, foot.side.part);
    std::stable_sort(feet.begin(), feet.end(),
                     [&](const Foot& a, const Foot& b) { return ways[a.side.part] > ways[b.side.part]; });
  }
  /// How far before the end the tail crosses the line from which it is within reach all the way on; -1: nowhere.
  [[nodiscard]] double way_to_crossing(const Tail& tail, PartId onto) const {
    double farthest = -1.0, way = 0.0;
    for (std::size_t i = 0; i + 1 < tail.size() && from_line(onto, tail[i]) < reach_; ++i) {
      const Segment own = tail.side(i);
      near(own.box(), [&](const Side& side) {
        if (side.part != onto) return;
        const geom::Intersection met = geom::intersect(own, segment(side));
        if (met.kind == geom::IntersectionKind::None) return;
        const Point at = met.start.point;
        const bool is_begin = i + 2 == tail.size() && at == own.from;  // where the line begins on the other one
        if (is_begin || !(from_line(onto, geom::midpoint(at, own.to)) < reach_)) return;
        farthest = std::max(farthest, way + geom::distance(at, own.to));
      });
      way += own.length();
    }
    return farthest;
  }

  /// What overshoots the line is cut off at the first crossing, so that the end is moved back, not folded over.
  [[nodiscard]] std::optional<Move> cut_back(const Tail& tail, const Foot& foot) const {
    std::optional<Move> found;
    double farthest = -1.0, way = 0.0;
    for (std::size_t i = 0; i + 1 < tail.size() && way < reach_; ++i) {
      const Segment own = tail.side(i);
      near(own.box(), [&](const Side& side) {
        if (side.part != foot.side.part) return;
        const geom::Intersection met = geom::intersect(own, segment(side));
        if (met.kind == geom::IntersectionKind::None) return;
        const Point at = met.start.point;  // of an overlap the place that comes first along the line
        const double back = way + geom::distance(at, own.to);
        if (back <= farthest || back >= reach_) return;
        const std::size_t dropped = at == own.from ? i + 1 : i;
        if (dropped + 1 >= tail.size()) return;
        farthest = back;
        found = Move{{}, false, dropped, tail[0], at, tail[dropped + 1], side};
      });
      way += own.length();
    }
    return found;
  }

  /// The end on the nearest place of the line.
  [[nodiscard]] std::optional<Move> moved_to(PartId own, const Tail& tail, const Foot& foot) const {
    std::size_t dropped = beyond(tail, foot);
    for (;; ++dropped) {
      if (dropped + 1 >= tail.size()) return std::nullopt;
      const Point last = tail[dropped + 1];
      const bool is_same = geom::distance(last, foot.at) <= same_place * reach_;
      if (dropped + 2 >= tail.size()) {
        if (is_same || geom::dot(tail[0] - last, foot.at - last) <= 0.0) return std::nullopt;  // it would vanish
        break;
      }
      const geom::Vector way = last - tail[dropped + 2];
      const bool folds = geom::dot(way, foot.at - last) < 0.0 && geom::dot(way, tail[dropped] - last) >= 0.0;
      if (!is_same && !folds) break;
      if (geom::distance(last, foot.at) >= reach_) return std::nullopt;
    }
    const Move move{{}, false, dropped, tail[0], foot.at, tail[dropped + 1], foot.side};
    if (crosses(own, tail, move)) return std::nullopt;
    return move;
  }

  /// Vertices beyond a line that is crossed at so small an angle that the crossing is not near.
  [[nodiscard]] std::size_t beyond(const Tail& tail, const Foot& foot) const {
    constexpr std::size_t most = 64;
    for (std::size_t i = 0; i + 1 < tail.size() && i < most; ++i) {
      bool meets = false;
      near(tail.side(i).box(), [&](const Side& side) {
        if (side.part == foot.side.part)
          meets |= geom::intersect(tail.side(i), segment(side)).kind != geom::IntersectionKind::None;
      });
      if (meets) return i;
      if (!(from_line(foot.side.part, tail[i + 1]) < reach_)) break;
    }
    return 0;
  }

  /// Whether the new last side meets something that the old ones did not, but at its end.
  [[nodiscard]] bool crosses(PartId own, const Tail& tail, const Move& move) const {
    const Segment made = move.last();
    std::set<PartId> met_now;
    bool itself = false;
    near(made.box(), [&](const Side& side) {
      const bool is_own = side.part == own;
      if (is_own ? tail.from_end(side.number) <= move.dropped : !bounds(side.part.feature)) return;
      const geom::Intersection met = geom::intersect(made, segment(side));
      if (met.kind == geom::IntersectionKind::None) return;
      const bool at_ends = met.kind == geom::IntersectionKind::Point &&
                           (met.start.point == made.from ||
                            (!is_own && geom::distance(met.start.point, made.to) <= same_place * reach_));
      if (at_ends) return;
      if (is_own)
        itself = true;
      else
        met_now.insert(side.part);
    });
    if (itself || met_now.contains(move.onto.part)) return true;
    for (std::size_t i = 0; i <= move.dropped && !met_now.empty(); ++i) {
      near(tail.side(i).box(), [&](const Side& side) {
        if (met_now.contains(side.part) &&
            geom::intersect(tail.side(i), segment(side)).kind != geom::IntersectionKind::None)
          met_now.erase(side.part);
      });
    }
    return !met_now.empty();
  }

  void leave_out_what_spoils(std::vector<Move>& moves) const {
    std::vector<bool> out(moves.size(), false);
    std::map<PartId, std::vector<std::size_t>> of;
    for (std::size_t i = 0; i < moves.size(); ++i) of[moves[i].part].push_back(i);
    for (const auto& [part, both] : of) {
      if (both.size() == 2 && spoil_line(line(part), moves[both[0]], moves[both[1]]))
        out[both[0]] = out[both[1]] = true;
    }
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const auto on = of.find(moves[i].onto.part);
      if (on == of.end()) continue;
      for (const std::size_t k : on->second) {  // a side that is moved itself
        const Tail tail(line(on->first), moves[k].front);
        if (tail.from_end(moves[i].onto.number) <= moves[k].dropped) out[i] = true;
      }
    }
    std::vector<geom::Box> boxes;
    for (const Move& move : moves) boxes.push_back(move.last().box());
    for (const auto& [a, b] : geom::SpatialIndex(boxes).overlapping_pairs()) {
      if (moves[a].part == moves[b].part) continue;
      if (cross(moves[a].last(), moves[b].last()) &&
          !cross({moves[a].before, moves[a].from}, {moves[b].before, moves[b].from}))
        out[a] = out[b] = true;
    }
    std::vector<Move> kept;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (!out[i]) kept.push_back(moves[i]);
    }
    moves = std::move(kept);
  }
  [[nodiscard]] bool cross(const Segment& a, const Segment& b) const {
    const geom::Intersection met = geom::intersect(a, b);
    if (met.kind == geom::IntersectionKind::None) return false;
    return met.kind == geom::IntersectionKind::Overlap
               ? a.to != b.to
               : geom::distance(met.start.point, a.to) > same_place * reach_ ||
                     geom::distance(met.start.point, b.to) > same_place * reach_;
  }
  /// Moves of both ends of one short line.
  static bool spoil_line(const Polyline& line, const Move& front, const Move& back) {
    const std::size_t inner = line.points.size() - 2;
    if (front.dropped + back.dropped > inner) return true;
    return front.dropped + back.dropped == inner && geom::dot(back.at - front.at, back.from - front.from) <= 0.0;
  }

  const std::vector<lines::Feature>& features_;
  const RepairOptions& options_;
  double reach_;
  std::vector<Side> sides_;
  geom::SpatialIndex index_;
};

/// The line with its ends moved, and with a vertex for each line that ends on it.
Polyline with_moves(const Polyline& line, const Move* front, const Move* back,
                    std::map<std::size_t, std::vector<Point>>& vertices) {
  const std::size_t count = line.points.size();
  const std::size_t first = front != nullptr ? front->dropped : 0;
  const std::size_t last = count - 1 - (back != nullptr ? back->dropped : 0);
  Polyline made{{}, line.closed};
  for (std::size_t i = first; i <= last; ++i) {
    const bool moved_front = front != nullptr && i == first, moved_back = back != nullptr && i == last;
    made.points.push_back(moved_front ? front->at : moved_back ? back->at : line.points[i]);
    const auto found = vertices.find(i);
    if (found == vertices.end() || i >= line.segment_count()) continue;
    std::vector<Point>& along = found->second;
    geom::sort_along(line.segment(i), along);
    for (const Point p : along) {
      if (i != last || line.closed) made.points.push_back(p);
    }
  }
  return geom::without_repeated_points(std::move(made));
}

}  // namespace

std::vector<SnappedEnd> snap_ends(std::vector<lines::Feature>& features, const RepairOptions& options) {
  const Snapping snapping(features, options);
  const std::vector<Move> moves = snapping.moves();
  std::map<PartId, std::pair<const Move*, const Move*>> ends;
  std::map<PartId, std::map<std::size_t, std::vector<Point>>> vertices;
  std::vector<SnappedEnd> snapped;
  for (const Move& move : moves) {
    auto& [front, back] = ends[move.part];
    (move.front ? front : back) = &move;
    const Polyline& own = features[move.part.feature].parts[move.part.part];
    for (const Point p : snapping.passengers(move))
      vertices[move.part][move.front ? 0 : own.points.size() - 2].push_back(p);
    const Segment side = features[move.onto.part.feature].parts[move.onto.part.part].segment(move.onto.number);
    if (move.at != side.from && move.at != side.to) vertices[move.onto.part][move.onto.number].push_back(move.at);
    snapped.push_back({move.part.feature, move.onto.part.feature, move.at, geom::distance(move.from, move.at)});
  }
  std::set<PartId> changed;
  for (const auto& [part, moved] : ends) changed.insert(part);
  for (const auto& [part, taken] : vertices) changed.insert(part);
  for (const PartId part : changed) {
    const auto moved = ends.find(part);
    const auto [front, back] = moved == ends.end() ? std::pair<const Move*, const Move*>{} : moved->second;
    Polyline& line = features[part.feature].parts[part.part];
    line = with_moves(line, front, back, vertices[part]);
  }
  return snapped;
}

}  // namespace dobra::io::formats
