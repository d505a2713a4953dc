#pragma once
// All lines of a file as what they are in a section: horizons in pieces or whole, faults, units, markers, ... by their
// kinds. Page: docs/user/import.md

#include <string>
#include <vector>

#include "recon/input/input.h"
#include "recon/input/section_input.h"
#include "shared/io/lines/feature.h"

namespace recon::input {

/// One line of the section, and the list of [input] that it belongs to.
struct ImportedLine {
  std::string
      table;  ///< "horizon", "fault", "pin", "loose", "topography", "datum", "eroded", "polygon", "border", "marker".
  std::string name;      ///< Unlike those before it in the table.
  std::string piece_of;  ///< Of horizons, faults and polygons, as the file states it or by the names.
  section::BedRole role = section::BedRole::Judged;
  geom::Polyline line;  ///< In section coordinates, as one draws it: polygons repeat their first point.
  base::Place source;
  int order = 0;  ///< Of faults, as the section has it.
  section::HangingWall hanging_wall = section::HangingWall::Auto;
};

struct Import {
  std::vector<ImportedLine> lines;
  std::vector<std::string> remarks;
};

/// "A" and 12 of "A (12)"; nothing where a name has no such end.
std::optional<std::pair<std::string, std::size_t>> numbered_name(const std::string& name);

/// A line that is, or is a piece of, a horizon.
bool is_horizon(const dobra::io::lines::Feature& feature);

/// Lines of one name that are horizons, and the parts of one line, are pieces of a horizon; faults likewise. A line
/// without a kind is a horizon, a polygon a unit, points a marker. Holes of polygons are left out, with a remark.
/// @error BadFormat with file, line and a suggestion: an unknown kind; a polygon that says that it is a line; an order
///        or a hanging wall that is none.
base::Result<Import> import_lines(const std::vector<dobra::io::lines::Feature>& features);

/// The input with every [[input.lines]] replaced by the lines of its file.
/// @error those of import_lines and of the readers; BadValue: options of the table.
base::Result<SectionInput> with_lines_of_files(SectionInput input, const ReadSettings& settings,
                                               const dobra::scenario::Context& context,
                                               std::vector<std::string>& remarks);

/// Remarks, with their places, on horizons and faults called "A (1)", "A (2)" that do not say that they are pieces.
/// @pre  the lines of the input have been read.
void tell_numbered_names(const SectionInput& input, ReadSection& read);

}  // namespace recon::input
