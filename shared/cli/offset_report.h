#pragma once
// What the sub-command `offset` gives out: JSON, a table, exchange files, a picture.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shared/io/curves.h"
#include "shared/offset/arcs.h"
#include "shared/scene/layer.h"

namespace dobra::cli {

/// An offset curve as it is given out. Length and area are those of the true arcs; the lines have chords instead.
struct DrawnOffset {
  double distance = 0.0;
  double length = 0.0;         ///< Of all pieces, m.
  /// What the pieces enclose, m2: outer contours minus holes. 0 where nothing remains of a closed base; nothing where a
  /// piece (or, without pieces, the base) is open.
  std::optional<double> area;
  std::vector<geom::Polyline> lines;
  std::size_t dropped = 0;
};

/// One curve of the file and the curves parallel to it, by distance.
struct OffsetFamily {
  io::NamedCurve base;
  offset::Treatment treatment = offset::Treatment::Treated;
  std::vector<DrawnOffset> curves;
};

/// @param tolerance  of the chords, in D; see offset::chords.
DrawnOffset drawn(const offset::OffsetCurve& curve, const geom::Polyline& base, double tolerance);

/// What the verifier has to say about offset curves.
struct OffsetVerdict {
  std::vector<std::string> findings;  ///< A line each, with curve, distance and place.
  std::size_t edges = 0;              ///< Judged.
  std::size_t samples = 0;            ///< Places where the curves had to be.
};

/// Adds to `verdict` what offset::verify finds in the curves of one base.  @error those of offset::verify.
base::Result<void> verify_offset(const io::NamedCurve& base, const offset::OffsetOptions& options,
                                 const std::vector<offset::OffsetCurve>& curves, OffsetVerdict& verdict);

/// {"curves":[{"distance":d,"length":L,"area":A or null,"pieces":[{"closed":b,"points":[[x,y],...]}]}],"dropped":n},
/// one line, every digit; "curve":name comes first in each where there are several families.
std::string offset_json(const std::vector<OffsetFamily>& families);

/// A line a curve: (name,) distance, pieces, points, length, area.
std::string offset_table(const std::vector<OffsetFamily>& families);

/// The base thick, offset curves coloured by distance, on one panel with a legend.
scene::Picture offset_picture(const std::vector<OffsetFamily>& families);

/// @error BadUsage for an ending that is not .geojson, .wkt, .csv, .svg, .pdf or .png.
base::Result<void> check_offset_ending(const std::filesystem::path& file);

/// Writes the format that the ending says. Treated closed curves are polygons with holes in .geojson and .wkt;
/// everything else is lines, whose last point repeats the first where they are closed.
/// @error those of check_offset_ending; NotFinite, CannotWrite, CannotDraw.
base::Result<void> write_offset(const std::vector<OffsetFamily>& families, const std::filesystem::path& file);

}  // namespace dobra::cli
