#pragma once
// What the sub-command `offset` computes: the lines and polygons of a file as bases, and the curves or areas of each.

#include "shared/cli/offset_report.h"
#include "shared/cli/session.h"
#include "shared/offset/area.h"

namespace dobra::cli {

enum class OffsetSide { Right, Left, Both };
enum class Dissolve { No, Yes };
enum class Closing { AsGiven, Closed };

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
};

/// Some open lines, or polygons, or both (parts of one feature).
struct OffsetBase {
  std::string name;
  io::lines::Feature source;  ///< Its name, kind, id and properties; no parts.
  std::vector<geom::Polyline> lines = {};
  std::vector<std::vector<geom::Polyline>> polygons = {};  ///< Each a contour anticlockwise and its holes clockwise.
};

struct OffsetInput {
  std::vector<OffsetBase> bases;
  OffsetOrigin origin = {};
  std::size_t mended = 0;  ///< Polygons that cross or touch themselves, and are taken as others.
};

/// The bases of a file, as the plan wants them: each line that goes to one side is a base of its own. What is left out
/// or mended is told. @error those of io::formats::read_any_lines; BadUsage: there is no such curve.
base::Result<OffsetInput> offset_input(Session& session, const std::string& file, const OffsetPlan& plan);

/// Where there are polygons, open lines are left out at distances below 0, and this is told.
/// @param verdict  of the verifier, if the plan wants it.
/// @error BadUsage (a distance below 0 and no polygon); those of offset::offset with the base.
base::Result<std::vector<OffsetFamily>> offset_families(Session& session, const std::string& file,
                                                        const OffsetInput& input, const OffsetPlan& plan,
                                                        OffsetVerdict& verdict);

}  // namespace dobra::cli
