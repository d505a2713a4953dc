#include "shared/surf/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/geom/arc_length.h"
#include "shared/surf/homogeneous.h"

namespace dobra::surf {

using base::Error;
using base::ErrorCode;
using geom::Point3;
using geom::Vector3;

namespace {

struct LineShape : Curve::Shape {
  Point3 from;
  Vector3 by;
  LineShape(Point3 begin, Vector3 way) : from(begin), by(way) {}
  [[nodiscard]] Curve::Jet jet(double t) const override { return {from + t * by, by, {}}; }
  [[nodiscard]] double bend(double, double) const override { return 0.0; }
};

struct ArcShape : Curve::Shape {
  Point3 centre;
  Vector3 along, across;
  ArcShape(Point3 middle, Vector3 first, Vector3 second) : centre(middle), along(first), across(second) {}
  [[nodiscard]] Curve::Jet jet(double t) const override {
    const double c = std::cos(t), s = std::sin(t);
    const Vector3 out = c * along + s * across;
    return {centre + out, c * across - s * along, -out};
  }
  /// The longer half axis.
  [[nodiscard]] double bend(double, double) const override {
    const double e = dot(along, along), f = dot(along, across), g = dot(across, across);
    return std::sqrt(0.5 * (e + g) + std::hypot(0.5 * (e - g), f)) * (1.0 + 1e-9);
  }
};

struct SplineShape : Curve::Shape {
  SplineBasis basis;
  std::vector<Homogeneous> points;
  SplineShape(SplineBasis functions, std::vector<Homogeneous> control)
      : basis(std::move(functions)), points(std::move(control)) {}
  [[nodiscard]] Curve::Jet jet(double t) const override {
    const SplineBasis::Values values = basis.at(t);
    std::array<Homogeneous, 3> sum{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i <= basis.degree(); ++i) sum[k] += values.of[k][i] * points[values.first + i];
    }
    const Point3 at = sum[0].point();
    const Vector3 first = (sum[1].vector() - sum[1].w * from_origin(at)) / sum[0].w;
    const Vector3 second = (sum[2].vector() - 2.0 * sum[1].w * first - sum[2].w * from_origin(at)) / sum[0].w;
    return {at, first, second};
  }
  [[nodiscard]] double bend(double from, double to) const override {
    double most = 0.0;
    for (const auto& [a, b] : basis.pieces(from, to)) {
      const std::vector<Homogeneous> net = bezier_net(basis, points, a, b);
      most = std::max(most, NetBounds(net, net.size(), 1).uu / ((b - a) * (b - a)));
    }
    return most;
  }
};

}  // namespace

base::Result<std::vector<Homogeneous>> homogeneous(const std::vector<Point3>& points, std::vector<double> weights,
                                                   std::size_t wanted) {
  if (points.size() != wanted)
    return Error{ErrorCode::InvalidOption,
                 fmt::format("{} control points, but degree and knots ask for {}", points.size(), wanted)};
  if (weights.empty()) weights.assign(wanted, 1.0);
  if (weights.size() != wanted)
    return Error{ErrorCode::InvalidOption, fmt::format("{} weights for {} control points", weights.size(), wanted)};
  std::vector<Homogeneous> made;
  made.reserve(wanted);
  for (std::size_t i = 0; i < wanted; ++i) {
    if (!geom::is_finite(points[i]))
      return Error{ErrorCode::NotFinite, fmt::format("control point {} is not finite", i + 1)};
    if (!(weights[i] > 0.0) || !std::isfinite(weights[i]))
      return Error{ErrorCode::InvalidOption, fmt::format("weight {} is {}; weights are above 0", i + 1, weights[i])};
    made.push_back(weights[i] * Homogeneous{points[i].x, points[i].y, points[i].z, 1.0});
  }
  return made;
}

double extent(const std::vector<Homogeneous>& points) {
  Point3 low = points.front().point(), high = low;
  for (const Homogeneous& each : points) {
    const Point3 p = each.point();
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return geom::distance(low, high);
}

base::Result<Curve> Curve::line(Point3 from, Point3 to) {
  if (!geom::is_finite(from) || !geom::is_finite(to))
    return Error{ErrorCode::NotFinite, "an end of the line is not finite"};
  if (from == to) return Error{ErrorCode::DegenerateCurve, "the ends of the line are the same point"};
  return Curve(std::make_shared<const LineShape>(from, to - from), {0.0, 1.0});
}

base::Result<Curve> Curve::arc(Point3 centre, Vector3 along, Vector3 across, double from, double to) {
  if (!geom::is_finite(centre) || !geom::is_finite(along) || !geom::is_finite(across) || !std::isfinite(from) ||
      !std::isfinite(to))
    return Error{ErrorCode::NotFinite, "the arc has a number that is not finite"};
  const double radius = geom::length(along);
  if (!(radius > 0.0)) return Error{ErrorCode::DegenerateCurve, "the arc has no radius"};
  constexpr double square = 1e-9;
  if (std::abs(geom::length(across) - radius) > square * radius ||
      std::abs(geom::dot(along, across)) > square * radius * radius)
    return Error{ErrorCode::DegenerateCurve, "the axes of the arc are not of one length at a right angle"};
  if (!(to > from) || to - from > 2.0 * std::numbers::pi * (1.0 + 1e-12))
    return Error{ErrorCode::DegenerateCurve,
                 fmt::format("the arc goes from {} to {} radians; it must go on, and a full "
                             "turn at most",
                             from, to)};
  return Curve(std::make_shared<const ArcShape>(centre, along, across), {from, to});
}

base::Result<Curve> Curve::ellipse(Point3 centre, Vector3 along, Vector3 across, double from, double to) {
  if (!geom::is_finite(centre) || !geom::is_finite(along) || !geom::is_finite(across) || !std::isfinite(from) ||
      !std::isfinite(to))
    return Error{ErrorCode::NotFinite, "the ellipse has a number that is not finite"};
  if (!(geom::length(cross(along, across)) > 1e-12 * geom::length(along) * geom::length(across)))
    return Error{ErrorCode::DegenerateCurve,
                 "the axes of the ellipse lie along one line; give two of other directions"};
  if (!(to > from) || to - from > 2.0 * std::numbers::pi * (1.0 + 1e-12))
    return Error{
        ErrorCode::DegenerateCurve,
        fmt::format("the ellipse goes from {} to {} radians; it must go on, and a full turn at most", from, to)};
  return Curve(std::make_shared<const ArcShape>(centre, along, across), {from, to});
}

base::Result<Curve> Curve::nurbs(std::size_t degree, std::vector<double> knots, std::vector<Point3> points,
                                 std::vector<double> weights) {
  DOBRA_TRY(SplineBasis basis, SplineBasis::make(degree, std::move(knots), "knots"));
  DOBRA_TRY(std::vector<Homogeneous> control, homogeneous(points, std::move(weights), basis.count()));
  for (const std::size_t i : basis.jumps()) {
    const double gap = geom::distance(control[i - 1].point(), control[i].point());
    if (gap > 1e-12 * extent(control))
      return Error{ErrorCode::DegenerateCurve,
                   fmt::format("the curve is torn at {}, where knot {} stands {} times: control points {} and {} are "
                               "{:.6g} m apart; give them one place",
                               basis.knots()[i], i + 1, degree + 1, i, i + 1, gap)};
  }
  std::vector<double> breaks = basis.breaks();
  return Curve(std::make_shared<const SplineShape>(std::move(basis), std::move(control)), std::move(breaks));
}

base::Result<Curve> Curve::bezier(std::vector<Point3> points, std::vector<double> weights) {
  if (points.size() < 2) return Error{ErrorCode::DegenerateCurve, "a Bezier curve has two points at least"};
  std::vector<double> knots(points.size(), 0.0);
  knots.resize(2 * points.size(), 1.0);
  const std::size_t degree = points.size() - 1;
  return nurbs(degree, std::move(knots), std::move(points), std::move(weights));
}

double Curve::length(double from, double to) const {
  const auto speed = [this](double t) { return geom::length(jet(t).first); };
  double sum = 0.0;
  const double a = std::min(from, to), b = std::max(from, to);
  double last = a;
  for (const double knot : breaks_) {
    if (knot <= last || knot >= b) continue;
    sum += geom::arc_length(speed, last, knot);
    last = knot;
  }
  sum += geom::arc_length(speed, last, b);
  return to < from ? -sum : sum;
}

}  // namespace dobra::surf
