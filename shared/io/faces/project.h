#pragma once
// Curves in the chart for edges that have only one in space.

#include "shared/io/faces/loops.h"

namespace dobra::io::faces {

/// On a plane exactly, elsewhere a spline through places found one from the other, told with the gap that is left.
Outcome<Piece> projected(const WholeSurface& whole, const surf::Surface& surface, const Piece& piece, double diagonal,
                         const ImportOptions& options, Report& report);

}  // namespace dobra::io::faces
