#pragma once
// Areas by distance: what lies within D of lines, on both sides and round their ends; polygons with holes that grow or
// shrink by D; what several such areas cover together. Each contour is offset by the engine alone (offset.h); where
// curves of different contours meet, the subdivision parts them (topo/region.h). Page: docs/algorithms/offset.md.

#include <functional>

#include "shared/offset/offset.h"

namespace dobra::offset {

/// What stands at the ends of an open line.
enum class Cap {
  Round,   ///< Half a disc.
  Flat,    ///< Nothing: the area ends across the line's end.
  Square,  ///< As Flat, D farther.
};

/// Told of each contour that was offset, with the options and the curves: for whoever wants to verify them.
using Judge =
    std::function<base::Result<void>(const geom::Polyline&, const OffsetOptions&, const std::vector<OffsetCurve>&)>;

struct AreaOptions {
  Join join = Join::Mitre;
  double mitre_limit = 4.0;  ///< As in OffsetOptions.
  Cap cap = Cap::Round;
  double arc_tolerance = default_arc_tolerance;  ///< Of the chords, in D; see chords().
  Judge judge = {};
};

/// Polygons, with chords in place of arcs.
struct Area {
  std::vector<geom::Polyline> rings = {};  ///< Each contour anticlockwise, followed by its holes clockwise.
  /// m2 and m, of the arcs; of the chords where curves of different contours, or of a line and its caps, were joined.
  double area = 0.0;
  double length = 0.0;
};

/// What lies within each distance of an open line.
/// @param distances  above 0, m.  @return one a distance.
/// @error as offset(), and those of topo::region.
base::Result<std::vector<Area>> around_line(const geom::Polyline& line, std::span<const double> distances,
                                            const AreaOptions& options, const base::Progress& progress = {});

/// A polygon grown by each distance, or shrunk where it is negative.
/// @param polygon  a contour anticlockwise and its holes clockwise, which do not cross; see mended().
/// @error as offset(), and those of topo::region.
base::Result<std::vector<Area>> grown(std::span<const geom::Polyline> polygon, std::span<const double> distances,
                                      const AreaOptions& options, const base::Progress& progress = {});

/// What lies within each distance of the rings of a polygon, on both sides of them.
base::Result<std::vector<Area>> around_polygon(std::span<const geom::Polyline> polygon,
                                               std::span<const double> distances, const AreaOptions& options,
                                               const base::Progress& progress = {});

/// What several areas cover together.
base::Result<Area> joined(std::span<const Area> areas, const base::Progress& progress = {});

/// The polygons of a polygon whose rings may cross or touch themselves or each other: what a way from outside enters by
/// an odd number of crossings. One that is sound comes back as it is.
base::Result<std::vector<std::vector<geom::Polyline>>> mended(std::span<const geom::Polyline> polygon,
                                                              const base::Progress& progress = {});

/// Rings of an Area, one polygon after the other.
std::vector<std::vector<geom::Polyline>> polygons_of(std::span<const geom::Polyline> rings);

}  // namespace dobra::offset
