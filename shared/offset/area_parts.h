#pragma once
// What area.cpp and area_lines.cpp share. Internal to offset.

#include "shared/offset/area.h"

namespace dobra::offset {

/// Of the chords. @param rings  polygons, see Area.
Area measured(std::vector<geom::Polyline> rings);

/// One side of a ring at each distance; contours first.
base::Result<std::vector<Area>> beside(const geom::Polyline& ring, const OffsetOptions& settings,
                                       std::span<const double> distances, const AreaOptions& options,
                                       const base::Progress& progress);

}  // namespace dobra::offset
