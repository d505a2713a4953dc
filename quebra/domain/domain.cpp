#include "quebra/domain/domain.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "quebra/domain/faces.h"
#include "quebra/domain/junctions.h"
#include "quebra/domain/open_outline.h"
#include "quebra/domain/roles.h"
#include "quebra/sketch/areas.h"
#include "quebra/sketch/ends.h"
#include "shared/geom/spatial_index.h"

namespace quebra::domain {
namespace {

using dobra::base::Error;
using dobra::base::ErrorCode;
using dobra::base::Place;
using dobra::base::Result;
using dobra::geom::Arc;
using dobra::geom::Box;
using dobra::geom::Point;
using dobra::geom::Polyline;

Point start_of(const sketch::Curve& curve) { return point(curve, 0.0); }
Point end_of(const sketch::Curve& curve) { return point(curve, length(curve)); }

Place at_point(Place place, Point p) {
  place.x = p.x;
  place.y = p.y;
  return place;
}

/// The curves of loops that meet at each point.
using Joints = std::map<Point, std::vector<Domain::Side>>;

Joints joints_of(const std::vector<sketch::Curve>& curves) {
  Joints joints;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (!bounds(curves[i]) || closed(curves[i])) continue;
    joints[start_of(curves[i])].push_back({i, false});
    joints[end_of(curves[i])].push_back({i, true});
  }
  return joints;
}

Result<void> check_joints(const Joints& joints, const std::vector<sketch::Curve>& curves,
                          const std::vector<Place>& places) {
  for (const auto& [at, sides] : joints) {
    const std::string& name = curves[sides.front().curve].name;
    const Place place = at_point(places[sides.front().curve], at);
    if (sides.size() == 1) {
      return Error{
          ErrorCode::BadDomain,
          fmt::format("curve '{}' ends where no other curve begins; close the loop or give it role = \"internal\"",
                      name),
          place};
    }
    if (sides.size() > 2) {
      return Error{ErrorCode::BadDomain,
                   fmt::format("{} boundary curves meet in one point, '{}' among them; a loop passes a point once",
                               sides.size(), name),
                   place};
    }
  }
  return {};
}

std::vector<Domain::Loop> follow_loops(const std::vector<sketch::Curve>& curves, const Joints& joints) {
  std::vector<Domain::Loop> loops;
  std::vector<bool> used(curves.size(), false);
  for (std::size_t first = 0; first < curves.size(); ++first) {
    if (used[first] || !bounds(curves[first])) continue;
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

Result<void> check_doubles(const std::vector<sketch::Curve>& curves, const std::vector<Place>& places) {
  std::map<sketch::ShapeKey, std::size_t> known;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto [first, is_new] = known.try_emplace(shape_key(curves[i]), i);
    if (is_new) continue;
    return Error{ErrorCode::BadDomain,
                 fmt::format("curves '{}' and '{}' are identical; remove one of them, or give --repair (repair = "
                             "\"yes\"), which leaves the second out",
                             curves[first->second].name, curves[i].name),
                 at_point(places[i], start_of(curves[i]))};
  }
  return {};
}

/// No curve bounds the domain: which ends come nearest to each other, and what to do.
Error nothing_closes(const Domain& domain, Place place, const std::optional<sketch::RepairOptions>& repaired) {
  const double size = domain.box().diagonal();
  std::string nearest;
  const std::vector<sketch::End> ends = open_ends(domain.curves);
  // Only the nearest pair is wanted: of many ends few are looked at.
  for (double limit = 1e-4 * size; nearest.empty() && limit < 0.2 * size; limit *= 10.0) {
    for (const auto& [gap, a, b] : near_ends(ends, limit)) {
      if (!(gap > 0.0)) continue;
      nearest = fmt::format("the ends nearest to each other leave {}: {}; ", gap_text(domain.curves, ends[a], ends[b]),
                            gap_advice(gap, size, repaired));
      place = at_point(place, ends[a].at);
      break;
    }
  }
  return {ErrorCode::BadDomain,
          fmt::format("no curve closes, so nothing bounds the domain; {}{}if each line is an outline without its last "
                      "side, give --closed (closed = \"yes\")",
                      nearest,
                      repaired ? "" : "if sides are drawn past their corners, --repair (repair = \"yes\") cuts them; "),
          place};
}

/// The loops of the boundary curves, each with its depth.
Result<Inside> find_loops(Domain& domain, const std::vector<Place>& places, const DomainOptions& options) {
  const Joints joints = joints_of(domain.curves);
  DOBRA_TRY_VOID(check_joints(joints, domain.curves, places));
  domain.loops = follow_loops(domain.curves, joints);
  if (domain.loops.empty()) return nothing_closes(domain, places.front(), options.repaired);
  Inside inside(domain);
  for (std::size_t i = 0; i < domain.loops.size(); ++i) {
    domain.loops[i].depth = static_cast<int>(inside.loops_around(inside.contours()[i].points.front()).size());
  }
  return inside;
}

/// Leaves out what two holes share. @return whether there is any: the loops must be followed anew.
bool drop_between_holes(Domain& domain, sketch::Sketch& sketch, const Inside& inside) {
  bool any = false;
  for (std::size_t i = domain.curves.size(); i-- > 0;) {
    const sketch::Curve& curve = domain.curves[i];
    if (!sketch.interfaces.contains(curve.name) || inside(point(curve, 0.5 * length(curve)))) continue;
    domain.curves.erase(domain.curves.begin() + static_cast<std::ptrdiff_t>(i));
    sketch.places.erase(sketch.places.begin() + static_cast<std::ptrdiff_t>(i));
    any = true;
  }
  return any;
}

Result<void> check_roles(const Domain& domain, const Inside& inside, const std::vector<Place>& places,
                         const DomainOptions& options) {
  for (const auto& loop : domain.loops) {
    for (const auto& side : loop.sides) {
      const sketch::Curve& curve = domain.curves[side.curve];
      if (curve.role == sketch::Role::Hole && loop.depth % 2 == 0) {
        return Error{ErrorCode::OutsideDomain,
                     fmt::format("hole '{}' lies outside the domain; move it inside or remove it", curve.name),
                     at_point(places[side.curve], start_of(curve))};
      }
    }
  }
  for (std::size_t i = 0; i < domain.curves.size(); ++i) {
    const sketch::Curve& curve = domain.curves[i];
    if (bounds(curve)) continue;
    // Between one junction and the next a curve lies on one side of the boundary.
    std::vector<double> cuts{0.0, length(curve)};
    for (const Junction& junction : domain.junctions) {
      if (junction.curve == i) cuts.push_back(junction.s);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const Point middle = point(curve, 0.5 * (cuts[k] + cuts[k + 1]));
      if (cuts[k + 1] - cuts[k] <= 1e-9 * cuts.back() || inside(middle)) continue;
      if (auto open = open_outline(domain.curves, places, inside, options.repaired)) return *std::move(open);
      return Error{ErrorCode::OutsideDomain,
                   fmt::format("{} '{}' lies outside the domain{}; trim it at the boundary or remove it",
                               curve.role == sketch::Role::Crack ? "crack" : "internal line", curve.name,
                               cuts.size() > 2 ? " in part" : ""),
                   at_point(places[i], middle)};
    }
  }
  return {};
}

}  // namespace

Box Domain::box() const {
  Box box;
  for (const sketch::Curve& curve : curves) box.add(box_of(curve));
  return box;
}

std::vector<std::uint8_t> Domain::lone_circles(double margin) const {
  std::vector<Point> at;
  for (const sketch::NamedPoint& named : points) at.push_back(named.at);
  return sketch::lone_circles(curves, at, margin);
}

Polyline contour(const Domain& domain, const Domain::Loop& loop) {
  Polyline result;
  result.closed = true;
  for (const auto& side : loop.sides) {
    Polyline line = trace(domain.curves[side.curve]).line;
    if (line.closed) return line;
    if (side.backwards) line = reversed(std::move(line));
    result.points.insert(result.points.end(), line.points.begin(), line.points.end() - 1);
  }
  return result;
}

Inside::Inside(const Domain& domain) {
  std::vector<Box> boxes;
  for (const auto& loop : domain.loops) {
    contours_.push_back(contour(domain, loop));
    boxes.push_back(contours_.back().box());
  }
  boxes_ = dobra::geom::SpatialIndex(boxes);
}

bool Inside::operator()(Point p) const {
  bool inside = false;
  bool on_boundary = false;
  boxes_.for_each_overlapping({p, p}, [&](std::size_t loop) {
    const auto side = dobra::geom::locate(contours_[loop], p);
    on_boundary = side == dobra::geom::Side::Boundary;
    if (side == dobra::geom::Side::Inside) inside = !inside;
    return on_boundary ? dobra::geom::Visit::Stop : dobra::geom::Visit::Continue;
  });
  return inside && !on_boundary;
}

std::vector<std::size_t> Inside::loops_around(Point p) const {
  std::vector<std::size_t> loops = boxes_.overlapping({p, p});
  std::erase_if(loops,
                [&](std::size_t loop) { return dobra::geom::locate(contours_[loop], p) != dobra::geom::Side::Inside; });
  return loops;
}

Result<Domain> make_domain(sketch::Sketch sketch, const DomainOptions& options) {
  const std::vector<Place>& places = sketch.places;
  if (sketch.curves.empty())
    return Error{ErrorCode::BadDomain, "the domain has no curve; add [[input.curve]], a file or a specimen"};
  Box box;
  for (const sketch::Curve& curve : sketch.curves) box.add(box_of(curve));
  constexpr double least_size = 1e-100;  // products of three lengths stay far from underflow
  const double extent = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  if (extent > 0.0 && extent < least_size)
    return Error{ErrorCode::BadDomain, fmt::format("the domain is only {:.3g} m large; use smaller units", extent),
                 places.front()};
  const double tolerance = options.join_tolerance * box.diagonal();
  for (std::size_t i = 0; i < sketch.curves.size(); ++i) {
    const sketch::Curve& curve = sketch.curves[i];
    if (length(curve) <= tolerance) {
      const double own = length(curve);
      const std::string what = own > 0.0 ? fmt::format(
                                               "is only {:.3g} m long, and points within {:.3g} m (join_tolerance) are "
                                               "one; make it longer or remove it",
                                               own, tolerance)
                                         : "has no length; remove it";
      return Error{ErrorCode::DegenerateCurve, fmt::format("curve '{}' {}", curve.name, what),
                   at_point(places[i], start_of(curve))};
    }
    if (curve.role == sketch::Role::Crack && closed(curve)) {
      return Error{ErrorCode::BadDomain, fmt::format("crack '{}' is closed; a crack has two ends", curve.name),
                   at_point(places[i], start_of(curve))};
    }
  }
  part_shared_sides(sketch, tolerance);
  DOBRA_TRY_VOID(check_doubles(sketch.curves, places));
  find_roles(sketch, tolerance);
  Domain domain;
  domain.curves = std::move(sketch.curves);
  domain.points = std::move(sketch.points);
  domain.regions = sketch.regions;
  DOBRA_TRY(Inside inside, find_loops(domain, places, options));
  if (drop_between_holes(domain, sketch, inside)) {
    DOBRA_TRY(inside, find_loops(domain, places, options));
  }
  if (sketch.hole_points) {
    DOBRA_TRY_VOID(apply_hole_points(domain, inside, *sketch.hole_points));
    DOBRA_TRY(inside, find_loops(domain, places, options));
  }
  DOBRA_TRY_VOID(find_junctions(domain, places, tolerance));
  DOBRA_TRY_VOID(check_roles(domain, inside, places, options));
  DOBRA_TRY_VOID(find_faces(domain, inside, sketch.regions, sketch.areas));
  return domain;
}

}  // namespace quebra::domain
