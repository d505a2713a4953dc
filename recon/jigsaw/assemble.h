#pragma once
// The unfolded blocks put together again to a section with its ledger. Page: docs/algorithms/jigsaw.md

#include "recon/jigsaw/blockwise.h"

namespace recon::jigsaw {

/// Fills rows, section, lengths, units and widths from blocks and faults.
void assemble(const CutSection& cut, const std::vector<faults::Fault>& faults, const faults::Blocks& blocks,
              Blockwise& made);

/// Fills balance and the worst fault. @pre assembled.
/// @param cutoffs  before the restoration.  @param target  that the blocks lie on; null: a level datum.
void judge(const faults::Blocks& blocks, const std::vector<faults::FaultWall>& walls,
           const std::vector<faults::FaultCutoffs>& cutoffs, const TargetLine* target, Blockwise& made);

/// The verdict and what it rests on, in words.
std::string verdict_text(const Blockwise& made);

}  // namespace recon::jigsaw
