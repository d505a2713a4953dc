#pragma once
// The fault under a rollover, by inclined shear. With q, w across and along the direction of shear, H the shift of the
// hanging wall along q, the bed as it lies w = b(q), its regional w = r(q) and the fault w = W(q):
//   W(q) = W(q - H) + b(q) - r(q - H)
// Known of W is what lies between the two cutoffs of the bed. Page: docs/algorithms/rollover.md.
// Source: [white1986], [gibbs1983].

#include <optional>

#include "shared/base/angle.h"
#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace recon {
namespace base = dobra::base;
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::inversion {

struct Rollover {
  geom::Polyline known;  ///< The fault from the footwall cutoff to the hanging-wall cutoff, m.
  geom::Polyline bed;    ///< From the hanging-wall cutoff away from the fault, m.
  base::Angle bedding;   ///< Direction of the regional through the footwall cutoff, anticlockwise from +x.
  base::Angle shear;     ///< Direction of shear from the vertical, + leaning to +x.
};

struct PredictedFault {
  geom::Polyline line;      ///< From the footwall cutoff to the end of the rollover, down.
  geom::Polyline regional;  ///< From the footwall cutoff to over that end.
  double shift = 0.0;       ///< Along the regional direction, m, > 0: of what lies over a flat.
  std::size_t steps = 0;    ///< How often the shift goes into the rollover: errors add up with each.
  base::Angle end_dip;      ///< Over the last shift, from the bedding, >= 0.
  geom::Point end;          ///< Middle of the last shift, on the fault.
  double lost_area = 0.0;   ///< Between regional, fault and bed, m2.
  double area_depth = 0.0;  ///< lost_area / shift: of the detachment under the regional, square to it, m.
  geom::Point area_place;   ///< There, under the end of the rollover.
};

/// @error CannotRestore with the place: the bed or the fault turns back along the direction of shear, cutoffs that are
///        one point along it, a rollover shorter or more than 200 times longer than the shift.
/// @cost O(n k log(n k)) for n points and k steps.
base::Result<PredictedFault> fault_under(const Rollover& rollover);

}  // namespace recon::inversion
