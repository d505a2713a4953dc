#pragma once
// A section restored block by block: each by an unfolding method with a pin of its own, alone or slid together to the
// classical restoration of a faulted section to a datum. Page: docs/algorithms/jigsaw.md

#include <optional>
#include <string>
#include <vector>

#include "recon/jigsaw/fault_fit.h"

namespace recon::jigsaw {

struct BlockRow {
  std::string name;
  std::optional<double> shift;  ///< m towards +x after unfolding; nothing: the block is not restored.
  /// Of a rigid block, by the middle of its beds, whose shift is then that: m upwards, and degrees anticlockwise.
  std::optional<double> raise = std::nullopt, turn = std::nullopt;
  /// Of the shift of a block that has slid, one standard deviation, m, by the slide errors of the faults between it and
  /// the pinned one; nothing where one of these is not known.
  std::optional<double> shift_error = std::nullopt;
};

/// The section's width along the top, m.
struct Widths {
  double before = 0.0;  ///< From its leftmost to its rightmost end.
  double after = 0.0;
  double faults = 0.0;  ///< What the faults have shortened it by.
  [[nodiscard]] double shortening() const { return after - before; }
  [[nodiscard]] double folding() const { return shortening() - faults; }
};

struct Blockwise {
  unfold::RestoreParams params;  ///< It was made with these.
  BlockwiseParams how;
  std::vector<Part> parts;                   ///< The blocks that the section is cut into.
  std::vector<UnfoldedBlock> blocks;         ///< Those of them that are unfolded.
  std::vector<Tie> ties;                     ///< Between those, by which they have slid.
  std::size_t pinned = 0;                    ///< The one of them that stays.
  std::vector<BlockRow> rows;                ///< Of all blocks of the section.
  std::vector<RestoredFault> faults;         ///< Of a jigsaw: all faults.
  section::Section section;                  ///< After it.
  std::vector<balance::LineLength> lengths;  ///< One for each horizon after it, in the same order.
  std::vector<balance::UnitRow> units;       ///< Of the unfolded blocks together.
  balance::Balance balance;
  double greatest_opening_percent = 0.0;  ///< Gap and overlap along a fault, of the smallest block that it bounds.
  std::string worst_fault;
  /// Between the restored cutoffs of a bed on both walls of a fault: heights, percent of the depth of the lowest bed.
  double greatest_offset_percent = 0.0;
  std::string worst_offset;  ///< That bed.
  Widths widths;
  std::vector<std::string> remarks;
  double size = 0.0;  ///< Of the section, m.

  /// Points and lines of the section before; what lies in no unfolded block, or on its faults, stays. A line is cut
  /// between blocks, and jumps.
  [[nodiscard]] geom::Point forward(geom::Point p) const;
  [[nodiscard]] geom::Polyline forward(const geom::Polyline& line) const;
  /// Of the section after it. What lies in two blocks comes from the left one.
  [[nodiscard]] geom::Point inverse(geom::Point p) const;
  [[nodiscard]] geom::Polyline inverse(const geom::Polyline& line) const;
};

/// @error BadValue: those of check_params(), a pin beside the top; BadSection: no fault, no such block, those of
///        faults_of() and Blocks; CannotRestore: those of unfold_block(), facing_walls(), slide() and turn_and_shift(),
///        no block with the top, a block with beds but without the top. With the place.
base::Result<Blockwise> restore_blockwise(const section::Section& section, const BlockwiseParams& how,
                                          const unfold::RestoreParams& params, const base::Progress& progress);

}  // namespace recon::jigsaw
