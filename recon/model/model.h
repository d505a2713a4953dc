#pragma once
// The state that RECON's operations work on, a value: a chain of stages. The last stage is in hand; each earlier one is
// a section, how it was restored or moved, and with that the section of the next. Page: docs/algorithms/chain.md

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recon/model/findings.h"
#include "recon/model/stage.h"
#include "shared/io/lines/feature.h"

namespace recon::model {

/// What stands directly in it is the stage in hand.
struct Model : Stage {
  std::vector<std::string> remarks;                   ///< On the input.
  std::vector<std::shared_ptr<const Stage>> earlier;  ///< Stages that are done, the input's first.
  Findings findings;                                  ///< Of the steps that leave section and chain as they are.
  double along_strike = 0.0;                          ///< Of the block that the input stands for, m; 0: not said.
  std::optional<dobra::io::lines::Trace> trace;       ///< Where the input stands on the map, if that is known.
};

/// The section as it was read (with a topography as a horizon, where the first grid stands on one).
const section::Section& input_section(const Model& model);

/// The stages that are done, in order: the earlier ones, and the one in hand if it is.
std::vector<const Stage*> restored_stages(const Model& model);

/// A new stage in hand with nothing but its section. What a stage gave that is not done is forgotten.
/// @error those of section_after().
base::Result<Model> next_stage(const Model& model);

/// The section as it is now: what the stage in hand made of it, or before that its own.
const section::Section& current_section(const Model& model);

}  // namespace recon::model
