#pragma once
// Lines that run along each other made to share their vertices: what is nearer than a tolerance becomes one.
// Page: docs/algorithms/domain_repair.md.

#include <span>
#include <vector>

#include "shared/geom/polyline.h"

namespace quebra::sketch {

/// A vertex that another line now passes too.
struct Snap {
  std::size_t line = 0;   ///< Whose vertex it is,
  std::size_t other = 0;  ///< and the line that was made to pass it.
  dobra::geom::Point at;
  double gap = 0.0;  ///< How far apart they were, m; 0: the vertex lay on a side.
};

/// A vertex nearer than `tolerance` to one of an earlier line moves to it; one that is nearer to a side of another line
/// becomes a vertex of that line. Afterwards stretches that the lines share have the same vertices, bit for bit.
/// @cost O(n log n + near pairs) for n vertices
std::vector<Snap> snap_together(std::span<dobra::geom::Polyline* const> lines, double tolerance);

}  // namespace quebra::sketch
