#include "quebra/surfaces/curve_params.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace quebra::surfaces {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;
using geom::Vector3;
using surf::Curve;

namespace {

/// Through three points, as part of their circle.
Result<Curve> make_arc(const std::vector<Point3>& points) {
  if (points.size() != 3) return lacking("an arc has three `points`: the first, one on the way, and the last");
  const Vector3 a = points[1] - points[0], b = points[2] - points[0];
  const Vector3 normal = cross(a, b);
  const double size = std::max(length(a), length(b));
  if (length(normal) <= 1e-12 * size * size) return lacking("the three `points` of the arc are on one line");
  const double square = dot(normal, normal);
  const Vector3 to_centre =
      (dot(a, a) / (2.0 * square)) * cross(b, normal) + (dot(b, b) / (2.0 * square)) * cross(normal, a);
  const Point3 centre = points[0] + to_centre;
  const Vector3 along = points[0] - centre;
  const Vector3 across = cross(normalised(normal), along);
  const Vector3 last = points[2] - centre;
  double sweep = std::atan2(dot(last, across), dot(last, along));
  if (sweep <= 0.0) sweep += 2.0 * std::numbers::pi;
  return Curve::arc(centre, along, across, 0.0, sweep);
}

Result<Curve> make_circle(const SpaceCurveParams& params) {
  if (!params.centre || !params.radius) return lacking("a circle needs `centre` and `radius`");
  DOBRA_TRY(const Axes axes, make_axes(params.axis, params.x_axis));
  return Curve::arc(*params.centre, *params.radius * axes.x, *params.radius * axes.y, params.start.radians(),
                    params.start.radians() + params.sweep.radians());
}

}  // namespace

Result<Axes> make_axes(const std::optional<Point3>& axis, const std::optional<Point3>& x_axis) {
  const auto vector = [](const Point3& p) { return Vector3{p.x, p.y, p.z}; };
  const Vector3 given = axis ? vector(*axis) : Vector3{0.0, 0.0, 1.0};
  if (!(length(given) > 0.0)) return Error{ErrorCode::DegenerateCurve, "`axis` has no length"};
  const Vector3 z = normalised(given);
  const Vector3 wanted =
      x_axis ? vector(*x_axis) : (std::abs(z.x) < 0.9 ? Vector3{1.0, 0.0, 0.0} : Vector3{0.0, 1.0, 0.0});
  const Vector3 square = wanted - dot(wanted, z) * z;
  if (!(length(square) > 1e-9 * length(wanted)))
    return Error{ErrorCode::DegenerateCurve, "`x_axis` has no length or lies along `axis`; give another direction"};
  const Vector3 x = normalised(square);
  return Axes{x, cross(z, x), z};
}

Result<Curve> make_space_curve(const SpaceCurveParams& params) {
  switch (params.kind) {
    case SpaceCurveKind::Line:
      break;
    case SpaceCurveKind::Arc:
      return make_arc(params.points);
    case SpaceCurveKind::Circle:
      return make_circle(params);
    case SpaceCurveKind::Bezier:
      if (params.points.size() < 2) return lacking("a Bezier curve needs two `points` or more");
      return Curve::bezier(params.points, params.weights);
    case SpaceCurveKind::Nurbs:
      return Curve::nurbs(static_cast<std::size_t>(params.degree), params.knots, params.points, params.weights);
    case SpaceCurveKind::Spline:
      return Curve::through(params.points);
  }
  if (params.points.size() < 2) return lacking("a line needs two `points` or more");
  return params.points.size() == 2 ? Curve::line(params.points[0], params.points[1]) : Curve::polyline(params.points);
}

}  // namespace quebra::surfaces
