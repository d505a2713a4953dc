#pragma once
// Rosettes of quarter-point elements at the tips of the cracks of a domain: they take the place of what the mesher would
// put there. Page: docs/algorithms/crack.md.

#include <string>
#include <vector>

#include "quebra/core/model.h"
#include "shared/base/result.h"
#include "shared/fem/rosette.h"
#include "shared/mesh/mesh_input.h"

namespace quebra::core {

struct TipRosette {
  std::string crack;  ///< Or the only lip.
  dobra::fem::CrackEnd end = dobra::fem::CrackEnd::End;
  dobra::fem::Rosette rosette;
  std::string ahead = {};  ///< Curve ahead of a half crack; empty: a whole one.
  dobra::fem::RosetteHalf half = dobra::fem::RosetteHalf::Left;
};

/// One for each end of a crack that lies inside the material, then one for each tip of a half crack.
/// @param options  a radius of 0 takes 1/80 of the room round the tip: to the nearest other curve or tip, and as far as the
/// crack runs straight.
/// @error BadDomain naming the crack: two rosettes overlap, one reaches a boundary, or the crack is not straight in it.
dobra::base::Result<std::vector<TipRosette>> tip_rosettes(const Domain& domain, const std::vector<HalfTip>& half_tips,
                                                          const dobra::fem::RosetteOptions& options);

/// Makes a hole of each rosette in the mesher's input, and lets the cracks end on its rim.
void cut_out(dobra::mesh::MeshInput& input, const std::vector<TipRosette>& rosettes);

/// Fills the holes again. @error those of fem::fill_rosette
dobra::base::Result<void> fill(dobra::mesh::ElementMesh& mesh, const std::vector<TipRosette>& rosettes);

}  // namespace quebra::core
