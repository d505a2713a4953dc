#pragma once
// The state that RECON's operations work on, a value: a chain of stages. The last stage is in hand; each earlier one is
// a section, how it was restored, and with that the section of the next. Page: docs/algorithms/chain.md

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recon/core/area_balance.h"
#include "recon/core/area_depth.h"
#include "recon/core/carry.h"
#include "recon/core/monte_carlo.h"
#include "recon/core/stage.h"

namespace dobra::operations {
struct Offsets;
}

namespace recon::core {

/// What stands directly in it is the stage in hand.
struct Model : Stage {
  std::vector<std::string> remarks;                                        ///< On the input.
  std::vector<std::shared_ptr<const Stage>> earlier;                       ///< Restored stages, the input's first.
  std::optional<MonteCarlo> monte_carlo;                                   ///< After the step monte_carlo.
  std::optional<AreaDepth> area_depth;                                     ///< After the step balance.
  std::optional<AreaBalance> area_balance;                                 ///< After the step area_balance.
  std::vector<CarriedLines> carried;                                       ///< One for each step carry.
  std::vector<std::shared_ptr<const dobra::operations::Offsets>> offsets;  ///< One for each step offset.
};

/// Forgets what was carried to or from a state that is to be restored anew.
void forget_carried(Model& model);

/// The section as it was read (with a topography as a horizon, where the first grid stands on one).
const Section& input_section(const Model& model);

/// The restored stages in order: the earlier ones, and the one in hand if it is restored.
std::vector<const Stage*> restored_stages(const Model& model);

}  // namespace recon::core
