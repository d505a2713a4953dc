#pragma once
// One turn of the chain that a model is: a section, and what it became: unfolded with a grid and a target, or with
// blocks moved along a fault, or restored block by block. The section after it is that of the next stage. Page:
// docs/algorithms/chain.md

#include <optional>

#include "recon/jigsaw/blockwise.h"
#include "recon/moving/move_section.h"
#include "recon/section/section.h"
#include "recon/unfold/grid.h"
#include "recon/unfold/restore.h"
#include "recon/unfold/target.h"

namespace recon::model {

struct Stage {
  section::Section section;                        ///< As it is before.
  std::optional<unfold::SourceGrid> source;        ///< After the step grid.
  std::optional<unfold::Target> target;            ///< After the step target.
  std::optional<unfold::Restoration> restoration;  ///< After the step restore.
  std::optional<moving::Moved> moved;              ///< After the step move, instead of the three above ...
  std::optional<jigsaw::Blockwise> blockwise;      ///< ... or after restore with blocks or as a jigsaw.
};

/// Whether it leaves another section than it has.
bool is_done(const Stage& stage);
/// That section as it was made.  @pre is_done(), as of all that follow.
const section::Section& section_made(const Stage& stage);

/// Where a point of its section goes, and where one of section_made() came from.
geom::Point forward(const Stage& stage, geom::Point p);
geom::Point inverse(const Stage& stage, geom::Point p);
/// Lines alike, with the vertices that the map needs.
geom::Polyline forward(const Stage& stage, const geom::Polyline& line);
geom::Polyline inverse(const Stage& stage, const geom::Polyline& line);

/// What it made of beds and units.
const std::vector<balance::LineLength>& lengths_of(const Stage& stage);
const std::vector<balance::UnitRow>& units_of(const Stage& stage);
const std::vector<std::string>& remarks_of(const Stage& stage);
/// "restoration", "move" or "restoration of blocks".
const char* what_was_done(const Stage& stage);

/// The section that a stage leaves, fit to be that of the next one: ids, names and roles of the stage's, no
/// repeated points, every horizon from its left end to its right end and without small loops, faces of its own.
/// @param remarks  gets a line for each horizon whose loops were cut.
/// @pre   is_done()
/// @error BadSection: a horizon or unit crosses itself or has no length left, with the place; those of
///        faces_of.
base::Result<section::Section> section_after(const Stage& stage, std::vector<std::string>& remarks);

}  // namespace recon::model
