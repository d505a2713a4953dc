#pragma once
// Curves parallel to open chains and closed contours of straight segments.
//
// What is computed. Let U be all points nearer than D to the base, plus the corners that the joins add on the chosen
// side. The treated curve is the part of U's boundary that belongs to the chosen side, so it keeps the distance from
// the WHOLE base (both sides and the ends of an open one), and has no spurious region. A base that crosses itself is
// treated by the same rule. What only just touches itself counts as closed (as if D were a little greater).
// Options and results are in types/, which this header includes: callers need no other.
// Page: docs/algorithms/offset.md. Source: [carvalho2005offset]; validity by sections as in [held2001voronoi].

#include <span>
#include <vector>

#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/offset/types/arcs.h"
#include "shared/offset/types/distances.h"

namespace dobra::offset {

/// True if the curve crosses, touches or runs along itself.
/// @error NotFinite, DegenerateCurve.  @cost O(n) where it is smooth
base::Result<bool> meets_itself(const geom::Polyline& curve);

/// Curves parallel to `curve`.
/// @param curve      segments, m; repeated points are passed over.
/// @param distances  m, each above 0 and measured from `curve`, in any order.
/// @return           one result a distance, in the same order; the same bytes for any number of threads.
/// @error            NotFinite, DegenerateCurve with the place; InvalidOption; Cancelled.
/// @cost             about O((n + s) log n) a distance, s = sections that remain after a cull by clearance.
base::Result<std::vector<OffsetCurve>> offset(const geom::Polyline& curve, std::span<const double> distances,
                                              const OffsetOptions& options = {}, const base::Progress& progress = {});

}  // namespace dobra::offset
