#pragma once
// Horizons out of a section that is drawn as polygons: the edges that units share, named by the unit whose top they
// are. Page: docs/algorithms/units.md, "Horizons from units".

#include "recon/input/input.h"

namespace recon::input {

/// Adds a horizon for the top of every unit that has another one above it, in pieces where faults or the border cut it.
/// Edges along faults and topographies, and those with no unit beyond, are none. A unit that ends within another one
/// has a top and a horizon "base of" it. What was taken for what is told in remarks.
/// @param tolerance  gaps and overlaps up to this are bridged, m; 0: a thousandth of the extent of the polygons.
/// @error BadSection: no polygon; no edge between two of them; a horizon of the section has the name of a unit. Those
///        of UnitOwners::make.
base::Result<void> add_horizons_of_units(double tolerance, ReadSection& read);

}  // namespace recon::input
