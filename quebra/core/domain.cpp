#include "quebra/core/domain.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

#include "shared/geom/intersect.h"
#include "shared/geom/spatial_index.h"

namespace quebra::core {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::Arc;
using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Segment;

/// By how much the ends of an arc may differ in their distance to its centre, as a fraction, once they are joined.
constexpr double arc_tolerance = 1e-6;

Point start_of(const Curve& curve) { return point(curve, 0.0); }
Point end_of(const Curve& curve) { return point(curve, length(curve)); }

void move_ends(Curve& curve, Point start, Point end) {
  if (auto* arc = std::get_if<Arc>(&curve.shape)) {
    const auto orientation = arc->sweep().radians() > 0.0 ? dobra::geom::Orientation::Anticlockwise : dobra::geom::Orientation::Clockwise;
    auto moved = Arc::from_ends(arc->centre(), start, end, orientation, arc_tolerance);
    if (moved) *arc = *moved;
    return;
  }
  auto& points = std::get<Polyline>(curve.shape).points;
  points.front() = start;
  points.back() = end;
}

Place at_point(Place place, Point p) {
  place.x = p.x;
  place.y = p.y;
  return place;
}

/// Makes ends that lie within `tolerance` of each other the same point: the first of them in the order of the curves.
void join_ends(std::vector<Curve>& curves, double tolerance) {
  struct End {
    Point at;
    std::size_t curve;
    bool is_end;
    std::size_t same_as;
  };
  std::vector<End> ends;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (closed(curves[i])) continue;
    ends.push_back({start_of(curves[i]), i, false, ends.size()});
    ends.push_back({end_of(curves[i]), i, true, ends.size()});
  }
  std::vector<std::size_t> by_x(ends.size());
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) { return ends[a].at.x < ends[b].at.x; });
  for (std::size_t i = 0; i < by_x.size(); ++i) {
    for (std::size_t j = i + 1; j < by_x.size() && ends[by_x[j]].at.x - ends[by_x[i]].at.x <= tolerance; ++j) {
      if (distance(ends[by_x[i]].at, ends[by_x[j]].at) > tolerance) continue;
      const std::size_t first = std::min(ends[by_x[i]].same_as, ends[by_x[j]].same_as);
      ends[by_x[i]].same_as = ends[by_x[j]].same_as = first;
    }
  }
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    move_ends(curves[ends[i].curve], ends[ends[i].same_as].at, ends[ends[i + 1].same_as].at);
  }
}

/// The curves of loops that meet at each point.
using Joints = std::map<Point, std::vector<Domain::Side>>;

Joints joints_of(const std::vector<Curve>& curves) {
  Joints joints;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].role == Role::Internal || closed(curves[i])) continue;
    joints[start_of(curves[i])].push_back({i, false});
    joints[end_of(curves[i])].push_back({i, true});
  }
  return joints;
}

Result<void> check_joints(const Joints& joints, const std::vector<Curve>& curves, const std::vector<Place>& places) {
  for (const auto& [at, sides] : joints) {
    const std::string& name = curves[sides.front().curve].name;
    const Place place = at_point(places[sides.front().curve], at);
    if (sides.size() == 1) {
      return Error{ErrorCode::BadDomain,
                   fmt::format("curve '{}' ends where no other curve begins; close the loop or give it role = \"internal\"", name),
                   place};
    }
    if (sides.size() > 2) {
      return Error{ErrorCode::BadDomain,
                   fmt::format("{} boundary curves meet in one point, '{}' among them; a loop passes a point once", sides.size(), name),
                   place};
    }
  }
  return {};
}

std::vector<Domain::Loop> follow_loops(const std::vector<Curve>& curves, const Joints& joints) {
  std::vector<Domain::Loop> loops;
  std::vector<bool> used(curves.size(), false);
  for (std::size_t first = 0; first < curves.size(); ++first) {
    if (used[first] || curves[first].role == Role::Internal) continue;
    Domain::Loop loop;
    Domain::Side side{first, false};
    while (!used[side.curve]) {
      used[side.curve] = true;
      loop.sides.push_back(side);
      if (closed(curves[side.curve])) break;
      const Point at = side.backwards ? start_of(curves[side.curve]) : end_of(curves[side.curve]);
      const auto& meeting = joints.at(at);
      const bool arrived_as_end = !side.backwards;
      const Domain::Side& here = meeting.front();
      const bool first_is_us = here.curve == side.curve && here.backwards == arrived_as_end;
      side = first_is_us ? meeting.back() : here;
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// Boundary and internal curves may meet only in their ends.
Result<void> check_crossings(const Domain& domain, const std::vector<Place>& places) {
  struct Piece {
    Segment segment;
    std::size_t curve;
  };
  std::vector<Piece> pieces;
  std::vector<Box> boxes;
  for (std::size_t c = 0; c < domain.curves.size(); ++c) {
    const Polyline line = trace(domain.curves[c], trace_turn).line;
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      pieces.push_back({line.segment(i), c});
      boxes.push_back(line.segment(i).box());
    }
  }
  for (const auto& [i, j] : dobra::geom::SpatialIndex(boxes).overlapping_pairs()) {
    const auto meeting = dobra::geom::intersect(pieces[i].segment, pieces[j].segment);
    if (meeting.kind == dobra::geom::IntersectionKind::None) continue;
    const bool at_ends = meeting.kind == dobra::geom::IntersectionKind::Point &&
                         meeting.start.on_first != dobra::geom::At::Interior &&
                         meeting.start.on_second != dobra::geom::At::Interior;
    if (at_ends) continue;
    const Curve& a = domain.curves[pieces[i].curve];
    const Curve& b = domain.curves[pieces[j].curve];
    constexpr Role internal = Role::Internal;
    // An internal line may begin on a boundary curve; the mesher then makes the point a node.
    if ((a.role == internal) != (b.role == internal) && meeting.kind == dobra::geom::IntersectionKind::Point &&
        !meeting.start.proper()) {
      continue;
    }
    const std::string what = pieces[i].curve == pieces[j].curve
                                 ? fmt::format("curve '{}' crosses or touches itself", a.name)
                                 : fmt::format("curves '{}' and '{}' cross or overlap", a.name, b.name);
    return Error{ErrorCode::SelfIntersection, what + "; curves may meet only at their ends",
                  at_point(places[std::max(pieces[i].curve, pieces[j].curve)], meeting.start.point)};
  }
  return {};
}

void find_depths(Domain& domain) {
  std::vector<Polyline> contours;
  for (const auto& loop : domain.loops) contours.push_back(contour(domain, loop));
  for (std::size_t i = 0; i < contours.size(); ++i) {
    for (std::size_t j = 0; j < contours.size(); ++j) {
      if (i == j || !contours[j].box().contains(contours[i].points.front())) continue;
      if (dobra::geom::locate(contours[j], contours[i].points.front()) == dobra::geom::Side::Inside) ++domain.loops[i].depth;
    }
  }
}

Result<void> check_roles(const Domain& domain, const std::vector<Place>& places) {
  const Inside inside(domain);
  for (const auto& loop : domain.loops) {
    for (const auto& side : loop.sides) {
      const Curve& curve = domain.curves[side.curve];
      if (curve.role == Role::Hole && loop.depth % 2 == 0) {
        return Error{ErrorCode::OutsideDomain,
                     fmt::format("hole '{}' lies outside the domain; move it inside or remove it", curve.name),
                     at_point(places[side.curve], start_of(curve))};
      }
    }
  }
  for (std::size_t i = 0; i < domain.curves.size(); ++i) {
    const Curve& curve = domain.curves[i];
    const Point middle = point(curve, 0.5 * length(curve));
    if (curve.role == Role::Internal && !inside(middle)) {
      return Error{ErrorCode::OutsideDomain,
                   fmt::format("internal line '{}' lies outside the domain; move it inside or remove it", curve.name),
                   at_point(places[i], middle)};
    }
  }
  return {};
}

}  // namespace

Box Domain::box() const {
  Box box;
  for (const Curve& curve : curves) box.add(trace(curve, trace_turn).line.box());
  return box;
}

Polyline contour(const Domain& domain, const Domain::Loop& loop) {
  Polyline result;
  result.closed = true;
  for (const auto& side : loop.sides) {
    Polyline line = trace(domain.curves[side.curve], trace_turn).line;
    if (line.closed) return line;
    if (side.backwards) line = reversed(std::move(line));
    result.points.insert(result.points.end(), line.points.begin(), line.points.end() - 1);
  }
  return result;
}

Inside::Inside(const Domain& domain) {
  for (const auto& loop : domain.loops) contours_.push_back(contour(domain, loop));
}

bool Inside::operator()(Point p) const {
  bool inside = false;
  for (const Polyline& contour : contours_) {
    const auto side = dobra::geom::locate(contour, p);
    if (side == dobra::geom::Side::Boundary) return false;
    if (side == dobra::geom::Side::Inside) inside = !inside;
  }
  return inside;
}

Result<Domain> make_domain(std::vector<Curve> curves, const std::vector<Place>& places, const DomainOptions& options) {
  if (curves.empty()) return Error{ErrorCode::BadDomain, "the domain has no curve; add [[input.curve]] or a file"};
  Domain domain;
  domain.curves = std::move(curves);
  const double size = domain.box().diagonal();
  for (std::size_t i = 0; i < domain.curves.size(); ++i) {
    if (length(domain.curves[i]) <= options.join_tolerance * size) {
      return Error{ErrorCode::DegenerateCurve, fmt::format("curve '{}' has no length; remove it", domain.curves[i].name),
                   at_point(places[i], start_of(domain.curves[i]))};
    }
  }
  join_ends(domain.curves, options.join_tolerance * size);
  const Joints joints = joints_of(domain.curves);
  DOBRA_TRY_VOID(check_joints(joints, domain.curves, places));
  domain.loops = follow_loops(domain.curves, joints);
  if (domain.loops.empty()) {
    return Error{ErrorCode::BadDomain, "the domain has only internal lines; add a closed boundary", places.front()};
  }
  DOBRA_TRY_VOID(check_crossings(domain, places));
  find_depths(domain);
  DOBRA_TRY_VOID(check_roles(domain, places));
  return domain;
}

}  // namespace quebra::core
