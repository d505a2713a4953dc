#pragma once
// The elastic problem on a domain as scenario files write it: materials, supports, springs, ties and loads by the names
// of regions, curves and points. Page: docs/algorithms/fem.md.

#include <optional>
#include <string>
#include <vector>

#include "quebra/analysis/load_params.h"
#include "quebra/model/model.h"
#include "shared/base/progress.h"
#include "shared/fem/problem.h"
#include "shared/scenario/program.h"

namespace quebra::analysis {

struct MaterialParams {
  std::string region;
  double young = 0.0;
  double poisson = 0.3;
  double thickness = 1.0;

  template <class D>
  static void describe(D& d) {
    d.field("region", &MaterialParams::region,
            {.title = "Region", .help = "Empty: every region that has no material of its own.", .names = "region"});
    d.field("young", &MaterialParams::young,
            {.title = "Young's modulus", .unit = "Pa", .above = 0, .presence = dobra::scenario::Presence::Required});
    d.field("poisson", &MaterialParams::poisson,
            {.title = "Poisson's ratio", .help = "Below 0.5 in plane strain.", .above = -1, .at_most = 0.5});
    d.field("thickness", &MaterialParams::thickness, {.title = "Thickness", .unit = "m", .above = 0});
  }
};

struct SupportParams {
  std::string where;
  std::optional<double> x, y, normal;
  std::string x_formula, y_formula;
  dobra::base::Place place = {};  ///< Of its table in the scenario.

  template <class D>
  static void describe(D& d) {
    d.field("where", &SupportParams::where,
            {.title = "Where",
             .help = "Name of a curve, a lip or a point; or a condition, such as \"x = 0 and y > 1\".",
             .names = "place",
             .presence = dobra::scenario::Presence::Required});
    d.field("x", &SupportParams::x,
            {.title = "Along x", .help = "Prescribed displacement; 0 holds, nothing leaves free.", .unit = "m"});
    d.field("y", &SupportParams::y, {.title = "Along y", .unit = "m"});
    d.field(
        "normal", &SupportParams::normal,
        {.title = "Across", .help = "Along the outward normal of the curve; 0 is a line of symmetry.", .unit = "m"});
    d.field("x_formula", &SupportParams::x_formula,
            {.title = "Along x, formula", .help = "Of x and y; with y or y_formula.", .unit = "m"});
    d.field("y_formula", &SupportParams::y_formula,
            {.title = "Along y, formula", .help = "Of x and y; with x or x_formula.", .unit = "m"});
  }
};

struct SpringParams {
  std::string where;
  dobra::fem::SpringKind kind = dobra::fem::SpringKind::EachNode;
  double x = 0.0;
  double y = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field("where", &SpringParams::where,
            {.title = "Where",
             .help = "Name of a curve, a lip or a point; or a condition, such as \"x = 0 and y > 1\".",
             .names = "place",
             .presence = dobra::scenario::Presence::Required});
    d.choice("kind", &SpringParams::kind, {"node", "bed"},
             {.title = "Kind", .help = "node: a spring at each node, N/m; bed: along a curve, N/m3."});
    d.field("x", &SpringParams::x, {.title = "Stiffness along x", .unit = "N/m, N/m3 if kind = bed", .at_least = 0});
    d.field("y", &SpringParams::y, {.title = "Stiffness along y", .unit = "N/m, N/m3 if kind = bed", .at_least = 0});
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
    d.field("where", &TieParams::where,
            {.title = "Where",
             .help = "Name of a curve, or a condition such as \"y = 2\", whose nodes all move alike along `axis`.",
             .names = "place"});
    d.choice("axis", &TieParams::axis, {"x", "y"}, {.title = "Axis", .when = "where is set"});
    d.field("points", &TieParams::points,
            {.title = "Points",
             .help = "Or: sum of coefficient times displacement of these points = value.",
             .names = "point"});
    d.field("axes", &TieParams::axes,
            {.title = "Axes", .help = "\"x\" or \"y\", one a point.", .when = "points is set"});
    d.field("coefficients", &TieParams::coefficients,
            {.title = "Coefficients", .help = "One a point.", .when = "points is set"});
    d.field("value", &TieParams::value, {.title = "Value", .unit = "m"});
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
    d.tables("case", &ProblemParams::cases,
             {.title = "Load cases", .help = "Only those with settings of their own, or without loads."});
  }
};

/// What is wrong with a problem on a domain, and in which table of the scenario.
struct ProblemFault {
  std::string key;      ///< "load"; empty: of no table.
  std::size_t row = 0;  ///< From 0.
  dobra::base::Error error;
};
/// Names that the domain has not, formulas that cannot be read, regions without a material, entries that do not go
/// together.
std::optional<ProblemFault> fault_of(const domain::Domain& domain, const ProblemParams& params);

/// Sets materials, supports and loads. @error that of fault_of, with "load 2" as its item.
dobra::base::Result<model::Model> set_problem(const model::Model& model, const ProblemParams& params,
                                              const dobra::scenario::Context& context,
                                              const dobra::base::Progress& progress);

/// What stands under `where` in supports, springs, ties and loads: names and conditions (selection.h).
std::vector<std::string> places_of(const ProblemParams& params);

/// Whether a support or tie prescribes a displacement that is not 0.
bool moves(const ProblemParams& params);

/// The problem on one mesh. @error a name that the mesh has not, with a suggestion.
dobra::base::Result<dobra::fem::Problem> problem_of(const dobra::mesh::ElementMesh& mesh, const ProblemParams& params);

/// Each support and load by itself: @error that of the first whose formula has no finite value somewhere, with its line
/// and the place.
dobra::base::Result<void> check_finite(const dobra::mesh::ElementMesh& mesh, const ProblemParams& params,
                                       const dobra::fem::Problem& problem);

}  // namespace quebra::analysis
