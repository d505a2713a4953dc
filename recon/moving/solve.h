#pragma once
// What a move leaves between the walls of its fault, and the slip that leaves least. Page: docs/algorithms/move.md

#include <span>
#include <string>
#include <vector>

#include "recon/moving/motion.h"

namespace recon::moving {

/// A horizon that the fault cuts on both walls.
struct CutHorizon {
  std::string horizon;
  geom::Point hanging_wall, footwall;  ///< Its cutoffs, m.
  double hanging_arc = 0.0;            ///< Where they stand on the path, m.
  double foot_arc = 0.0;
  bool hanging_moves = true;  ///< Whether the block of that cutoff moves; else, and for the other wall, it stays.
  bool foot_moves = false;
};

/// Metres, after the move.
struct Misfit {
  std::string horizon;
  double along = 0.0;    ///< From the cutoff in the hanging wall up the fault to that in the footwall.
  double gap = 0.0;      ///< Across the fault: how far the cutoff of the hanging wall lies off it ...
  double overlap = 0.0;  ///< ... and in it.
};

Misfit misfit_of(const CutHorizon& cut, const kinematics::FaultPath& path, const MoveParams& params,
                 const kinematics::BlockMap& map);

/// Root of the mean of the squares of `along`, m.
double root_mean_square(std::span<const Misfit> misfits);

/// The motion in which the cutoffs meet; of several horizons that with the least sum of squares of `along`.
/// @param arc   where slip is measured, m.
/// @param size  of the section, m.
/// @pre   close is not empty.
/// @error those of make_motion(); CannotRestore: the cutoffs of one horizon cannot meet, with the misfit that is left.
base::Result<Motion> solve_slip(const kinematics::FaultPath& path, const MoveParams& params,
                                std::span<const CutHorizon> close, double arc, double size);

}  // namespace recon::moving
