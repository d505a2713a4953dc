#pragma once
// Rosettes of quarter-point elements at the tips of the cracks of a domain: they take the place of what the mesher
// would put there. Page: docs/algorithms/crack.md.

#include <span>
#include <string>
#include <vector>

#include "quebra/model/model.h"
#include "shared/base/result.h"
#include "shared/fem/fracture/rosette.h"
#include "shared/mesh/delaunay/mesh_input.h"

namespace quebra::meshing {

struct TipRosette {
  std::string crack;  ///< Or the only lip.
  dobra::fem::fracture::CrackEnd end = dobra::fem::fracture::CrackEnd::End;
  dobra::fem::fracture::Rosette rosette;
  std::string ahead = {};  ///< Curve ahead of a half crack; empty: a whole one.
  dobra::fem::fracture::RosetteHalf half = dobra::fem::fracture::RosetteHalf::Left;
  std::vector<std::string> names = {};  ///< Node sets that the tip is to be in.
};

/// The radius wanted at one tip.
struct TipRadius {
  dobra::geom::Point tip;
  double radius = 0.0;  ///< m
};

/// One for each end of a crack that lies inside the material, then one for each tip of a half crack.
/// @param options  a radius of 0 takes 1/80 of the room round the tip: to the nearest other curve or tip, and as far as
/// the crack runs straight.
/// @param radii    those of single tips, in place of that of the options.
/// @error BadDomain naming the crack: two rosettes overlap, one reaches a boundary, or the crack is not straight in it.
dobra::base::Result<std::vector<TipRosette>> tip_rosettes(const domain::Domain& domain,
                                                          const std::vector<model::HalfTip>& half_tips,
                                                          const dobra::fem::fracture::RosetteOptions& options,
                                                          std::span<const TipRadius> radii = {});

/// Makes a hole of each rosette in the mesher's input, and lets the cracks end on its rim; names of the tips themselves
/// go to the rosettes.
/// @error BadDomain: a named point lies in a rosette, whose nodes are its own.
dobra::base::Result<void> cut_out(dobra::mesh::delaunay::MeshInput& input, std::vector<TipRosette>& rosettes);

/// Fills the holes again. @error those of fem::fill_rosette
dobra::base::Result<void> fill(dobra::mesh::ElementMesh& mesh, const std::vector<TipRosette>& rosettes);

}  // namespace quebra::meshing
