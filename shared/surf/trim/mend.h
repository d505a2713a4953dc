#pragma once
// Trimmed surfaces as files bring them: loops with gaps, turned the wrong way, a period off, without the sides that
// they need over a seam; and surfaces that fold. Page: docs/algorithms/trimming.md.

#include "shared/surf/trim/recognise.h"

namespace dobra::surf::trim {

struct Mended {
  TrimmedSurface face;
  /// "gap_closed", "loop_turned", "no_loops" (the whole chart is meant).
  std::vector<Finding> findings;
};

/// The face that loops mean, with loops that are as TrimmedSurface asks: closed, simple, turned rightly, in the chart,
/// with seams in pairs. On which side of a loop it lies follows from the sides of the chart that are no seam and no
/// point, beyond which there is nothing; where there are none, from the turn of the loops. Edges that loops have twice
/// (a slit) become lines inside. Lines inside are cut as recognise does.
/// @error SelfIntersection with the place: loops that cross themselves or each other; as recognise
base::Result<Mended> mended(const TrimmedSurface& face, SharedNumbers& numbers, const RecogniseOptions& options = {});

/// Looks for places of a face, its poles left out, where the surface has no normal, or where normals beside each other
/// look opposite ways, in a net of 65 lines each way and through breaks of the surface.
/// @return none, or DegenerateCurve with the first place
std::optional<base::Error> find_fold(const TrimmedSurface& face);

}  // namespace dobra::surf::trim
