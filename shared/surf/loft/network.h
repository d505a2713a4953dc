#pragma once
// The patches of one line between sections that cross. Page: docs/algorithms/loft.md.

#include <string>
#include <vector>

#include "shared/surf/loft/through.h"

namespace dobra::surf::loft {

/// A patch for every cell that three or four sections bound; other cells, and lines that reach beyond all cells, are
/// told. No patch where there is no cell, or where faults part the line.
/// @param misties  those of the line.
/// @error those of lattice()
base::Result<std::vector<Patch>> patches_between(const std::vector<Section>& sections, const std::string& name,
                                                 const std::vector<Mistie>& misties, const ThroughOptions& options,
                                                 double size, std::vector<Finding>& findings);

}  // namespace dobra::surf::loft
