#pragma once
// The walls of the faults of unfolded blocks: how far the blocks slide so that the walls meet, what stays open, and the
// restored faults. Page: docs/algorithms/jigsaw.md

#include <optional>
#include <string>
#include <vector>

#include "recon/jigsaw/slide.h"
#include "recon/jigsaw/unfold_block.h"
#include "recon/jigsaw/wall.h"

namespace recon::jigsaw {

/// Both walls of a fault, each of one unfolded block, where they stand beside each other.
struct FacingWalls {
  std::size_t fault = 0;
  std::size_t left = 0, right = 0;  ///< Unfolded blocks.
  WallPair walls;
};

/// What the jigsaw has to do with, besides the blocks.
struct FaultSetting {
  const std::vector<faults::Fault>& faults;
  const std::vector<faults::FaultCutoffs>& cutoffs;
  std::vector<faults::FaultWall> walls;
  std::string top;
  double size = 0.0;                   ///< Of the section, m.
  const TargetLine* target = nullptr;  ///< That the blocks lie on; else they lie on their datum.
};

/// Of all faults, on the datum's side of the layers, as the blocks are placed.
/// @error CannotRestore: a wall turns up or down where the other one does not, with the place.
base::Result<std::vector<FacingWalls>> facing_walls(const FaultSetting& setting,
                                                    const std::vector<UnfoldedBlock>& blocks);

/// What the fit asks of the blocks: that walls lie near to each other, or that the ends of the top meet. Walls count
/// the less the deeper they lie, as the noise of the picks of the top makes them lean.
std::vector<Tie> ties_of_walls(const std::vector<FacingWalls>& facing, const std::vector<UnfoldedBlock>& blocks,
                               double size);
std::vector<Tie> ties_of_top(const FaultSetting& setting, const std::vector<UnfoldedBlock>& blocks);

/// A fault after the jigsaw.
struct RestoredFault {
  std::string name;
  bool measured = false;             ///< Both walls are of unfolded blocks that stand beside each other.
  Opening opening;                   ///< Between the walls.
  geom::Polyline line;               ///< In the middle between them, from its lower end; empty if not measured.
  std::optional<double> dip;         ///< Of the straight line between its ends, degrees in [0, 90].
  std::optional<double> shortening;  ///< That the fault has brought the top, m: its heave; < 0: extension.
  std::optional<double> left_apart;  ///< Fit by the top: how far the ends of the top are still apart, m.
  double smaller_area = 0.0;         ///< m2, of the smallest block that it bounds.
  std::optional<double> misfit;      ///< Between the walls, root of the mean square over z, m.
  /// How unsure the slide along the datum is, one standard deviation, m: the misfit as the fit of walls trusts them.
  std::optional<double> slide_error;
};
/// One for each fault.
/// @param facing  of the blocks as they are placed at last.
std::vector<RestoredFault> restored_faults(const FaultSetting& setting, const std::vector<FacingWalls>& facing);
/// Sets the slide errors of those that are measured.
void add_slide_errors(const std::vector<FacingWalls>& facing, const std::vector<UnfoldedBlock>& blocks, double size,
                      std::vector<RestoredFault>& faults);

}  // namespace recon::jigsaw
