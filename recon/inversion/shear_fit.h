#pragma once
// Inclined shear over a known fault from the shapes of beds. Page: docs/algorithms/inversion.md

#include "recon/inversion/fit.h"
#include "recon/inversion/invert_params.h"

namespace recon::inversion {

/// angle [deg] from the vertical, + leaning to +x, and slip [m] along the fault, > 0 raised the hanging wall, of its
/// point on the uppermost cutoff of the hanging wall, or where no bed is cut at the fault's higher end.
struct ShearTask {
  Model model;
  std::vector<Unknown> unknowns;
};

/// @error BadSection: those of find_fault(); a fault whose hanging wall nothing tells, or whose ends are level.
base::Result<ShearTask> shear_task(const section::Section& section, const std::vector<BedShape>& beds,
                                   const InvertParams& params);

}  // namespace recon::inversion
