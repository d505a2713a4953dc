#pragma once
// One [[input.surface]]: a parametric surface with the part of its chart that is meant.

#include <optional>
#include <string>
#include <vector>

#include "quebra/surfaces/curve_params.h"
#include "shared/scenario/units.h"
#include "shared/surf/surface.h"

namespace quebra::surfaces {

enum class SurfaceKind {
  Plane,
  Ruled,
  Extruded,
  Revolved,
  Coons,
  Sphere,
  Cylinder,
  Cone,
  Torus,
  Graph,
  Nurbs,
  Through,
  Triangular
};
/// Whether it is meshed, or there to cut others with.
enum class SurfaceUse { Mesh, Tool };
enum class Facing { Along, Against };

struct SurfaceParams {
  std::string name;
  SurfaceKind kind = SurfaceKind::Plane;
  SurfaceUse use = SurfaceUse::Mesh;
  std::vector<std::string> curves;
  std::optional<dobra::geom::Point3> origin, axis, x_axis, by;
  std::optional<double> radius, minor_radius;
  std::optional<dobra::base::Angle> half_angle;
  std::vector<double> u, v;
  std::string formula;
  int degree = 3;
  std::optional<int> degree_u, degree_v;
  std::vector<double> knots_u, knots_v, weights;
  std::vector<dobra::geom::Point3> points;
  int rows = 0;
  Facing facing = Facing::Along;

  template <class D>
  static void describe(D& d) {
    d.field("name", &SurfaceParams::name,
            {.title = "Name",
             .help = "Of the region of its elements; trims name it.",
             .presence = dobra::scenario::Presence::Required});
    d.choice(
        "kind", &SurfaceParams::kind,
        {"plane", "ruled", "extruded", "revolved", "coons", "sphere", "cylinder", "cone", "torus", "graph", "nurbs",
         "through", "triangular"},
        {.title = "Kind",
         .help = "ruled, extruded, revolved, coons, triangular: of space curves; graph: height by a formula; nurbs: "
                 "control points with knots; through: smooth through a grid of points."});
    d.choice("use", &SurfaceParams::use, {"mesh", "tool"},
             {.title = "Use", .help = "tool: it is not meshed and only cuts others."});
    d.field("curves", &SurfaceParams::curves,
            {.title = "Curves",
             .help = "Names of space curves. ruled: v = 0 and v = 1; extruded, revolved: the profile; coons: bottom, "
                     "top (both along u), left and right (both along v); triangular: three round it, each either way.",
             .names = "space_curve",
             .when = "kind in ruled, extruded, revolved, coons, triangular"});
    d.field("origin", &SurfaceParams::origin,
            {.title = "Origin (x, y, z)",
             .help = "Centre of a sphere or torus, a point of an axis, the point u = v = 0 of a plane.",
             .unit = "m",
             .when = "kind in plane, revolved, sphere, cylinder, cone, torus"});
    d.field("axis", &SurfaceParams::axis,
            {.title = "Axis",
             .help = "Direction of the axis; of a plane its normal. z where left out.",
             .when = "kind in plane, revolved, sphere, cylinder, cone, torus"});
    d.field("x_axis", &SurfaceParams::x_axis,
            {.title = "Direction of u = 0",
             .help = "Where longitudes begin; of a plane the direction of u. Square to the axis where left out.",
             .when = "kind in plane, sphere, cylinder, cone, torus"});
    d.field("by", &SurfaceParams::by, {.title = "Extruded by (x, y, z)", .unit = "m", .when = "kind = extruded"});
    d.field("radius", &SurfaceParams::radius,
            {.title = "Radius",
             .help = "Of a cone at v = 0, of a torus from its axis to the middle of its tube.",
             .unit = "m",
             .at_least = 0,
             .when = "kind in sphere, cylinder, cone, torus"});
    d.field("minor_radius", &SurfaceParams::minor_radius,
            {.title = "Radius of the tube", .unit = "m", .above = 0, .when = "kind = torus"});
    d.field("half_angle", &SurfaceParams::half_angle,
            {.title = "Half angle",
             .help = "Between the axis of a cone and its sides; negative narrows it along the axis.",
             .unit = "deg",
             .above = -90,
             .at_most = 89.999,
             .when = "kind = cone"});
    d.field("u", &SurfaceParams::u,
            {.title = "Range of u",
             .help = "From, to. Longitudes in degrees (all round where left out); of a plane and a graph lengths.",
             .unit = "m, deg if kind = sphere, deg if kind = cylinder, deg if kind = cone, deg if kind = torus, deg if "
                     "kind = revolved",
             .when = "kind in plane, revolved, sphere, cylinder, cone, torus, graph"});
    d.field("v", &SurfaceParams::v,
            {.title = "Range of v",
             .help = "From, to. Latitudes in degrees (pole to pole where left out), angles round the tube of a torus; "
                     "else lengths, along the axis or, of a cone, along its side.",
             .unit = "m, deg if kind = sphere, deg if kind = torus",
             .when = "kind in plane, sphere, cylinder, cone, torus, graph"});
    d.field("formula", &SurfaceParams::formula,
            {.title = "Height z", .help = "A formula of x and y.", .unit = "m", .when = "kind = graph"});
    d.field("degree", &SurfaceParams::degree,
            {.title = "Degree", .help = "Both ways.", .at_least = 1, .at_most = 15, .when = "kind in nurbs, through"});
    d.field("degree_u", &SurfaceParams::degree_u,
            {.title = "Degree along u", .at_least = 1, .at_most = 15, .when = "kind = nurbs"});
    d.field("degree_v", &SurfaceParams::degree_v,
            {.title = "Degree along v", .at_least = 1, .at_most = 15, .when = "kind = nurbs"});
    d.field("knots_u", &SurfaceParams::knots_u,
            {.title = "Knots along u",
             .help = "Not decreasing, one for each row and degree + 1 more.",
             .when = "kind = nurbs"});
    d.field("knots_v", &SurfaceParams::knots_v,
            {.title = "Knots along v",
             .help = "Not decreasing, one for each column and degree + 1 more.",
             .when = "kind = nurbs"});
    d.field("points", &SurfaceParams::points,
            {.title = "Points (x, y, z)",
             .help = "A grid, row after row: along v first, then along u.",
             .unit = "m",
             .when = "kind in nurbs, through"});
    d.field("weights", &SurfaceParams::weights,
            {.title = "Weights",
             .help = "One a point, greater than 0; all 1 where none are given.",
             .when = "kind = nurbs"});
    d.field("rows", &SurfaceParams::rows,
            {.title = "Rows", .help = "Of the grid, along u.", .at_least = 0, .when = "kind = through"});
    d.choice("facing", &SurfaceParams::facing, {"along", "against"},
             {.title = "Triangles face", .help = "Along the normal Su x Sv of the surface, or against it."});
  }
};

/// What the numbers of a chart are written in: factors that turn them into those of surf::Surface.
struct ChartUnits {
  double u = 1.0, v = 1.0;
  std::string u_name = {}, v_name = {};  ///< Of the units; empty: a parameter.
  [[nodiscard]] dobra::geom::Point in(dobra::geom::Point written) const { return {u * written.x, v * written.y}; }
  [[nodiscard]] dobra::geom::Point out(dobra::geom::Point chart) const { return {chart.x / u, chart.y / v}; }
};
/// Degrees and the document's length where the kind has angles and lengths.
ChartUnits chart_units(SurfaceKind kind, const dobra::scenario::UnitSystem& units);

/// How many rows the grid of points of a surface has, along u; 0: its kind or its knots do not say.
std::size_t rows_of(const SurfaceParams& params);

/// @param curves  those of `params.curves`, in their order.
/// @error BadValue: what its kind needs is missing, in the words of the keys; those of the makers of surf::Surface.
dobra::base::Result<dobra::surf::Surface> make_surface(const SurfaceParams& params,
                                                       const std::vector<dobra::surf::Curve>& curves);

}  // namespace quebra::surfaces
