#include "quebra/core/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

#include "quebra/core/areas.h"
#include "quebra/core/ends.h"
#include "quebra/core/faces.h"
#include "quebra/core/roles.h"
#include "quebra/core/snap.h"
#include "quebra/core/stray_lines.h"
#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"
#include "shared/topo/insert.h"

// 1 points of each curve. 2 spikes; polygons that share sides are parted, what nearly touches is made to. 3 curves drawn twice. 4 gaps; then roles, where the
// file tells none. 5 crossings: groups of rings that meet are put into a subdivision, those that bend as chords through the places where they truly meet; faces
// inside and outside are told apart; the edges between the two are walked as new loops, whose runs along one curve are parts of it.

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
    if (find_rings().empty()) DOBRA_TRY_VOID(cut_at_crossings(repaired_.sketch));
    const std::set<std::string> without_role = repaired_.sketch.without_role;
    find_roles(repaired_.sketch, DomainOptions{}.join_tolerance * size_);
    DOBRA_TRY_VOID(rebuild_crossings());
    for (Finding& finding : drop_outside(repaired_.sketch, without_role, {})) repaired_.findings.push_back(std::move(finding));
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
    std::map<ShapeKey, std::string> known;
    for (std::size_t i = 0; i < curves().size();) {
      const Point start = point(curves()[i], 0.0);
      const auto [first, is_new] = known.try_emplace(shape_key(curves()[i]), curves()[i].name);
      if (is_new) {
        ++i;
        continue;
      }
      found(Wrong::CurveTwice, start, first->second + ", " + curves()[i].name, "the second is left out");
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
    std::size_t curve;
    double s_from, s_to;
  };

  /// Boundary curves that follow each other back to their start.
  struct Ring {
    std::vector<Domain::Side> sides;
    Polyline outline;  ///< Traced, through the places where its curves are cut.
  };

  /// Rings that meet away from common ends, and where their curves meet.
  struct Group {
    std::set<std::size_t> curves;
    Point at;
    bool can = true;  ///< Whether it can be rebuilt.
  };

  /// A curve as chords, through the places where it meets others.
  struct Chain {
    std::vector<Point> points;
    std::map<Point, double> s;
  };

  /// The rings of all boundary curves; a curve that is on none bounds nothing.
  std::vector<Ring> find_rings() {
    std::map<Point, std::vector<Domain::Side>> leaving;
    for (std::size_t c = 0; c < curves().size(); ++c) {
      if (!bounds(curves()[c]) || closed(curves()[c])) continue;
      leaving[point(curves()[c], 0.0)].push_back({c, false});
      leaving[point(curves()[c], length(curves()[c]))].push_back({c, true});
    }
    std::vector<Ring> rings;
    std::vector<std::uint8_t> used(curves().size(), 0);
    for (std::size_t c = 0; c < curves().size(); ++c) {
      if (!bounds(curves()[c]) || used[c] != 0) continue;
      Ring ring{{{c, false}}, {}};
      used[c] = 1;
      bool whole = closed(curves()[c]);
      const Point start = point(curves()[c], 0.0);
      for (Domain::Side side = ring.sides.front(); !whole;) {
        const Point at = point(curves()[side.curve], side.backwards ? 0.0 : length(curves()[side.curve]));
        whole = at == start;
        const auto& here = leaving.at(at);
        if (whole || here.size() != 2) break;
        side = here[here[0].curve == side.curve ? 1 : 0];
        if (used[side.curve] != 0) break;
        used[side.curve] = 1;
        ring.sides.push_back(side);
      }
      if (whole) rings.push_back(std::move(ring));
    }
    return rings;
  }

  /// Notes for each curve where it is cut.
  std::map<std::size_t, Group> crossing_groups(const std::vector<Ring>& rings) {
    std::vector<Chord> chords;
    std::vector<Box> boxes;
    for (std::size_t c = 0; c < curves().size(); ++c) {
      if (!bounds(curves()[c])) continue;
      const Trace along = trace(curves()[c]);
      for (std::size_t i = 0; i < along.line.segment_count(); ++i) {
        chords.push_back({along.line.segment(i), c, along.s[i], along.s[i + 1]});
        boxes.push_back(along.line.segment(i).box());
      }
    }
    std::vector<std::size_t> parent(curves().size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t c) {
      while (parent[c] != c) c = parent[c] = parent[parent[c]];
      return c;
    };
    const auto join = [&](std::size_t a, std::size_t b) { parent[std::max(root(a), root(b))] = std::min(root(a), root(b)); };
    std::vector<std::uint8_t> on_ring(curves().size(), 0);
    for (const Ring& ring : rings) {
      for (const auto& side : ring.sides) {
        join(ring.sides.front().curve, side.curve);
        on_ring[side.curve] = 1;
      }
    }
    struct Meeting {
      std::size_t curve;
      Point at;
      bool can;
    };
    std::vector<Meeting> meetings;
    for (const auto& [i, j] : dobra::geom::SpatialIndex(boxes).overlapping_pairs()) {
      const Chord& a = chords[i];
      const Chord& b = chords[j];
      const auto met = intersect(a.segment, b.segment);
      if (met.kind == dobra::geom::IntersectionKind::None) continue;
      using dobra::geom::At;
      const bool point_only = met.kind == dobra::geom::IntersectionKind::Point;
      if (point_only && met.start.on_first != At::Interior && met.start.on_second != At::Interior) continue;
      const Met how = cut(a, b, met.start.point, point_only);
      if (how == Met::Apart) continue;
      join(a.curve, b.curve);
      meetings.push_back({a.curve, met.start.point, how == Met::Cut});
    }
    std::map<std::size_t, Group> groups;
    for (const Meeting& meeting : meetings) {
      Group& group = groups.try_emplace(root(meeting.curve), Group{{}, meeting.at}).first->second;
      group.can = group.can && meeting.can;
    }
    for (std::size_t c = 0; c < curves().size(); ++c) {
      const auto group = groups.find(root(c));
      if (group == groups.end()) continue;
      group->second.curves.insert(c);
      group->second.can = group->second.can && on_ring[c] != 0;
    }
    return groups;
  }

  enum class Met { Cut, Apart, Cannot };

  /// Notes where two curves meet of which one bends at least. Those that cross themselves or run along each other cannot be cut;
  /// those whose chords alone meet are apart.
  Met cut(const Chord& a, const Chord& b, Point at, bool point_only) {
    if (line(a.curve) != nullptr && line(b.curve) != nullptr) return Met::Cut;  // the subdivision does
    if (a.curve == b.curve || !point_only) return Met::Cannot;
    const auto along = [&](const Chord& chord) { return chord.s_from + nearest_fraction(chord.segment, at) * (chord.s_to - chord.s_from); };
    const auto s = meeting(curves()[a.curve], along(a), curves()[b.curve], along(b), options_.same_point * size_);
    if (!s) return Met::Apart;
    Point p = point(curves()[a.curve], (*s)[0]);
    for (std::size_t k = 0; k < 2; ++k) p = known(k == 0 ? a.curve : b.curve, (*s)[k]).value_or(p);
    if (!known(a.curve, (*s)[0])) cuts_[a.curve][(*s)[0]] = p;
    if (!known(b.curve, (*s)[1])) cuts_[b.curve][(*s)[1]] = p;
    return Met::Cut;
  }

  /// The end or cut of a curve that is as good as at distance s.
  std::optional<Point> known(std::size_t curve, double s) {
    const double apart = options_.same_point * size_;
    for (const double end : {0.0, length(curves()[curve])}) {
      if (std::abs(s - end) <= apart) return point(curves()[curve], end);
    }
    const auto& cuts = cuts_[curve];
    const auto above = cuts.lower_bound(s - apart);
    return above != cuts.end() && above->first <= s + apart ? std::optional(above->second) : std::nullopt;
  }

  Chain chain_of(std::size_t curve) {
    const Trace along = trace(curves()[curve]);
    std::map<double, Point> nodes = cuts_[curve];
    const double apart = options_.same_point * size_;
    for (std::size_t i = 0; i < along.s.size(); ++i) {
      const auto above = nodes.lower_bound(along.s[i] - apart);
      if (above != nodes.end() && above->first <= along.s[i] + apart) continue;  // the cut stands for it
      nodes[along.s[i]] = along.line.points[i % along.line.points.size()];
    }
    Chain chain;
    for (const auto& [s, p] : nodes) {
      chain.points.push_back(p);
      chain.s.try_emplace(p, s);
    }
    return chain;
  }

  static bool holds_all_of(const Polyline& outer, const Polyline& inner) {
    if (std::abs(signed_area(inner)) >= std::abs(signed_area(outer))) return false;
    const auto in = [&](Point p) { return locate(outer, p) != dobra::geom::Side::Outside; };
    for (std::size_t i = 0; i < inner.segment_count(); ++i) {
      if (!in(inner.points[i]) || !in(midpoint(inner.segment(i).from, inner.segment(i).to))) return false;
    }
    return true;
  }

  /// +1 for an outline, -1 for a hole: by its role, or by how many rings it lies in; of its own group those that hold all of it.
  int sign_of(const Ring& ring, const std::vector<Ring>& rings, const Group& group) {
    if (curves()[ring.sides.front().curve].role == Role::Hole) return -1;
    int depth = 0;
    for (const Ring& other : rings) {
      if (&other == &ring) continue;
      const bool near = group.curves.contains(other.sides.front().curve);
      const bool inside = near ? holds_all_of(other.outline, ring.outline) : locate(other.outline, ring.outline.points.front()) == dobra::geom::Side::Inside;
      depth += inside ? 1 : 0;
    }
    return depth % 2 == 0 ? 1 : -1;
  }

  /// Hole points of loops that were cut out of an outline have no loop any more.
  void forget_holes_cut_out(const std::vector<Polyline>& gone, const std::vector<Polyline>& made) {
    if (!repaired_.sketch.hole_points) return;
    const auto in = [](const std::vector<Polyline>& rings, Point p) {
      return std::any_of(rings.begin(), rings.end(), [&](const Polyline& ring) { return locate(ring, p) == dobra::geom::Side::Inside; });
    };
    std::erase_if(repaired_.sketch.hole_points->at, [&](Point p) { return in(gone, p) && !in(made, p); });
  }

  Result<void> rebuild_crossings() {
    std::vector<Ring> rings = find_rings();
    const auto groups = crossing_groups(rings);
    if (groups.empty()) return {};
    chains_.resize(curves().size());
    for (Ring& ring : rings) {
      ring.outline.closed = true;
      for (const auto& [curve, backwards] : ring.sides) {
        chains_[curve] = chain_of(curve);
        std::vector<Point> nodes = chains_[curve].points;
        if (backwards) std::reverse(nodes.begin(), nodes.end());
        ring.outline.points.insert(ring.outline.points.end(), nodes.begin(), nodes.end() - 1);
      }
    }
    std::set<std::size_t> gone;
    std::vector<Curve> made;
    std::vector<Polyline> outlines_gone, outlines_made;
    for (const auto& [root, group] : groups) {
      std::string names;
      for (const std::size_t c : group.curves) names += (names.empty() ? "" : ", ") + curves()[c].name;
      if (!group.can) {
        found(Wrong::Crossing, group.at, names, "left as it is: only loops are rebuilt, and of arcs and splines those that cross others at an angle; cut the curves where they cross");
        continue;
      }
      std::vector<Polyline> loops;
      DOBRA_TRY(std::vector<Curve> pieces, rebuilt(group, rings, loops));
      found(Wrong::Crossing, group.at, names, fmt::format("rebuilt as {} {}: outlines united, holes cut out", loops.size(), loops.size() == 1 ? "loop" : "loops"));
      made.insert(made.end(), std::make_move_iterator(pieces.begin()), std::make_move_iterator(pieces.end()));
      outlines_made.insert(outlines_made.end(), std::make_move_iterator(loops.begin()), std::make_move_iterator(loops.end()));
      gone.insert(group.curves.begin(), group.curves.end());
      for (const Ring& ring : rings) {
        if (group.curves.contains(ring.sides.front().curve)) outlines_gone.push_back(ring.outline);
      }
    }
    if (gone.empty()) return {};
    forget_holes_cut_out(outlines_gone, outlines_made);
    const auto places = repaired_.sketch.places;
    for (auto c = gone.rbegin(); c != gone.rend(); ++c) drop(*c);
    for (Curve& curve : made) {
      curves().push_back(std::move(curve));
      repaired_.sketch.places.push_back(places.empty() ? dobra::base::Place{} : places[*gone.begin()]);
    }
    return {};
  }

  /// A loop round the material: its points, and the curve that each side from one to the next is of.
  struct Walk {
    std::vector<Point> points;
    std::vector<std::size_t> owner;
  };

  /// @param loops  gets the outline of each.
  Result<std::vector<Curve>> rebuilt(const Group& group, const std::vector<Ring>& rings, std::vector<Polyline>& loops) {
    Subdivision subdivision;
    std::map<std::size_t, std::size_t> curve_of;  // by edge
    for (const bool again : {false, true}) {  // edges were split by later curves: which of the curves each now belongs to is asked again
      for (const std::size_t c : group.curves) {
        const auto inserted = insert(subdivision, Polyline{chains_[c].points, false});
        if (!inserted) return inserted.error();
        if (!again) continue;
        for (const HalfEdgeId h : inserted->path) curve_of.try_emplace(Subdivision::edge(h).index(), c);
      }
    }
    std::vector<std::pair<const Polyline*, int>> outlines;
    for (const Ring& ring : rings) {
      if (group.curves.contains(ring.sides.front().curve)) outlines.emplace_back(&ring.outline, sign_of(ring, rings, group));
    }
    const bool any_outline = std::any_of(outlines.begin(), outlines.end(), [](const auto& o) { return o.second > 0; });
    std::map<FaceId, bool> inside;
    for (const FaceId face : subdivision.faces()) {
      if (face == Subdivision::unbounded()) continue;
      const Point p = inner_point(sides_of(subdivision, face));
      int sum = 0;
      for (const auto& [outline, sign] : outlines) sum += locate(*outline, p) == dobra::geom::Side::Inside ? sign : 0;
      inside[face] = any_outline ? sum > 0 : sum < 0;
    }
    const auto divides = [&](HalfEdgeId h) {
      const auto in = [&](FaceId face) { return face != Subdivision::unbounded() && inside[face]; };
      return in(subdivision.face(h)) && !in(subdivision.face(Subdivision::twin(h)));
    };
    std::vector<Curve> pieces;
    std::set<std::size_t> walked;
    std::map<std::size_t, int> used;
    for (const auto edge : subdivision.edges()) {
      for (const HalfEdgeId start : {Subdivision::half_edge(edge), Subdivision::twin(Subdivision::half_edge(edge))}) {
        if (!divides(start) || walked.contains(start.index())) continue;
        Walk walk;
        for (HalfEdgeId h = start; walked.insert(h.index()).second;) {
          walk.points.push_back(subdivision.point(subdivision.origin(h)));
          walk.owner.push_back(curve_of.at(Subdivision::edge(h).index()));
          h = subdivision.next(h);
          while (!divides(h)) h = subdivision.next(Subdivision::twin(h));
        }
        loops.push_back({walk.points, true});
        DOBRA_TRY_VOID(add_pieces(walk, used, pieces));
      }
    }
    return pieces;
  }

  /// A loop of closed curves of straight sides is one curve; of others each run along one curve is a part of it.
  Result<void> add_pieces(const Walk& walk, std::map<std::size_t, int>& used, std::vector<Curve>& pieces) {
    const std::size_t n = walk.points.size();
    const auto add = [&](std::size_t owner, decltype(Curve::shape) shape) {
      Curve curve = curves()[owner];
      if (++used[owner] > 1) curve.name += fmt::format("_{}", used[owner]);
      auto& holes = repaired_.sketch.hole_points;
      if (holes && holes->curves.contains(curves()[owner].name)) holes->curves.insert(curve.name);
      curve.role = Role::Boundary;
      curve.shape = std::move(shape);
      pieces.push_back(std::move(curve));
    };
    if (std::all_of(walk.owner.begin(), walk.owner.end(), [&](std::size_t c) { return line(c) != nullptr && line(c)->closed; })) {
      add(walk.owner.front(), Polyline{walk.points, true});
      return {};
    }
    std::size_t first = 0;
    while (first < n && walk.owner[first] == walk.owner[(first + n - 1) % n]) ++first;
    if (first == n) {  // all of a curve that bends, or a part of an open one that crosses itself
      const std::size_t owner = walk.owner.front();
      if (line(owner) != nullptr) add(owner, Polyline{walk.points, true});
      else add(owner, curves()[owner].shape);
      return {};
    }
    for (std::size_t i = 0; i < n;) {
      const std::size_t owner = walk.owner[(first + i) % n];
      std::vector<Point> run{walk.points[(first + i) % n]};
      for (; i < n && walk.owner[(first + i) % n] == owner; ++i) run.push_back(walk.points[(first + i + 1) % n]);
      if (line(owner) != nullptr) {
        add(owner, Polyline{std::move(run), false});
        continue;
      }
      DOBRA_TRY(auto parts, parts_along(owner, run));
      for (auto& part : parts) add(owner, std::move(part));
    }
    return {};
  }

  /// The part of a curve that bends along some of its chain's points; two where a closed one passes its start.
  Result<std::vector<decltype(Curve::shape)>> parts_along(std::size_t owner, const std::vector<Point>& run) {
    const Curve& curve = curves()[owner];
    const double whole = length(curve);
    const auto& s_of = chains_[owner].s;
    double from = s_of.at(run.front()), to = s_of.at(run.back());
    double step = s_of.at(run[1]) - from;
    if (closed(curve) && std::abs(step) > 0.5 * whole) step = -step;  // across the start
    const bool backwards = step < 0.0;
    std::vector<decltype(Curve::shape)> parts;
    if (const auto* arc = std::get_if<dobra::geom::Arc>(&curve.shape)) {
      const bool anticlockwise = (arc->sweep().radians() > 0.0) != backwards;
      DOBRA_TRY(auto part, dobra::geom::Arc::from_ends(arc->centre(), run.front(), run.back(), anticlockwise ? dobra::geom::Orientation::Anticlockwise : dobra::geom::Orientation::Clockwise, 1e-6));
      parts.emplace_back(std::move(part));
      return parts;
    }
    if (backwards) std::swap(from, to);
    const auto& smooth = std::get<Smooth>(curve.shape);
    const std::array ends{backwards ? run.back() : run.front(), backwards ? run.front() : run.back()};
    const auto add = [&](double s, double t) -> Result<void> {
      DOBRA_TRY(auto part, smooth.part(s, t));
      Curve piece{curve.name, curve.role, std::move(part), {}};
      if (s == from) move_end(piece, false, ends[0]);
      if (t == to) move_end(piece, true, ends[1]);
      parts.push_back(std::move(piece.shape));
      return {};
    };
    if (closed(curve) && from == whole) from = 0.0;
    if (closed(curve) && to == 0.0) to = whole;
    if (from < to) {
      DOBRA_TRY_VOID(add(from, to));
    } else {
      DOBRA_TRY_VOID(add(from, whole));
      DOBRA_TRY_VOID(add(0.0, to));
    }
    return parts;
  }

  std::map<std::size_t, std::map<double, Point>> cuts_;  ///< By curve: where it meets others, by distance along it.
  std::vector<Chain> chains_;                            ///< One a curve; of those on rings.
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
    case Wrong::NearlyTouching: return "crack nearly touching";
    case Wrong::CutThrough: return "material cut through";
    case Wrong::Outside: return "line outside";
    case Wrong::Apart: return "loop outside";
  }
  return "";
}

Result<Repaired> repair(Sketch sketch, const RepairOptions& options) { return Repairer(std::move(sketch), options).run(); }

}  // namespace quebra::core
