#include "recon/maps/strain.h"

#include <cmath>

namespace recon::maps {

Strain strain_of(geom::Point at, const Gradient& f) {
  Strain strain;
  strain.at = at;
  const double det = f.determinant();
  strain.dilatation = det - 1.0;
  // The deformation is G = F^-1; its left stretch has the squares of the principal stretches as eigenvalues of G G^T.
  const Gradient g{f.yy / det, -f.xy / det, -f.yx / det, f.xx / det};
  const double xx = g.xx * g.xx + g.xy * g.xy;
  const double yy = g.yx * g.yx + g.yy * g.yy;
  const double xy = g.xx * g.yx + g.xy * g.yy;
  const double mean = 0.5 * (xx + yy);
  const double radius = std::hypot(0.5 * (xx - yy), xy);
  strain.greatest = std::sqrt(mean + radius);
  strain.least = std::abs(g.determinant()) / strain.greatest;  // mean - radius would cancel
  strain.direction = base::Angle::from_radians(radius > 0.0 ? 0.5 * std::atan2(2.0 * xy, xx - yy) : 0.0);
  strain.rotation = base::Angle::from_radians(std::atan2(g.yx - g.xy, g.xx + g.yy));
  return strain;
}

}  // namespace recon::maps
