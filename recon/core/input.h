#pragma once
// From the [input] of a scenario to a Section: horizons from files in any format of lines (text, CSV, GeoJSON, DXF,
// GOCAD, MOVE, Shapefile, GeoPackage, WKT) or written in the scenario itself. What is doubtful is refused or repaired
// with a remark, never guessed.

#include <string>
#include <vector>

#include "recon/core/section.h"
#include "shared/base/progress.h"
#include "shared/base/result.h"
#include "shared/geom/drawn_curve.h"
#include "shared/io/section_plane.h"
#include "shared/scenario/program.h"

namespace recon::core {

enum class FieldSeparator { Detect, Blank, Tab, Comma, Semicolon };
enum class SelfCrossings { Refuse, CutLoops };
/// Section: as for the whole section, or where that says nothing, as the file itself says.
enum class LineAxis { Section, Up, Down };
enum class LineUnit { Section, Metre, Kilometre, Foot };
enum class PointOrder { AsGiven, AlongCurve };

/// One [[input.horizon]].
struct HorizonInput {
  std::string name;
  std::string file;
  std::vector<geom::Point> points;
  std::string feature;
  std::vector<double> columns = {1.0, 2.0};
  FieldSeparator separator = FieldSeparator::Detect;
  LineAxis y_axis = LineAxis::Section;
  LineUnit unit = LineUnit::Section;
  PointOrder order = PointOrder::AsGiven;
  double drop_duplicates = 0.0;
  double join_gaps = 0.0;
  geom::DrawnAs curve = geom::DrawnAs::Line;
  std::vector<geom::Point> tangents;
  std::vector<double> weights;
  template <class D>
  static void describe(D& d) {
    d.field("name", &HorizonInput::name, {.title = "Name", .presence = dobra::scenario::Presence::Required});
    d.file("file", &HorizonInput::file,
           {.title = "File",
            .help = "Text, CSV, GeoJSON, DXF, GOCAD, MOVE, Shapefile, GeoPackage or WKT; instead of points."});
    d.field("points", &HorizonInput::points,
            {.title = "Points", .help = "The line itself, [[x, y], ...]; instead of a file."});
    d.field("feature", &HorizonInput::feature,
            {.title = "Feature", .help = "Name of the line in a file that holds several."});
    d.field("columns", &HorizonInput::columns,
            {.title = "Columns of x and y",
             .help = "In a text file, counted from 1; three for map coordinates with heights."});
    d.choice("separator", &HorizonInput::separator, {"detect", "blank", "tab", "comma", "semicolon"},
             {.title = "Separator", .help = "Between the columns of a text file."});
    d.choice("y_axis", &HorizonInput::y_axis, {"section", "up", "down"},
             {.title = "Second coordinate grows", .help = "section: as for all files, or as the file itself says."});
    d.choice("unit", &HorizonInput::unit, {"section", "m", "km", "ft"},
             {.title = "Unit of the file", .help = "section: as for all files, or as the file itself says."});
    d.choice(
        "order", &HorizonInput::order, {"as_given", "along_curve"},
        {.title = "Order of the points", .help = "along_curve: unordered points are put in order, with a remark."});
    d.field("drop_duplicates", &HorizonInput::drop_duplicates,
            {.title = "Drop points nearer than", .help = "0: none but equal ones.", .unit = "m", .at_least = 0.0});
    d.field("join_gaps", &HorizonInput::join_gaps,
            {.title = "Join gaps below",
             .help = "Parts of the same name whose ends are nearer become one line; 0: none.",
             .unit = "m",
             .at_least = 0.0});
    d.choice(
        "curve", &HorizonInput::curve, {"line", "hermite", "spline", "bezier", "b_spline", "rational_bezier"},
        {.title = "Drawn as",
         .help = "What the points mean: line, corners; hermite, points with tangents; spline, natural through the "
                 "points (closed if the last repeats the first); bezier, rational_bezier and b_spline, vertices."});
    d.field("tangents", &HorizonInput::tangents,
            {.title = "Tangents", .help = "Of curve = \"hermite\", one a point: derivatives along a piece."});
    d.field("weights", &HorizonInput::weights,
            {.title = "Weights", .help = "Of curve = \"rational_bezier\", one a point, above 0."});
  }
};

/// One [[input.backdrop]].
struct BackdropInput {
  std::string name;
  std::string file;
  std::vector<geom::Point> corners;
  double opacity = 0.6;
  template <class D>
  static void describe(D& d) {
    d.field("name", &BackdropInput::name, {.title = "Name", .presence = dobra::scenario::Presence::Required});
    d.file("file", &BackdropInput::file,
           {.title = "Picture", .help = "PNG, JPEG or TIFF.", .presence = dobra::scenario::Presence::Required});
    d.field("corners", &BackdropInput::corners,
            {.title = "Corners",
             .help = "The lower left and the upper right one, in the coordinates of the section's files; by default as "
                     "the GeoTIFF or its world file says."});
    d.field("opacity", &BackdropInput::opacity, {.title = "Opacity", .at_least = 0.0, .at_most = 1.0});
  }
};

enum class AboveTopography { Leave, Restore };

/// [input]
struct SectionInput {
  VerticalAxis y_axis = VerticalAxis::Up;
  double reference = 0.0;
  LengthUnit unit = LengthUnit::Metre;
  double exaggeration = 1.0;
  SelfCrossings self_crossings = SelfCrossings::Refuse;
  std::vector<HorizonInput> horizons;
  std::vector<HorizonInput> faults;
  std::vector<HorizonInput> pins;
  std::vector<HorizonInput> loose_lines;
  std::vector<HorizonInput> units;
  std::vector<HorizonInput> markers;
  std::vector<HorizonInput> borders;
  std::vector<HorizonInput> topographies;
  std::vector<HorizonInput> datums;
  std::vector<BackdropInput> backdrops;
  AboveTopography above_topography = AboveTopography::Leave;
  base::Angle curve_angle = base::Angle::from_degrees(5.0);
  std::optional<double> curve_length;
  double snap_to_faults = 0.0;
  double share_edges = 0.0;
  double slivers = 0.0;
  std::vector<double> trace;
  std::vector<double> fold_axis;
  double plane_tolerance = 1e-3;
  template <class D>
  static void describe(D& d) {
    d.choice("y_axis", &SectionInput::y_axis, {"up", "down"},
             {.title = "Second coordinate grows", .help = "down: z = reference - y, as for depths and images."});
    d.field(
        "reference", &SectionInput::reference,
        {.title = "Reference of y", .help = "Value of y at z = 0 where y grows downwards, in the unit of the files."});
    d.choice("unit", &SectionInput::unit, {"m", "km", "ft"}, {.title = "Unit of the coordinates"});
    d.field("exaggeration", &SectionInput::exaggeration,
            {.title = "Exaggeration in the data",
             .help = "The files hold z this many times too large; it is divided by this.",
             .above = 0.0});
    d.choice("self_crossings", &SectionInput::self_crossings, {"refuse", "cut_loops"},
             {.title = "Lines that cross themselves",
              .help = "cut_loops: small loops of the pen are cut out, with a remark."});
    d.tables("horizon", &SectionInput::horizons, {.title = "Horizons"});
    d.tables("fault", &SectionInput::faults, {.title = "Faults"});
    d.tables("pin", &SectionInput::pins, {.title = "Pin lines"});
    d.tables("loose", &SectionInput::loose_lines, {.title = "Loose lines"});
    d.tables("polygon", &SectionInput::units, {.title = "Unit polygons"});
    d.tables("marker", &SectionInput::markers, {.title = "Markers"});
    d.tables("border", &SectionInput::borders,
             {.title = "Border",
              .help = "One polygon round what belongs to the section; by default it reaches from the "
                      "first horizon to the last, between their ends."});
    d.tables("topography", &SectionInput::topographies, {.title = "Topography"});
    d.tables("datum", &SectionInput::datums, {.title = "Datums", .help = "Lines that the step target may name."});
    d.tables("backdrop", &SectionInput::backdrops, {.title = "Backdrop pictures"});
    d.choice("above_topography", &SectionInput::above_topography, {"leave", "restore"},
             {.title = "Horizons above the topography",
              .help = "leave: what is eroded is drawn dashed and not restored; restore: the whole horizon is."});
    d.field("curve_angle", &SectionInput::curve_angle,
            {.title = "Turn of a chord of a curve", .unit = "deg", .above = 0.0, .at_most = 90.0});
    d.field("curve_length", &SectionInput::curve_length,
            {.title = "Longest chord of a curve", .unit = "m", .above = 0.0});
    d.field("snap_to_faults", &SectionInput::snap_to_faults,
            {.title = "Snap ends to faults",
             .help = "Ends of horizons nearer to a fault than this are moved onto it, with a remark; 0: none.",
             .unit = "m",
             .at_least = 0.0});
    d.field("share_edges", &SectionInput::share_edges,
            {.title = "Make polygons share edges",
             .help = "Their vertices nearer than this to a line or another polygon are moved onto it; 0: none.",
             .unit = "m",
             .at_least = 0.0});
    d.field("slivers", &SectionInput::slivers,
            {.title = "Remove slivers",
             .help = "Polygons and spikes of polygons thinner than this are removed, with a remark; 0: none.",
             .unit = "m",
             .at_least = 0.0});
    d.field("trace", &SectionInput::trace,
            {.title = "Trace of the section",
             .help = "Of files with lines in space: x0, y0, x1, y1 on the map, in metres; found by least squares where "
                     "one file holds them all."});
    d.field("fold_axis", &SectionInput::fold_axis,
            {.title = "Fold axis",
             .help = "Of files with lines in space: trend and plunge in degrees; they are projected down the plunge."});
    d.field("plane_tolerance", &SectionInput::plane_tolerance,
            {.title = "Lines in space off their plane", .help = "At most this part of the length.", .above = 0.0});
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
  std::optional<dobra::io::Trace> trace = std::nullopt;  ///< Of a line in space that was laid into its own plane.
};

/// How a line is read beside what its own input says.
struct ReadSettings {
  Convention convention = {};
  geom::DiscretiseOptions curves = {};
  std::optional<dobra::io::Trace> trace = std::nullopt;
  std::optional<dobra::io::FoldAxis> fold_axis = std::nullopt;
  double plane_tolerance = 1e-3;
};
/// @error BadValue: a trace or fold axis that is none.
base::Result<ReadSettings> read_settings(const SectionInput& input);

/// One line from a file or from points, in section coordinates, without repeated points, curves cut into chords; in the
/// order in which it was given.
/// @error as above, except those about the section.
base::Result<ReadLine> read_line(const HorizonInput& input, const ReadSettings& settings,
                                 const dobra::scenario::Context& context);

}  // namespace recon::core
