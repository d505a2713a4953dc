#pragma once
// What a scenario says of one line of the section: [[input.horizon]], [[input.fault]], [[input.pin]], ...

#include <optional>
#include <string>
#include <vector>

#include "recon/section/section.h"
#include "shared/geom/drawn_curve.h"
#include "shared/io/lines/feature.h"
#include "shared/scenario/lines/line_reading.h"

namespace recon::input {

enum class FieldSeparator { Detect, Blank, Tab, Comma, Semicolon };
/// Section: as for the whole section, or where that says nothing, as the file itself says.
enum class LineAxis { Section, Up, Down };
enum class LineUnit { Section, Metre, Kilometre, Foot };
enum class PointOrder { AsGiven, AlongCurve };

/// A line in section coordinates, m, and the plane that it was laid into, if it was.
struct PlacedLine {
  geom::Polyline line;
  std::optional<dobra::io::lines::Trace> trace = std::nullopt;
};

/// The fields of how the lines of a file are read, and their points repaired.
template <class Input, class D>
void describe_reading(dobra::scenario::lines::LineKeys<Input, D>& keys, const char* order) {
  keys.separator();
  keys.y_axis("section");
  keys.unit("section", {"m", "km", "ft"});
  keys.order(order);
  keys.drop_duplicates();
  keys.join_gaps();
}

/// One [[input.horizon]].
struct HorizonInput {
  std::string name;
  std::string file;
  std::vector<geom::Point> points;
  std::string feature;
  std::string piece_of;
  section::BedRole role = section::BedRole::Judged;
  std::vector<double> columns;  ///< Empty: as the header says, else the first two.
  FieldSeparator separator = FieldSeparator::Detect;
  LineAxis y_axis = LineAxis::Section;
  LineUnit unit = LineUnit::Section;
  PointOrder order = PointOrder::AsGiven;
  double drop_duplicates = 0.0;
  double join_gaps = 0.0;
  geom::DrawnAs curve = geom::DrawnAs::Line;
  std::vector<geom::Point> tangents;
  std::vector<double> weights;
  std::string color;
  std::optional<PlacedLine> placed = std::nullopt;  ///< Out of an [[input.lines]]; instead of file and points.
  template <class D>
  static void describe(D& d) {
    describe_line<HorizonInput>(d, "order");
    d.field("piece_of", &HorizonInput::piece_of,
            {.title = "Piece of the horizon",
             .help = "Name of the horizon that faults have cut this piece from; the pieces add up in the ledger."});
    d.field("colour", &HorizonInput::color,
            {.title = "Colour", .help = "Such as #1a2b3c; by default the usual ones, one after the other."});
  }
  /// What lines of all kinds have. @param order  the key of the order of the points.
  template <class Input, class D>
  static void describe_line(D& d, const char* order) {
    dobra::scenario::lines::LineKeys<Input, D> keys(d);
    d.field("name", keys.of(&Input::name), {.title = "Name", .presence = dobra::scenario::Presence::Required});
    d.file("file", keys.of(&Input::file),
           {.title = "File",
            .help = "In any format of lines; instead of points.",
            .files = dobra::scenario::lines::file_kinds({dobra::io::formats::Use::ReadLines})});
    d.field("points", keys.of(&Input::points),
            {.title = "Points", .help = "The line itself, [[x, y], ...]; instead of a file."});
    d.field("feature", keys.of(&Input::feature),
            {.title = "Feature", .help = "Name of the line in a file that holds several.", .when = "file is set"});
    d.choice("role", keys.of(&Input::role), {"judged", "growth"},
             {.title = "Role in the balance",
              .help = "growth: a horizon laid down while the section deformed; it is listed, not judged."});
    d.field("columns", keys.of(&Input::columns),
            {.title = "Columns of x and y",
             .help = "In a text file, counted from 1; three for map coordinates with heights.",
             .when = "file is set"});
    describe_reading(keys, order);
    d.choice(
        "curve", keys.of(&Input::curve), {"line", "hermite", "spline", "bezier", "b_spline", "rational_bezier"},
        {.title = "Drawn as",
         .help = "What the points mean: line, corners; hermite, points with tangents; spline, natural through the "
                 "points (closed if the last repeats the first); bezier, rational_bezier and b_spline, vertices."});
    d.field("tangents", keys.of(&Input::tangents),
            {.title = "Tangents",
             .help = "Of curve = \"hermite\", one a point: derivatives along a piece.",
             .when = "curve = hermite"});
    d.field("weights", keys.of(&Input::weights),
            {.title = "Weights",
             .help = "Of curve = \"rational_bezier\", one a point, above 0.",
             .when = "curve = rational_bezier"});
  }
};

/// One [[input.fault]].
struct FaultInput : HorizonInput {
  std::optional<int> age;  ///< Key "order".
  section::HangingWall hanging_wall = section::HangingWall::Auto;
  FaultInput() = default;
  FaultInput(HorizonInput line) : HorizonInput(std::move(line)) {}
  template <class D>
  static void describe(D& d) {
    describe_line<FaultInput>(d, "point_order");
    dobra::scenario::lines::LineKeys<FaultInput, D> keys(d);
    d.field("piece_of", keys.of(&FaultInput::piece_of),
            {.title = "Piece of the fault", .help = "Name of the fault that younger ones have cut this piece from."});
    d.field("order", &FaultInput::age,
            {.title = "Order of age", .help = "1: the youngest fault, which is restored first.", .at_least = 1.0});
    d.choice("hanging_wall", &FaultInput::hanging_wall, {"auto", "left", "right", "above", "below"},
             {.title = "Hanging wall", .help = "On which side it lies; auto: above the fault."});
  }
};

/// One [[input.block]].
struct BlockInput {
  std::string name;
  geom::Point point;
  std::string part_of;
  template <class D>
  static void describe(D& d) {
    d.field("name", &BlockInput::name, {.title = "Name", .presence = dobra::scenario::Presence::Required});
    d.field("point", &BlockInput::point,
            {.title = "Point in the block",
             .help = "Any place between the faults that bound it.",
             .presence = dobra::scenario::Presence::Required});
    d.field("part_of", &BlockInput::part_of, {.title = "Group", .help = "Blocks of one group move together."});
  }
};

/// One [[input.lines]]: all lines of a file, each as what its kind says.
struct LinesInput {
  std::string file;
  std::vector<std::string> kind;
  std::vector<std::string> columns;
  std::vector<std::string> name_columns;
  FieldSeparator separator = FieldSeparator::Detect;
  LineAxis y_axis = LineAxis::Section;
  LineUnit unit = LineUnit::Section;
  PointOrder order = PointOrder::AsGiven;
  double drop_duplicates = 0.0;
  double join_gaps = 0.0;
  template <class D>
  static void describe(D& d) {
    d.file("file", &LinesInput::file,
           {.title = "File",
            .help = "In any format of lines.",
            .files = dobra::scenario::lines::file_kinds({dobra::io::formats::Use::ReadLines}),
            .presence = dobra::scenario::Presence::Required});
    dobra::scenario::lines::LineKeys<LinesInput, D> keys(d);
    keys.kind();
    keys.columns();
    keys.name_columns();
    describe_reading(keys, "order");
  }
};

}  // namespace recon::input
