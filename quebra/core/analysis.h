#pragma once
// The analysis of the last mesh, and what is derived from it: recovered stresses, error, crack tips.
// Page: docs/algorithms/fem.md.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "quebra/core/problem.h"
#include "shared/fem/crack.h"
#include "shared/fem/estimate.h"
#include "shared/fem/hot_spots.h"
#include "shared/scenario/program.h"

namespace quebra::core {

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
  std::vector<dobra::fem::HotSpot> peaks = {};  ///< Greatest stress first.
};

struct Analysis {
  std::shared_ptr<const Meshed> meshed;
  dobra::fem::Problem problem = {};
  dobra::fem::Solution solution = {};
  std::vector<dobra::fem::SingularVertex> singular = {};
  std::vector<CaseFields> fields = {};  ///< One a case.
  double eta = 0.0;                ///< Greatest of the cases.
  double peak_eta = 0.0;           ///< Greatest of the elements round a peak of stress; 0: no peak.
  int cycle = 0;                   ///< Of an adaptive loop, from 1; 0: not of one.
  std::vector<std::vector<dobra::fem::TipResult>> tips = {};  ///< By case; empty until the crack step.
};

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

}  // namespace quebra::core
