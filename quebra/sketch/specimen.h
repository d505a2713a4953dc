#pragma once
// The specimens of fracture mechanics by name and size: domains with their cracks, and the points of their supports and
// loads. Names, sizes and references: docs/user/specimens.md. Source: [tada2000handbook], [bittencourt1996],
// [astm-e399].

#include <optional>
#include <string>
#include <vector>

#include "quebra/sketch/sketch.h"
#include "shared/base/angle.h"
#include "shared/base/result.h"

namespace quebra::sketch {

enum class SpecimenKind {
  None,
  PlateWithHole,    ///< width x height, hole of `radius` in the middle.
  QuarterPlate,     ///< Its first quarter: [0, width] x [0, height] without the quarter disc.
  LShape,           ///< [0, width]^2 without its lower right quarter.
  Cook,             ///< (0,0) (48,44) (48,60) (0,44), to the scale of width / 48.
  SingleEdgeNotch,  ///< width x height, edge crack of length `crack` from the left at mid-height.
  DoubleEdgeNotch,  ///< Edge cracks of length `crack` from both sides.
  CentreCrack,      ///< Crack of length 2 `crack` in the middle, at `angle`.
  CompactTension,   ///< ASTM E399: W = width, a = crack, both from the load line; two pin holes.
  ThreePointBend,   ///< ASTM E399 beam: depth W = height, length width, edge crack from below in the middle.
  PmmaBeam,  ///< Bittencourt's beam of 20 x 8 with three holes; notch of length `crack` at `position` left of the
             ///< middle.
  DoubleCantilever,  ///< width x height, crack from the left at mid-height.
  BrazilianDisc,     ///< Disc of `radius`, centre crack of length 2 `crack` at `angle`.
};

/// As in scenario files, in the order of SpecimenKind.
std::vector<std::string> specimen_names();

/// What is not given takes the default of the specimen, m.
struct SpecimenParams {
  SpecimenKind kind = SpecimenKind::None;
  std::optional<double> width, height, radius, crack, position;
  std::optional<dobra::base::Angle> angle;
};

/// @error BadValue for a size that the specimen does not have, which would be left out in silence.
dobra::base::Result<void> check_sizes(const SpecimenParams& params);

/// @error those of check_sizes; BadValue for sizes that do not fit together: a hole or crack that leaves the specimen.
dobra::base::Result<Sketch> make_specimen(const SpecimenParams& params);

}  // namespace quebra::sketch
