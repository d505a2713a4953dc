#include "quebra/surfaces/trim_params.h"

#include <cmath>

namespace quebra::surfaces {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point;
using geom::Point3;
using surf::Curve;

namespace {

/// An affine image of the circle in four rational quadratics; exact.
Result<Curve> make_ellipse(Point centre, geom::Vector along, geom::Vector across, ChartUnits units) {
  const double half = std::sqrt(0.5);
  constexpr int corners[9][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
  std::vector<Point3> points;
  std::vector<double> weights;
  for (const auto& [a, b] : corners) {
    const Point p = units.in(centre + (static_cast<double>(a) * along + static_cast<double>(b) * across));
    points.push_back({p.x, p.y, 0.0});
    weights.push_back(a * b == 0 ? 1.0 : half);
  }
  return Curve::nurbs(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, std::move(points), std::move(weights));
}

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
  constexpr double turn = 2.0 * 3.14159265358979323846;
  if (twice > 0.0 && sweep < 0.0) sweep += turn;
  if (twice < 0.0 && sweep > 0.0) sweep -= turn;
  // Pieces below a third of a turn as rational quadratics.
  const int pieces = static_cast<int>(std::ceil(std::abs(sweep) / (turn / 4.0)));
  const double half = 0.5 * sweep / pieces;
  std::vector<Point3> points;
  std::vector<double> weights, knots{0.0};
  for (int i = 0; i <= 2 * pieces; ++i) {
    const double angle = start + i * half, out = i % 2 == 0 ? radius : radius / std::cos(half);
    Point at = centre + geom::Vector{out * std::cos(angle), out * std::sin(angle)};
    if (i == 0) at = p[0];
    if (i == 2 * pieces) at = p[2];
    at = units.in(at);
    points.push_back({at.x, at.y, 0.0});
    weights.push_back(i % 2 == 0 ? 1.0 : std::cos(half));
  }
  for (int i = 0; i <= pieces; ++i) knots.insert(knots.end(), 2, static_cast<double>(i));
  knots.push_back(pieces);
  return Curve::nurbs(2, std::move(knots), std::move(points), std::move(weights));
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
    return make_ellipse(*params.centre, {along * c, along * s}, {-across * s, across * c}, units);
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
