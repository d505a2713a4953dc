#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "shared/io/faces/geometry.h"

namespace dobra::io::faces {

using base::Result;
using geom::Box;
using geom::Point;
using geom::Point3;
using geom::Vector3;
using surf::Surface;

namespace {

constexpr double pi = std::numbers::pi;
constexpr Box everywhere{{-endless, -endless}, {endless, endless}};

/// Unit axes at right angles, as far as rounding goes.
bool is_motion(const brep::Placement& p) {
  constexpr double close = 1e-9;
  return std::abs(length(p.x) - 1.0) < close && std::abs(length(p.y) - 1.0) < close &&
         std::abs(length(p.z) - 1.0) < close && std::abs(dot(p.x, p.y)) < close && std::abs(dot(p.y, p.z)) < close &&
         std::abs(dot(p.z, p.x)) < close;
}

/// Files write axes with as many digits as they like: made unit and square, from the axis on.
Result<surf::Frame> squared(const brep::Elementary& surface) {
  const auto flat = [](Vector3 a) { return !(length(a) > 0.0) || !geom::is_finite(a); };
  const base::Error error{base::ErrorCode::DegenerateCurve, "the axes of the surface are parallel, or have no length"};
  if (flat(surface.z) || flat(surface.x) || flat(surface.y)) return error;
  const Vector3 z = normalised(surface.z);
  const Vector3 x = surface.x - dot(surface.x, z) * z;
  if (!(length(x) > 1e-9 * length(surface.x))) return error;
  const Vector3 unit = normalised(x), y = cross(z, unit);
  const double side = dot(y, surface.y);
  if (!(std::abs(side) > 1e-9 * length(surface.y))) return error;
  return surf::Frame{surface.at, unit, side > 0.0 ? y : -y, z};
}

/// Moved as a whole; the frame itself where that is a motion, which keeps formulas short.
Result<Surface> placed_surface(const Result<Surface>& made, const brep::Placement& placement) {
  if (!made || placement == brep::Placement{}) return made;
  return made->moved({placement.origin, placement.x, placement.y, placement.z});
}

class Quadric {
 public:
  Quadric(const brep::Elementary& surface, const surf::Frame& frame, const brep::Placement& placement)
      : is_(surface), frame_(frame), placement_(placement) {}

  [[nodiscard]] Result<Surface> over(const Box& chart) const { return placed_surface(own(chart), placement_); }

  [[nodiscard]] Point place_of(Point3 world) const {
    using Kind = brep::Elementary::Kind;
    const Vector3 d = placement_.inverse().of(world) - frame_.origin;
    const double x = dot(d, frame_.x), y = dot(d, frame_.y), z = dot(d, frame_.z), r = std::hypot(x, y);
    switch (is_.kind) {
      case Kind::Plane:
        return {x, y};
      case Kind::Cylinder:
        return {std::atan2(y, x), z};
      case Kind::Cone:
        return {std::atan2(y, x), z / std::cos(is_.other)};
      case Kind::Sphere:
        return {std::atan2(y, x), std::atan2(z, r)};
      case Kind::Torus:
        break;
    }
    return {std::atan2(y, x), std::atan2(z, r - is_.radius)};
  }

 private:
  [[nodiscard]] Result<Surface> own(const Box& chart) const {
    using Kind = brep::Elementary::Kind;
    switch (is_.kind) {
      case Kind::Plane:
        return Surface::plane(frame_, chart);
      case Kind::Cylinder:
        return going_round(chart, [&](const Box& part) { return Surface::cylinder(frame_, is_.radius, part); });
      case Kind::Cone:
        return going_round(chart, [&](const Box& part) { return Surface::cone(frame_, is_.radius, is_.other, part); });
      case Kind::Sphere:
        return going_round(chart, [&](const Box& part) { return Surface::sphere(frame_, is_.radius, part); });
      case Kind::Torus:
        break;
    }
    if (is_.other <= is_.radius)
      return going_round(chart, [&](const Box& part) { return Surface::torus(frame_, is_.radius, is_.other, part); });
    // One that would cross itself, cut before it does: a circle turned round the axis.
    DOBRA_TRY(const surf::Curve circle,
              surf::Curve::conic(surf::Curve::Conic::Ellipse, frame_.origin + is_.radius * frame_.x,
                                 is_.other * frame_.x, is_.other * frame_.z, chart.low.y, chart.high.y));
    const double sign = dot(cross(frame_.x, frame_.y), frame_.z);
    return going_round(chart, [&](const Box& part) {
      return Surface::revolved(circle, frame_.origin, sign * frame_.z, part.low.x, part.high.x);
    });
  }

  /// Surfaces go round once at most; a face may go on, as that of a thread does.
  template <class Make>
  [[nodiscard]] static Result<Surface> going_round(const Box& chart, Make make) {
    constexpr double most = 2.0 * pi * (1.0 + 1e-12);
    if (chart.width() <= most && chart.height() <= most) return make(chart);
    const bool torus = make(Box{{0.0, -pi}, {1.0, pi}}).ok() && !make(Box{{0.0, -pi}, {1.0, 2.0 * pi}}).ok();
    Box part = chart;
    if (chart.width() > most) part.high.x = part.low.x + 2.0 * pi;
    if (torus && chart.height() > most) part.high.y = part.low.y + 2.0 * pi;
    DOBRA_TRY(const Surface once, make(part));
    return once.over(chart, Surface::Beyond::GoesRound, Surface::Beyond::GoesRound);
  }

  brep::Elementary is_;
  surf::Frame frame_;
  brep::Placement placement_;
};

Result<WholeSurface> whole_elementary(const brep::Elementary& surface, const brep::Placement& placement) {
  using Kind = brep::Elementary::Kind;
  DOBRA_TRY(surf::Frame frame, squared(surface));
  const bool motion = is_motion(placement);
  if (motion) frame = {placement.of(frame.origin), placement.of(frame.x), placement.of(frame.y), placement.of(frame.z)};
  const auto quadric = std::make_shared<const Quadric>(surface, frame, motion ? brep::Placement{} : placement);
  WholeSurface whole;
  whole.range = everywhere;
  whole.over = [quadric](const Box& chart) { return quadric->over(chart); };
  whole.place_of = [quadric](Point3 at) { return quadric->place_of(at); };
  whole.flat = surface.kind == Kind::Plane;
  if (whole.flat) return whole;
  whole.range.low.x = 0.0;
  whole.range.high.x = whole.period_u = 2.0 * pi;
  if (surface.kind == Kind::Cone) whole.points_v = {-surface.radius / std::sin(surface.other)};
  if (surface.kind == Kind::Sphere) {
    whole.range.low.y = -0.5 * pi;
    whole.range.high.y = 0.5 * pi;
    whole.points_v = {-0.5 * pi, 0.5 * pi};
  }
  if (surface.kind == Kind::Torus) {
    whole.range.low.y = 0.0;
    whole.range.high.y = whole.period_v = 2.0 * pi;
    if (surface.other >= surface.radius) {  // the circle meets the axis
      const double at = std::acos(-surface.radius / surface.other);
      whole.points_v = {-at, at, 2.0 * pi - at};
    }
  }
  // The makers judge radii and angles; a part that each of them has asks them.
  DOBRA_TRY_VOID(whole.over(surface.kind == Kind::Cone ? Box{{0.0, whole.points_v[0]},
                                                             {1.0, whole.points_v[0] + std::max(1.0, surface.radius)}}
                                                       : Box{{0.0, 0.0}, {1.0, 1.0}}));
  return whole;
}

Result<WholeSurface> whole_extrusion(const brep::Extrusion& extrusion, const brep::Placement& placement) {
  DOBRA_TRY(const CurveRange range, range_of(*extrusion.of));
  if (!(length(extrusion.along) > 0.0))
    return base::Error{base::ErrorCode::DegenerateCurve, "the direction of an extrusion has no length"};
  const Vector3 along = placement.of(normalised(extrusion.along));
  WholeSurface whole;
  whole.range = {{range.low, -endless}, {range.high, endless}};
  whole.period_u = range.period;
  whole.over = [of = extrusion.of, along, placement](const Box& chart) -> Result<Surface> {
    DOBRA_TRY(const surf::Curve profile, to_curve(*of, chart.low.x, chart.high.x));
    return Surface::extruded(placed(profile, placement), along, chart.low.y, chart.high.y);
  };
  return whole;
}

/// Where a meridian meets the axis: there the surface is one point.
Result<std::vector<double>> on_axis(const brep::Revolution& revolution, const CurveRange& range) {
  constexpr double touches = 1e-9;  // of its distance elsewhere
  std::vector<double> points;
  if (!(geom::length(revolution.axis) > 0.0)) return points;  // whoever makes the surface says so
  const geom::Vector3 axis = geom::normalised(revolution.axis);
  const auto across = [&](geom::Vector3 from) { return from - dot(from, axis) * axis; };
  const auto away = [&](geom::Point3 p) { return geom::length(across(p - revolution.at)); };
  if (const auto* line = std::get_if<brep::Line>(&revolution.of->is)) {
    const geom::Vector3 out = across(line->along);
    if (!(dot(out, out) > 0.0)) return points;
    const double t = -dot(line->at - revolution.at, out) / dot(out, out);
    const double size = std::max(geom::distance(line->at, revolution.at), geom::length(out));
    if (away(line->at + t * line->along) <= touches * size) points.push_back(t);
    return points;
  }
  if (!std::isfinite(range.low) || !std::isfinite(range.high)) return points;
  DOBRA_TRY(const surf::Curve profile, to_curve(*revolution.of, range.low, range.high));
  constexpr int places = 256, halvings = 100;
  std::array<double, places + 1> distance{};
  const auto at = [&](int i) { return std::lerp(range.low, range.high, static_cast<double>(i) / places); };
  for (int i = 0; i <= places; ++i) distance[i] = away(profile.at(at(i)));
  const double most = *std::max_element(distance.begin(), distance.end());
  for (int i = 0; i <= places; ++i) {
    if ((i > 0 && distance[i - 1] < distance[i]) || (i < places && distance[i + 1] <= distance[i])) continue;
    double low = at(std::max(i - 1, 0)), high = at(std::min(i + 1, places));
    for (int k = 0; k < halvings; ++k) {
      const double third = (high - low) / 3.0;
      if (away(profile.at(low + third)) <= away(profile.at(high - third)))
        high -= third;
      else
        low += third;
    }
    double t = std::midpoint(low, high);
    for (const double end : {range.low, range.high}) {
      if (std::abs(t - end) <= touches * (range.high - range.low)) t = end;
    }
    const bool again = range.period > 0.0 && t == range.high && !points.empty() && points[0] == range.low;
    if (!again && away(profile.at(t)) <= touches * most) points.push_back(t);
  }
  return points;
}

Result<WholeSurface> whole_revolution(const brep::Revolution& revolution, const brep::Placement& placement) {
  DOBRA_TRY(const CurveRange range, range_of(*revolution.of));
  WholeSurface whole;
  whole.range = {{0.0, range.low}, {2.0 * pi, range.high}};
  whole.period_u = 2.0 * pi;
  whole.period_v = range.period;
  DOBRA_TRY(whole.points_v, on_axis(revolution, range));
  whole.over = [revolution, placement](const Box& chart) -> Result<Surface> {
    DOBRA_TRY(const surf::Curve profile, to_curve(*revolution.of, chart.low.y, chart.high.y));
    const bool again = chart.width() > 2.0 * pi * (1.0 + 1e-12);
    DOBRA_TRY(Surface made, Surface::revolved(profile, revolution.at, revolution.axis, chart.low.x,
                                              again ? chart.low.x + 2.0 * pi : chart.high.x));
    if (again) {
      DOBRA_TRY(made, made.over(chart, Surface::Beyond::GoesRound));
    }
    return placed_surface(made, placement);
  };
  return whole;
}

bool same_points(const Surface& surface, bool of_u) {
  constexpr int places = 17;
  constexpr double closes = 1e-9;
  const Box& chart = surface.chart();
  for (int i = 0; i < places; ++i) {
    const double part = i / (places - 1.0);
    const double u = std::lerp(chart.low.x, chart.high.x, part), v = std::lerp(chart.low.y, chart.high.y, part);
    const Point low = of_u ? Point{chart.low.x, v} : Point{u, chart.low.y};
    const Point high = of_u ? Point{chart.high.x, v} : Point{u, chart.high.y};
    if (distance(surface.at(low), surface.at(high)) > closes * surface.size()) return false;
  }
  return true;
}

Result<WholeSurface> whole_patch(const brep::SplinePatch& patch, const brep::Placement& placement) {
  std::vector<Point3> points;
  points.reserve(patch.points.size());
  for (const Point3& p : patch.points) points.push_back(placement.of(p));
  DOBRA_TRY(const Surface made,
            Surface::nurbs(patch.degree_u, patch.knots_u, patch.degree_v, patch.knots_v, points, patch.weights));
  WholeSurface whole;
  whole.range = made.chart();
  const bool round_u = same_points(made, true), round_v = same_points(made, false);
  const auto goes = [](bool round) { return round ? Surface::Beyond::GoesRound : Surface::Beyond::GoesOn; };
  if (round_u) whole.period_u = whole.range.width();
  if (round_v) whole.period_v = whole.range.height();
  if (made.collapsed(surf::Side::Left)) whole.points_u.push_back(whole.range.low.x);
  if (made.collapsed(surf::Side::Right)) whole.points_u.push_back(whole.range.high.x);
  if (made.collapsed(surf::Side::Bottom)) whole.points_v.push_back(whole.range.low.y);
  if (made.collapsed(surf::Side::Top)) whole.points_v.push_back(whole.range.high.y);
  whole.over = [made, round_u, round_v, goes](const Box& chart) {
    return made.over(chart, goes(round_u), goes(round_v));
  };
  return whole;
}

Result<WholeSurface> whole_offset(const brep::OffsetPatch& offset, const brep::Placement& placement) {
  // In the file's own place, so that a mirror or a scale moves what is already offset.
  DOBRA_TRY(WholeSurface whole, whole_surface(*offset.of, {}));
  const auto of = whole.over;
  whole.over = [of, by = offset.distance, placement](const Box& chart) -> Result<Surface> {
    DOBRA_TRY(const Surface base, of(chart));
    return placed_surface(base.offset(by), placement);
  };
  whole.place_of = [place = whole.place_of, back = placement.inverse()](Point3 at) {
    return place ? place(back.of(at)) : std::nullopt;
  };
  if (!whole.flat) whole.points_u.clear(), whole.points_v.clear();
  return whole;
}

}  // namespace

Result<WholeSurface> whole_surface(const brep::Surface& surface, const brep::Placement& placement) {
  if (const auto* is = std::get_if<brep::Elementary>(&surface.is)) return whole_elementary(*is, placement);
  if (const auto* is = std::get_if<brep::Extrusion>(&surface.is)) return whole_extrusion(*is, placement);
  if (const auto* is = std::get_if<brep::Revolution>(&surface.is)) return whole_revolution(*is, placement);
  if (const auto* is = std::get_if<brep::SplinePatch>(&surface.is)) return whole_patch(*is, placement);
  if (const auto* is = std::get_if<brep::OffsetPatch>(&surface.is)) return whole_offset(*is, placement);
  const auto& trimmed = std::get<brep::TrimmedPatch>(surface.is);
  DOBRA_TRY(WholeSurface whole, whole_surface(*trimmed.of, placement));
  whole.range = {{std::min(trimmed.low.x, trimmed.high.x), std::min(trimmed.low.y, trimmed.high.y)},
                 {std::max(trimmed.low.x, trimmed.high.x), std::max(trimmed.low.y, trimmed.high.y)}};
  return whole;
}

}  // namespace dobra::io::faces
