#pragma once
// Ramsay's class of a folded layer from its dip isogons: the distance T between the tangents of one dip at its two
// surfaces, against that at the hinge, t' = T / T_0, over the dip a from the hinge.
//   1A t' > 1   1B t' = 1 (parallel)   1C cos a < t' < 1   2 t' = cos a (similar)   3 t' < cos a
// One index tells them apart: t' = (cos a)^p, with p < 0, 0, 0..1, 1, > 1. Tangents are taken as supporting lines, T as
// the difference of the support functions, so that unsteady digitising does not matter. For one fold, open up or down.
// Source: [ramsay1967].  Page: docs/algorithms/ledger.md

#include <optional>
#include <string>
#include <vector>

#include "shared/base/angle.h"
#include "shared/geom/polyline.h"

namespace recon {
namespace base = dobra::base;
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::balance {

enum class RamsayClass { Class1A, Class1B, Class1C, Class2, Class3 };
/// "1A", "1B", ...
const char* class_name(RamsayClass value);

struct FoldClassOptions {
  int angles = 61;          ///< Dips that are compared.
  double tolerance = 0.25;  ///< Of the index round 0 and 1, within which a layer is parallel or similar.
  /// Less common dip than this on either limb tells nothing.
  base::Angle least_range = base::Angle::from_degrees(10.0);
};

struct FoldClass {
  RamsayClass value = RamsayClass::Class1B;
  double index = 0.0;            ///< p
  double hinge_thickness = 0.0;  ///< T_0, m
  base::Angle axial_normal;      ///< Direction that the hinge's normal leans from the vertical, clockwise.
  base::Angle dips;              ///< Greatest dip from the hinge that both surfaces have on both limbs.
};

/// @param upper, lower  the two surfaces, left to right.
/// @return nothing if the surfaces have too few dips in common.
std::optional<FoldClass> fold_class(const geom::Polyline& upper, const geom::Polyline& lower,
                                    const FoldClassOptions& options = {});

}  // namespace recon::balance
