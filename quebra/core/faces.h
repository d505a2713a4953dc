#pragma once
// The parts of the material that loops and internal lines enclose, recognised by the planar subdivision, with the
// region (tag and name) of each.

#include <span>

#include "quebra/core/domain.h"
#include "shared/geom/polyline.h"
#include "shared/geom/segment.h"
#include "shared/topo/subdivision.h"

namespace quebra::core {

/// Fills domain.faces and domain.region_names. Cracks divide nothing; `inside` is of the domain. A part without a name
/// takes that of the smallest area round it.
/// @error OutsideDomain with the place for a name whose point is not inside the material; BadValue for two names in one
/// part.
dobra::base::Result<void> find_faces(Domain& domain, const Inside& inside, std::span<const RegionName> names,
                                     std::span<const Area> areas = {});

/// The chords of a curve, through its junctions.
dobra::geom::Polyline chords(const Domain& domain, std::size_t curve);

/// The directed sides of a face, which lies on their left, and its area.
std::vector<dobra::geom::Segment> sides_of(const dobra::topo::Subdivision& subdivision, dobra::topo::FaceId face);
double area_of(std::span<const dobra::geom::Segment> sides);

/// A point well inside what the directed sides enclose on their left. @pre some side
dobra::geom::Point inner_point(std::span<const dobra::geom::Segment> sides);

}  // namespace quebra::core
