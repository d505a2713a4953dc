#pragma once
// The operation `faults`.

#include "recon/faults/report.h"
#include "recon/model/model.h"
#include "shared/scenario/program.h"

namespace recon::core {

/// The report, and the section that it is of.
struct FoundFaults {
  section::Section section;
  faults::FaultReport report;
};

/// Cutoffs, displacement and blocks of the section as it is now: restored, if it is.
base::Result<model::Model> run_faults(const model::Model& model, const faults::FaultsParams& params,
                                      const dobra::scenario::Context& context, const base::Progress& progress);

/// Quantities: fault.NAME.HORIZON.separation, .throw, .heave; block.NAME.area. Tables cutoffs and blocks; in the
/// picture the blocks, and displacement against distance.
dobra::scenario::Operation faults_step();

}  // namespace recon::core
