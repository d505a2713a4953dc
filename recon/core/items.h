#pragma once
// What a section has besides horizons: faults, pin and loose lines, unit polygons and markers, from the same files and
// points that horizons come from.

#include "recon/core/input.h"

namespace recon::core {

/// Adds them to `read.section`. Ids count within each kind, lines through faults, pins and loose lines in this order.
/// @error BadSection: a polygon that does not close or that crosses itself, two things of a kind with the same name;
/// and
///        those of read_line, each with the item and the place.
base::Result<void> read_items(const SectionInput& input, const dobra::scenario::Context& context, ReadSection& read);

/// Refuses a section one of whose horizons is about a thousand times as large or as small as the others: metres and
/// kilometres mixed. @error BadSection with the horizon and its place.
base::Result<void> check_units(const Section& section);

/// A polygon from the points of a file or a scenario. The first point may be repeated at the end; if it is not, the gap
/// must not be longer than any other side, or the polygon counts as open.
/// @error BadSection with the place.
base::Result<geom::Polyline> closed_contour(geom::Polyline line);

}  // namespace recon::core
