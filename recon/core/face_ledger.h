#pragma once
// Areas of units by their faces: where faults, truncated beds, topography or a border make a unit other than all that
// lies between two horizons. Page: docs/algorithms/units.md

#include "recon/core/ledger.h"

namespace recon::core {

/// Whether all that lies between two horizons (indices, in any order) is one unit, as ledger_units takes it. True where
/// the section has no faces.
bool is_whole_unit(const Section& section, std::size_t one, std::size_t other);

/// Adds the units that are not such at the end of the ledger: areas of their faces and of the faces' images; without
/// thickness and det F. Nothing where the section has polygons or no faces.
void measure_faces(const Section& section, const SectionMap& map, Ledger& ledger);

}  // namespace recon::core
