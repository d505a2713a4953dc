#pragma once
// What a section tells of what it does not show: the operation `predict`. Page: docs/algorithms/rollover.md

#include <utility>
#include <vector>

#include "recon/inversion/predict_params.h"
#include "recon/section/section.h"

namespace recon::inversion {

struct Predicted {
  PredictParams params;
  /// "fault", "regional" or "bed".
  struct Line {
    std::string kind;
    geom::Polyline line;
  };
  std::vector<Line> lines;
  /// Of folds one list for each solution. Degrees, m, m2.
  std::vector<std::vector<std::pair<std::string, double>>> solutions;
  std::vector<std::string> remarks;
};

/// @error BadValue: what is missing or of no use; BadSection: no such fault or horizon, a bed without both cutoffs;
///        those of fault_under(), shear_over(), bend_folds_of(), propagation_fold_of(). With the place.
base::Result<Predicted> predict(const section::Section& section, const PredictParams& params);

}  // namespace recon::inversion
