#pragma once
// The analysis of the last mesh, and what is derived from it: recovered stresses, error, crack tips.
// Page: docs/algorithms/fem.md.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quebra/analysis/loaded_points.h"
#include "quebra/analysis/problem.h"
#include "shared/fem/error/estimate.h"
#include "shared/fem/error/hot_spots.h"
#include "shared/fem/fracture/crack.h"
#include "shared/scenario/program.h"

namespace quebra::analysis {

enum class PointForces { LeaveOut, Count };

/// How the error of an analysis is judged: part of the parameters of `analyse` and `adapt`.
struct EstimateParams {
  PointForces point_forces = PointForces::LeaveOut;
  double point_radius = 0.0;
  std::vector<double> exact_energy;

  template <class P, class D>
  static void describe_in(D& d) {
    d.choice("point_forces", of<P>(&EstimateParams::point_forces), {"leave_out", "count"},
             {.title = "Forces at points",
              .help = "leave_out: the surroundings of points with a force or reaction of their own, where the energy "
                      "is infinite, do not count for the error; count: they do, and no mesh meets a small error."});
    d.field("point_radius", of<P>(&EstimateParams::point_radius),
            {.title = "Radius round points",
             .help = "Of those surroundings; 0 takes 1/20 of the room round each: thickness of the material, other "
                     "boundaries, cracks.",
             .unit = "m",
             .at_least = 0});
    d.field("exact_energy", of<P>(&EstimateParams::exact_energy),
            {.title = "Exact energy",
             .help = "Strain energy where it is known, one a load case in their order, 0 where it is not: the true "
                     "error and the effectivity of the estimate are told. Only with supports that stand still.",
             .unit = "J"});
  }

 private:
  template <class P, class T>
  static T P::*of(T EstimateParams::*member) {
    return member;
  }
};

struct AnalyseParams : EstimateParams {
  double memory = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field("memory", &AnalyseParams::memory,
            {.title = "Memory",
             .help = "Most that the factorisation may take; 0 takes what the machine has.",
             .unit = "B",
             .at_least = 0});
    EstimateParams::describe_in<AnalyseParams>(d);
  }
};

/// One case of an analysis with what is derived from it.
struct CaseFields {
  dobra::fem::error::RecoveredStress recovered;
  dobra::fem::error::ErrorEstimate estimate;
  std::vector<dobra::fem::error::HotSpot> peaks = {};  ///< Greatest stress first.
  std::vector<LoadedPoint> loaded = {};                ///< Points with a force of their own.
  std::optional<double> exact_energy = std::nullopt;   ///< Where it is known, J.
};

struct Analysis {
  std::shared_ptr<const model::Meshed> meshed;
  dobra::fem::Problem problem = {};
  dobra::fem::Solution solution = {};
  std::vector<dobra::fem::error::SingularVertex> singular = {};
  std::vector<CaseFields> fields = {};  ///< One a case.
  double eta = 0.0;                     ///< Greatest of the cases.
  double peak_eta = 0.0;                ///< Greatest of the elements round a peak of stress; 0: no peak.
  /// Whether the estimate leaves the loaded points' surroundings out.
  PointForces point_forces = PointForces::LeaveOut;
  int cycle = 0;                                                        ///< Of an adaptive loop, from 1; 0: not of one.
  std::vector<std::vector<dobra::fem::fracture::TipResult>> tips = {};  ///< By case; empty until the crack step.
};

/// Analyses the last mesh and adds the analysis to the model.
/// @error BadValue: no mesh or no problem; those of fem::solve.
dobra::base::Result<model::Model> add_analysis(const model::Model& model, const AnalyseParams& params,
                                               const dobra::scenario::Context& context,
                                               const dobra::base::Progress& progress);

/// The analysis of one mesh of a domain. @error as add_analysis
dobra::base::Result<Analysis> analyse(const domain::Domain& domain, std::shared_ptr<const model::Meshed> meshed,
                                      const ProblemParams& problem, double memory, const EstimateParams& judged,
                                      const dobra::base::Progress& progress);

/// What the user should know of an analysis's error: points left out of it, an exact energy that cannot be.
std::vector<std::string> remarks_on(const Analysis& analysis);
/// The true error of a case, sqrt(J), and the estimated one as a multiple of it; nothing where the exact energy is not
/// known, or cannot be compared: forces at points, an energy above it.
struct Truth {
  double error = 0.0;
  std::optional<double> effectivity = std::nullopt;  ///< Nothing if the error is but the last digits of the energy.
};
std::optional<Truth> truth_of(const Analysis& analysis, std::size_t load_case);

/// What the analyses of a model add to what layers.h says of it.
void add_analysis_quantities(const model::Model& model, std::vector<dobra::scenario::Quantity>& quantities);
void add_analysis_tables(const model::Model& model, std::vector<dobra::scenario::DataTable>& tables);
void add_analysis_outputs(const std::shared_ptr<const model::Model>& model,
                          std::vector<dobra::scenario::Output>& outputs);

}  // namespace quebra::analysis
