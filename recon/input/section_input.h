#pragma once
// What a scenario says of the whole section: its [input].

#include <optional>
#include <string>
#include <vector>

#include "recon/input/line_input.h"
#include "recon/section/section.h"
#include "shared/base/angle.h"

namespace recon::input {

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
           {.title = "Picture",
            .help = "PNG, JPEG or TIFF.",
            .files = {{"Pictures", {".png", ".jpg", ".jpeg", ".tif", ".tiff"}}},
            .presence = dobra::scenario::Presence::Required});
    d.field("corners", &BackdropInput::corners,
            {.title = "Corners",
             .help = "The lower left and the upper right one, in the coordinates of the section's files; by default as "
                     "the GeoTIFF or its world file says."});
    d.field("opacity", &BackdropInput::opacity, {.title = "Opacity", .at_least = 0.0, .at_most = 1.0});
  }
};

/// One [[input.section]]: a section of its own, and where it stands on the map.
struct PlacedSectionInput {
  std::string name;
  std::string file;
  std::vector<double> trace;
  template <class D>
  static void describe(D& d) {
    d.field("name", &PlacedSectionInput::name, {.title = "Name", .help = "By default that of the file."});
    d.file("file", &PlacedSectionInput::file,
           {.title = "File",
            .help = "A scenario of RECON (.toml), whose input is meant, or lines in any format.",
            .files = placed_file_kinds(),
            .presence = dobra::scenario::Presence::Required});
    d.field("trace", &PlacedSectionInput::trace,
            {.title = "Trace on the map",
             .help = "x0, y0, x1, y1 and further corners, from the left end of the section; by default that of its "
                     "scenario.",
             .unit = "m"});
  }
  static std::vector<dobra::scenario::FileKind> placed_file_kinds() {
    auto kinds = dobra::scenario::lines::file_kinds({dobra::io::formats::Use::ReadLines});
    kinds.insert(kinds.begin(), {"Scenarios", {".toml"}});
    return kinds;
  }
};

enum class SelfCrossings { Refuse, CutLoops };
enum class AboveTopography { Leave, Restore };

/// [input]
struct SectionInput {
  section::VerticalAxis y_axis = section::VerticalAxis::Up;
  double reference = 0.0;
  section::LengthUnit unit = section::LengthUnit::Metre;
  double exaggeration = 1.0;
  SelfCrossings self_crossings = SelfCrossings::Refuse;
  std::vector<HorizonInput> horizons;
  std::vector<FaultInput> faults;
  std::vector<HorizonInput> pins;
  std::vector<HorizonInput> loose_lines;
  std::vector<HorizonInput> units;
  std::vector<HorizonInput> markers;
  std::vector<HorizonInput> borders;
  std::vector<HorizonInput> topographies;
  std::vector<HorizonInput> datums;
  std::vector<BackdropInput> backdrops;
  std::vector<BlockInput> blocks;
  AboveTopography above_topography = AboveTopography::Leave;
  base::Angle curve_angle = base::Angle::from_degrees(5.0);
  std::optional<double> curve_length;
  std::optional<double> snap_to_faults;  ///< Not said: what rounding has parted is joined.
  double share_edges = 0.0;
  double slivers = 0.0;
  std::vector<double> trace;
  std::vector<double> fold_axis;
  double plane_tolerance = 1e-3;
  std::vector<LinesInput> lines;
  std::vector<PlacedSectionInput> placed_sections;
  std::vector<HorizonInput> eroded;
  bool horizons_from_units = false;
  std::string colors;
  std::string orientation;
  std::optional<double> along_strike;
  std::vector<double> cut;
  template <class D>
  static void describe(D& d) {
    dobra::scenario::lines::LineKeys<SectionInput, D> keys(d);
    keys.y_axis();
    keys.reference();
    keys.unit(nullptr, {"m", "km", "ft"});
    keys.exaggeration();
    d.choice("self_crossings", &SectionInput::self_crossings, {"refuse", "cut_loops"},
             {.title = "Lines that cross themselves",
              .help = "cut_loops: small loops of the pen are cut out, with a remark."});
    d.tables("horizon", &SectionInput::horizons, {.title = "Horizons"});
    d.tables("fault", &SectionInput::faults, {.title = "Faults"});
    d.tables(
        "block", &SectionInput::blocks,
        {.title = "Blocks", .help = "Names for what faults part; without one, block 1, block 2, ... from the left."});
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
    d.tables("eroded", &SectionInput::eroded, {.title = "Eroded lines", .help = "Drawn dashed and not restored."});
    d.tables("lines", &SectionInput::lines,
             {.title = "Files of many lines", .help = "Each line becomes what its kind says, a horizon without one."});
    d.tables(
        "section", &SectionInput::placed_sections,
        {.title = "Sections in space",
         .help = "Several sections with their traces on the map, instead of the lines of one; for surface and cut."});
    d.field("horizons_from_units", &SectionInput::horizons_from_units,
            {.title = "Horizons from units",
             .help = "Edges that polygons share become horizons, named by the unit below; none along faults."});
    d.tables("backdrop", &SectionInput::backdrops, {.title = "Backdrop pictures"});
    d.choice("above_topography", &SectionInput::above_topography, {"leave", "restore"},
             {.title = "Horizons above the topography",
              .help = "leave: what is eroded is drawn dashed and not restored; restore: the whole horizon is."});
    d.field("curve_angle", &SectionInput::curve_angle,
            {.title = "Turn of a chord of a curve", .unit = "deg", .above = 0.0, .at_most = 90.0});
    d.field("curve_length", &SectionInput::curve_length,
            {.title = "Longest chord of a curve", .unit = "m", .above = 0.0});
    keys.snap_to_faults(0.0);
    keys.share_edges();
    keys.slivers();
    keys.trace();
    keys.fold_axis();
    keys.plane_tolerance();
    d.file("colours", &SectionInput::colors,
           {.title = "Table of colours",
            .help = "CSV or TOML: name, colour, pattern, age and lithology of units and lines."});
    d.field(
        "orientation", &SectionInput::orientation,
        {.title = "Orientation",
         .help = "What stands over the left and the right end, such as W - E; told by the plane of lines in space."});
    d.field("along_strike", &SectionInput::along_strike,
            {.title = "Length along strike",
             .help = "Of the block that the section stands for: its beds go on like this, into the picture.",
             .unit = "m",
             .above = 0.0});
    d.field("cut", &SectionInput::cut,
            {.title = "Cut through the block",
             .help = "x and y of the beginning and the end of a trace on the map: the section that the vertical plane "
                     "over it cuts out of the block takes the place of the one that was drawn.",
             .unit = "m",
             .when = "along_strike is set"});
  }
};

}  // namespace recon::input
