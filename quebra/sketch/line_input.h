#pragma once
// What a scenario says of a file of lines: format, columns, units, axes, the plane of lines in space, and whether lines
// that do not close are outlines. The same answers as the options of `convert` (shared/cli/convert_command.h).

#include <optional>
#include <string>
#include <vector>

#include "quebra/sketch/sketch_file.h"
#include "shared/scenario/program.h"

namespace quebra::sketch {

enum class FileUnit { File, Metre, Kilometre, Foot, Inch, Centimetre, Millimetre };
enum class FileAxis { File, Up, Down };

/// A base of InputParams.
struct LineInput {
  OpenLines closed = OpenLines::AsDrawn;
  std::string format, columns, name_columns;
  dobra::io::lines::Separator separator = dobra::io::lines::Separator::Detect;
  dobra::io::formats::Coordinates coordinates = dobra::io::formats::Coordinates::Detect;
  std::vector<double> trace, fold_axis;
  std::optional<double> plane_tolerance, reference, exaggeration;
  FileAxis y_axis = FileAxis::File;
  FileUnit unit = FileUnit::File;

  template <class P, class D>
  static void describe_in(D& d) {
    d.choice("closed", of<P>(&LineInput::closed), {"no", "yes"},
             {.title = "Closed",
              .help = "yes: every line of the file is an outline, whose last point need not repeat the first."});
    d.field("format", of<P>(&LineInput::format),
            {.title = "Format",
             .help = "Of a file of lines (text, wkt, geojson, dxf, move, gocad, shapefile, geopackage); by its ending "
                     "otherwise."});
    d.field(
        "columns", of<P>(&LineInput::columns),
        {.title = "Columns",
         .help = "Of a text: numbers or headers of x and y, such as \"1,2\"; of x, y and height for lines in space."});
    d.field("name_columns", of<P>(&LineInput::name_columns),
            {.title = "Columns of names", .help = "Of a text: the columns whose words name a line."});
    d.choice("separator", of<P>(&LineInput::separator), {"detect", "blank", "tab", "comma", "semicolon"},
             {.title = "Separator", .help = "Of the columns of a text."});
    d.choice(
        "coordinates", of<P>(&LineInput::coordinates), {"detect", "section", "map"},
        {.title = "Coordinates", .help = "section: x and y as they stand; map: lines on a vertical plane in space."});
    d.field(
        "trace", of<P>(&LineInput::trace),
        {.title = "Trace",
         .help = "The plane of lines in space: x and y of its beginning and its end; found by least squares otherwise.",
         .unit = "m"});
    d.field("fold_axis", of<P>(&LineInput::fold_axis),
            {.title = "Fold axis",
             .help = "Trend and plunge of the axis along which lines in space are projected.",
             .unit = "deg"});
    d.field("plane_tolerance", of<P>(&LineInput::plane_tolerance),
            {.title = "Plane tolerance",
             .help = "Largest distance of lines in space from their plane, as a part of the length.",
             .above = 0});
    d.choice("y_axis", of<P>(&LineInput::y_axis), {"file", "up", "down"},
             {.title = "Heights grow", .help = "As the file says, else up."});
    d.field("reference", of<P>(&LineInput::reference),
            {.title = "Reference", .help = "With y_axis = \"down\": the value at height 0, in units of the file."});
    d.choice("unit", of<P>(&LineInput::unit), {"file", "m", "km", "ft", "in", "cm", "mm"},
             {.title = "Unit", .help = "Of the coordinates in the file; as the file says, else as the scenario."});
    d.field("exaggeration", of<P>(&LineInput::exaggeration),
            {.title = "Exaggeration", .help = "Heights are stored this many times too large.", .above = 0});
  }

 private:
  template <class P, class T>
  static T P::*of(T LineInput::*member) {
    return member;
  }
};

/// @error BadValue naming the key.
dobra::base::Result<SketchOptions> sketch_options(const LineInput& input);

}  // namespace quebra::sketch
