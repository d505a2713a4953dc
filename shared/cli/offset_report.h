#pragma once
// What the sub-command `offset` gives out: JSON, a table, exchange files, a picture.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shared/io/line_files.h"
#include "shared/offset/area.h"
#include "shared/scene/layer.h"

namespace dobra::cli {

/// An offset curve as it is given out. Length and area are those of the true arcs where they are known; the lines have
/// chords instead.
struct DrawnOffset {
  double distance = 0.0;
  double length = 0.0;  ///< Of all pieces, m.
  /// What the pieces enclose, m2: outer contours minus holes. 0 where nothing remains of a closed base; nothing where a
  /// piece (or, without pieces, the base) is open.
  std::optional<double> area = std::nullopt;
  std::vector<geom::Polyline> lines = {};
  std::size_t dropped = 0;      ///< Pieces of an open line that were left out,
  double dropped_length = 0.0;  ///< and how long they are, m.
};

enum class OffsetContent { Lines, Polygons };

/// A base of the file (see offset_families.h), and the curves parallel to it or the areas about it, by distance.
struct OffsetFamily {
  std::string name;
  io::Feature source = {};  ///< Its name, kind, id and properties.
  std::vector<geom::Polyline> bases = {};
  OffsetContent content = OffsetContent::Lines;
  std::vector<DrawnOffset> curves = {};
};

/// @param tolerance  of the chords, in D; see offset::chords.
DrawnOffset drawn(const offset::OffsetCurve& curve, const geom::Polyline& base, double tolerance);
DrawnOffset drawn(const offset::Area& area, double distance);

/// What the coordinates of the file are in.
struct OffsetOrigin {
  std::optional<io::ReferenceSystem> system = std::nullopt;
  std::optional<double> unit = std::nullopt;  ///< Metres in one unit, as the file says.
};

/// What the verifier has to say about offset curves, and what it was not asked about.
struct OffsetVerdict {
  std::vector<std::string> findings;  ///< A line each, with curve, distance and place.
  std::size_t curves = 0;             ///< Judged: one a ring or line and distance.
  std::size_t edges = 0;              ///< Judged.
  std::size_t samples = 0;            ///< Places where the curves had to be.
  std::size_t dropped = 0;            ///< Pieces that were left out of the curves of open lines,
  double dropped_length = 0.0;        ///< and how long they are, m.
  std::size_t cut_tips = 0;           ///< Bisector points that were cut across.
  std::size_t mended = 0;             ///< Polygons taken as others, which do not cross themselves.
  std::size_t skipped = 0;            ///< Open lines at distances below 0.
  std::size_t coarse =
      0;                ///< Curves so near that rounding hides whether they touch; see offset::verifier::Verification.
  bool joined = false;  ///< Areas were made of several curves.
};

/// "2 pieces left out (3 m); ...": what the verdict says nothing about; empty if there is nothing.
std::string not_judged(const OffsetVerdict& verdict, const offset::OffsetOptions& options);

/// Adds to `verdict` what offset::verifier::verify finds in the curves of one base.  @error those of
/// offset::verifier::verify.
base::Result<void> verify_offset(const std::string& name, const geom::Polyline& base,
                                 const offset::OffsetOptions& options, const std::vector<offset::OffsetCurve>& curves,
                                 OffsetVerdict& verdict, const base::Progress& progress = {});

/// @error NotFinite: a length or an area is beyond the range of doubles.
base::Result<void> check_numbers(const std::vector<OffsetFamily>& families);

/// {"curves":[{"distance":d,"length":L,"area":A,"dropped":n,"dropped_length":L,"pieces":[{"closed":b,"points":
/// [[x,y],...]}]}],"dropped":n}, one line, every digit; "curve":name comes first in each where there are several
/// families. Without "area" where it is not known. Of areas each contour comes before its holes.
std::string offset_json(const std::vector<OffsetFamily>& families);

/// A line a curve: (name,) distance, pieces, points, length, area, and what was left out, if anything was.
std::string offset_table(const std::vector<OffsetFamily>& families);

/// The base thick, offset curves coloured by distance, on one panel with a legend.
scene::Picture offset_picture(const std::vector<OffsetFamily>& families);

/// @error BadUsage for an ending that is not among these.
base::Result<void> check_offset_ending(const std::filesystem::path& file);

/// Writes the format that the ending says. Areas are polygons with holes; everything else is lines, whose last point
/// repeats the first where they are closed. Ids, properties, and the system or unit of the file are kept where the
/// format can.
/// @param remarks  what it cannot.
/// @error those of check_offset_ending; BadUsage (lines and polygons in a Shapefile), NotFinite, CannotWrite,
/// CannotDraw.
base::Result<void> write_offset(const std::vector<OffsetFamily>& families, const OffsetOrigin& origin,
                                const std::filesystem::path& file, std::vector<std::string>& remarks);

}  // namespace dobra::cli
