#include "quebra/surfaces/surface_params.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shared/surf/triangular_patch.h"

namespace quebra::surfaces {

using namespace dobra;
using base::Error;
using base::ErrorCode;
using base::Result;
using geom::Point3;
using geom::Vector3;
using surf::Curve;
using surf::Surface;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

struct Range {
  double from = 0.0, to = 0.0;
};
/// @param otherwise  nothing: the key is needed.
Result<Range> range(const std::vector<double>& given, const char* key, double unit, std::optional<Range> otherwise) {
  if (given.empty() && otherwise) return *otherwise;
  if (given.size() != 2)
    return lacking(fmt::format("`{}` is a range of the chart: give two numbers, from and to", key));
  if (!(given[0] < given[1]))
    return lacking(fmt::format("the range `{}` is empty: its second number must be the greater", key));
  return Range{unit * given[0], unit * given[1]};
}

Result<geom::Box> chart(const SurfaceParams& params, double unit_u, double unit_v, std::optional<Range> u,
                        std::optional<Range> v) {
  DOBRA_TRY(const Range along_u, range(params.u, "u", unit_u, u));
  DOBRA_TRY(const Range along_v, range(params.v, "v", unit_v, v));
  geom::Box box;
  box.add(geom::Point{along_u.from, along_v.from});
  box.add(geom::Point{along_u.to, along_v.to});
  return box;
}

Result<surf::Frame> frame(const SurfaceParams& params) {
  DOBRA_TRY(const Axes axes, make_axes(params.axis, params.x_axis));
  return surf::Frame{params.origin.value_or(Point3{}), axes.x, axes.y, axes.z};
}

Result<double> radius(const SurfaceParams& params) {
  if (!params.radius) return lacking("`radius` is needed");
  return *params.radius;
}

Result<Surface> make_round(const SurfaceParams& params) {
  constexpr Range all_round{0.0, 360.0 * degree};
  DOBRA_TRY(const surf::Frame axes, frame(params));
  DOBRA_TRY(const double size, radius(params));
  switch (params.kind) {
    case SurfaceKind::Sphere: {
      DOBRA_TRY(const geom::Box box, chart(params, degree, degree, all_round, Range{-90.0 * degree, 90.0 * degree}));
      return Surface::sphere(axes, size, box);
    }
    case SurfaceKind::Cylinder: {
      DOBRA_TRY(const geom::Box box, chart(params, degree, 1.0, all_round, std::nullopt));
      return Surface::cylinder(axes, size, box);
    }
    case SurfaceKind::Cone: {
      if (!params.half_angle) return lacking("`half_angle` is needed");
      DOBRA_TRY(const geom::Box box, chart(params, degree, 1.0, all_round, std::nullopt));
      return Surface::cone(axes, size, params.half_angle->radians(), box);
    }
    default:
      break;
  }
  if (!params.minor_radius) return lacking("`minor_radius` is needed");
  DOBRA_TRY(const geom::Box box, chart(params, degree, degree, all_round, all_round));
  return Surface::torus(axes, size, *params.minor_radius, box);
}

Result<Surface> make_swept(const SurfaceParams& params, const std::vector<Curve>& curves) {
  const bool triangular = params.kind == SurfaceKind::Triangular;
  const std::size_t wanted = params.kind == SurfaceKind::Coons   ? 4
                             : triangular                        ? 3
                             : params.kind == SurfaceKind::Ruled ? 2
                                                                 : 1;
  if (curves.size() != wanted)
    return lacking(
        fmt::format("`curves` must name {} space curve{}, found {}", wanted, wanted == 1 ? "" : "s", curves.size()));
  if (params.kind == SurfaceKind::Coons) return Surface::coons(curves[0], curves[1], curves[2], curves[3]);
  if (triangular) {
    DOBRA_TRY(const surf::TriangularPatch patch, surf::TriangularPatch::make(curves[0], curves[1], curves[2]));
    return patch.surface();
  }
  if (params.kind == SurfaceKind::Ruled) return Surface::ruled(curves[0], curves[1]);
  if (params.kind == SurfaceKind::Extruded) {
    if (!params.by) return lacking("`by` is needed: how far and where to the profile is extruded");
    return Surface::extruded(curves[0], {params.by->x, params.by->y, params.by->z});
  }
  DOBRA_TRY(const Range turn, range(params.u, "u", degree, Range{0.0, 360.0 * degree}));
  const Point3 axis = params.axis.value_or(Point3{0.0, 0.0, 1.0});
  return Surface::revolved(curves[0], params.origin.value_or(Point3{}), {axis.x, axis.y, axis.z}, turn.from, turn.to);
}

Result<Surface> make_of_points(const SurfaceParams& params) {
  if (params.kind == SurfaceKind::Nurbs)
    return Surface::nurbs(static_cast<std::size_t>(params.degree_u.value_or(params.degree)), params.knots_u,
                          static_cast<std::size_t>(params.degree_v.value_or(params.degree)), params.knots_v,
                          params.points, params.weights);
  const auto rows = static_cast<std::size_t>(std::max(params.rows, 0));
  if (rows < 2 || params.points.size() % rows != 0)
    return lacking(
        fmt::format("`rows` must divide the number of `points` ({}) and be at least 2", params.points.size()));
  return Surface::through(params.points, rows, params.points.size() / rows, static_cast<std::size_t>(params.degree));
}

}  // namespace

std::size_t rows_of(const SurfaceParams& params) {
  if (params.kind == SurfaceKind::Through) return static_cast<std::size_t>(std::max(params.rows, 0));
  const auto beyond = static_cast<std::size_t>(params.degree_u.value_or(params.degree)) + 1;
  if (params.kind != SurfaceKind::Nurbs || params.knots_u.size() <= beyond) return 0;
  return params.knots_u.size() - beyond;
}

ChartUnits chart_units(SurfaceKind kind, const scenario::UnitSystem& units) {
  const double metre = units.to_si(1.0, "m");
  const std::string length = units.unit("m"), angle = "\u00b0";
  switch (kind) {
    case SurfaceKind::Plane:
    case SurfaceKind::Graph:
      return {metre, metre, length, length};
    case SurfaceKind::Cylinder:
    case SurfaceKind::Cone:
      return {degree, metre, angle, length};
    case SurfaceKind::Sphere:
    case SurfaceKind::Torus:
      return {degree, degree, angle, angle};
    case SurfaceKind::Revolved:
      return {degree, 1.0, angle, {}};
    default:
      return {};
  }
}

Result<Surface> make_surface(const SurfaceParams& params, const std::vector<Curve>& curves) {
  switch (params.kind) {
    case SurfaceKind::Plane: {
      DOBRA_TRY(const surf::Frame axes, frame(params));
      DOBRA_TRY(const geom::Box box, chart(params, 1.0, 1.0, std::nullopt, std::nullopt));
      return Surface::plane(axes, box);
    }
    case SurfaceKind::Ruled:
    case SurfaceKind::Extruded:
    case SurfaceKind::Revolved:
    case SurfaceKind::Coons:
    case SurfaceKind::Triangular:
      return make_swept(params, curves);
    case SurfaceKind::Sphere:
    case SurfaceKind::Cylinder:
    case SurfaceKind::Cone:
    case SurfaceKind::Torus:
      return make_round(params);
    case SurfaceKind::Graph: {
      if (params.formula.empty()) return lacking("`formula` is needed: the height as a formula of x and y");
      DOBRA_TRY(const geom::Box box, chart(params, 1.0, 1.0, std::nullopt, std::nullopt));
      return Surface::graph(params.formula, box);
    }
    case SurfaceKind::Nurbs:
    case SurfaceKind::Through:
      break;
  }
  return make_of_points(params);
}

}  // namespace quebra::surfaces
