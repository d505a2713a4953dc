#pragma once
// The kinematics of a fold from the shapes of its beds: the operation `invert`. Page: docs/algorithms/inversion.md

#include "recon/inversion/fit.h"
#include "recon/inversion/invert_params.h"
#include "recon/section/section.h"

namespace recon::inversion {

/// "trishear", "shear": in results.
const char* name_of(InvertMethod method);

struct Inversion {
  InvertParams params;
  Fit fit;
  std::optional<MisfitMap> map;
  geom::Polyline fault;                  ///< With the best values: of trishear a ramp that ends at the tip.
  std::vector<geom::Polyline> triangle;  ///< Of trishear: the sides of the zone in front of the tip.
  std::vector<geom::Polyline> restored;  ///< Pieces of beds, restored with the best values.
  std::vector<std::string> restored_names;
  std::vector<std::string> remarks;
};

/// @error BadValue: what the method has no use for, or lacks; limits that are none; BadSection: no such fault or bed;
///        those of fit_beds().
base::Result<Inversion> invert(const section::Section& section, const InvertParams& params,
                               const base::Progress& progress);

}  // namespace recon::inversion
