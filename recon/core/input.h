#pragma once
// From the [input] of a scenario to a Section: horizons from text, CSV and GeoJSON files or written in the scenario
// itself. What is doubtful is refused or repaired with a remark, never guessed.

#include <string>
#include <vector>

#include "recon/core/section.h"
#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/scenario/program.h"

namespace recon::core {

enum class FieldSeparator { Detect, Blank, Tab, Comma, Semicolon };
enum class SelfCrossings { Refuse, CutLoops };

/// One [[input.horizon]].
struct HorizonInput {
  std::string name;
  std::string file;
  std::vector<geom::Point> points;
  std::string feature;
  std::vector<double> columns = {1.0, 2.0};
  FieldSeparator separator = FieldSeparator::Detect;
  template <class D>
  static void describe(D& d) {
    d.field("name", &HorizonInput::name, {.title = "Name", .presence = dobra::scenario::Presence::Required});
    d.file("file", &HorizonInput::file,
           {.title = "File", .help = "Two-column text, CSV or GeoJSON; instead of points."});
    d.field("points", &HorizonInput::points,
            {.title = "Points", .help = "The line itself, [[x, y], ...]; instead of a file."});
    d.field("feature", &HorizonInput::feature,
            {.title = "Feature", .help = "Name of the feature in a GeoJSON file that holds several lines."});
    d.field("columns", &HorizonInput::columns,
            {.title = "Columns of x and y", .help = "In a text file, counted from 1."});
    d.choice("separator", &HorizonInput::separator, {"detect", "blank", "tab", "comma", "semicolon"},
             {.title = "Separator", .help = "Between the columns of a text file."});
  }
};

/// [input]
struct SectionInput {
  VerticalAxis y_axis = VerticalAxis::Up;
  double reference = 0.0;
  LengthUnit unit = LengthUnit::Metre;
  SelfCrossings self_crossings = SelfCrossings::Refuse;
  std::vector<HorizonInput> horizons;
  std::vector<HorizonInput> faults;
  std::vector<HorizonInput> pins;
  std::vector<HorizonInput> loose_lines;
  std::vector<HorizonInput> units;
  std::vector<HorizonInput> markers;
  template <class D>
  static void describe(D& d) {
    d.choice("y_axis", &SectionInput::y_axis, {"up", "down"},
             {.title = "Second coordinate grows", .help = "down: z = reference - y, as for depths and images."});
    d.field(
        "reference", &SectionInput::reference,
        {.title = "Reference of y", .help = "Value of y at z = 0 where y grows downwards, in the unit of the files."});
    d.choice("unit", &SectionInput::unit, {"m", "km", "ft"}, {.title = "Unit of the coordinates"});
    d.choice("self_crossings", &SectionInput::self_crossings, {"refuse", "cut_loops"},
             {.title = "Lines that cross themselves",
              .help = "cut_loops: small loops of the pen are cut out, with a remark."});
    d.tables("horizon", &SectionInput::horizons, {.title = "Horizons"});
    d.tables("fault", &SectionInput::faults, {.title = "Faults"});
    d.tables("pin", &SectionInput::pins, {.title = "Pin lines"});
    d.tables("loose", &SectionInput::loose_lines, {.title = "Loose lines"});
    d.tables("polygon", &SectionInput::units, {.title = "Unit polygons"});
    d.tables("marker", &SectionInput::markers, {.title = "Markers"});
  }
};

struct ReadSection {
  Section section;
  std::vector<std::string> remarks;  ///< Repairs and doubts, one line each.
};

/// @error BadSection (no horizon, the same name twice, a line that crosses itself), MissingKey, BadValue,
/// DegenerateCurve, NotFinite and those
///        of the file readers, each with the file or the horizon and the place.
base::Result<ReadSection> read_section(const SectionInput& input, const dobra::scenario::Context& context,
                                       const base::Progress& progress);

struct ReadLine {
  geom::Polyline line;
  std::vector<std::string> remarks;
};

/// One line from a file or from points, in section coordinates, without repeated points; in the order in which it was
/// given.
/// @error as above, except those about the section.
base::Result<ReadLine> read_line(const HorizonInput& input, const Convention& convention,
                                 const dobra::scenario::Context& context);

}  // namespace recon::core
