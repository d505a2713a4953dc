#pragma once
// One turn of the chain that a model is: a section, the grid and the target that it was given, and what restoring it
// gave. The section after it is that of the next stage. Page: docs/algorithms/chain.md

#include <optional>

#include "recon/section/section.h"
#include "recon/unfold/grid.h"
#include "recon/unfold/restore.h"
#include "recon/unfold/target.h"

namespace recon::core {

struct Stage {
  section::Section section;                        ///< As it is before the restoration.
  std::optional<unfold::SourceGrid> source;        ///< After the step grid.
  std::optional<unfold::Target> target;            ///< After the step target.
  std::optional<unfold::Restoration> restoration;  ///< After the step restore.
};

/// The section that a restored stage leaves, fit to be that of the next one: ids, names and roles of the stage's, no
/// repeated points, every horizon from its left end to its right end and without small loops, faces of its own.
/// @param remarks  gets a line for each horizon whose loops were cut.
/// @pre   the stage has a restoration.
/// @error BadSection: a restored horizon or unit crosses itself or has no length left, with the place; those of
///        faces_of.
base::Result<section::Section> section_after(const Stage& stage, std::vector<std::string>& remarks);

}  // namespace recon::core
