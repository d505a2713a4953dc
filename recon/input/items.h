#pragma once
// What a section has besides horizons: faults, pin and loose lines, unit polygons and markers, from the same files and
// points that horizons come from.

#include "recon/input/input.h"

namespace recon::input {

/// Adds them to `read.section`. Ids count within each kind, lines through faults, pins and loose lines in this order.
/// @error BadSection: a polygon that does not close or that crosses itself, two things of a kind with the same name;
///        and those of read_line, each with the item and the place.
base::Result<void> read_items(const SectionInput& input, const ReadSettings& settings,
                              const dobra::scenario::Context& context, ReadSection& read);

/// Adds the pictures behind the section.
/// @error BadSection: a picture without a place; those of io::gis::read_raster; each with the file and the item.
base::Result<void> read_backdrops(const SectionInput& input, const dobra::scenario::Context& context,
                                  section::Section& section);

/// Whether something is about a thousand times as small or large as the section, and would lie where the section is if
/// it were a thousand times as large or small: metres and kilometres mixed.
bool seems_of_another_unit(const geom::Box& item, const geom::Box& section);

/// Refuses a section with such a horizon, line or polygon, unless its input says its unit itself.
/// @error BadSection with the item and its place.
base::Result<void> check_units(const section::Section& section, const SectionInput& input);

/// A polygon from the points of a file or a scenario. The first point may be repeated at the end; if it is not, the gap
/// must not be longer than any other side, or the polygon counts as open.
/// @error BadSection with the place.
base::Result<geom::Polyline> closed_contour(geom::Polyline line);

}  // namespace recon::input
