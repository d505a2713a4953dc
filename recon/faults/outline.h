#pragma once
// What surrounds the rock of a section that has no border. Page: docs/algorithms/blocks.md

#include <string>
#include <vector>

#include "recon/faults/fault.h"

namespace recon::faults {

struct Outline {
  std::vector<geom::Polyline> rings;  ///< Simple; holes clockwise. None where the horizons enclose nothing.
  std::vector<std::string> remarks;   ///< Where the horizons leave the rock open, and what closes it; with places.
};

/// The border of the section, or what its units enclose, where horizons have been extended and trimmed to the faults.
/// Where these leave rock open between two beds, the cell between the faults is closed: gaps of a bed and the way from
/// an end to the next bed's by straight lines, along the faults where ends lie on them.
/// @param faults  their ends need not have been found.
/// @error those of section::faces_of and topo::region.
base::Result<Outline> outline_of(const section::Section& section, std::vector<Fault> faults,
                                 const FaultOptions& options);

}  // namespace recon::faults
