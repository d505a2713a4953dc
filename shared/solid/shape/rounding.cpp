#include "shared/solid/shape/rounding.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "shared/solid/boolean.h"
#include "shared/solid/shape/convex_cutter.h"

namespace dobra::solid::shape {
namespace {

using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;
using geom::Sign;
using geom::Vector3;

/// A face's plane in doubles: unit normal, and how far it is from the origin.
struct Side {
  Vector3 normal;
  double height = 0.0;
};

double height_of(const std::vector<Point3>& points, Vector3 normal) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Point3 p : points) most = std::max(most, dot(p - Point3{}, normal));
  return most;
}

std::vector<Point3> points_of(const Solid& solid) {
  std::vector<Point3> points;
  for (std::uint32_t h = 0; h < solid.boundary().mates.size(); ++h) points.push_back(solid.point(HalfEdgeId(h)));
  return points;
}

/// Exact: every corner lies on or below every face.
Result<void> check_convex(const Solid& solid) {
  const Soup& soup = solid.boundary().soup;
  for (std::size_t f = 0; f < solid.face_count(); ++f) {
    for (std::size_t h = 0; h < soup.corners.size(); ++h) {
      if (soup.space.side(soup.facets[f].plane, soup.corners[h]) != Sign::Positive) continue;
      const Point3 at = soup.space.rounded(soup.corners[h]);
      return Error{ErrorCode::InvalidOption,
                   fmt::format("only convex solids are rounded, and a corner stands out over face '{}'",
                               solid.name(FaceId(static_cast<std::uint32_t>(f)))),
                   base::Place{.x = at.x, .y = at.y, .z = at.z}};
    }
  }
  return {};
}

Vector3 between(Vector3 a, Vector3 b, double t) {
  const double angle = std::atan2(length(cross(a, b)), dot(a, b));
  if (angle == 0.0) return a;
  return normalised(std::sin((1.0 - t) * angle) / std::sin(angle) * a + std::sin(t * angle) / std::sin(angle) * b);
}

/// Normals of the planes that round the edges and the corners.
std::vector<Vector3> new_normals(const Solid& solid, const std::vector<Side>& sides, int segments) {
  std::vector<Vector3> normals;
  const auto normal = [&](HalfEdgeId h) { return sides[solid.face(h).index()].normal; };
  const auto count = static_cast<std::uint32_t>(solid.boundary().mates.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const HalfEdgeId h(i);
    if (solid.mate(h).index() < i) continue;
    for (int k = 1; k < segments; ++k)
      normals.push_back(between(normal(h), normal(solid.mate(h)), static_cast<double>(k) / segments));
  }
  std::vector<char> done(solid.vertex_count(), 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const HalfEdgeId first(i);
    if (std::exchange(done[solid.origin(first).index()], 1) != 0) continue;
    std::vector<Vector3> round;
    Vector3 sum{};
    HalfEdgeId h = first;
    do {
      round.push_back(normal(h));
      sum = sum + normal(h);
      h = solid.next(solid.mate(h));
    } while (h != first);
    // A fan of triangles about the mean; of each the points inside and on the spoke that it begins with.
    const Vector3 mean = normalised(sum);
    normals.push_back(mean);
    for (std::size_t c = 0; c < round.size(); ++c) {
      for (int row = 1; row < segments; ++row) {
        const double out = static_cast<double>(row) / segments;
        const Vector3 a = between(mean, round[c], out);
        const Vector3 b = between(mean, round[(c + 1) % round.size()], out);
        for (int k = 0; k < row; ++k) normals.push_back(between(a, b, static_cast<double>(k) / row));
      }
    }
  }
  return normals;
}

/// Neighbours in one plane, of different names.
bool has_flat_edges(const Solid& solid) {
  const auto& across = solid.boundary().soup.across;
  return std::any_of(across.begin(), across.end(), [](PlaneId plane) { return !plane.valid(); });
}

/// Where several faces of the solid lie in one plane, the rounded one has one face for them all.
Result<Solid> with_its_faces(const Solid& solid, const Solid& rounded) {
  DOBRA_TRY(Combined both, combine(std::array{solid, rounded}, Operation::Intersection));
  return std::move(both.solid);
}

}  // namespace

Result<Solid> round_convex(const Solid& solid, const RoundOptions& options) {
  if (!std::isfinite(options.radius) || options.radius <= 0.0)
    return Error{ErrorCode::InvalidOption, fmt::format("radius is {}; it must be above 0", options.radius)};
  if (options.segments < 2 || options.segments > 64)
    return Error{ErrorCode::InvalidOption, fmt::format("segments is {}; give 2 to 64", options.segments)};
  if (solid.shell_count() != 1)
    return Error{ErrorCode::InvalidOption,
                 fmt::format("only convex solids are rounded; this one has {} shells", solid.shell_count())};
  DOBRA_TRY_VOID(check_convex(solid));
  const std::vector<Point3> corners = points_of(solid);
  std::vector<Side> sides;
  for (std::uint32_t f = 0; f < solid.face_count(); ++f) {
    const Vector3 n = normalised(solid.space().rough_normal(solid.boundary().soup.facets[f].plane));
    sides.push_back({n, height_of(corners, n)});
  }
  double size = options.radius;
  for (const Point3 p : corners) size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  const double reach = 4.0 * size;
  // Where the centre of the ball can be.
  ConvexCutter core(reach);
  for (const Side& side : sides)
    core.cut(CutPlane{side.normal.x, side.normal.y, side.normal.z, options.radius - side.height}, "");
  const std::vector<Point3> centres = core.corners();
  for (std::uint32_t f = 0; f < sides.size(); ++f) {
    if (!core.empty() && height_of(centres, sides[f].normal) + options.radius >= sides[f].height - 1e-9 * size)
      continue;
    return Error{ErrorCode::InvalidOption, fmt::format("radius {} is too large: nothing would be left of face '{}'",
                                                       options.radius, solid.name(FaceId(f)))};
  }
  const Soup& soup = solid.boundary().soup;
  ConvexCutter rounded(reach);
  for (std::uint32_t f = 0; f < solid.face_count(); ++f)
    rounded.cut(soup.space.plane(soup.facets[f].plane), solid.name(FaceId(f)));
  for (const Vector3 n : new_normals(solid, sides, options.segments))
    rounded.cut(CutPlane{n.x, n.y, n.z, -(height_of(centres, n) + options.radius)}, options.name);
  return has_flat_edges(solid) ? with_its_faces(solid, rounded.solid()) : rounded.solid();
}

}  // namespace dobra::solid::shape
