#pragma once
// The parts of the material that loops and internal lines enclose, recognised by the planar subdivision, with the
// region (tag and name) of each.

#include <span>

#include "quebra/domain/domain.h"
#include "shared/geom/polyline.h"
#include "shared/geom/segment.h"
#include "shared/topo/subdivision.h"

namespace quebra::domain {

/// Fills domain.faces and domain.region_names. Cracks divide nothing; `inside` is of the domain. A part without a name
/// takes that of the smallest area round it.
/// @error OutsideDomain with the place for a name whose point is not inside the material; BadValue for two names in one
/// part.
dobra::base::Result<void> find_faces(Domain& domain, const Inside& inside, std::span<const sketch::RegionName> names,
                                     std::span<const sketch::Area> areas = {});

/// The chords of a curve, through its junctions.
dobra::geom::Polyline chords(const Domain& domain, std::size_t curve);

/// The directed sides of a face, which lies on their left.
std::vector<dobra::geom::Segment> sides_of(const dobra::topo::Subdivision& subdivision, dobra::topo::FaceId face);

}  // namespace quebra::domain
