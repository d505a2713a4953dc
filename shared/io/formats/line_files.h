#pragma once
// Line-work in and out in every format that carries it: one way in and one way out for commands, scenarios and windows.
// Coordinates become section coordinates (x right, y up, metres) by options or by what the file says itself; what
// neither says is asked, never guessed. Page: docs/user/import.md.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "shared/base/result.h"
#include "shared/io/formats/format.h"
#include "shared/io/formats/repair.h"
#include "shared/io/lines/line_kinds.h"
#include "shared/io/lines/section_plane.h"
#include "shared/io/lines/text_points.h"

namespace dobra::io::formats {

/// By the ending of a name, capitals or not. @error UnknownFormat, naming the endings.
base::Result<const Format*> line_format_of(const std::string& path);

/// What the first two coordinates are. Section: x along the section and y up (or down), as they stand; a third one is
/// dropped. Map: a place on the map, and the third one is the height: the section's plane is fitted, or given.
/// Detect: Map where a file has heights other than 0.
enum class Coordinates { Detect, Section, Map };

/// The units that files of lines may be in, as users name them, and their metres; in one order.
inline constexpr std::array<const char*, 6> file_units{"m", "km", "ft", "in", "cm", "mm"};
inline constexpr std::array<double, 6> file_unit_metres{1.0, 1000.0, 0.3048, 0.0254, 0.01, 0.001};

/// "a,b" as a, b; empty text gives none.
std::vector<std::string> words_between_commas(const std::string& text);

/// Metres: coordinates are turned into metres. OfTheFile: they stay as they are, whatever the unit.
enum class UnitWanted { Metres, OfTheFile };

struct LineOptions {
  const Format* format = nullptr;  ///< Of lines; by the ending of the name where none is given.
  /// Columns are chosen by number or header; empty: the first two, asked where there is a third column of numbers.
  lines::TextPointsOptions text = {
      .columns = {}, .blank_lines = lines::BlankLines::SplitLines, .closing = lines::Closing::WhenFirstPointRepeats};
  Coordinates coordinates = Coordinates::Detect;
  std::optional<lines::Trace> trace = std::nullopt;  ///< The plane of 3D lines, m; fitted by least squares otherwise.
  std::optional<lines::FoldAxis> fold_axis =
      std::nullopt;               ///< 3D lines are projected along it onto the profile of the fold.
  double plane_tolerance = 1e-3;  ///< Largest misfit of the plane as a part of the length of the section, > 0.
  std::optional<lines::YDirection> y_direction = std::nullopt;  ///< As the file says, else up.
  double y_reference = 0.0;                   ///< Down: y = y_reference - value, in units of the file.
  std::optional<double> unit = std::nullopt;  ///< Metres in one unit; as the file says, else silent_unit.
  double silent_unit = 1.0;                   ///< Metres in one unit where nobody says.
  double exaggeration = 1.0;                  ///< Heights are stored this many times too large, > 0.
  std::vector<lines::KindRule> kinds =
      {};  ///< Kinds by names; the first rule that fits goes before what the file says.
  RepairOptions repair = {};
  lines::Faulty faulty = lines::Faulty::Refuse;  ///< Skip: as the readers of text, WKT, GeoJSON, DXF and OGR do it.
  UnitWanted unit_wanted = UnitWanted::Metres;   ///< OfTheFile: `unit` and `silent_unit` are not looked at.
};

struct LineWork {
  std::vector<lines::Feature> features;  ///< In section coordinates, m; at least one, in the order of the file.
  const Format* format = nullptr;        ///< That it was read in; of work that was not read: none.
  std::optional<lines::Trace> trace = std::nullopt;             ///< Of 3D lines that were laid into their plane.
  lines::YDirection y_direction = lines::YDirection::Up;        ///< As it was taken.
  double unit = 1.0;                                            ///< As it was taken, m.
  std::optional<double> stated_unit = std::nullopt;             ///< Metres in one unit, as the file says.
  std::optional<lines::ReferenceSystem> system = std::nullopt;  ///< As the file states it; not applied.
  std::vector<Repair> repairs;
  std::vector<std::string> remarks;  ///< What was changed, left out or taken from the file, one line each.
};

/// @error Unclear: what the file leaves open, with the option that answers it; InvalidOption; BadFormat: no feature, or
///        a plane that does not fit, with the misfit; NotFinite; those of the readers and of repair.
base::Result<LineWork> read_any_lines(const std::string& path, const LineOptions& options = {});
/// The same from text in memory, for the formats that are text. `file` is the name that errors show.
base::Result<LineWork> parse_any_lines(std::string_view text, const std::string& file, const LineOptions& options);

struct LineWriteOptions {
  const Format* format = nullptr;  ///< Of lines; by the ending of the name where none is given.
  /// Section: two coordinates. Map: three, on the trace, or on the plane y = 0 without one. Detect: Map for MOVE and
  /// GOCAD, which have no other, else Section.
  Coordinates coordinates = Coordinates::Detect;
  /// Kept in GeoJSON (with a code), Shapefile and GeoPackage; for coordinates that are still those of the file.
  const lines::ReferenceSystem* system = nullptr;
  /// Metres in one unit of the coordinates; kept in DXF, where it is a unit that DXF knows.
  std::optional<double> unit = std::nullopt;
};

/// The text of a format that is text, that of `work` (else "text") where the options give none. Adds a remark for what
/// the format cannot hold.
/// @error InvalidOption (not a text format), NotFinite.
base::Result<std::string> lines_text(const LineWork& work, const LineWriteOptions& options,
                                     std::vector<std::string>& remarks);
/// @error those of lines_text; InvalidOption (a Shapefile of several kinds), UnknownFormat, CannotWrite.
base::Result<void> write_any_lines(const std::string& path, const LineWork& work, const LineWriteOptions& options,
                                   std::vector<std::string>& remarks);

}  // namespace dobra::io::formats
