#pragma once
// Every line, polygon and marker of a section through the map of a move, cut where the block ends.

#include "recon/moving/move_section.h"

namespace recon::moving {

/// Fills section, pieces, lengths, units and remarks of `moved` from its map and its part `before`.
/// @param fault      what moves along; its pieces stay, but for the tip of methods that have one.
/// @param overshoot  ends of lines that cross the fault by no more are no pieces, m.
/// @error those of MovingPart::split_area() and faces_of().
base::Result<void> move_lines(const section::Section& section, const std::vector<section::LineId>& fault,
                              double overshoot, Moved& moved);

}  // namespace recon::moving
