#pragma once
// What of a section lies between two places along it: where a trace ends, the section that is cut over it ends. Page:
// docs/algorithms/section_block.md.

#include <limits>
#include <vector>

#include "shared/geom/polyline.h"

namespace recon {
namespace geom = dobra::geom;
}

namespace recon::block {

/// from <= x <= to. A point on a bound counts as within, and lines that meet on one side of a bound are cut in the same
/// place: no part of a line depends on any other.
struct Strip {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool holds(geom::Point p) const { return from <= p.x && p.x <= to; }
  [[nodiscard]] bool bounded() const { return from > Strip().from || to < Strip().to; }
  [[nodiscard]] bool empty() const { return !(from < to); }
};

/// The pieces of an open line, in order along it. Points within stay as they are, the others are left out; each end
/// that is new lies on a bound.  @cost O(n)
std::vector<geom::Polyline> within(const geom::Polyline& line, const Strip& strip);

/// The loops that bound the part within of the area that closed loops bound; they go the same way round.
/// @pre   the loops do not cross each other or themselves.
/// @cost  O(n + k log k) for k places on the bounds
std::vector<geom::Polyline> loops_within(std::vector<geom::Polyline> loops, const Strip& strip);

}  // namespace recon::block
