#pragma once
// Areas of units by their faces: where faults, truncated beds, topography or a border make a unit other than all that
// lies between two horizons. Page: docs/algorithms/units.md

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "recon/balance/ledger.h"
#include "recon/section/section_faces.h"

namespace recon::balance {

/// The units that are not all that lies between two horizons, which ledger_units has; none where the section has
/// polygons or no faces.
std::vector<section::RockUnit> units_by_faces(const section::Section& section);

/// Of the unit between two horizons (indices; one may be missing).
section::BedRole role_of(const section::Section& section, std::optional<std::size_t> one,
                         std::optional<std::size_t> other);
/// Likewise of a unit by faces. One with no horizon over it (or none under it) is rock only where the topography or a
/// border was given to bound it.
section::BedRole role_of(const section::Section& section, const section::RockUnit& unit);

/// Images of closed contours, and the area that contours enclose, holes running the other way, m2.
std::vector<geom::Polyline> images_of(std::span<const geom::Polyline> contours, const maps::SectionMap& map);
double area_of(std::span<const geom::Polyline> contours);

/// Adds units_by_faces at the end of the ledger: areas of their faces and of the faces' images; without
/// thickness and det F.
void measure_faces(const section::Section& section, const maps::SectionMap& map, Ledger& ledger);

/// What lies between two horizons, with all pieces of either.
struct RestoredBed {
  std::string name;        ///< "A - B", by whole_name.
  std::size_t upper = 0;   ///< Index of the horizon, or of a piece of it.
  double area = 0.0;       ///< Before restoration, m2.
  double thickness = 0.0;  ///< Mean after it, by area over the pieces, m.
};

/// Of the units whose thickness is known, in their order. @pre rows begins with those of units.
std::vector<RestoredBed> restored_beds(const section::Section& section, const std::vector<LedgerUnit>& units,
                                       const std::vector<UnitRow>& rows);

/// How much area of the section's units is in no row, and where; nothing if the rows add up to the units, or if the
/// section has polygons (section_faces.h tells what they leave out) or no faces.
std::optional<std::string> missing_area(const section::Section& section, const Ledger& ledger);

}  // namespace recon::balance
