#pragma once
// Beds completed from end to end of the section, for methods that lay them out by their own length. A bed seldom
// reaches as far as the others do. The missing part is taken as a parallel of the next bed towards the top that reaches
// the pin, at the depth of the bed's end. So what is left of a bed in a parallel fold goes where the whole bed would.
// Page: docs/algorithms/flexural_slip.md

#include <string>
#include <vector>

#include "recon/section/section.h"
#include "recon/unfold/grid.h"
#include "recon/unfold/pin_line.h"
#include "shared/base/result.h"

namespace recon::unfold {

/// A piece of a bed, which travels like the top.
struct BedPart {
  section::HorizonId horizon;  ///< Not valid where the bed is missing.
  geom::Polyline line;
  std::vector<double> arc;  ///< m
};

struct FullBed {
  section::HorizonId id;       ///< Of the horizon; of one in pieces that of the first piece along travel.
  std::vector<BedPart> parts;  ///< In the order of travel. Where the bed jumps one does not begin where the last ends.
  std::size_t pin_part = 0;    ///< Where the pin line meets it: the part, and ...
  double pin_arc = 0.0;        ///< ... the arc length along that part, m.
};

/// Where beds end that reach about as far as the top does.
enum class BedEnds {
  AsTheyAre,
  OfTheSection,  ///< An end nearer to the normal of the top's end than half its depth goes with that end.
};

/// @param order  the horizons that are taken, from the top of the section down; pieces of one count as one bed.
/// @return  one a bed, in the order of the first of its horizons; remarks where a bed does not reach the pin.
/// @error  CannotRestore with the place: pieces of a horizon above each other; a bed that cannot be completed.
base::Result<std::vector<FullBed>> full_beds(const section::Section& section, const SourceGrid& source,
                                             const maps::Columns& top, double pin_arc,
                                             const std::vector<section::HorizonId>& order, BedEnds ends,
                                             std::vector<std::string>& remarks);

}  // namespace recon::unfold
