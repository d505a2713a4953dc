#pragma once
// A section in which blocks moved along a fault: every line, polygon, marker and other fault of them by one map,
// everything else as it was, bit for bit. Page: docs/algorithms/move.md

#include <string>
#include <vector>

#include "recon/balance/balance.h"
#include "recon/balance/ledger.h"
#include "recon/faults/fault.h"
#include "recon/moving/moving_part.h"
#include "recon/moving/solve.h"
#include "recon/section/section.h"
#include "shared/base/progress.h"

namespace recon::moving {

/// What moved. A line or polygon that the fault parts falls into pieces, of which those that move are here.
struct MovedPiece {
  std::string name;
  std::string kind;  ///< "horizon", "growth", "unit", "marker", "border", or that of the line.
  geom::Polyline after;
};

/// What the moved block leaves open along the fault, and where it lies in the other wall. m2, and the places of the
/// greatest of each.
struct OpenedArea {
  double gap = 0.0, overlap = 0.0;
  geom::Point gap_at, overlap_at;
};

struct Moved {
  MoveParams params;    ///< It was made with these.
  faults::Fault fault;  ///< Before the move, as it runs for the slip.
  Motion motion;
  std::vector<std::string> blocks;  ///< That moved; none for methods with a tip.
  section::Section section;         ///< After the move: ids and names of the section's, new ones for further pieces.
  std::vector<MovedPiece> pieces;
  std::vector<Misfit> misfit;                ///< Of every horizon that the fault cuts on both walls.
  OpenedArea opened;                         ///< Of the whole hanging wall; of no meaning where other blocks move.
  bool whole_wall = true;                    ///< Whether just the blocks of the hanging wall move.
  std::vector<balance::LineLength> lengths;  ///< One for each horizon before the move.
  std::vector<balance::UnitRow> units;       ///< Polygons, or without any what lies between horizons.
  std::vector<std::string> remarks;
  MovingPart before;  ///< What moves, ...
  MovingPart after;   ///< ... and where it lies then.

  /// Points and lines of the section before; what lies on the boundary of the block stays. A line is cut there, and
  /// jumps.
  [[nodiscard]] geom::Point forward(geom::Point p) const;
  [[nodiscard]] geom::Polyline forward(const geom::Polyline& line) const;
  /// Of the section after. What now lies in a block and in the rest came with the block.
  [[nodiscard]] geom::Point inverse(geom::Point p) const;
  [[nodiscard]] geom::Polyline inverse(const geom::Polyline& line) const;
};

/// @error BadValue: those of check_params(), names of nothing; BadSection: those of faults_of(), cutoffs_of() and
///        Blocks, cutoffs that are missing or ambiguous where slip is solved from them, blocks that overlap;
///        CannotRestore: those of make_motion() and solve_slip(), a tip that would leave the section. With the place.
base::Result<Moved> move_block(const section::Section& section, const MoveParams& params,
                               const base::Progress& progress);

}  // namespace recon::moving
