#pragma once
// The elastic problem on a domain as scenario files write it: materials, supports, springs, ties and loads by the names of
// regions, curves and points. Page: docs/algorithms/fem.md.

#include <optional>
#include <string>
#include <vector>

#include "quebra/core/model.h"
#include "shared/base/progress.h"
#include "shared/fem/problem.h"
#include "shared/scenario/program.h"

namespace quebra::core {

struct MaterialParams {
  std::string region;
  double young = 0.0;
  double poisson = 0.3;
  double thickness = 1.0;

  template <class D>
  static void describe(D& d) {
    d.field("region", &MaterialParams::region, {.title = "Region", .help = "Empty: every region that has no material of its own."});
    d.field("young", &MaterialParams::young, {.title = "Young's modulus", .unit = "Pa", .above = 0, .presence = dobra::scenario::Presence::Required});
    d.field("poisson", &MaterialParams::poisson, {.title = "Poisson's ratio", .help = "Below 0.5 in plane strain.", .above = -1, .at_most = 0.5});
    d.field("thickness", &MaterialParams::thickness, {.title = "Thickness", .unit = "m", .above = 0});
  }
};

struct SupportParams {
  std::string where;
  std::optional<double> x, y, normal;
  std::string x_formula, y_formula;

  template <class D>
  static void describe(D& d) {
    d.field("where", &SupportParams::where, {.title = "Where", .help = "Name of a curve, a lip or a point.", .presence = dobra::scenario::Presence::Required});
    d.field("x", &SupportParams::x, {.title = "Along x", .help = "Prescribed displacement; 0 holds, nothing leaves free.", .unit = "m"});
    d.field("y", &SupportParams::y, {.title = "Along y", .unit = "m"});
    d.field("normal", &SupportParams::normal, {.title = "Across", .help = "Along the outward normal of the curve; 0 is a line of symmetry.", .unit = "m"});
    d.field("x_formula", &SupportParams::x_formula, {.title = "Along x, formula", .help = "Of x and y; with y or y_formula.", .unit = "m"});
    d.field("y_formula", &SupportParams::y_formula, {.title = "Along y, formula", .help = "Of x and y; with x or x_formula.", .unit = "m"});
  }
};

struct SpringParams {
  std::string where;
  dobra::fem::SpringKind kind = dobra::fem::SpringKind::EachNode;
  double x = 0.0;
  double y = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field("where", &SpringParams::where, {.title = "Where", .help = "Name of a curve, a lip or a point.", .presence = dobra::scenario::Presence::Required});
    d.choice("kind", &SpringParams::kind, {"node", "bed"}, {.title = "Kind", .help = "node: a spring at each node, N/m; bed: along a curve, N/m3."});
    d.field("x", &SpringParams::x, {.title = "Stiffness along x", .at_least = 0});
    d.field("y", &SpringParams::y, {.title = "Stiffness along y", .at_least = 0});
  }
};

enum class TieAxis { X, Y };

struct TieParams {
  std::string where;
  TieAxis axis = TieAxis::X;
  std::vector<std::string> points;
  std::vector<std::string> axes;
  std::vector<double> coefficients;
  double value = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field("where", &TieParams::where, {.title = "Where", .help = "Name of a curve whose nodes all move alike along `axis`."});
    d.choice("axis", &TieParams::axis, {"x", "y"}, {.title = "Axis"});
    d.field("points", &TieParams::points, {.title = "Points", .help = "Or: sum of coefficient times displacement of these points = value."});
    d.field("axes", &TieParams::axes, {.title = "Axes", .help = "\"x\" or \"y\", one a point."});
    d.field("coefficients", &TieParams::coefficients, {.title = "Coefficients", .help = "One a point."});
    d.field("value", &TieParams::value, {.title = "Value", .unit = "m"});
  }
};

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

  template <class D>
  static void describe(D& d) {
    d.field("where", &LoadParams::where, {.title = "Where", .help = "Name of a curve or lip; of a point (force); of a region, or empty for all (body)."});
    d.choice("kind", &LoadParams::kind, {"traction", "pressure", "force", "body", "stress", "kirsch", "l_shape"},
             {.title = "Kind", .help = "traction x, y in Pa; pressure: value in Pa, presses on the material (opens a crack by its two lips); force x, y in N at each node; body x, y in N/m3; stress: the exact tractions of a stress field given by formulas; kirsch, l_shape: those of the plate with a hole of `radius` at the origin under a tension `value`, or of the corner of 270 degrees at the origin."});
    d.field("x", &LoadParams::x, {.title = "x"});
    d.field("y", &LoadParams::y, {.title = "y"});
    d.field("value", &LoadParams::value, {.title = "Value"});
    d.field("from", &LoadParams::from, {.title = "From", .help = "Of a linear traction, pressure or body force: x, y, value hold here, x_to, y_to, value_to at `to`.", .unit = "m"});
    d.field("to", &LoadParams::to, {.title = "To", .unit = "m"});
    d.field("x_to", &LoadParams::x_to, {.title = "x at the end"});
    d.field("y_to", &LoadParams::y_to, {.title = "y at the end"});
    d.field("value_to", &LoadParams::value_to, {.title = "Value at the end"});
    d.field("x_formula", &LoadParams::x_formula, {.title = "x, formula", .help = "Of x, y, and of the outward normal nx, ny on a curve: \"3 * (1 - y^2)\"."});
    d.field("y_formula", &LoadParams::y_formula, {.title = "y, formula"});
    d.field("value_formula", &LoadParams::value_formula, {.title = "Value, formula", .help = "Of a pressure."});
    d.field("stress_xx", &LoadParams::stress_xx, {.title = "sigma_x, formula", .help = "Of x and y (stress).", .unit = "Pa"});
    d.field("stress_yy", &LoadParams::stress_yy, {.title = "sigma_y, formula", .unit = "Pa"});
    d.field("stress_xy", &LoadParams::stress_xy, {.title = "tau_xy, formula", .unit = "Pa"});
    d.field("radius", &LoadParams::radius, {.title = "Radius", .unit = "m", .above = 0});
    d.field("bisector", &LoadParams::bisector, {.title = "Bisector", .help = "Direction from the corner into the material (l_shape).", .unit = "deg"});
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
    d.field("settlement", &CaseParams::settlement, {.title = "Settlement", .help = "Multiplies prescribed displacements and values of ties in this case; 0: supports stand still."});
  }
};

enum class Plane { Stress, Strain };

struct ProblemParams {
  Plane state = Plane::Stress;
  std::vector<MaterialParams> materials;
  std::vector<SupportParams> supports;
  std::vector<SpringParams> springs;
  std::vector<TieParams> ties;
  std::vector<LoadParams> loads;
  std::vector<CaseParams> cases;

  template <class D>
  static void describe(D& d) {
    d.choice("state", &ProblemParams::state, {"stress", "strain"}, {.title = "Plane"});
    d.tables("material", &ProblemParams::materials, {.title = "Materials"});
    d.tables("support", &ProblemParams::supports, {.title = "Supports"});
    d.tables("spring", &ProblemParams::springs, {.title = "Springs"});
    d.tables("tie", &ProblemParams::ties, {.title = "Ties", .help = "Equations between displacements."});
    d.tables("load", &ProblemParams::loads, {.title = "Loads", .help = "Of one load case or several."});
    d.tables("case", &ProblemParams::cases, {.title = "Load cases", .help = "Only those with settings of their own, or without loads."});
  }
};

/// What is wrong with a problem on a domain, and in which table of the scenario.
struct ProblemFault {
  std::string key;      ///< "load"; empty: of no table.
  std::size_t row = 0;  ///< From 0.
  dobra::base::Error error;
};
/// Names that the domain has not, formulas that cannot be read, regions without a material, entries that do not go together.
std::optional<ProblemFault> fault_of(const Domain& domain, const ProblemParams& params);

/// Sets materials, supports and loads. @error that of fault_of, with "load 2" as its item.
dobra::base::Result<Model> set_problem(const Model& model, const ProblemParams& params, const dobra::scenario::Context& context,
                                       const dobra::base::Progress& progress);

/// The problem on one mesh. @error a name that the mesh has not, with a suggestion.
dobra::base::Result<dobra::fem::Problem> problem_of(const dobra::mesh::ElementMesh& mesh, const ProblemParams& params);

}  // namespace quebra::core
