#pragma once
// The parameters of `offset`: the keys of the step, and the options of the command of both programs.
// Page: docs/user/offset_command.md

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "shared/base/progress.h"
#include "shared/offset/area.h"
#include "shared/offset/offset.h"
#include "shared/scenario/lines/line_keys.h"

namespace dobra::operations {

enum class OffsetSide { Right, Left, Both };
enum class Dissolve { No, Yes };
enum class Closing { AsGiven, Closed };

struct OffsetParams {
  std::string file;
  std::optional<std::string> curve;
  std::optional<double> distance;
  std::optional<int> count;
  std::optional<double> factor;
  std::vector<double> distances;
  std::optional<OffsetSide> side;
  std::optional<offset::Cap> caps;
  std::optional<offset::Keep> pieces;
  bool dissolve = false;
  offset::Join join = offset::Join::Mitre;
  std::optional<offset::Ends> ends;
  std::optional<double> mitre_limit;
  double arc_tolerance = offset::default_arc_tolerance;
  bool untreated = false;
  bool closed = false;
  bool verify = false;
  int stop_after = 0;

  template <class D>
  static void describe(D& d) {
    d.file("file", &OffsetParams::file,
           {.title = "File",
            .help = "Of lines and polygons, in any format; by default those of the model.",
            .files = scenario::lines::file_kinds({io::formats::Use::ReadLines})});
    d.field("curve", &OffsetParams::curve,
            {.title = "Curve", .help = "Only the curve of this name or number; all by default."});
    d.field("distance", &OffsetParams::distance,
            {.title = "First distance",
             .help = "Of the first curve from the base; below 0 polygons shrink.",
             .unit = "m",
             .other_than = 0});
    d.field("count", &OffsetParams::count,
            {.title = "Number of curves", .help = "1 by default.", .at_least = 1, .at_most = 100000});
    d.field("factor", &OffsetParams::factor,
            {.title = "Factor",
             .help = "F of the distances D_k = F D_(k-1) + first distance; 1 (equal gaps) by default.",
             .above = 0});
    d.field("distances", &OffsetParams::distances,
            {.title = "Distances", .help = "From the base, instead of the three above.", .unit = "m", .other_than = 0});
    d.choice("side", &OffsetParams::side, {"right", "left", "both"},
             {.title = "Side", .help = "Of travel: right (default; outside of polygons), left, or both as an area."});
    d.choice("caps", &OffsetParams::caps, {"round", "flat", "square"},
             {.title = "Caps",
              .help = "With both sides, at the ends of lines; round by default.",
              .when = "side = both or dissolve = true"});
    d.choice("pieces", &OffsetParams::pieces, {"longest", "all"},
             {.title = "Pieces",
              .help = "Of an open curve on one side; the longest by default.",
              .when = "side != both and dissolve = false"});
    d.field(
        "dissolve", &OffsetParams::dissolve,
        {.title = "Dissolve", .help = "Joins all areas to one; lines get both sides unless the side says otherwise."});
    d.choice("join", &OffsetParams::join, {"mitre", "bisector", "round", "bevel"},
             {.title = "Corners", .help = "What fills the outer side of a corner."});
    d.choice("ends", &OffsetParams::ends, {"paper", "trimmed", "extended"},
             {.title = "Open ends",
              .help = "trimmed by default: what is nearer than D to any part of the base goes.",
              .when = "side != both and dissolve = false"});
    d.field("mitre_limit", &OffsetParams::mitre_limit,
            {.title = "Mitre limit",
             .help = "Greatest distance of a mitre from its corner, in D; 4 by default.",
             .at_least = 1,
             .when = "join = mitre"});
    d.field("arc_tolerance", &OffsetParams::arc_tolerance,
            {.title = "Arc tolerance",
             .help = "Greatest distance of a chord from its arc, in D.",
             .above = 0,
             .at_most = 0.5});
    d.field("untreated", &OffsetParams::untreated,
            {.title = "Untreated",
             .help = "Raw normals and bisectors: spurious regions stay.",
             .when = "side != both and dissolve = false"});
    d.field("closed", &OffsetParams::closed, {.title = "Closed", .help = "Takes every curve as a closed contour."});
    d.field("verify", &OffsetParams::verify,
            {.title = "Verify", .help = "Judges the curves independently; exit code 1 if anything is wrong."});
    d.field("stop_after", &OffsetParams::stop_after,
            {.title = "Stop after",
             .help = "So many steps of the construction on the subdivision, one raw edge each, for a look at the work; "
                     "0 makes the curves.",
             .at_least = 0});
  }
};

/// What the parameters mean.
struct OffsetPlan {
  std::vector<double> distances;  ///< Below 0: polygons shrink.
  /// Nothing: to the right; with `dissolve` both sides of open lines, and polygons grow.
  std::optional<OffsetSide> side;
  offset::OffsetOptions curves = {};  ///< Of one side; its side is set from `side`.
  offset::Cap cap = offset::Cap::Round;
  double arc_tolerance = offset::default_arc_tolerance;
  Dissolve dissolve = Dissolve::No;
  Closing closing = Closing::AsGiven;
  bool verify = false;
  std::optional<std::string> curve;  ///< Only the base of this name or number.
  std::size_t stop_after = 0;
};

/// Who asks for offset curves: how parameters are called there, who is told of what is left out or mended, progress.
struct OffsetCaller {
  enum class Speaks { Keys, Options };
  Speaks speaks = Speaks::Keys;
  std::function<void(const std::string&)> note = [](const std::string&) {};
  base::Progress progress = {};

  /// "mitre_limit" or "--mitre-limit".
  [[nodiscard]] std::string name(const std::string& key) const;
  /// "side = left" or "--side left".
  [[nodiscard]] std::string set(const std::string& key, const std::string& value) const;
  /// "0.5 m" of a step, which units turn; "0.5" of a command, whose file is in any unit.
  [[nodiscard]] std::string length(double value) const;
  /// BadValue of a key, BadUsage of an option.
  [[nodiscard]] base::Error refuse(std::string message) const;
};

/// @pre the fields were checked.
/// @error those of OffsetCaller::refuse: no distance, or two ways to say them; a parameter that would have no effect.
/// InvalidOption: distances that cannot be.
base::Result<OffsetPlan> offset_plan(const OffsetParams& params, const OffsetCaller& caller);

}  // namespace dobra::operations
