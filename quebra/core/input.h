#pragma once
// The [input] of a QUEBRA scenario: a specimen of the library, a file, and curves, cracks, regions and points written
// in the document; any of them together.

#include <optional>
#include <string>
#include <vector>

#include "quebra/domain/domain.h"
#include "quebra/model/model.h"
#include "quebra/sketch/line_input.h"
#include "quebra/sketch/specimen.h"
#include "quebra/surfaces/surface_input.h"
#include "shared/base/progress.h"
#include "shared/scenario/program.h"

namespace quebra::core {

enum class Repair { No, Yes };
enum class CurveKind { Line, Polygon, Arc, Circle, Spline, Bezier };
enum class Turning { Anticlockwise, Clockwise };

/// One [[input.curve]].
struct CurveParams {
  std::string name;
  CurveKind kind = CurveKind::Line;
  std::vector<dobra::geom::Point> points;
  std::optional<dobra::geom::Point> centre;
  std::optional<double> radius;
  std::optional<dobra::base::Angle> start;
  std::optional<dobra::base::Angle> sweep;
  Turning turning = Turning::Anticlockwise;
  sketch::Role role = sketch::Role::Boundary;
  int segments = 0;
  double size = 0.0;
  double ratio = 1.0;
  std::vector<std::string> groups;

  template <class D>
  static void describe(D& d) {
    d.field("name", &CurveParams::name,
            {.title = "Name", .help = "Sets of the mesh take it.", .presence = dobra::scenario::Presence::Required});
    d.choice(
        "kind", &CurveParams::kind, {"line", "polygon", "arc", "circle", "spline", "bezier"},
        {.title = "Kind",
         .help =
             "line: a chain of points; polygon: closed; arc: centre and two points, or centre, radius, start, sweep; "
             "circle: centre and radius; spline: smooth through the points, closed if the last repeats the first; "
             "bezier: cubics end to end, by their vertices."});
    d.field("points", &CurveParams::points,
            {.title = "Points",
             .help = "Vertices of a line or polygon; first and last point of an arc.",
             .unit = "m",
             .when = "kind in line, polygon, arc, spline, bezier"});
    d.field("centre", &CurveParams::centre,
            {.title = "Centre", .help = "Of an arc or circle.", .unit = "m", .when = "kind in arc, circle"});
    d.field("radius", &CurveParams::radius,
            {.title = "Radius",
             .help = "Of a circle, or of an arc given by angles.",
             .unit = "m",
             .above = 0,
             .when = "kind in arc, circle"});
    d.field("start", &CurveParams::start,
            {.title = "Start angle", .help = "Of an arc, anticlockwise from +x.", .unit = "deg", .when = "kind = arc"});
    d.field("sweep", &CurveParams::sweep,
            {.title = "Sweep angle",
             .help = "Of an arc; negative runs clockwise.",
             .unit = "deg",
             .at_least = -360,
             .at_most = 360,
             .when = "kind = arc"});
    d.choice("turning", &CurveParams::turning, {"anticlockwise", "clockwise"},
             {.title = "Turning", .help = "Of an arc given by its two points.", .when = "kind in arc, circle"});
    d.choice("role", &CurveParams::role, {"boundary", "hole", "internal"},
             {.title = "Role", .help = "Loops inside loops are holes by themselves; role = \"hole\" insists on it."});
    d.field("segments", &CurveParams::segments,
            {.title = "Segments",
             .help = "Number of element sides along the curve; 0 leaves it to the sizes.",
             .at_least = 0,
             .at_most = 1000000});
    d.field("size", &CurveParams::size,
            {.title = "Size",
             .help = "Length of the element sides along the curve; 0 leaves it to the mesh step.",
             .unit = "m",
             .at_least = 0});
    d.field("ratio", &CurveParams::ratio,
            {.title = "Ratio", .help = "Last side to first side, for `segments`.", .above = 0});
    d.field("groups", &CurveParams::groups,
            {.title = "Sets", .help = "Further names that its sides have in conditions and in the mesh."});
  }
};

/// One [[input.crack]].
struct CrackParams {
  std::string name;
  CurveKind kind = CurveKind::Line;
  std::vector<dobra::geom::Point> points;
  std::optional<dobra::geom::Point> centre;
  Turning turning = Turning::Anticlockwise;
  int segments = 0;
  double size = 0.0;
  double tip_size = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field("name", &CrackParams::name,
            {.title = "Name",
             .help = "The lips are the sets NAME_left and NAME_right, the tips NAME_start and NAME_end.",
             .presence = dobra::scenario::Presence::Required});
    d.choice("kind", &CrackParams::kind, {"line", "polygon", "arc", "circle", "spline", "bezier"},
             {.title = "Kind",
              .help = "line: a chain of points; arc: centre and two points; spline: smooth through the points; "
                      "bezier: cubics end to end, by their vertices."});
    d.field("points", &CrackParams::points,
            {.title = "Points",
             .help = "In order from start to end; an end on the boundary or on another crack opens there.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
    d.field("centre", &CrackParams::centre,
            {.title = "Centre", .help = "Of an arc.", .unit = "m", .when = "kind = arc"});
    d.choice("turning", &CrackParams::turning, {"anticlockwise", "clockwise"},
             {.title = "Turning", .help = "Of an arc.", .when = "kind = arc"});
    d.field("segments", &CrackParams::segments,
            {.title = "Segments",
             .help = "Number of element sides along each lip; 0 leaves it to the sizes.",
             .at_least = 0,
             .at_most = 1000000});
    d.field("size", &CrackParams::size,
            {.title = "Size",
             .help = "Length of the element sides along the lips; 0 leaves it to the mesh step.",
             .unit = "m",
             .at_least = 0});
    d.field("tip_size", &CrackParams::tip_size,
            {.title = "Size at the ends",
             .help = "Length of the element sides at both ends, from which they grow; 0: none of their own.",
             .unit = "m",
             .at_least = 0});
  }
};

/// One [[input.region]].
struct RegionParams {
  std::string name;
  dobra::geom::Point point;

  template <class D>
  static void describe(D& d) {
    d.field("name", &RegionParams::name,
            {.title = "Name",
             .help = "Of the material; parts of one name are one region.",
             .presence = dobra::scenario::Presence::Required});
    d.field("point", &RegionParams::point,
            {.title = "Point",
             .help = "Anywhere in the part that is meant.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
  }
};

/// One [[input.point]].
struct PointParams {
  std::string name;
  dobra::geom::Point point;
  double size = 0.0;

  template <class D>
  static void describe(D& d) {
    d.field(
        "name", &PointParams::name,
        {.title = "Name", .help = "Of the set that holds its node.", .presence = dobra::scenario::Presence::Required});
    d.field("point", &PointParams::point,
            {.title = "Point",
             .help = "Inside or on a curve: there is a node.",
             .unit = "m",
             .presence = dobra::scenario::Presence::Required});
    d.field("size", &PointParams::size,
            {.title = "Size", .help = "Of the elements there; 0: no wish.", .unit = "m", .at_least = 0});
  }
};

/// What `file` may be.
std::vector<dobra::scenario::FileKind> input_files();

struct InputParams : sketch::LineInput, surfaces::SurfaceInput {
  sketch::SpecimenKind specimen = sketch::SpecimenKind::None;
  std::optional<double> width, height, radius, crack, position;
  std::optional<dobra::base::Angle> angle;
  std::string file;
  bool solids = false;
  std::vector<std::string> kinds;
  double join_tolerance = domain::DomainOptions{}.join_tolerance;
  Repair repair = Repair::No;
  std::optional<double> gap;
  std::vector<CurveParams> curves;
  std::vector<CrackParams> cracks;
  std::vector<RegionParams> regions;
  std::vector<PointParams> points;

  template <class D>
  static void describe(D& d) {
    d.choice("specimen", &InputParams::specimen, sketch::specimen_names(),
             {.title = "Specimen", .help = "Of the library, with the six sizes below; see docs/user/specimens.md."});
    d.field("width", &InputParams::width,
            {.title = "Width",
             .help = "Of the specimen.",
             .unit = "m",
             .above = 0,
             .when = "specimen in plate_with_hole, quarter_plate, l_shape, cook, compact_tension, single_edge_notch, "
                     "double_edge_notch, three_point_bend, double_cantilever, centre_crack"});
    d.field("height", &InputParams::height,
            {.title = "Height",
             .help = "Of the specimen.",
             .unit = "m",
             .above = 0,
             .when = "specimen in plate_with_hole, quarter_plate, single_edge_notch, double_edge_notch, "
                     "three_point_bend, double_cantilever, centre_crack"});
    d.field("radius", &InputParams::radius,
            {.title = "Radius",
             .help = "Of its hole or disc.",
             .unit = "m",
             .above = 0,
             .when = "specimen in plate_with_hole, quarter_plate, brazilian_disc"});
    d.field("crack_length", &InputParams::crack,
            {.title = "Crack length",
             .help = "As its handbook formula has it: a whole edge crack, half a centre crack.",
             .unit = "m",
             .at_least = 0,
             .when = "specimen in compact_tension, single_edge_notch, double_edge_notch, three_point_bend, "
                     "double_cantilever, centre_crack, pmma_beam, brazilian_disc"});
    d.field("position", &InputParams::position,
            {.title = "Position",
             .help = "Of the notch of pmma_beam, from the middle.",
             .unit = "m",
             .when = "specimen = pmma_beam"});
    d.field("angle", &InputParams::angle,
            {.title = "Crack angle",
             .help = "Of a centre crack, anticlockwise from +x.",
             .unit = "deg",
             .at_least = -180,
             .at_most = 180,
             .when = "specimen in centre_crack, brazilian_disc"});
    d.file("file", &InputParams::file,
           {.title = "File",
            .help = "Geometry as a drawing or as lines, a mesh whose boundary is meant, or faces of a boundary model.",
            .files = input_files()});
    d.field("solids", &InputParams::solids,
            {.title = "Solids",
             .help = "The steps make solids: there is no plane domain before the step `cut` makes one of them."});
    d.field("kind", &InputParams::kinds,
            {.title = "Kinds by names",
             .help = "What curves of the file are, such as 'C*=crack': outline, hole, internal, crack, found (as the "
                     "drawing shows), or none to leave them out; the first that fits a name counts.",
             .when = "file is set"});
    sketch::LineInput::describe_in<InputParams>(d);
    d.field("join_tolerance", &InputParams::join_tolerance,
            {.title = "Join tolerance",
             .help = "Ends of curves nearer than this fraction of the domain's diagonal are one point.",
             .at_least = 0,
             .at_most = 0.01});
    d.choice("repair", &InputParams::repair, {"no", "yes"},
             {.title = "Repair",
              .help = "Mends repeated points, spikes, doubles, gaps, slivers and crossings of boundaries, and lists "
                      "each with its place."});
    d.field(
        "gap", &InputParams::gap,
        {.title = "Widest gap",
         .help =
             "That repair closes between ends of curves; 1/1000 of the drawing's diagonal by default, 1/10 at most.",
         .unit = "m",
         .above = 0,
         .when = "repair = yes"});
    d.tables("curve", &InputParams::curves,
             {.title = "Curves", .help = "The boundary, in any order and direction; internal lines."});
    d.tables("crack", &InputParams::cracks,
             {.title = "Cracks", .help = "Their two lips come apart; they may branch, cross and reach the boundary."});
    d.tables("region", &InputParams::regions,
             {.title = "Regions", .help = "Names of the parts that loops and internal lines enclose."});
    d.tables("point", &InputParams::points, {.title = "Points", .help = "Nodes with a name: supports, loads, gauges."});
    surfaces::SurfaceInput::describe_in<InputParams>(d);
  }
};

/// Whether the file is a boundary model, whose faces are surfaces.
bool is_brep(const std::string& file);

/// Surfaces of an input that read_input() may refuse, untrimmed, with those of their lines that can be drawn, to be
/// looked at alone; nothing: there are none.
std::optional<model::Model> drawn_surfaces(const InputParams& params, const dobra::scenario::Table& table,
                                           const dobra::scenario::Context& context);

/// What is drawn, before anything is made of it.
/// @param table  the table that `params` came from: the places of its curves stand in the errors.
/// @error those of the reader of the file; BadValue for a curve that lacks what its kind needs.
dobra::base::Result<sketch::Sketch> read_drawing(const InputParams& params, const dobra::scenario::Table& table,
                                                 const dobra::scenario::Context& context);

/// @error those of make_domain and of the reader of the file; BadValue for a curve that lacks what its kind needs.
dobra::base::Result<model::Model> read_input(const InputParams& params, const dobra::scenario::Table& table,
                                             const dobra::scenario::Context& context);

}  // namespace quebra::core
