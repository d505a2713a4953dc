#pragma once
// The line that holds beds together: the normal of the top at the pin; at a corner of the top its rung.
// Page: docs/algorithms/flexural_slip.md

#include <numbers>
#include <optional>
#include <vector>

#include "recon/maps/columns.h"
#include "recon/section/section.h"
#include "shared/geom/polyline.h"

namespace recon::unfold {

struct SourceGrid;

class PinLine {
 public:
  /// @param arc  of the pin on the line of `top`, m.  @pre `top` outlives this.
  PinLine(const maps::Columns& top, double arc);

  /// Where along `line`, which travels like the top, it passes from before the pin line to behind it, m; of several
  /// places the one nearest to the pin. Ends that lie on the pin line count, and places do not that some other part of
  /// the top is far nearer to: there the pin line has left the bed that it pins.
  [[nodiscard]] std::optional<double> meets(const geom::Polyline& line, const std::vector<double>& arc) const;
  /// Depth of a point of the pin line below the top, m.
  [[nodiscard]] double depth(geom::Point p) const;
  [[nodiscard]] geom::Point at() const { return at_; }
  [[nodiscard]] double tolerance() const { return tolerance_; }

 private:
  const maps::Columns* top_;
  geom::Point at_;
  geom::Vector down_;       ///< Along the pin line for one metre of depth.
  double tolerance_ = 0.0;  ///< m
};

/// Where a point stands on the line of `top`: the arc length of the foot of its normal; beyond an end of the line so
/// many metres beyond. Beside a corner it stands on the corner.
double place_on(const maps::Columns& top, const maps::Located& located, geom::Point p);
/// By how much the top at a pin dips off what it does on both sides, over a twentieth of its length each, radians >= 0:
/// a slip of the pen, or a loop cut out, tilts what the pin line holds by that. 0 where the dip there lies between
/// those of both sides, as in a fold. @param arcs  of the line's points, m.
double askew_at(const geom::Polyline& top, const std::vector<double>& arcs, double arc);
/// A pin that is more askew than this is told, and not taken by itself; radians.
inline constexpr double askew_tolerance = 5.0 * std::numbers::pi / 180.0;
/// Lengths below this part of a section's size are rounding.
inline constexpr double bed_tolerance = 1e-11;

/// The pin that is taken where none is given: the leftmost place of the top whose pin line meets all horizons; where
/// there is none, one that meets most of them.
struct DefaultPin {
  double arc = 0.0;  ///< On the grid's base, m.
  std::vector<section::HorizonId>
      off;  ///< Horizons (of those in pieces the first piece) that its pin line does not meet.
};
/// @error those of Columns::along.
base::Result<DefaultPin> default_pin(const section::Section& section, const SourceGrid& source);

}  // namespace recon::unfold
