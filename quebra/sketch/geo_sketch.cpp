#include "quebra/sketch/geo_sketch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "quebra/sketch/cubics.h"
#include "quebra/sketch/enclosed.h"

namespace quebra::sketch {
namespace {

using dobra::base::Result;
using dobra::geom::Arc;
using dobra::geom::CubicPath;
using dobra::geom::HermiteCubic;
using dobra::geom::Orientation;
using dobra::geom::Point;
using dobra::geom::Polyline;
using dobra::geom::Segment;
using dobra::geom::Vector;
using dobra::io::drawings::GeoCurve;
using dobra::io::drawings::GeoCurveKind;
using dobra::io::drawings::GeoFile;
using dobra::io::drawings::GeoGroup;

std::vector<Point> points_of(const GeoFile& file, const GeoCurve& curve) {
  std::vector<Point> points;
  for (const std::int64_t tag : curve.points) points.push_back(file.points.at(tag).at);
  return points;
}

/// gmsh's arcs are shorter than half a turn.
Orientation shorter_way(Point centre, Point from, Point to) {
  return cross(from - centre, to - centre) >= 0.0 ? Orientation::Anticlockwise : Orientation::Clockwise;
}

/// The ellipse through both ends with the given centre and direction of its major axis, as cubics.
Result<CubicPath> ellipse(Point from, Point centre, Point on_major, Point to) {
  using dobra::base::Error;
  using dobra::base::ErrorCode;
  const Error bad{ErrorCode::DegenerateCurve, "no ellipse has this centre and major axis and passes both ends"};
  if (on_major == centre) return bad;
  const Vector u = normalised(on_major - centre);
  const Vector v = left_of(u);
  const auto local = [&](Point p) { return Vector{dot(p - centre, u), dot(p - centre, v)}; };
  const Vector a = local(from), b = local(to);
  // x^2 / A + y^2 / B = 1 at both ends, linear in 1 / A and 1 / B; an end on the axis gives it alone.
  const double determinant = a.x * a.x * b.y * b.y - b.x * b.x * a.y * a.y;
  if (determinant == 0.0) return bad;
  const double inverse_a = (b.y * b.y - a.y * a.y) / determinant;
  const double inverse_b = (a.x * a.x - b.x * b.x) / determinant;
  if (!(inverse_a > 0.0) || !(inverse_b > 0.0)) return bad;
  const double rx = 1.0 / std::sqrt(inverse_a), ry = 1.0 / std::sqrt(inverse_b);
  const double start = std::atan2(a.y / ry, a.x / rx);
  double sweep = std::atan2(b.y / ry, b.x / rx) - start;
  sweep = std::remainder(sweep, 2.0 * std::numbers::pi);
  return ellipse_arc({.centre = centre, .u = rx * u, .v = ry * v, .start = start, .sweep = sweep}, from, to);
}

/// gmsh's spline is Catmull and Rom's: at each point the derivative is half the way from the point before to the one
/// behind.
CubicPath catmull_rom(std::vector<Point> p) {
  const std::size_t n = p.size();
  const bool closed = n > 3 && p.front() == p.back();
  const auto slope = [&](std::size_t i) {
    const bool end = i == 0 || i + 1 == n;
    if (closed && end) return 0.5 * (p[1] - p[n - 2]);
    if (end) return i == 0 ? p[1] - p[0] : p[n - 1] - p[n - 2];
    return 0.5 * (p[i + 1] - p[i - 1]);
  };
  std::vector<HermiteCubic> cubics;
  std::vector<double> knots{0.0};
  for (std::size_t i = 0; i + 1 < n; ++i) {
    cubics.push_back({p[i], p[i + 1], slope(i), slope(i + 1)});
    knots.push_back(static_cast<double>(i + 1) / static_cast<double>(n - 1));
  }
  return {std::move(cubics), std::move(knots)};
}

/// gmsh's B-spline begins and ends at its first and last point: those count three times.
Result<CubicPath> b_spline(const std::vector<Point>& p) {
  std::vector<Point> vertices;
  if (p.size() > 3 && p.front() == p.back()) {
    vertices.assign(p.begin(), p.end() - 1);
    vertices.insert(vertices.end(), p.begin(), p.begin() + 3);
  } else {
    vertices.assign(2, p.front());
    vertices.insert(vertices.end(), p.begin(), p.end());
    vertices.insert(vertices.end(), 2, p.back());
  }
  return uniform_b_spline(vertices);
}

Result<Curve> make_curve(const GeoFile& file, std::int64_t tag, const GeoCurve& geo) {
  const std::vector<Point> p = points_of(file, geo);
  Curve curve{fmt::format("curve_{}", tag), Role::Boundary, Polyline{p, false}, {geo.segments, 0.0, geo.ratio}};
  const auto smooth = [&](Result<CubicPath> path) -> Result<Curve> {
    if (!path) return path.error();
    DOBRA_TRY(Smooth made, Smooth::make(*std::move(path)));
    curve.shape = std::move(made);
    return curve;
  };
  switch (geo.kind) {
    case GeoCurveKind::Line:
      break;
    case GeoCurveKind::Circle: {
      DOBRA_TRY(Arc arc, Arc::from_ends(p[1], p[0], p[2], shorter_way(p[1], p[0], p[2]), 1e-6));
      curve.shape = std::move(arc);
      return curve;
    }
    case GeoCurveKind::Ellipse:
      return smooth(ellipse(p[0], p[1], p[2], p[3]));
    case GeoCurveKind::Spline:
      return p.size() > 2 ? smooth(catmull_rom(p)) : Result<Curve>(curve);
    case GeoCurveKind::BSpline:
      return p.size() > 2 ? smooth(b_spline(p)) : Result<Curve>(curve);
    case GeoCurveKind::Bezier:
      return smooth(bezier(p));
  }
  auto line = without_repeated_points(std::get<Polyline>(curve.shape));
  DOBRA_TRY_VOID(validate(line));
  curve.shape = std::move(line);
  return curve;
}

std::string name_of(const GeoGroup& group) {
  return group.name.empty() ? fmt::format("physical_{}", group.tag) : group.name;
}

/// How many surfaces each curve bounds.
std::map<std::int64_t, int> surfaces_at(const GeoFile& file) {
  std::map<std::int64_t, int> count;
  for (const auto& [tag, loops] : file.surfaces) {
    for (const auto& loop : loops) {
      for (const std::int64_t c : loop) ++count[std::abs(c)];
    }
  }
  return count;
}

Point point_inside(const std::vector<std::vector<std::int64_t>>& loops, const std::map<std::int64_t, Curve>& curves) {
  std::vector<Segment> sides;
  for (const auto& loop : loops) {
    for (const std::int64_t c : loop) {
      const Polyline line = trace(curves.at(std::abs(c))).line;
      for (std::size_t i = 0; i < line.segment_count(); ++i) sides.push_back(line.segment(i));
    }
  }
  return inner_point(sides);
}

/// The greatest size that its points want holds along a curve; the smaller ones hold at the points, from which sizes
/// grow.
void take_sizes(const GeoFile& file, const GeoCurve& geo, Curve& curve) {
  double largest = 0.0;
  for (const std::int64_t tag : geo.points) largest = std::max(largest, file.points.at(tag).size);
  if (geo.segments == 0) curve.division.size = largest;
}

}  // namespace

Result<Sketch> sketch_of(GeoFile file, double unit) {
  for (auto& [tag, point] : file.points) {
    point.at = {unit * point.at.x, unit * point.at.y};
    point.size *= unit;
  }
  const auto uses = surfaces_at(file);
  std::set<std::int64_t> embedded, ends;
  for (const auto& [dimension, tag] : file.embedded) {
    if (dimension == 1) embedded.insert(tag);
  }
  Sketch sketch;
  sketch.remarks = std::move(file.remarks);
  std::map<std::int64_t, Curve> all;
  for (const auto& [tag, geo] : file.curves) {
    const auto used = uses.find(tag);
    const bool bounds = file.surfaces.empty() || used != uses.end();
    if (!bounds && !embedded.contains(tag)) {
      sketch.remarks.push_back(
          fmt::format("{}:{}: curve {} belongs to no surface and is left out", geo.place.file, geo.place.line, tag));
      continue;
    }
    auto curve = make_curve(file, tag, geo);
    if (!curve) return located(curve.error(), geo.place);
    if (!bounds || (used != uses.end() && used->second > 1)) curve->role = Role::Internal;
    take_sizes(file, geo, *curve);
    for (const GeoGroup& group : file.groups) {
      if (group.dimension == 1 && std::find(group.entities.begin(), group.entities.end(), tag) != group.entities.end())
        curve->groups.push_back(name_of(group));
    }
    all.emplace(tag, *curve);
    sketch.curves.push_back(*std::move(curve));
    sketch.places.push_back(geo.place);
    ends.insert({geo.points.front(), geo.points.back()});
  }
  for (const GeoGroup& group : file.groups) {
    for (const std::int64_t entity : group.entities) {
      if (group.dimension == 0)
        sketch.points.push_back({name_of(group), file.points.at(entity).at, file.points.at(entity).size});
      if (group.dimension == 2) sketch.regions.push_back({name_of(group), point_inside(file.surfaces.at(entity), all)});
    }
  }
  for (const std::int64_t tag : ends) {
    const auto& p = file.points.at(tag);
    if (p.size > 0.0) sketch.points.push_back({"", p.at, p.size});
  }
  for (const auto& [dimension, tag] : file.embedded) {
    if (dimension == 0)
      sketch.points.push_back({fmt::format("point_{}", tag), file.points.at(tag).at, file.points.at(tag).size});
  }
  return sketch;
}

}  // namespace quebra::sketch
