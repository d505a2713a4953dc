#pragma once
// Finite strain of a map from its gradient F: stretches from C = F^T F, rotation from the polar decomposition.
// Page: docs/algorithms/ledger.md. Source: [ramsay1967].

#include "recon/maps/section_map.h"
#include "shared/base/angle.h"

namespace recon::maps {

/// Strain that the section has in its deformed state, taking the restored state as unstrained: the ellipse that the map
/// turns into a circle.
struct Strain {
  geom::Point at;           ///< In the deformed section.
  double dilatation = 0.0;  ///< det F - 1 of the restoration: > 0 where area grows.
  double greatest = 1.0;    ///< Principal stretches, greatest >= least > 0.
  double least = 1.0;
  base::Angle direction;  ///< Of the greatest stretch, from the x axis, in (-90, 90] degrees.
  base::Angle rotation;   ///< Of the deformation (from restored to deformed), anticlockwise.
};

/// @param f  gradient of the restoration; its determinant must not be 0.
Strain strain_of(geom::Point at, const Gradient& f);

}  // namespace recon::maps
