#pragma once
// One [[input.space_curve]]: a border or profile of surfaces.

#include <optional>
#include <string>
#include <vector>

#include "shared/scenario/field.h"
#include "shared/surf/curve.h"

namespace quebra::surfaces {

enum class SpaceCurveKind { Line, Arc, Circle, Bezier, Nurbs, Spline };

struct SpaceCurveParams {
  std::string name;
  SpaceCurveKind kind = SpaceCurveKind::Line;
  std::vector<dobra::geom::Point3> points;
  std::vector<double> weights, knots;
  int degree = 3;
  std::optional<dobra::geom::Point3> centre, axis, x_axis;
  std::optional<double> radius;
  dobra::base::Angle start = dobra::base::Angle::from_degrees(0.0);
  dobra::base::Angle sweep = dobra::base::Angle::from_degrees(360.0);

  template <class D>
  static void describe(D& d) {
    d.field("name", &SpaceCurveParams::name,
            {.title = "Name", .help = "By which surfaces know it.", .presence = dobra::scenario::Presence::Required});
    d.choice("kind", &SpaceCurveParams::kind, {"line", "arc", "circle", "bezier", "nurbs", "spline"},
             {.title = "Kind",
              .help = "line: a chain of points; arc: through three points; circle: a centre, an axis and angles; "
                      "bezier: one of any degree, by its vertices; nurbs: control points with knots; spline: smooth "
                      "through the points."});
    d.field("points", &SpaceCurveParams::points,
            {.title = "Points (x, y, z)",
             .help = "In order. An arc has three: first, one on the way, last.",
             .unit = "m",
             .when = "kind in line, arc, bezier, nurbs, spline"});
    d.field("weights", &SpaceCurveParams::weights,
            {.title = "Weights",
             .help = "One a point, greater than 0; all 1 where none are given.",
             .when = "kind in bezier, nurbs"});
    d.field("degree", &SpaceCurveParams::degree,
            {.title = "Degree", .at_least = 1, .at_most = 15, .when = "kind = nurbs"});
    d.field(
        "knots", &SpaceCurveParams::knots,
        {.title = "Knots", .help = "Not decreasing, one for each point and degree + 1 more.", .when = "kind = nurbs"});
    d.field("centre", &SpaceCurveParams::centre,
            {.title = "Centre (x, y, z)", .help = "Of a circle.", .unit = "m", .when = "kind = circle"});
    d.field("axis", &SpaceCurveParams::axis,
            {.title = "Axis",
             .help = "Of a circle: it turns anticlockwise about it; z where left out.",
             .when = "kind = circle"});
    d.field("x_axis", &SpaceCurveParams::x_axis,
            {.title = "Direction of angle 0",
             .help = "Of a circle; square to the axis where left out.",
             .when = "kind = circle"});
    d.field("radius", &SpaceCurveParams::radius,
            {.title = "Radius", .help = "Of a circle.", .unit = "m", .above = 0, .when = "kind = circle"});
    d.field("start", &SpaceCurveParams::start,
            {.title = "Start angle", .help = "Of a part of a circle.", .unit = "deg", .when = "kind = circle"});
    d.field("sweep", &SpaceCurveParams::sweep,
            {.title = "Sweep angle",
             .help = "Of a part of a circle; 360 is all of it.",
             .unit = "deg",
             .above = 0,
             .at_most = 360,
             .when = "kind = circle"});
  }
};

/// @error BadValue: what its kind needs is missing, in the words of the keys; those of the makers of surf::Curve.
dobra::base::Result<dobra::surf::Curve> make_space_curve(const SpaceCurveParams& params);

/// What a kind needs is not there.
inline dobra::base::Error lacking(const std::string& what) { return {dobra::base::ErrorCode::BadValue, what}; }

/// The axes of a circle or a surface of revolution.
/// @param x_axis  any that is not along the axis; nothing: square to it, of x or y the one that is farther from it.
/// @error DegenerateCurve: an axis of no length, an x axis along it.
struct Axes {
  dobra::geom::Vector3 x, y, z;
};
dobra::base::Result<Axes> make_axes(const std::optional<dobra::geom::Point3>& axis,
                                    const std::optional<dobra::geom::Point3>& x_axis);

}  // namespace quebra::surfaces
