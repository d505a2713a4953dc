#pragma once
// Rigid blocks that turn and shift until the two sides of their faults fit. Page: docs/algorithms/jigsaw.md

#include <string>
#include <vector>

#include "recon/jigsaw/fault_fit.h"
#include "recon/jigsaw/rigid_motion.h"

namespace recon::jigsaw {

/// Two places, each of a block as it is now, that were one: weight * distance^2 after the motions is to be small.
struct Match {
  std::size_t left = 0, right = 0;  ///< Blocks.
  geom::Point at_left, at_right;
  double weight = 1.0;  ///< > 0
};

/// Both walls of all faults, matched by the cutoffs that they share and in between by the part of the way. The weights
/// are those with which a sum is the integral of the squared distance along the walls.
/// @param fit  Walls: by the cutoffs of all beds but growth; Top: by those of the top, which are to meet.
std::vector<Match> matches_of(const FaultSetting& setting, const std::vector<UnfoldedBlock>& blocks, Fit fit);

/// The motions of least squares, that of the pinned block none: by Gauss and Newton from block to block fitted ones.
/// @param names  of the blocks, one each.  @param size  of the section, m.
/// @error CannotRestore: blocks that no chain of matched walls leads to from the pinned one; it names them.
/// @cost  O(matches + blocks^3) a step
base::Result<std::vector<RigidMotion>> turn_and_shift(const std::vector<std::string>& names, std::size_t pinned,
                                                      const std::vector<Match>& matches, double size);

}  // namespace recon::jigsaw
