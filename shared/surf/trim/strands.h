#pragma once
// Lines of a chart made ready to be cut: taken into the chart over its seams, gaps closed, with the sides of the chart.
// Of use inside this folder.

#include "shared/surf/trim/arcs.h"
#include "shared/surf/trim/recognise.h"

namespace dobra::surf::trim {

struct Strands {
  Arcs arcs;  ///< Not cut yet.
  std::vector<Finding> findings;
};

/// @error as recognise
base::Result<Strands> strands_of(const Surface& surface, std::span<const TrimLine> lines,
                                 const RecogniseOptions& options);

}  // namespace dobra::surf::trim
