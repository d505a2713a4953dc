#pragma once
// The [input] of a QUEBRA scenario: curves written in the document, or a .poly file.

#include <optional>
#include <string>
#include <vector>

#include "quebra/core/model.h"
#include "shared/base/progress.h"
#include "shared/scenario/program.h"

namespace quebra::core {

enum class CurveKind { Line, Polygon, Arc, Circle };
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
  Role role = Role::Boundary;
  int segments = 0;
  double size = 0.0;
  double ratio = 1.0;

  template <class D>
  static void describe(D& d) {
    d.field("name", &CurveParams::name, {.title = "Name", .help = "Sets of the mesh take it.",
                                         .presence = dobra::scenario::Presence::Required});
    d.choice("kind", &CurveParams::kind, {"line", "polygon", "arc", "circle"},
             {.title = "Kind", .help = "line: a chain of points; polygon: closed; arc: centre and two points, or centre, radius, start, sweep; circle: centre and radius."});
    d.field("points", &CurveParams::points, {.title = "Points", .help = "Vertices of a line or polygon; first and last point of an arc.", .unit = "m"});
    d.field("centre", &CurveParams::centre, {.title = "Centre", .help = "Of an arc or circle.", .unit = "m"});
    d.field("radius", &CurveParams::radius, {.title = "Radius", .help = "Of a circle, or of an arc given by angles.", .unit = "m", .above = 0});
    d.field("start", &CurveParams::start, {.title = "Start angle", .help = "Of an arc, anticlockwise from +x.", .unit = "deg"});
    d.field("sweep", &CurveParams::sweep, {.title = "Sweep angle", .help = "Of an arc; negative runs clockwise.", .unit = "deg", .at_least = -360, .at_most = 360});
    d.choice("turning", &CurveParams::turning, {"anticlockwise", "clockwise"}, {.title = "Turning", .help = "Of an arc given by its two points."});
    d.choice("role", &CurveParams::role, {"boundary", "hole", "internal"},
             {.title = "Role", .help = "Loops inside loops are holes by themselves; role = \"hole\" insists on it."});
    d.field("segments", &CurveParams::segments, {.title = "Segments", .help = "Number of element sides along the curve; 0 leaves it to the sizes.", .at_least = 0, .at_most = 1000000});
    d.field("size", &CurveParams::size, {.title = "Size", .help = "Length of the element sides along the curve; 0 leaves it to the mesh step.", .unit = "m", .at_least = 0});
    d.field("ratio", &CurveParams::ratio, {.title = "Ratio", .help = "Last side to first side, for `segments`.", .above = 0});
  }
};

struct InputParams {
  std::string file;
  double join_tolerance = 1e-9;
  std::vector<CurveParams> curves;

  template <class D>
  static void describe(D& d) {
    d.file("file", &InputParams::file, {.title = "File", .help = "A .poly file of Triangle with the boundary, in place of curves or beside them."});
    d.field("join_tolerance", &InputParams::join_tolerance,
            {.title = "Join tolerance", .help = "Ends of curves nearer than this fraction of the domain's diagonal are one point.", .at_least = 0, .at_most = 0.01});
    d.tables("curve", &InputParams::curves, {.title = "Curves", .help = "The boundary, in any order and direction; internal lines."});
  }
};

/// @param table  the table that `params` came from: the places of its curves stand in the errors.
/// @error those of make_domain and of the reader of the file; BadValue for a curve that lacks what its kind needs.
dobra::base::Result<Model> read_input(const InputParams& params, const dobra::scenario::Table& table,
                                      const dobra::scenario::Context& context);

}  // namespace quebra::core
