#pragma once
// Offset curves as they are given out: lines with their lengths and areas, and what the verifier says of them.

#include <optional>
#include <string>
#include <vector>

#include "shared/io/formats/line_files.h"
#include "shared/offset/area.h"

namespace dobra::operations {

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

/// A base (see offset_families.h), and the curves parallel to it or the areas about it, by distance.
struct OffsetFamily {
  std::string name;
  io::lines::Feature source = {};  ///< Its name, kind, id and properties.
  std::vector<geom::Polyline> bases = {};
  OffsetContent content = OffsetContent::Lines;
  std::vector<DrawnOffset> curves = {};
};

/// @param tolerance  of the chords, in D; see offset::chords.
DrawnOffset drawn(const offset::OffsetCurve& curve, const geom::Polyline& base, double tolerance);
DrawnOffset drawn(const offset::Area& area, double distance);

/// What the coordinates of the file are in.
struct OffsetOrigin {
  std::optional<io::lines::ReferenceSystem> system = std::nullopt;
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

/// Curves of which something remains, each with its numbers and then what its base has; a property of the base that has
/// the name of one of ours is "source_...". Areas are polygons with holes; everything else is lines.
std::vector<io::lines::Feature> features_of(const std::vector<OffsetFamily>& families);

std::size_t point_count(const DrawnOffset& curve);

}  // namespace dobra::operations
