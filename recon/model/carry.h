#pragma once
// Points, lines and polygons carried along the chain of a model, from any of its states to any other, forward or back.
// State 0 is the input; state k is the section after k restorations and moves. Page: docs/algorithms/chain.md

#include <optional>
#include <string>
#include <vector>

#include "recon/model/stage.h"
#include "shared/scenario/lines/line_keys.h"
#include "shared/scenario/program.h"

namespace recon::model {

/// What the points of a step are.
enum class CarryAs { Line, Points };

/// Parameters of the step `carry`.
struct CarryParams {
  std::string file;
  std::string feature;
  std::vector<geom::Point> points;
  CarryAs as = CarryAs::Line;
  int from = 0;
  std::optional<int> to;
  template <class D>
  static void describe(D& d) {
    d.file("file", &CarryParams::file,
           {.title = "File of the line",
            .help = "In any format of lines, like a horizon's.",
            .files = dobra::scenario::lines::file_kinds({dobra::io::formats::Use::ReadLines})});
    d.field("feature", &CarryParams::feature,
            {.title = "Feature", .help = "Name of the line in a file that holds several.", .when = "file is set"});
    d.field("points", &CarryParams::points,
            {.title = "Points",
             .help = "Instead of a file: one point, a line, or a polygon whose last point repeats the first.",
             .unit = "m"});
    d.choice(
        "as", &CarryParams::as, {"line", "points"},
        {.title = "Taken as", .help = "line: joined in their order; points: each by itself.", .when = "points is set"});
    d.field("from", &CarryParams::from,
            {.title = "From state",
             .help = "0 is the input, k the section after k restorations and moves.",
             .at_least = 0});
    d.field("to", &CarryParams::to, {.title = "To state", .help = "By default the last.", .at_least = 0});
  }
};

/// Where a point of one state lies in another.
struct CarriedPoint {
  geom::Point at;
  /// How far the way back misses where it came from, m: nothing where every map on the way is single-valued there.
  double misses = 0.0;
};

/// A line, polygon or point with its image. Metres.
struct CarriedLine {
  geom::Polyline before;
  std::vector<CarriedPoint> points;  ///< One for each vertex of `before`.
  geom::Polyline after;              ///< With the vertices that cells of the maps add.
};

struct CarriedLines {
  std::size_t from = 0;
  std::size_t to = 0;
  std::vector<CarriedLine> lines;
  std::vector<std::string> remarks;
};

/// @param chain  stages that are done, in order.  @param from, to  states, 0 to chain.size().
/// @cost  O(log n) a stage for a point.
CarriedPoint carry(const std::vector<const Stage*>& chain, std::size_t from, std::size_t to, geom::Point p);
/// @param line  open or closed, n >= 1 points.  @return its image, closed if it was, with the vertices of the cells.
geom::Polyline carry(const std::vector<const Stage*>& chain, std::size_t from, std::size_t to, geom::Polyline line);

/// The lines of the parameters. Vertices of which the way back misses by more than 1e-9 of the section get a remark.
/// @error MissingKey (neither file nor points, or both), BadValue (a state that the chain has not), those of
/// read_pieces.
base::Result<CarriedLines> carry_lines(const std::vector<const Stage*>& chain, const CarryParams& params,
                                       const dobra::scenario::Context& context);

}  // namespace recon::model
