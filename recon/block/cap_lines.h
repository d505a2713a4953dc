#pragma once
// What a plane cuts out of a block between several sections, as lines with the names of the faces that were cut. Page:
// docs/algorithms/section_block.md.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "recon/block/cut.h"
#include "shared/solid/cap.h"

namespace recon::block {

/// The loops of a region in the axes of the cut, the region on their left.
std::vector<geom::Polyline> loops_of(const dobra::solid::CapRegion& region, const dobra::solid::SectionFrame& from,
                                     const CutFrame& to);

struct CapLines {
  /// By "horizon A", "fault F", "topography T" and so on; what hangs together is one line.
  std::map<std::string, std::vector<geom::Polyline>> named;
  std::vector<geom::Polyline> border;  ///< Closed, round all rock, anticlockwise.
  /// Unit and its closed outer contours, anticlockwise, in the order of the regions.
  std::vector<std::pair<std::size_t, geom::Polyline>> contours;
};

/// In the axes of the cut. An edge of several names has the one that counts most (unit_map.h).  @cost O(n log n)
CapLines lines_of(const dobra::solid::Cap& cap, const CutFrame& to);

}  // namespace recon::block
