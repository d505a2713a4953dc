#pragma once
// The loads of a problem and what holds for a whole load case, as scenario files write them.

#include <optional>
#include <string>

#include "shared/scenario/program.h"

namespace quebra::analysis {

enum class LoadKind { Traction, Pressure, Force, Body, Stress, Kirsch, Corner };

struct LoadParams {
  std::string where;
  LoadKind kind = LoadKind::Traction;
  double x = 0.0;
  double y = 0.0;
  double value = 0.0;
  std::optional<dobra::geom::Point> from, to;
  double x_to = 0.0;
  double y_to = 0.0;
  double value_to = 0.0;
  std::string x_formula, y_formula, value_formula;
  std::string stress_xx, stress_yy, stress_xy;
  double radius = 1.0;
  dobra::base::Angle bisector = dobra::base::Angle::from_degrees(135.0);
  std::string load_case = "load";
  dobra::base::Place place = {};  ///< Of its table in the scenario.

  static constexpr const char* by_kind = "Pa, N if kind = force, N/m3 if kind = body";

  template <class D>
  static void describe(D& d) {
    d.field("where", &LoadParams::where,
            {.title = "Where",
             .help = "Name of a curve or lip, or a condition such as \"x = 0 and y > 1\"; of a point (force); of a "
                     "region, or empty for all (body).",
             .names = "place"});
    d.choice("kind", &LoadParams::kind, {"traction", "pressure", "force", "body", "stress", "kirsch", "l_shape"},
             {.title = "Kind",
              .help = "traction x, y in Pa; pressure: value in Pa, presses on the material (opens a crack by its two "
                      "lips); force x, y in N at each node; body x, y in N/m3; stress: the exact tractions of a stress "
                      "field given by formulas; kirsch, l_shape: those of the plate with a hole of `radius` at the "
                      "origin under a tension `value`, or of the corner of 270 degrees at the origin."});
    d.field("x", &LoadParams::x, {.title = "x", .unit = by_kind, .when = "kind in traction, force, body"});
    d.field("y", &LoadParams::y, {.title = "y", .unit = by_kind, .when = "kind in traction, force, body"});
    d.field("value", &LoadParams::value, {.title = "Value", .unit = "Pa", .when = "kind in pressure, kirsch"});
    d.field(
        "from", &LoadParams::from,
        {.title = "From",
         .help = "Of a linear traction, pressure or body force: x, y, value hold here, x_to, y_to, value_to at `to`.",
         .unit = "m",
         .when = "kind in traction, pressure, body"});
    d.field("to", &LoadParams::to, {.title = "To", .unit = "m", .when = "kind in traction, pressure, body"});
    d.field("x_to", &LoadParams::x_to,
            {.title = "x at the end", .unit = by_kind, .when = "kind in traction, body and from is set"});
    d.field("y_to", &LoadParams::y_to,
            {.title = "y at the end", .unit = by_kind, .when = "kind in traction, body and from is set"});
    d.field("value_to", &LoadParams::value_to,
            {.title = "Value at the end", .unit = "Pa", .when = "kind = pressure and from is set"});
    d.field("x_formula", &LoadParams::x_formula,
            {.title = "x, formula",
             .help = "Of x, y, and of the outward normal nx, ny on a curve: \"3 * (1 - y^2)\".",
             .unit = by_kind,
             .when = "kind in traction, body"});
    d.field("y_formula", &LoadParams::y_formula,
            {.title = "y, formula", .unit = by_kind, .when = "kind in traction, body"});
    d.field("value_formula", &LoadParams::value_formula,
            {.title = "Value, formula", .help = "Of a pressure.", .unit = "Pa", .when = "kind = pressure"});
    d.field("stress_xx", &LoadParams::stress_xx,
            {.title = "sigma_x, formula", .help = "Of x and y (stress).", .unit = "Pa", .when = "kind = stress"});
    d.field("stress_yy", &LoadParams::stress_yy, {.title = "sigma_y, formula", .unit = "Pa", .when = "kind = stress"});
    d.field("stress_xy", &LoadParams::stress_xy, {.title = "tau_xy, formula", .unit = "Pa", .when = "kind = stress"});
    d.field("radius", &LoadParams::radius, {.title = "Radius", .unit = "m", .above = 0, .when = "kind = kirsch"});
    d.field("bisector", &LoadParams::bisector,
            {.title = "Bisector",
             .help = "Direction from the corner into the material (l_shape).",
             .unit = "deg",
             .when = "kind = l_shape"});
    d.field("case", &LoadParams::load_case, {.title = "Load case"});
  }
};

/// What holds for a whole load case.
struct CaseParams {
  std::string name;
  double settlement = 1.0;

  template <class D>
  static void describe(D& d) {
    d.field("name", &CaseParams::name, {.title = "Name", .presence = dobra::scenario::Presence::Required});
    d.field("settlement", &CaseParams::settlement,
            {.title = "Settlement",
             .help = "Multiplies prescribed displacements and values of ties in this case; 0: supports stand still."});
  }
};

}  // namespace quebra::analysis
