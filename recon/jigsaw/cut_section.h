#pragma once
// A section cut into its blocks: every line and polygon of it lies in one of them, or in none.
// Page: docs/algorithms/jigsaw.md

#include <optional>
#include <span>
#include <vector>

#include "recon/faults/blocks.h"
#include "recon/faults/cutoffs.h"
#include "recon/moving/moving_part.h"

namespace recon::jigsaw {

/// A block that is taken out of its section.
struct Part {
  faults::BlockId id;
  std::string name;
  std::vector<geom::Polyline> contours;  ///< Of its rock.
  geom::Box within;                      ///< Round all that the section can have of the block.
  moving::MovingPart area;               ///< As far as the plane between its faults goes.
};

/// @error those of area_of_blocks() and MovingPart.
base::Result<std::vector<Part>> parts_of(const section::Section& section, const std::vector<faults::Fault>& faults,
                                         const faults::Blocks& blocks, std::span<const faults::BlockId> chosen);

/// A line in its parts, in order; by index among the blocks, nothing in none of them.
struct PartOfLine {
  geom::Polyline line;
  std::optional<std::size_t> part;
  double trimmed = 0.0;  ///< m that reached across a fault and were cut off.
};
std::vector<PartOfLine> split(const geom::Polyline& line, const std::vector<Part>& parts, double overshoot);

/// Which line a piece comes from, and in which of the blocks it lies.
struct Origin {
  std::size_t index = 0;
  std::optional<std::size_t> part;
};

struct CutSection {
  /// With the ids and names of the given one; further pieces stand at the end. Horizons of the blocks end on the faults
  /// that cut them off; what lies in none of the blocks is as it was, bit for bit.
  section::Section section;
  std::vector<Origin> horizons, lines, units;  ///< Of each.
  std::vector<std::string> remarks;
};

/// @param boundary  the lines of faults that bound blocks: they stay whole.
/// @error those of MovingPart::split_area().
base::Result<CutSection> cut(const section::Section& section, const std::vector<Part>& parts,
                             const std::vector<faults::FaultCutoffs>& cutoffs,
                             const std::vector<section::LineId>& boundary, double overshoot);

}  // namespace recon::jigsaw
