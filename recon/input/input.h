#pragma once
// From the [input] of a scenario to a Section: horizons from files in any format of lines (text, CSV, GeoJSON, DXF,
// GOCAD, MOVE, Shapefile, GeoPackage, WKT) or written in the scenario itself. What is doubtful is refused or repaired
// with a remark, never guessed.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "recon/input/section_input.h"
#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/io/lines/section_plane.h"
#include "shared/scenario/program.h"

namespace recon::input {

struct ReadSection {
  section::Section section;
  std::vector<std::string> remarks;             ///< Repairs and doubts, one line each.
  std::map<std::string, base::Place> places{};  ///< Of remarks that have one, by their text.
  /// The plane that it stands in, as the input says or as lines in space were laid into it.
  std::optional<dobra::io::lines::Trace> trace = std::nullopt;
};

/// @error BadSection (no horizon, the same name twice, a line that crosses itself), MissingKey, BadValue,
/// DegenerateCurve, NotFinite and those
///        of the file readers, each with the file or the horizon and the place.
base::Result<ReadSection> read_section(const SectionInput& input, const dobra::scenario::Context& context,
                                       const base::Progress& progress);

/// Of remarks on a section that have a place, by their text.
struct RemarkPlaces {
  std::map<std::string, base::Place> of;
};

struct ReadLine {
  geom::Polyline line;
  std::vector<std::string> remarks;
  std::optional<dobra::io::lines::Trace> trace =
      std::nullopt;  ///< Of a line in space that was laid into its own plane.
};
/// The same of a line that the file has in one piece or in several.
struct ReadPieces {
  std::vector<geom::Polyline> pieces;
  std::vector<std::string> remarks;
  std::optional<dobra::io::lines::Trace> trace = std::nullopt;
};

/// How a line is read beside what its own input says.
struct ReadSettings {
  section::Convention convention = {};
  geom::DiscretiseOptions curves = {};
  std::optional<dobra::io::lines::Trace> trace = std::nullopt;
  std::optional<dobra::io::lines::FoldAxis> fold_axis = std::nullopt;
  double plane_tolerance = 1e-3;
};
/// @error BadValue: a trace or fold axis that is none.
base::Result<ReadSettings> read_settings(const SectionInput& input);

/// One line from a file or from points, without repeated points, curves cut into chords; in the order in which it was
/// given. Lines of the file that share its name are its pieces.
/// @error as above, except those about the section.
base::Result<ReadPieces> read_pieces(const HorizonInput& input, const ReadSettings& settings,
                                     const dobra::scenario::Context& context);
/// The same of a line that must be in one piece. @error BadSection where it is not.
base::Result<ReadLine> read_line(const HorizonInput& input, const ReadSettings& settings,
                                 const dobra::scenario::Context& context);

}  // namespace recon::input
