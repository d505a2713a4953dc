#pragma once
// The geometry that a section is restored to, matched to the top by arc length from a pin, and its grid.
// Page: docs/algorithms/unfold.md

#include <optional>
#include <string>
#include <vector>

#include "recon/input/input.h"
#include "recon/maps/map.h"
#include "recon/unfold/grid.h"
#include "shared/scenario/lines/line_keys.h"

namespace recon::unfold {

enum class TargetShape { Flat, Line, Horizon, Regional, Datum };
enum class TargetDirection { LeftToRight, AsGiven };

/// Parameters of the step `target`.
struct TargetParams {
  TargetShape shape = TargetShape::Flat;
  std::optional<double> elevation;
  std::optional<double> pin;
  std::optional<geom::Point> target_pin;
  std::vector<geom::Point> points;
  std::string file;
  std::string feature;
  std::string horizon;
  std::string datum;
  TargetDirection direction = TargetDirection::LeftToRight;
  template <class D>
  static void describe(D& d) {
    d.choice(
        "shape", &TargetParams::shape, {"flat", "line", "horizon", "regional", "datum"},
        {.title = "Shape",
         .help = "flat: a horizontal datum; line: the points or the file; horizon: another horizon's line; regional: "
                 "the straight line that fits a horizon best; datum: one of the section's [[input.datum]]."});
    d.field("elevation", &TargetParams::elevation,
            {.title = "Elevation of the datum",
             .help = "By default that of the top at the pin.",
             .unit = "m",
             .names = "z",
             .when = "shape = flat"});
    d.field("pin", &TargetParams::pin,
            {.title = "x of the pin",
             .help = "Where the top is held; by default the leftmost place where all horizons are.",
             .unit = "m",
             .names = "x"});
    d.field("target_pin", &TargetParams::target_pin,
            {.title = "Pin on the target",
             .help = "The point to which the pin goes; by default the one with the same x.",
             .unit = "m"});
    d.field("points", &TargetParams::points, {.title = "Points of the line", .unit = "m", .when = "shape = line"});
    d.file("file", &TargetParams::file,
           {.title = "File of the line",
            .help = "In any format of lines, like a horizon's.",
            .files = dobra::scenario::lines::file_kinds({dobra::io::formats::Use::ReadLines}),
            .when = "shape = line"});
    d.field("feature", &TargetParams::feature,
            {.title = "Feature",
             .help = "Name of the line in a file that holds several.",
             .when = "shape = line and file is set"});
    d.field("horizon", &TargetParams::horizon,
            {.title = "Horizon of the target",
             .help = "For horizon and regional; regional: by default the top.",
             .names = "horizon",
             .when = "shape in horizon, regional"});
    d.field(
        "datum", &TargetParams::datum,
        {.title = "Datum", .help = "Its name; by default the only one.", .names = "datum", .when = "shape = datum"});
    d.choice("direction", &TargetParams::direction, {"left_to_right", "as_given"},
             {.title = "Direction of the line",
              .help = "as_given: its first point goes with the left end of the top.",
              .when = "shape != flat"});
  }
};

struct Target {
  TargetParams params;      ///< It was made with these.
  geom::Point source_pin;   ///< On the top.
  geom::Point target_pin;   ///< On the target.
  double source_arc = 0.0;  ///< Of the pin on the grid's base, m.
  geom::Polyline line;      ///< The target as given, travelling like the grid's base.
  double target_arc = 0.0;  ///< Of the pin on it, m; may lie beyond its ends.
  maps::ColumnMap map;      ///< Constant thickness, from the section to the target: the columns of both grids.
  Grid grid;                ///< On the target; its base is map.target().base_line().
  double extended = 0.0;    ///< How much of the target was added straight at its ends, m.
  std::vector<std::string> remarks;
};

/// The target and its columns, without curves and rungs.
/// @error as make_target.
base::Result<Target> place_target(const section::Section& section, const SourceGrid& source, const TargetParams& params,
                                  const dobra::scenario::Context& context);

/// @error BadValue (pin beside the top or the target; a target in another unit; parameters that contradict each other),
/// those of read_line and make_grid; BadSection (no such horizon).
base::Result<Target> make_target(const section::Section& section, const SourceGrid& source, const TargetParams& params,
                                 const dobra::scenario::Context& context, const base::Progress& progress);

}  // namespace recon::unfold
