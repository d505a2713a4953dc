#include "quebra/surfaces/trim_params.h"

#include <cmath>
#include <numbers>

namespace quebra::surfaces {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using surf::Curve;

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

Point3 flat(Point p) { return {p.x, p.y, 0.0}; }
geom::Vector3 flat(geom::Vector v, ChartUnits units) { return {units.u * v.x, units.v * v.y, 0.0}; }

/// Part of the circle through three points as they are written.
Result<Curve> make_arc(const std::vector<Point>& p, ChartUnits units) {
  if (p.size() != 3) return lacking("an arc has three `points`: the first, one on the way, and the last");
  const geom::Vector a = p[1] - p[0], b = p[2] - p[0];
  const double twice = 2.0 * cross(a, b);
  if (std::abs(twice) <= 1e-12 * std::max(dot(a, a), dot(b, b)))
    return lacking("the three `points` of the arc are on one line");
  const Point centre =
      p[0] + geom::Vector{(b.y * dot(a, a) - a.y * dot(b, b)) / twice, (a.x * dot(b, b) - b.x * dot(a, a)) / twice};
  const geom::Vector from = p[0] - centre;
  const double radius = length(from), start = std::atan2(from.y, from.x);
  const geom::Vector last = p[2] - centre;
  double sweep = std::atan2(cross(from, last), dot(from, last));
  if (twice > 0.0 && sweep < 0.0) sweep += turn;
  if (twice < 0.0 && sweep > 0.0) sweep -= turn;
  const double round = sweep < 0.0 ? -1.0 : 1.0;  // clockwise: mirrored, by the negative angle
  return Curve::ellipse(flat(units.in(centre)), flat({radius, 0.0}, units), flat({0.0, round * radius}, units),
                        round * start, round * (start + sweep));
}

}  // namespace

bool is_closed(const TrimParams& params) {
  switch (params.kind) {
    case TrimKind::Polygon:
    case TrimKind::Circle:
    case TrimKind::Ellipse:
      return true;
    case TrimKind::Line:
    case TrimKind::Spline:
    case TrimKind::Bezier:
      return params.points.size() > 2 && params.points.front() == params.points.back();
    default:
      return false;
  }
}

Result<Curve> make_trim_curve(const TrimParams& params, ChartUnits units) {
  if (params.kind == TrimKind::Circle || params.kind == TrimKind::Ellipse) {
    if (!params.centre) return lacking("`centre` is needed");
    double along = 0.0, across = 0.0;
    if (params.kind == TrimKind::Circle) {
      if (!params.radius) return lacking("`radius` is needed");
      along = across = *params.radius;
    } else {
      if (params.radii.size() != 2) return lacking("`radii` must be two numbers, the half axes of the ellipse");
      along = params.radii[0], across = params.radii[1];
    }
    const double c = std::cos(params.rotation.radians()), s = std::sin(params.rotation.radians());
    return Curve::ellipse(flat(units.in(*params.centre)), flat({along * c, along * s}, units),
                          flat({-across * s, across * c}, units), 0.0, turn);
  }
  if (params.kind == TrimKind::Arc) return make_arc(params.points, units);
  SpaceCurveParams curve;
  curve.kind = params.kind == TrimKind::Spline   ? SpaceCurveKind::Spline
               : params.kind == TrimKind::Bezier ? SpaceCurveKind::Bezier
                                                 : SpaceCurveKind::Line;
  for (const Point& p : params.points) curve.points.push_back({units.u * p.x, units.v * p.y, 0.0});
  if (params.kind == TrimKind::Polygon) {
    if (params.points.size() < 3) return lacking("a polygon needs three `points` or more");
    if (params.points.front() != params.points.back()) curve.points.push_back(curve.points.front());
  }
  return make_space_curve(curve);
}

}  // namespace quebra::surfaces
