#include "quebra/repair/crossings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

#include "quebra/domain/domain.h"
#include "quebra/domain/faces.h"
#include "quebra/repair/rings.h"
#include "quebra/sketch/enclosed.h"
#include "quebra/sketch/ends.h"
#include "quebra/sketch/snap.h"
#include "shared/base/disjoint_sets.h"
#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"
#include "shared/topo/insert.h"

// 1. Groups of rings that meet are put into a subdivision, those that bend as chords through the places where they
// truly meet. 2. Each ring is taken for an outline, a hole or a notch; so faces are inside or outside. 3. The edges
// between the two are walked as new loops, whose runs along one curve are parts of it.

namespace quebra::repair {
namespace {

using dobra::base::Result;
using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::topo::FaceId;
using dobra::topo::HalfEdgeId;
using dobra::topo::Subdivision;

/// What a ring of a group is taken for.
enum class Taken { Outline, Hole, Notch };

class Crossings {
 public:
  Crossings(sketch::Sketch& sketch, const std::set<std::string>& without_role, double same_point)
      : sketch_(sketch), curves_(sketch.curves), without_role_(without_role), same_point_(same_point) {}

  Result<std::vector<sketch::Finding>> run() {
    std::vector<Ring> rings = find_rings(curves_);
    settle(rings);
    const auto groups = crossing_groups(rings);
    if (groups.empty()) return std::move(findings_);
    trace_outlines(rings);
    std::set<std::size_t> gone;
    std::vector<sketch::Curve> made;
    std::vector<Polyline> outlines_gone, outlines_made;
    for (const auto& [root, group] : groups) {
      if (!group.can) {
        found(group,
              "left as it is: only loops are rebuilt, and of arcs and splines those that cross others at an angle; cut "
              "the curves where they cross");
        continue;
      }
      DOBRA_TRY(std::vector<sketch::Curve> pieces, rebuilt(group, rings, outlines_made));
      made.insert(made.end(), std::make_move_iterator(pieces.begin()), std::make_move_iterator(pieces.end()));
      gone.insert(group.curves.begin(), group.curves.end());
      for (const Ring& ring : rings) {
        if (is_of(ring, group)) outlines_gone.push_back(ring.outline);
      }
    }
    forget_holes_cut_out(outlines_gone, outlines_made);
    replace(gone, std::move(made));
    return std::move(findings_);
  }

 private:
  struct Chord {
    dobra::geom::Segment segment;
    std::size_t curve;
    double s_from, s_to;
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

  /// The part of a ring's plane that it shares with the largest outline of its group decides what it is.
  struct Verdict {
    const Ring* ring = nullptr;
    Taken taken = Taken::Outline;
    double area = 0.0;
    double in_largest = 0.0;
  };

  /// A bounded face of the subdivision and which of the group's rings hold it.
  struct Cell {
    FaceId face;
    double area = 0.0;
    std::vector<std::uint8_t> in;
  };

  static bool is_of(const Ring& ring, const Group& group) { return group.curves.contains(ring.sides.front().curve); }

  const Polyline* line(std::size_t curve) const { return std::get_if<Polyline>(&curves_[curve].shape); }

  void found(const Group& group, std::string mend) {
    std::string names;
    for (const std::size_t c : group.curves) names += (names.empty() ? "" : ", ") + curves_[c].name;
    findings_.push_back({sketch::Wrong::Crossing, group.at, std::move(names), std::move(mend)});
  }

  /// Straight sides that run along each other up to rounding share their vertices afterwards, bit for bit.
  void settle(const std::vector<Ring>& rings) {
    std::vector<std::size_t> owner;
    std::vector<Polyline> lines;
    for (const Ring& ring : rings) {
      for (const auto& side : ring.sides) {
        if (line(side.curve) == nullptr) continue;
        owner.push_back(side.curve);
        lines.push_back(*line(side.curve));
      }
    }
    std::vector<Polyline*> together;
    for (Polyline& own : lines) together.push_back(&own);
    sketch::snap_together(together, same_point_);
    for (std::size_t i = 0; i < owner.size(); ++i) curves_[owner[i]].shape = std::move(lines[i]);
  }

  void trace_outlines(std::vector<Ring>& rings) {
    chains_.resize(curves_.size());
    for (Ring& ring : rings) {
      ring.outline.closed = true;
      for (const auto& [curve, backwards] : ring.sides) {
        chains_[curve] = chain_of(curve);
        std::vector<Point> nodes = chains_[curve].points;
        if (backwards) std::reverse(nodes.begin(), nodes.end());
        ring.outline.points.insert(ring.outline.points.end(), nodes.begin(), nodes.end() - 1);
      }
    }
  }

  void replace(const std::set<std::size_t>& gone, std::vector<sketch::Curve> made) {
    if (gone.empty()) return;
    auto& places = sketch_.places;
    const dobra::base::Place first = places.empty() ? dobra::base::Place{} : places[*gone.begin()];
    for (auto c = gone.rbegin(); c != gone.rend(); ++c) {
      curves_.erase(curves_.begin() + static_cast<std::ptrdiff_t>(*c));
      if (*c < places.size()) places.erase(places.begin() + static_cast<std::ptrdiff_t>(*c));
    }
    for (sketch::Curve& curve : made) {
      curves_.push_back(std::move(curve));
      places.push_back(first);
    }
  }

  // --- where they meet ----------------------------------------------------------------------------------------------

  /// Notes for each curve where it is cut.
  std::map<std::size_t, Group> crossing_groups(const std::vector<Ring>& rings) {
    std::vector<Chord> chords;
    std::vector<Box> boxes;
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      if (!bounds(curves_[c])) continue;
      const sketch::Trace along = trace(curves_[c]);
      for (std::size_t i = 0; i < along.line.segment_count(); ++i) {
        chords.push_back({along.line.segment(i), c, along.s[i], along.s[i + 1]});
        boxes.push_back(along.line.segment(i).box());
      }
    }
    dobra::base::DisjointSets parts(curves_.size());
    std::vector<std::uint8_t> on_ring(curves_.size(), 0);
    for (const Ring& ring : rings) {
      for (const auto& side : ring.sides) {
        parts.join(ring.sides.front().curve, side.curve);
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
      parts.join(a.curve, b.curve);
      meetings.push_back({a.curve, met.start.point, how == Met::Cut});
    }
    std::map<std::size_t, Group> groups;
    for (const Meeting& meeting : meetings) {
      Group& group = groups.try_emplace(parts.root(meeting.curve), Group{{}, meeting.at}).first->second;
      group.can = group.can && meeting.can;
    }
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      const auto group = groups.find(parts.root(c));
      if (group == groups.end()) continue;
      group->second.curves.insert(c);
      group->second.can = group->second.can && on_ring[c] != 0;
    }
    return groups;
  }

  enum class Met { Cut, Apart, Cannot };

  /// Notes where two curves meet of which one bends at least. Those that cross themselves or run along each other
  /// cannot be cut; those whose chords alone meet are apart.
  Met cut(const Chord& a, const Chord& b, Point at, bool point_only) {
    if (line(a.curve) != nullptr && line(b.curve) != nullptr) return Met::Cut;  // the subdivision does
    if (a.curve == b.curve || !point_only) return Met::Cannot;
    const auto along = [&](const Chord& chord) {
      return chord.s_from + nearest_fraction(chord.segment, at) * (chord.s_to - chord.s_from);
    };
    const auto s = meeting(curves_[a.curve], along(a), curves_[b.curve], along(b), same_point_);
    if (!s) return Met::Apart;
    Point p = point(curves_[a.curve], (*s)[0]);
    for (std::size_t k = 0; k < 2; ++k) p = known(k == 0 ? a.curve : b.curve, (*s)[k]).value_or(p);
    if (!known(a.curve, (*s)[0])) cuts_[a.curve][(*s)[0]] = p;
    if (!known(b.curve, (*s)[1])) cuts_[b.curve][(*s)[1]] = p;
    return Met::Cut;
  }

  /// The end or cut of a curve that is as good as at distance s.
  std::optional<Point> known(std::size_t curve, double s) {
    const double apart = same_point_;
    for (const double end : {0.0, length(curves_[curve])}) {
      if (std::abs(s - end) <= apart) return point(curves_[curve], end);
    }
    const auto& cuts = cuts_[curve];
    const auto above = cuts.lower_bound(s - apart);
    return above != cuts.end() && above->first <= s + apart ? std::optional(above->second) : std::nullopt;
  }

  Chain chain_of(std::size_t curve) {
    const sketch::Trace along = trace(curves_[curve]);
    std::map<double, Point> nodes = cuts_[curve];
    const double apart = same_point_;
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

  // --- outlines, holes and notches
  // ------------------------------------------------------------------------------------

  /// By its role, or by how many rings it lies in; of its own group those that hold all of it.
  Taken by_depth(const Ring& ring, const std::vector<Ring>& rings, const Group& group) const {
    if (curves_[ring.sides.front().curve].role == sketch::Role::Hole) return Taken::Hole;
    int depth = 0;
    for (const Ring& other : rings) {
      if (&other == &ring) continue;
      const bool inside = is_of(other, group)
                              ? holds_all_of(other.outline, ring.outline)
                              : locate(other.outline, ring.outline.points.front()) == dobra::geom::Side::Inside;
      depth += inside ? 1 : 0;
    }
    return depth % 2 == 0 ? Taken::Outline : Taken::Hole;
  }

  /// Whether the file leaves open what an outline is, and it looks like a hole that reaches across the largest one: it
  /// is smaller, its centre is not outside, and it holds nothing. Of a .poly the hole points say it.
  bool is_notch(const Verdict& own, const Verdict& largest, const std::vector<Ring>& rings) const {
    const auto unsaid = [&](const domain::Domain::Side& side) {
      return without_role_.contains(curves_[side.curve].name);
    };
    if (!std::all_of(own.ring->sides.begin(), own.ring->sides.end(), unsaid)) return false;
    if (sketch_.hole_points) {
      const auto& holes = sketch_.hole_points->at;
      return std::any_of(holes.begin(), holes.end(),
                         [&](Point p) { return locate(own.ring->outline, p) == dobra::geom::Side::Inside; });
    }
    constexpr double most_of_largest = 0.5, on_rim = 0.01;  // the latter of its own size
    if (own.area > most_of_largest * largest.area) return false;
    const Point centre = centroid(own.ring->outline);
    const Polyline& rim = largest.ring->outline;
    if (locate(rim, centre) == dobra::geom::Side::Outside && distance(rim, centre) > on_rim * std::sqrt(own.area))
      return false;
    return std::none_of(rings.begin(), rings.end(), [&](const Ring& other) {
      return &other != own.ring && holds_all_of(own.ring->outline, other.outline);
    });
  }

  /// One a ring of the group, in the order of `rings`, the largest outline first.
  std::vector<Verdict> judged(const Group& group, const std::vector<Ring>& rings,
                              const std::vector<Cell>& cells) const {
    std::vector<Verdict> verdicts;
    for (const Ring& ring : rings) {
      if (is_of(ring, group)) verdicts.push_back({&ring, by_depth(ring, rings, group)});
    }
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
      for (const Cell& cell : cells) verdicts[k].area += cell.in[k] != 0 ? cell.area : 0.0;
    }
    std::size_t largest = verdicts.size();
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
      if (verdicts[k].taken == Taken::Outline &&
          (largest == verdicts.size() || verdicts[k].area > verdicts[largest].area))
        largest = k;
    }
    if (largest == verdicts.size()) return verdicts;
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
      for (const Cell& cell : cells)
        verdicts[k].in_largest += cell.in[k] != 0 && cell.in[largest] != 0 ? cell.area : 0.0;
      const bool other_outline = k != largest && verdicts[k].taken == Taken::Outline;
      if (other_outline && is_notch(verdicts[k], verdicts[largest], rings)) verdicts[k].taken = Taken::Notch;
    }
    return verdicts;
  }

  /// Outlines count up, holes down, and what a notch holds is outside; where all are holes, what any of them holds is
  /// inside.
  static bool is_inside(const Cell& cell, const std::vector<Verdict>& verdicts) {
    int sum = 0;
    bool any_outline = false;
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
      any_outline = any_outline || verdicts[k].taken == Taken::Outline;
      if (cell.in[k] == 0) continue;
      if (verdicts[k].taken == Taken::Notch) return false;
      sum += verdicts[k].taken == Taken::Outline ? 1 : -1;
    }
    return any_outline ? sum > 0 : sum < 0;
  }

  /// "'a' (16 m2), 'b' (4 m2, 2 m2 of it inside)": the rings that were taken for that.
  std::string listed(const std::vector<Verdict>& verdicts, Taken taken) const {
    std::string text;
    for (const Verdict& own : verdicts) {
      if (own.taken != taken) continue;
      const std::size_t more = own.ring->sides.size() - 1;
      text +=
          fmt::format("{}'{}'{} ({:.4g} m2{})", text.empty() ? "" : ", ", curves_[own.ring->sides.front().curve].name,
                      more == 0 ? "" : fmt::format(" and {} more", more), own.area,
                      taken == Taken::Outline ? "" : fmt::format(", {:.4g} m2 of it inside", own.in_largest));
    }
    return text;
  }

  /// What was taken for what, and the areas.
  std::string told(const std::vector<Verdict>& verdicts, const std::vector<Cell>& cells, std::size_t loops) const {
    double before = 0.0, after = 0.0;
    std::size_t outlines = 0;
    for (const Verdict& own : verdicts) {
      if (own.taken == Taken::Outline) before = std::max(before, own.area);
      outlines += own.taken == Taken::Outline ? 1 : 0;
    }
    for (const Cell& cell : cells) after += is_inside(cell, verdicts) ? cell.area : 0.0;
    std::string text = fmt::format("rebuilt as {} {}: ", loops, loops == 1 ? "loop" : "loops");
    if (outlines == 0) return text + fmt::format("holes {} united to {:.4g} m2", listed(verdicts, Taken::Hole), after);
    text += fmt::format("{} {}", listed(verdicts, Taken::Outline),
                        outlines == 1 ? "taken for the outline" : "taken for outlines and united");
    const std::string holes = listed(verdicts, Taken::Hole), notches = listed(verdicts, Taken::Notch);
    if (!holes.empty()) text += fmt::format("; {} for a hole and cut out", holes);
    if (!notches.empty()) text += fmt::format("; {} for a hole across it and cut out", notches);
    text += fmt::format("; the area was {:.6g} m2{} and is {:.6g} m2", before, outlines > 1 ? " (of the largest)" : "",
                        after);
    if (!notches.empty())
      text += "; if that is material, draw it and the outline as one";
    else if (outlines > 1)
      text += "; if one of them is a hole, give it role = \"hole\" or draw the notch as part of the outline";
    return text;
  }

  // --- new loops
  // ------------------------------------------------------------------------------------------------------

  /// A loop round the material: its points, and the curve that each side from one to the next is of.
  struct Walk {
    std::vector<Point> points;
    std::vector<std::size_t> owner;
  };

  static std::vector<Cell> cells_of(const Subdivision& subdivision, const Group& group,
                                    const std::vector<Ring>& rings) {
    std::vector<Cell> cells;
    for (const FaceId face : subdivision.faces()) {
      if (face == Subdivision::unbounded()) continue;
      const auto sides = domain::sides_of(subdivision, face);
      Cell cell{face, sketch::area_of(sides), {}};
      const Point p = sketch::inner_point(sides);
      for (const Ring& ring : rings) {
        if (is_of(ring, group)) cell.in.push_back(locate(ring.outline, p) == dobra::geom::Side::Inside ? 1 : 0);
      }
      cells.push_back(std::move(cell));
    }
    return cells;
  }

  /// @param loops  gets the outline of each.
  Result<std::vector<sketch::Curve>> rebuilt(const Group& group, const std::vector<Ring>& rings,
                                             std::vector<Polyline>& loops) {
    std::vector<Polyline> lines;
    for (const std::size_t c : group.curves) lines.push_back({chains_[c].points, false});
    Subdivision subdivision;
    DOBRA_TRY(const auto paths, insert(subdivision, lines));
    std::map<std::size_t, std::size_t> curve_of;  // by edge
    auto path = paths.begin();
    for (const std::size_t c : group.curves) {
      for (const HalfEdgeId h : *path++) curve_of.try_emplace(Subdivision::edge(h).index(), c);
    }
    const std::vector<Cell> cells = cells_of(subdivision, group, rings);
    const std::vector<Verdict> verdicts = judged(group, rings, cells);
    std::map<FaceId, bool> inside{{Subdivision::unbounded(), false}};
    for (const Cell& cell : cells) inside[cell.face] = is_inside(cell, verdicts);
    const std::vector<Walk> walks = walked(subdivision, inside, curve_of);
    found(group, told(verdicts, cells, walks.size()));
    std::vector<sketch::Curve> pieces;
    std::map<std::size_t, int> used;
    for (const Walk& walk : walks) {
      loops.push_back({walk.points, true});
      DOBRA_TRY_VOID(add_pieces(walk, used, pieces));
    }
    return pieces;
  }

  /// The loops between inside, on their left, and outside; those that touch in a point come apart there.
  static std::vector<Walk> walked(const Subdivision& subdivision, const std::map<FaceId, bool>& inside,
                                  const std::map<std::size_t, std::size_t>& curve_of) {
    const auto divides = [&](HalfEdgeId h) {
      return inside.at(subdivision.face(h)) && !inside.at(subdivision.face(Subdivision::twin(h)));
    };
    std::vector<Walk> walks;
    std::set<std::size_t> done;
    for (const auto edge : subdivision.edges()) {
      for (const HalfEdgeId start : {Subdivision::half_edge(edge), Subdivision::twin(Subdivision::half_edge(edge))}) {
        if (!divides(start) || done.contains(start.index())) continue;
        Walk walk;
        for (HalfEdgeId h = start; done.insert(h.index()).second;) {
          walk.points.push_back(subdivision.point(subdivision.origin(h)));
          walk.owner.push_back(curve_of.at(Subdivision::edge(h).index()));
          h = subdivision.next(h);
          while (!divides(h)) h = subdivision.next(Subdivision::twin(h));
        }
        walks.push_back(std::move(walk));
      }
    }
    return walks;
  }

  /// A loop of closed curves of straight sides is one curve; of others each run along one curve is a part of it.
  Result<void> add_pieces(const Walk& walk, std::map<std::size_t, int>& used, std::vector<sketch::Curve>& pieces) {
    const std::size_t n = walk.points.size();
    const auto add = [&](std::size_t owner, decltype(sketch::Curve::shape) shape) {
      sketch::Curve curve = curves_[owner];
      if (++used[owner] > 1) curve.name += fmt::format("_{}", used[owner]);
      auto& holes = sketch_.hole_points;
      if (holes && holes->curves.contains(curves_[owner].name)) holes->curves.insert(curve.name);
      curve.role = sketch::Role::Boundary;
      curve.shape = std::move(shape);
      pieces.push_back(std::move(curve));
    };
    if (std::all_of(walk.owner.begin(), walk.owner.end(),
                    [&](std::size_t c) { return line(c) != nullptr && line(c)->closed; })) {
      add(walk.owner.front(), Polyline{walk.points, true});
      return {};
    }
    std::size_t first = 0;
    while (first < n && walk.owner[first] == walk.owner[(first + n - 1) % n]) ++first;
    if (first == n) {  // all of a curve that bends, or a part of an open one that crosses itself
      const std::size_t owner = walk.owner.front();
      if (line(owner) != nullptr)
        add(owner, Polyline{walk.points, true});
      else
        add(owner, curves_[owner].shape);
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
  Result<std::vector<decltype(sketch::Curve::shape)>> parts_along(std::size_t owner, const std::vector<Point>& run) {
    const sketch::Curve& curve = curves_[owner];
    const double whole = length(curve);
    const auto& s_of = chains_[owner].s;
    double from = s_of.at(run.front()), to = s_of.at(run.back());
    double step = s_of.at(run[1]) - from;
    if (closed(curve) && std::abs(step) > 0.5 * whole) step = -step;  // across the start
    const bool backwards = step < 0.0;
    std::vector<decltype(sketch::Curve::shape)> parts;
    if (const auto* arc = std::get_if<dobra::geom::Arc>(&curve.shape)) {
      const bool anticlockwise = (arc->sweep().radians() > 0.0) != backwards;
      DOBRA_TRY(auto part, dobra::geom::Arc::from_ends(arc->centre(), run.front(), run.back(),
                                                       anticlockwise ? dobra::geom::Orientation::Anticlockwise
                                                                     : dobra::geom::Orientation::Clockwise,
                                                       1e-6));
      parts.emplace_back(std::move(part));
      return parts;
    }
    if (backwards) std::swap(from, to);
    const auto& smooth = std::get<sketch::Smooth>(curve.shape);
    const std::array ends{backwards ? run.back() : run.front(), backwards ? run.front() : run.back()};
    const auto add = [&](double s, double t) -> Result<void> {
      DOBRA_TRY(auto part, smooth.part(s, t));
      sketch::Curve piece{curve.name, curve.role, std::move(part), {}};
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

  /// Hole points of loops that were cut out of an outline have no loop any more.
  void forget_holes_cut_out(const std::vector<Polyline>& gone, const std::vector<Polyline>& made) {
    if (!sketch_.hole_points) return;
    const auto in = [](const std::vector<Polyline>& rings, Point p) {
      return std::any_of(rings.begin(), rings.end(),
                         [&](const Polyline& ring) { return locate(ring, p) == dobra::geom::Side::Inside; });
    };
    std::erase_if(sketch_.hole_points->at, [&](Point p) { return in(gone, p) && !in(made, p); });
  }

  sketch::Sketch& sketch_;
  std::vector<sketch::Curve>& curves_;
  const std::set<std::string>& without_role_;
  double same_point_;
  std::vector<sketch::Finding> findings_;
  std::map<std::size_t, std::map<double, Point>> cuts_;  ///< By curve: where it meets others, by distance along it.
  std::vector<Chain> chains_;                            ///< One a curve; of those on rings.
};

}  // namespace

bool any_loop_closes(const sketch::Sketch& sketch) { return !find_rings(sketch.curves).empty(); }

Result<std::vector<sketch::Finding>> rebuild_crossings(sketch::Sketch& sketch,
                                                       const std::set<std::string>& without_role, double same_point) {
  return Crossings(sketch, without_role, same_point).run();
}

}  // namespace quebra::repair
