#include "quebra/core/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "quebra/core/areas.h"
#include "quebra/core/ends.h"
#include "quebra/core/faces.h"
#include "quebra/core/roles.h"
#include "quebra/core/snap.h"
#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"
#include "shared/topo/insert.h"

// 1 points of each curve. 2 spikes; polygons that share sides are parted, what nearly touches is made to. 3 curves drawn twice. 4 gaps; then roles, where the
// file tells none. 5 crossings: groups of closed boundaries that meet are put
// into a subdivision; faces inside and outside are told apart; the edges between the two are walked as new loops.

namespace quebra::core {
namespace {

using dobra::base::Result;
using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Vector;
using dobra::topo::FaceId;
using dobra::topo::HalfEdgeId;
using dobra::topo::Subdivision;

bool bounds(const Curve& curve) { return curve.role == Role::Boundary || curve.role == Role::Hole; }

class Repairer {
 public:
  Repairer(Sketch sketch, const RepairOptions& options) : repaired_{std::move(sketch), {}}, options_(options) {
    Box box;
    for (const Curve& curve : curves()) box.add(trace(curve).line.box());
    size_ = curves().empty() ? 0.0 : box.diagonal();
  }

  Result<Repaired> run() {
    for (std::size_t i = 0; i < curves().size();) {
      const bool stays = clean(i);
      if (stays) {
        ++i;
      } else {
        drop(i);
      }
    }
    part_shared_sides(repaired_.sketch, options_.same_point * size_);
    merge_near();
    drop_doubles();
    close_gaps();
    find_roles(repaired_.sketch, DomainOptions{}.join_tolerance * size_);
    DOBRA_TRY_VOID(rebuild_crossings());
    return std::move(repaired_);
  }

 private:
  std::vector<Curve>& curves() { return repaired_.sketch.curves; }
  Polyline* line(std::size_t i) { return std::get_if<Polyline>(&curves()[i].shape); }
  void found(Wrong wrong, Point at, std::string curve, std::string mend) { repaired_.findings.push_back({wrong, at, std::move(curve), std::move(mend)}); }
  void drop(std::size_t i) {
    curves().erase(curves().begin() + static_cast<std::ptrdiff_t>(i));
    auto& places = repaired_.sketch.places;
    if (i < places.size()) places.erase(places.begin() + static_cast<std::ptrdiff_t>(i));
  }

  // --- 1, 2 ---------------------------------------------------------------------------------------------------------
  /// False if nothing is left of the curve.
  bool clean(std::size_t i) {
    Polyline* const own = line(i);
    if (own == nullptr) return true;
    const std::string name = curves()[i].name;
    const double least = options_.same_point * size_;
    std::vector<Point> kept;
    for (const Point p : own->points) {
      if (kept.empty() || distance(kept.back(), p) > least) {
        kept.push_back(p);
      } else {
        found(kept.back() == p ? Wrong::RepeatedPoint : Wrong::NearlyRepeatedPoint, p, name, "one of the two points is left out");
      }
    }
    while (own->closed && kept.size() > 1 && distance(kept.front(), kept.back()) <= least) {
      found(kept.front() == kept.back() ? Wrong::RepeatedPoint : Wrong::NearlyRepeatedPoint, kept.back(), name, "one of the two points is left out");
      kept.pop_back();
    }
    remove_spikes(kept, own->closed, name);
    own->points = std::move(kept);
    if (own->points.size() >= (own->closed ? 3U : 2U) && !(own->closed && thin(own->points, least))) return true;
    found(Wrong::NoExtent, own->points.empty() ? Point{} : own->points.front(), name, "the curve is left out");
    return false;
  }

  /// Whether all points lie within `width` of the line from the first to the one farthest from it.
  static bool thin(const std::vector<Point>& points, double width) {
    const Point first = points.front();
    const Point far = *std::max_element(points.begin(), points.end(), [&](Point a, Point b) { return distance(first, a) < distance(first, b); });
    return std::all_of(points.begin(), points.end(), [&](Point p) { return distance(dobra::geom::Segment{first, far}, p) <= width; });
  }

  void remove_spikes(std::vector<Point>& points, bool closed, const std::string& name) {
    const double flat = std::cos(options_.spike * std::numbers::pi / 180.0);
    for (std::size_t i = 0; points.size() > 2 && i < points.size();) {
      const std::size_t n = points.size();
      const bool end = !closed && (i == 0 || i + 1 == n);
      const Vector back = points[(i + n - 1) % n] - points[i];
      const Vector ahead = points[(i + 1) % n] - points[i];
      const double lengths = length(back) * length(ahead);
      if (end || (lengths > 0.0 && dot(back, ahead) < flat * lengths)) {
        ++i;
        continue;
      }
      found(lengths > 0.0 ? Wrong::Spike : Wrong::RepeatedPoint, points[i], name, "its point is left out");
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
      i = i > 0 ? i - 1 : 0;
    }
  }

  /// Boundaries that run so close to each other that nothing fits between become one line there.
  void merge_near() {
    std::vector<Polyline*> lines;
    std::vector<std::size_t> owner;
    for (std::size_t i = 0; i < curves().size(); ++i) {
      if (!bounds(curves()[i]) || line(i) == nullptr || !line(i)->closed) continue;
      lines.push_back(line(i));
      owner.push_back(i);
    }
    for (const Snap& snap : snap_together(lines, options_.same_point * size_)) {
      if (snap.gap == 0.0) continue;
      found(Wrong::Sliver, snap.at, curves()[owner[snap.line]].name + ", " + curves()[owner[snap.other]].name,
            fmt::format("the two curves, {:.3g} m apart there, pass one point", snap.gap));
    }
  }

  // --- 3 ------------------------------------------------------------------------------------------------------------
  void drop_doubles() {
    std::map<std::vector<Point>, std::string> known;
    for (std::size_t i = 0; i < curves().size();) {
      const Polyline* const own = line(i);
      std::vector<Point> key;
      if (own != nullptr) key = own->points;
      std::sort(key.begin(), key.end());
      const auto [first, is_new] = known.try_emplace(key, curves()[i].name);
      if (own == nullptr || is_new) {
        ++i;
        continue;
      }
      found(Wrong::CurveTwice, own->points.front(), first->second + ", " + curves()[i].name, "the second is left out");
      drop(i);
    }
  }

  // --- 4 ------------------------------------------------------------------------------------------------------------
  void close_gaps() {
    std::vector<End> ends = open_ends(curves());
    std::erase_if(ends, [&](const End& end) { return !bounds(curves()[end.curve]); });
    std::map<Point, int> meeting;
    for (const End& end : ends) ++meeting[end.at];
    std::erase_if(ends, [&](const End& end) { return meeting[end.at] > 1; });
    std::vector<std::uint8_t> used(ends.size(), 0);
    for (const auto& [gap, a, b] : near_ends(ends, options_.gap * size_)) {
      if (used[a] != 0 || used[b] != 0) continue;
      used[a] = used[b] = 1;
      // What make_domain joins anyway is no gap.
      if (gap > DomainOptions{}.join_tolerance * size_) join(ends[a], ends[b], gap);
    }
  }

  void join(const End& a, const End& b, double gap) {
    const std::string names = curves()[a.curve].name + ", " + curves()[b.curve].name;
    Polyline* const own = line(b.curve);
    if (a.curve == b.curve && own != nullptr && own->points.size() > 3) {
      own->points.pop_back();
      own->closed = true;
      found(Wrong::Gap, a.at, names, fmt::format("the ends, {:.3g} m apart, are joined", gap));
      return;
    }
    // A straight curve is moved rather than one that bends.
    const bool b_first = own != nullptr || line(a.curve) == nullptr;
    const End& first = b_first ? b : a;
    const End& second = b_first ? a : b;
    const bool moved = move_end(curves()[first.curve], first.last, second.at) || move_end(curves()[second.curve], second.last, first.at);
    found(Wrong::Gap, second.at, names,
          moved ? fmt::format("the ends, {:.3g} m apart, are joined", gap)
                : fmt::format("left as it is: arcs cannot be moved so far; close the gap of {:.3g} m by hand", gap));
  }

  // --- 5 ------------------------------------------------------------------------------------------------------------
  struct Chord {
    dobra::geom::Segment segment;
    std::size_t curve, number, count;
  };

  /// Groups of boundaries that meet away from common ends, with one place each.
  std::map<std::size_t, std::pair<std::set<std::size_t>, Point>> crossing_groups() {
    std::vector<Chord> chords;
    std::vector<Box> boxes;
    for (std::size_t c = 0; c < curves().size(); ++c) {
      if (!bounds(curves()[c])) continue;
      const Polyline along = trace(curves()[c]).line;
      for (std::size_t i = 0; i < along.segment_count(); ++i) {
        chords.push_back({along.segment(i), c, i, along.segment_count()});
        boxes.push_back(along.segment(i).box());
      }
    }
    std::vector<std::size_t> parent(curves().size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t c) {
      while (parent[c] != c) c = parent[c] = parent[parent[c]];
      return c;
    };
    std::vector<std::pair<std::size_t, Point>> meetings;
    for (const auto& [i, j] : dobra::geom::SpatialIndex(boxes).overlapping_pairs()) {
      const Chord& a = chords[i];
      const Chord& b = chords[j];
      const auto meeting = intersect(a.segment, b.segment);
      if (meeting.kind == dobra::geom::IntersectionKind::None) continue;
      using dobra::geom::At;
      const bool at_ends = meeting.kind == dobra::geom::IntersectionKind::Point && meeting.start.on_first != At::Interior && meeting.start.on_second != At::Interior;
      if (at_ends) continue;
      parent[std::max(root(a.curve), root(b.curve))] = std::min(root(a.curve), root(b.curve));
      meetings.emplace_back(a.curve, meeting.start.point);
    }
    std::map<std::size_t, std::pair<std::set<std::size_t>, Point>> groups;
    for (const auto& [curve, at] : meetings) groups.try_emplace(root(curve), std::set<std::size_t>{}, at);
    for (std::size_t c = 0; c < curves().size(); ++c) {
      const auto group = groups.find(root(c));
      if (group != groups.end()) group->second.first.insert(c);
    }
    return groups;
  }

  static bool holds_all_of(const Polyline& outer, const Polyline& inner) {
    if (std::abs(signed_area(inner)) >= std::abs(signed_area(outer))) return false;
    const auto in = [&](Point p) { return locate(outer, p) != dobra::geom::Side::Outside; };
    for (std::size_t i = 0; i < inner.segment_count(); ++i) {
      if (!in(inner.points[i]) || !in(midpoint(inner.segment(i).from, inner.segment(i).to))) return false;
    }
    return true;
  }

  /// +1 for an outline, -1 for a hole: by its role, or by how many closed boundaries it lies in; of its own group those that hold all of it.
  int sign_of(std::size_t curve, const std::set<std::size_t>& group) {
    if (curves()[curve].role == Role::Hole) return -1;
    int depth = 0;
    for (std::size_t c = 0; c < curves().size(); ++c) {
      if (c == curve || !bounds(curves()[c]) || !closed(curves()[c])) continue;
      if (group.contains(c)) {
        depth += holds_all_of(*line(c), *line(curve)) ? 1 : 0;
        continue;
      }
      if (locate(trace(curves()[c]).line, line(curve)->points.front()) == dobra::geom::Side::Inside) ++depth;
    }
    return depth % 2 == 0 ? 1 : -1;
  }

  /// Hole points of loops that were cut out of an outline have no loop any more.
  void forget_holes_cut_out(const std::set<std::size_t>& gone, const std::vector<Curve>& made) {
    if (!repaired_.sketch.hole_points) return;
    const auto in = [](const Curve& curve, Point p) { return locate(std::get<Polyline>(curve.shape), p) == dobra::geom::Side::Inside; };
    std::erase_if(repaired_.sketch.hole_points->at, [&](Point p) {
      return std::any_of(gone.begin(), gone.end(), [&](std::size_t c) { return in(curves()[c], p); }) &&
             std::none_of(made.begin(), made.end(), [&](const Curve& curve) { return in(curve, p); });
    });
  }

  Result<void> rebuild_crossings() {
    std::set<std::size_t> gone;
    std::vector<Curve> made;
    for (const auto& [root, entry] : crossing_groups()) {
      const auto& [group, at] = entry;
      std::string names;
      for (const std::size_t c : group) names += (names.empty() ? "" : ", ") + curves()[c].name;
      const bool can = std::all_of(group.begin(), group.end(), [&](std::size_t c) { return line(c) != nullptr && line(c)->closed; });
      if (!can) {
        found(Wrong::Crossing, at, names, "left as it is: only closed curves of straight sides are rebuilt; cut the curves where they cross");
        continue;
      }
      DOBRA_TRY(std::vector<Curve> loops, rebuilt(group));
      found(Wrong::Crossing, at, names, fmt::format("rebuilt as {} {}: outlines united, holes cut out", loops.size(), loops.size() == 1 ? "loop" : "loops"));
      made.insert(made.end(), std::make_move_iterator(loops.begin()), std::make_move_iterator(loops.end()));
      gone.insert(group.begin(), group.end());
    }
    if (gone.empty()) return {};
    forget_holes_cut_out(gone, made);
    const auto places = repaired_.sketch.places;
    for (auto c = gone.rbegin(); c != gone.rend(); ++c) drop(*c);
    for (Curve& curve : made) {
      curves().push_back(std::move(curve));
      repaired_.sketch.places.push_back(places.empty() ? dobra::base::Place{} : places[*gone.begin()]);
    }
    return {};
  }

  Result<std::vector<Curve>> rebuilt(const std::set<std::size_t>& group) {
    Subdivision subdivision;
    std::map<std::size_t, std::size_t> curve_of;  // by edge
    std::vector<std::pair<Polyline, int>> outlines;
    for (const std::size_t c : group) {
      auto inserted = insert(subdivision, *line(c));
      if (!inserted) return inserted.error();
      outlines.emplace_back(*line(c), sign_of(c, group));
    }
    for (const std::size_t c : group) {
      // Edges were split by later curves: which of the curves each now belongs to is asked again.
      const auto again = insert(subdivision, *line(c));
      if (!again) return again.error();
      for (const HalfEdgeId h : again->path) curve_of.try_emplace(Subdivision::edge(h).index(), c);
    }
    const bool any_outline = std::any_of(outlines.begin(), outlines.end(), [](const auto& o) { return o.second > 0; });
    std::map<FaceId, bool> inside;
    for (const FaceId face : subdivision.faces()) {
      if (face == Subdivision::unbounded()) continue;
      std::vector<dobra::geom::Segment> sides;
      for (const auto loop : subdivision.loops(face)) {
        for (const HalfEdgeId h : subdivision.half_edges(loop)) sides.push_back(subdivision.segment(h));
      }
      const Point p = inner_point(sides);
      int sum = 0;
      for (const auto& [outline, sign] : outlines) sum += locate(outline, p) == dobra::geom::Side::Inside ? sign : 0;
      inside[face] = any_outline ? sum > 0 : sum < 0;
    }
    const auto divides = [&](HalfEdgeId h) {
      const auto in = [&](FaceId face) { return face != Subdivision::unbounded() && inside[face]; };
      return in(subdivision.face(h)) && !in(subdivision.face(Subdivision::twin(h)));
    };
    std::vector<Curve> loops;
    std::set<std::size_t> walked;
    std::map<std::size_t, int> used;
    for (const auto edge : subdivision.edges()) {
      for (const HalfEdgeId start : {Subdivision::half_edge(edge), Subdivision::twin(Subdivision::half_edge(edge))}) {
        if (!divides(start) || walked.contains(start.index())) continue;
        Polyline loop{{}, true};
        for (HalfEdgeId h = start; walked.insert(h.index()).second;) {
          loop.points.push_back(subdivision.point(subdivision.origin(h)));
          h = subdivision.next(h);
          while (!divides(h)) h = subdivision.next(Subdivision::twin(h));
        }
        const std::size_t owner = curve_of.at(edge.index());
        Curve curve = curves()[owner];
        if (++used[owner] > 1) curve.name += fmt::format("_{}", used[owner]);
        auto& holes = repaired_.sketch.hole_points;
        if (holes && holes->curves.contains(curves()[owner].name)) holes->curves.insert(curve.name);
        curve.role = Role::Boundary;
        curve.shape = std::move(loop);
        loops.push_back(std::move(curve));
      }
    }
    return loops;
  }

  Repaired repaired_;
  RepairOptions options_;
  double size_ = 0.0;
};

}  // namespace

const char* name_of(Wrong wrong) {
  switch (wrong) {
    case Wrong::RepeatedPoint: return "repeated point";
    case Wrong::NearlyRepeatedPoint: return "nearly repeated point";
    case Wrong::NoExtent: return "curve without extent";
    case Wrong::CurveTwice: return "curve drawn twice";
    case Wrong::Spike: return "spike";
    case Wrong::Gap: return "gap";
    case Wrong::Crossing: return "crossing";
    case Wrong::Sliver: return "sliver";
  }
  return "";
}

Result<Repaired> repair(Sketch sketch, const RepairOptions& options) { return Repairer(std::move(sketch), options).run(); }

}  // namespace quebra::core
