#pragma once
// Restoration: every line of the section carried from the source columns to the target columns. Requirements REC-2..5.
// Page: docs/algorithms/unfold.md

#include <string>
#include <vector>

#include "recon/core/balance.h"
#include "recon/core/map.h"
#include "recon/core/section.h"
#include "recon/core/target.h"
#include "shared/base/progress.h"

namespace recon::core {

/// What restoration keeps. Further methods join here.
enum class RestoreMethod { ConstantThickness };

/// Parameters of the step `restore`.
struct RestoreParams {
  RestoreMethod method = RestoreMethod::ConstantThickness;
  double tolerance = 2.0;
  template <class D>
  static void describe(D& d) {
    d.choice(
        "method", &RestoreParams::method, {"constant"},
        {.title = "Method", .help = "constant: keeps the length of the top and the depth of every point below it."});
    d.field("tolerance", &RestoreParams::tolerance,
            {.title = "Balance tolerance",
             .help = "Greatest change of a bed's length in a balanced section.",
             .unit = "%",
             .at_least = 0.0});
  }
};

struct Restoration {
  Section section;                  ///< The restored horizons, with the ids and names of the section's.
  std::vector<MappedLine> lines;    ///< One for each horizon, in the same order.
  std::vector<LineLength> lengths;  ///< Likewise.
  Balance balance;
  double tolerance_percent = 0.0;
  std::vector<std::string> remarks;
};

/// @error Cancelled
base::Result<Restoration> restore(const Section& section, const ColumnMap& map, const RestoreParams& params,
                                  const base::Progress& progress);

}  // namespace recon::core
