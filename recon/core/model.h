#pragma once
// The state that RECON's operations work on: the section as read, and what each step has added. A value.

#include <optional>
#include <string>
#include <vector>

#include "recon/core/area_balance.h"
#include "recon/core/area_depth.h"
#include "recon/core/grid.h"
#include "recon/core/monte_carlo.h"
#include "recon/core/restore.h"
#include "recon/core/section.h"
#include "recon/core/target.h"

namespace recon::core {

struct Model {
  Section section;
  std::vector<std::string> remarks;         ///< On the input.
  std::optional<SourceGrid> source;         ///< After the step grid.
  std::optional<Target> target;             ///< After the step target.
  std::optional<Restoration> restoration;   ///< After the step restore.
  std::optional<MonteCarlo> monte_carlo;    ///< After the step monte_carlo.
  std::optional<AreaDepth> area_depth;      ///< After the step balance.
  std::optional<AreaBalance> area_balance;  ///< After the step area_balance.
};

}  // namespace recon::core
