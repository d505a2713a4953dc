#pragma once
// Simple shear along one direction, vertical or inclined: every point slides along it by as much as the top does there.
//   q  = x cos a - z sin a      w  = x sin a + z cos a      a: from the vertical to the direction, towards +x upwards
//   q' = q + travel             w' = w + w_target(q + travel) - w_top(q)
// The map is affine in the strips between the corners of both lines, with det F = 1. It keeps areas, and thickness
// along the direction; it does not keep bed lengths. Page: docs/algorithms/shear.md

#include <array>
#include <vector>

#include "recon/maps/map.h"
#include "recon/maps/trace.h"
#include "shared/base/angle.h"
#include "shared/base/result.h"

namespace recon::maps {

class ShearMap {
 public:
  ShearMap() = default;

  /// @param top     open line; its ends go on straight. @param target likewise.
  /// @param angle   of the direction of shear from the vertical, within (-90, 90) degrees.
  /// @param from, to  two points; the section moves across the direction of shear by as much as `to` lies beside
  /// `from`.
  /// @param what  the word for the top in messages.
  /// @error CannotRestore with the place where a line turns against the direction, so that it is passed more than once
  ///        along it, and the angles at which it does not.
  static base::Result<ShearMap> make(const geom::Polyline& top, const geom::Polyline& target, base::Angle angle,
                                     geom::Point from = {}, geom::Point to = {}, const MapOptions& options = {},
                                     const char* what = "top");

  [[nodiscard]] ShearMap swapped() const;
  /// The map on the way: `part` (0 .. 1) of every displacement.
  [[nodiscard]] ShearMap part(double part) const;
  using Hint = Cell;
  /// Where a single point goes.  @param hint  the cell of a point near it; becomes that of this one.
  [[nodiscard]] geom::Point map(geom::Point p, Cell& hint) const {
    hint = locate(p, hint).cell;
    return carry(hint, p).image;
  }

  // What Tracer asks (trace.cpp). Cell: strip 0 .. n + 1 between the n + 1 corners of both lines.
  using Entered = Cell;
  [[nodiscard]] static Cell enter(Cell cell) { return cell; }
  [[nodiscard]] Spot locate(geom::Point p, Cell hint) const;
  [[nodiscard]] std::array<double, 2> beyond(Cell cell, geom::Point p) const;
  [[nodiscard]] Carried carry(Cell cell, geom::Point p) const;
  [[nodiscard]] static bool keeps(const Spot&, geom::Point, const Spot&) { return true; }
  [[nodiscard]] static Hint hint_back(Cell cell) { return cell; }
  [[nodiscard]] geom::Point back(geom::Point image, Cell& hint) const;
  [[nodiscard]] bool is_outer(Cell cell, geom::Point p) const;
  [[nodiscard]] static bool bends() { return false; }
  /// det F at a point by the formula of a cell.
  [[nodiscard]] static double determinant(Cell, geom::Point) { return 1.0; }
  [[nodiscard]] const TraceTolerances& tolerances() const { return tolerances_; }

 private:
  struct Strip {
    double begin = 0.0;      ///< q of its left side; of strip 0 that of its right side.
    double top = 0.0;        ///< w of the top there.
    double top_slope = 0.0;  ///< dw/dq
    double goal = 0.0;       ///< w of the target there.
    double goal_slope = 0.0;
  };
  [[nodiscard]] double q_of(geom::Point p) const { return cosine_ * p.x - sine_ * p.y; }
  [[nodiscard]] geom::Point shifted(geom::Point p, double along, double across) const {
    return {p.x + along * sine_ + across * cosine_, p.y + along * cosine_ - across * sine_};
  }

  double cosine_ = 1.0;
  double sine_ = 0.0;
  std::vector<Strip> strips_;  ///< Strip 0 lies before the first corner.
  double first_ = 0.0;         ///< q of the two ends of the top.
  double last_ = 0.0;
  double travel_ = 0.0;
  TraceTolerances tolerances_;
};

}  // namespace recon::maps
