#include "shared/solid/shape/profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "shared/solid/placement.h"
#include "shared/solid/shape/contours.h"

namespace dobra::solid::shape {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using geom::Vector3;

/// The sides between two copies of the contours, the second farther along the direction from which they run
/// anticlockwise.
void add_sides(Maker& maker, const std::vector<Contour>& contours, const Rings& from, const Rings& to) {
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const std::size_t n = from[c].size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      maker.face({{from[c][i], from[c][j], to[c][j], to[c][i]}}, contours[c].names[i]);
    }
  }
}

/// Why the path folds, if it does so at a corner or has a leg without length.
std::optional<Error> fold_of(const std::vector<Point3>& path) {
  const auto refuse = [&](std::size_t i, const char* why) {
    return Error{ErrorCode::InvalidOption, fmt::format("the path folds at its point {}: {}", i + 1, why),
                 at_point(path[i])};
  };
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    if (path[i] == path[i + 1]) return refuse(i + 1, "it lies at the place of the one before; leave it out");
  }
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Vector3 in = path[i] - path[i - 1];
    const Vector3 out = path[i + 1] - path[i];
    const Vector3 across = cross(in, out);
    if (dot(in, out) < 0.0 && length(across) <= 1e-9 * length(in) * length(out))
      return refuse(i, "it turns straight back");
  }
  return std::nullopt;
}

}  // namespace

Result<Solid> solid_of(const Shape& shape, const std::string& prefix) {
  FromMeshOptions options;
  options.face_names = shape.names;
  if (!prefix.empty()) {
    for (std::string& name : options.face_names) name = prefix + '_' + name;
  }
  return from_loops(shape.mesh, options);
}

Result<Shape> extrude(const Profile& profile, Vector3 along, SideNames names) {
  if (!std::isfinite(along.x) || !std::isfinite(along.y) || !std::isfinite(along.z))
    return Error{ErrorCode::NotFinite, "the vector of an extrusion has no finite numbers"};
  if (along.z == 0.0) {
    return Error{ErrorCode::InvalidOption,
                 "the vector of an extrusion lies in the plane of its profile, so that nothing would have volume; give "
                 "it a third number"};
  }
  const auto contours = contours_of(profile, names);
  if (!contours) return put_in_space(contours.error(), flat);
  Maker maker(along.z < 0.0);
  const Rings low = rings_at(maker, *contours, flat);
  const Rings high = rings_at(maker, *contours, [&](Point p) { return flat(p) + along; });
  DOBRA_TRY_VOID(check_apart(maker, high));
  maker.face(reversed(low), along.z < 0.0 ? "top" : "bottom");
  maker.face(high, along.z < 0.0 ? "bottom" : "top");
  add_sides(maker, *contours, low, high);
  return maker.take();
}

Result<Shape> draw_to_point(const Profile& profile, Point3 apex, SideNames names) {
  if (!profile.holes.empty())
    return Error{ErrorCode::InvalidOption, "a profile with holes cannot be drawn to a point: subtract what is hollow"};
  if (!std::isfinite(apex.x) || !std::isfinite(apex.y) || !std::isfinite(apex.z))
    return Error{ErrorCode::NotFinite, "the point of a pyramid has no finite numbers"};
  if (apex.z == 0.0) return Error{ErrorCode::InvalidOption, "the point of a pyramid lies in the plane of its profile"};
  const auto contours = contours_of(profile, names);
  if (!contours) return put_in_space(contours.error(), flat);
  Maker maker(apex.z < 0.0);
  const Rings base = rings_at(maker, *contours, flat);
  const std::uint32_t top = maker.point(apex);
  maker.face(reversed(base), apex.z < 0.0 ? "top" : "bottom");
  for (std::size_t i = 0; i < base[0].size(); ++i)
    maker.face({{base[0][i], base[0][(i + 1) % base[0].size()], top}}, (*contours)[0].names[i]);
  return maker.take();
}

Result<Shape> sweep(const Profile& profile, const std::vector<Point3>& path, SideNames names) {
  if (path.size() < 2) return Error{ErrorCode::InvalidOption, "a path needs two points or more"};
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!std::isfinite(path[i].x) || !std::isfinite(path[i].y) || !std::isfinite(path[i].z))
      return Error{ErrorCode::NotFinite, fmt::format("point {} of the path has no finite numbers", i + 1)};
  }
  if (auto fold = fold_of(path)) return *std::move(fold);
  if (path.front() == path.back()) {
    return Error{ErrorCode::InvalidOption, "the path comes back to its first point; sweep it in two parts",
                 at_point(path.back())};
  }
  Vector3 leg = normalised(path[1] - path[0]);
  const Vector3 level = cross({0, 0, 1}, leg);
  const Vector3 x = length(level) <= 1e-12 ? Vector3{leg.z < 0.0 ? -1.0 : 1.0, 0, 0} : normalised(level);
  const Vector3 y = cross(leg, x);
  const auto at_start = [&](Point p) { return path[0] + p.x * x + p.y * y; };
  const auto contours = contours_of(profile, names);
  if (!contours) return put_in_space(contours.error(), at_start);
  // Of each contour's points, where its line stands now.
  std::vector<std::vector<Point3>> now;
  for (const Contour& contour : *contours) {
    auto& places = now.emplace_back();
    for (const Point p : contour.points) places.push_back(at_start(p));
  }
  Maker maker;
  const auto ring_points = [&] {
    Rings rings;
    for (const auto& places : now) {
      Ring& ring = rings.emplace_back();
      for (const Point3 p : places) ring.push_back(maker.point(p));
    }
    return rings;
  };
  Rings before = ring_points();
  maker.face(reversed(before), "start");
  for (std::size_t k = 1; k < path.size(); ++k) {
    const Vector3 next = k + 1 < path.size() ? normalised(path[k + 1] - path[k]) : leg;
    const Vector3 mitre = leg + next;
    for (auto& places : now) {
      for (Point3& p : places) {
        const double way = dot(path[k] - p, mitre) / dot(leg, mitre);
        if (!(way > 0.0)) {
          return Error{ErrorCode::InvalidOption,
                       fmt::format("the path folds at its point {}: the leg before it is too short, or turns too "
                                   "sharply, for a profile that reaches so far from the path",
                                   k + 1),
                       at_point(path[k])};
        }
        p = p + way * leg;
      }
    }
    const Rings after = ring_points();
    DOBRA_TRY_VOID(check_apart(maker, after));
    add_sides(maker, *contours, before, after);
    before = after;
    leg = next;
  }
  maker.face(before, "end");
  return maker.take();
}

Result<Shape> revolve(const geom::Polyline& line, const RevolveOptions& options, SideNames names) {
  const bool whole = options.angle == 360.0;
  if (!(options.angle > 0.0) || options.angle > 360.0)
    return Error{ErrorCode::InvalidOption, "the angle of a revolution must be above 0 and at most 360 degrees"};
  if (options.segments < (whole ? 3 : 1) || options.angle / options.segments >= 180.0) {
    return Error{ErrorCode::InvalidOption,
                 fmt::format("{} segments are too few for a revolution by {} degrees: each must turn by less than 180",
                             options.segments, options.angle)};
  }
  const auto in_space = [](Point p) { return Point3{p.x, 0.0, p.y}; };
  if (const auto checked = check_contour(line, "contour of a revolution", Touching::InPoints); !checked)
    return put_in_space(checked.error(), in_space);
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (line.points[i].x < 0.0) {
      return Error{
          ErrorCode::InvalidOption,
          fmt::format("the contour of a revolution crosses its axis: point {} has radius {}", i + 1, line.points[i].x),
          at_point(in_space(line.points[i]))};
    }
  }
  const Contour contour = turned_contour(line, false, names, "side");
  const std::size_t n = contour.points.size();
  const std::size_t rings = static_cast<std::size_t>(options.segments) + (whole ? 0 : 1);
  Maker maker;
  std::vector<Ring> at(rings, Ring(n, 0));
  for (std::size_t i = 0; i < n; ++i) {
    const Point p = contour.points[i];
    const std::uint32_t on_axis = p.x == 0.0 ? maker.point({0.0, 0.0, p.y}) : 0;
    for (std::size_t k = 0; k < rings; ++k) {
      const auto [c, s] = circle_at(options.angle * static_cast<double>(k) / options.segments);
      at[k][i] = p.x == 0.0 ? on_axis : maker.point({p.x * c, p.x * s, p.y});
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const bool a = contour.points[i].x == 0.0;
    const bool b = contour.points[j].x == 0.0;
    if (a && b) continue;
    for (std::size_t k = 0; k < static_cast<std::size_t>(options.segments); ++k) {
      const std::size_t l = (k + 1) % rings;
      Ring ring{at[k][i]};
      if (!a) ring.push_back(at[l][i]);
      ring.push_back(at[l][j]);
      if (!b) ring.push_back(at[k][j]);
      maker.face({ring}, contour.names[i]);
    }
  }
  if (!whole) {
    maker.face({at.front()}, "start");
    maker.face(reversed({at.back()}), "end");
  }
  return maker.take();
}

}  // namespace dobra::solid::shape
