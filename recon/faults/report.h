#pragma once
// All that there is to tell of the faults of a section. Page: docs/user/faults.md

#include <optional>
#include <string>
#include <vector>

#include "recon/faults/blocks.h"
#include "recon/faults/cutoffs.h"
#include "recon/faults/displacement.h"

namespace recon::faults {

/// The operation `faults`.
struct FaultsParams {
  std::optional<double> tolerance;
  template <class D>
  static void describe(D& d) {
    d.field(
        "tolerance", &FaultsParams::tolerance,
        {.title = "Tolerance of cutoffs",
         .help = "Ends of horizons nearer to a fault than this are cut off by it; by default 0.005 of the section's "
                 "diagonal.",
         .unit = "m",
         .above = 0.0});
  }
};

struct FaultReport {
  double tolerance = 0.0;  ///< m
  std::vector<Fault> faults;
  std::vector<FaultCutoffs> cutoffs;                ///< Of each fault.
  std::vector<std::vector<ProfilePoint>> profiles;  ///< Of each fault.
  std::vector<Block> blocks;
  std::vector<std::string> remarks;
};

/// @pre   the section has its faces.
/// @error BadSection: no fault; those of faults_of and Blocks::make.
base::Result<FaultReport> report_faults(const section::Section& section, const FaultsParams& params);

}  // namespace recon::faults
