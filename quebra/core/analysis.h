#pragma once
// The elastic problem on a domain, by the names of its regions, curves and points, and its analysis on the last mesh.
// Page: docs/algorithms/fem.md.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quebra/core/model.h"
#include "shared/base/progress.h"
#include "shared/fem/crack.h"
#include "shared/fem/estimate.h"
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
    d.field("young", &MaterialParams::young, {.title = "Young's modulus", .unit = "Pa", .presence = dobra::scenario::Presence::Required});
    d.field("poisson", &MaterialParams::poisson, {.title = "Poisson's ratio"});
    d.field("thickness", &MaterialParams::thickness, {.title = "Thickness", .unit = "m"});
  }
};

struct SupportParams {
  std::string where;
  std::optional<double> x, y, normal;

  template <class D>
  static void describe(D& d) {
    d.field("where", &SupportParams::where, {.title = "Where", .help = "Name of a curve, a lip or a point.", .presence = dobra::scenario::Presence::Required});
    d.field("x", &SupportParams::x, {.title = "Along x", .help = "Prescribed displacement; 0 holds, nothing leaves free.", .unit = "m"});
    d.field("y", &SupportParams::y, {.title = "Along y", .unit = "m"});
    d.field("normal", &SupportParams::normal, {.title = "Across", .help = "Along the outward normal of the curve; 0 is a line of symmetry.", .unit = "m"});
  }
};

enum class LoadKind { Traction, Pressure, Force, Body, Kirsch, Corner };

struct LoadParams {
  std::string where;
  LoadKind kind = LoadKind::Traction;
  double x = 0.0;
  double y = 0.0;
  double value = 0.0;
  double radius = 1.0;
  dobra::base::Angle bisector = dobra::base::Angle::from_degrees(135.0);
  std::string load_case = "load";

  template <class D>
  static void describe(D& d) {
    d.field("where", &LoadParams::where, {.title = "Where", .help = "Name of a curve or lip; of a point (force); of a region, or empty for all (body)."});
    d.choice("kind", &LoadParams::kind, {"traction", "pressure", "force", "body", "kirsch", "l_shape"},
             {.title = "Kind", .help = "traction x, y in Pa; pressure: value in Pa; force x, y in N; body x, y in N/m3; the exact tractions of the plate with a hole of `radius` at the origin under a tension `value`, or of the corner of 270 degrees at the origin."});
    d.field("x", &LoadParams::x, {.title = "x"});
    d.field("y", &LoadParams::y, {.title = "y"});
    d.field("value", &LoadParams::value, {.title = "Value"});
    d.field("radius", &LoadParams::radius, {.title = "Radius", .unit = "m", .above = 0});
    d.field("bisector", &LoadParams::bisector, {.title = "Bisector", .help = "Direction from the corner into the material (l_shape).", .unit = "deg"});
    d.field("case", &LoadParams::load_case, {.title = "Load case"});
  }
};

enum class Plane { Stress, Strain };

struct ProblemParams {
  Plane state = Plane::Stress;
  std::vector<MaterialParams> materials;
  std::vector<SupportParams> supports;
  std::vector<LoadParams> loads;

  template <class D>
  static void describe(D& d) {
    d.choice("state", &ProblemParams::state, {"stress", "strain"}, {.title = "Plane"});
    d.tables("material", &ProblemParams::materials, {.title = "Materials"});
    d.tables("support", &ProblemParams::supports, {.title = "Supports"});
    d.tables("load", &ProblemParams::loads, {.title = "Loads", .help = "Of one load case or several."});
  }
};

struct AnalyseParams {
  double memory = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field("memory", &AnalyseParams::memory, {.title = "Memory", .help = "Most that the factorisation may take; 0 takes what the machine has.", .unit = "B", .at_least = 0});
  }
};

/// One case of an analysis with what is derived from it.
struct CaseFields {
  dobra::fem::RecoveredStress recovered;
  dobra::fem::ErrorEstimate estimate;
};

struct Analysis {
  std::shared_ptr<const Meshed> meshed;
  dobra::fem::Problem problem = {};
  dobra::fem::Solution solution = {};
  std::vector<CaseFields> fields = {};  ///< One a case.
  double eta = 0.0;                ///< Greatest of the cases.
  int cycle = 0;                   ///< Of an adaptive loop, from 1; 0: not of one.
  std::vector<std::vector<dobra::fem::TipResult>> tips = {};  ///< By case; empty until the crack step.
};

/// Sets materials, supports and loads; names are looked up when a mesh is analysed.
dobra::base::Result<Model> set_problem(const Model& model, const ProblemParams& params, const dobra::scenario::Context& context,
                                       const dobra::base::Progress& progress);

/// Analyses the last mesh and adds the analysis to the model.
/// @error BadValue: no mesh or no problem; those of fem::solve.
dobra::base::Result<Model> add_analysis(const Model& model, const AnalyseParams& params, const dobra::scenario::Context& context,
                                        const dobra::base::Progress& progress);

/// The analysis of one mesh. @error as add_analysis
dobra::base::Result<Analysis> analyse(std::shared_ptr<const Meshed> meshed, const ProblemParams& problem, double memory,
                                      const dobra::base::Progress& progress);

/// What the analyses of a model add to what layers.h says of it.
void add_analysis_quantities(const Model& model, std::vector<dobra::scenario::Quantity>& quantities);
void add_analysis_tables(const Model& model, std::vector<dobra::scenario::DataTable>& tables);
void add_analysis_outputs(const Model& model, std::vector<dobra::scenario::Output>& outputs);
void add_analysis_panel(const Model& model, dobra::scene::Picture& picture);

}  // namespace quebra::core
