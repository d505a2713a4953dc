#pragma once
// A bed that is in several pieces within one block, made one. Page: docs/algorithms/jigsaw.md

#include <string>
#include <vector>

#include "recon/jigsaw/cut_section.h"

namespace recon::jigsaw {

/// In every part the pieces of the bed become one line, straight across the gaps between them, with a remark for each
/// gap. Cutoffs name the joined line, or nothing where they were at a gap.
/// @param size  of the section, m.
/// @error CannotRestore: pieces of which one lies beside the other, so that they are not one line, with the place.
base::Result<void> join_pieces(const std::string& bed, const std::vector<Part>& parts, double size, CutSection& cut,
                               std::vector<faults::FaultCutoffs>& cutoffs);

}  // namespace recon::jigsaw
