#pragma once
// Areas of units by their faces: where faults, truncated beds, topography or a border make a unit other than all that
// lies between two horizons. Page: docs/algorithms/units.md

#include <span>

#include "recon/core/ledger.h"
#include "recon/core/section_faces.h"

namespace recon::core {

/// Whether all that lies between two horizons (indices, in any order) is one unit, as ledger_units takes it. True where
/// the section has no faces.
bool is_whole_unit(const Section& section, std::size_t one, std::size_t other);

/// The units that are not such; none where the section has polygons or no faces.
std::vector<RockUnit> units_by_faces(const Section& section);

/// Of the unit between two horizons (indices; one may be missing).
BedRole role_of(const Section& section, std::optional<std::size_t> one, std::optional<std::size_t> other);
/// Likewise of a unit by faces. One with no horizon over it (or none under it) is rock only where the topography or a
/// border was given to bound it.
BedRole role_of(const Section& section, const RockUnit& unit);

/// Images of closed contours, and the area that contours enclose, holes running the other way, m2.
std::vector<geom::Polyline> images_of(std::span<const geom::Polyline> contours, const SectionMap& map);
double area_of(std::span<const geom::Polyline> contours);

/// Adds the units that are not such at the end of the ledger: areas of their faces and of the faces' images; without
/// thickness and det F.
void measure_faces(const Section& section, const SectionMap& map, Ledger& ledger);

}  // namespace recon::core
