#pragma once
// Maps between the columns of two base lines, each its own law for the depth and for the place along the bed:
//   Thickness  the same column, the same fraction of the offset edge, the same depth. It keeps the length of the top
//              and the depth of every point; det F = (1 - k' d) / (1 - k d), with the curvatures k, k' of the bases.
//   Area       the same column and fraction, and the depth that has as much area above it. It keeps d + c d^2 / 2;
//              c = (widening of the two columns at a rung) / (their length) is linear between the rungs of a column.
//   Slip       flexural slip: the same depth, and the same distance from the pin line along the bed at that depth.
//              It is affine in every column with det F = 1: every bed keeps its length, every unit its area.
//
// Pages: docs/algorithms/unfold.md (Thickness), docs/algorithms/thickness.md (Area) and
// docs/algorithms/flexural_slip.md (Slip). Source of the columns: [carvalho2005offset].

#include <array>
#include <vector>

#include "recon/maps/columns.h"
#include "recon/maps/trace.h"
#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace recon::maps {

enum class ColumnLaw { Thickness, Area, Slip };

struct MapOptions {
  /// How far beyond a rung a point still counts as inside, relative to the base line's box.
  double rung_tolerance = 1e-12;
  double tear_tolerance = 1e-9;   ///< Images farther apart than this are a tear, relative to the base line's box.
  double chord_tolerance = 1e-6;  ///< Straight pieces whose image is curved are halved until the chord is this near,
                                  ///< relative to the base line's box.
  int most_halvings = 12;         ///< But no more often than this.
};

/// Tolerances in metres for a map between things in these boxes.
TraceTolerances tolerances_for(const geom::Box& source, const geom::Box& target, const MapOptions& options);

/// Source and target columns with a law between them. A value, cheap to map with from many threads at once.
class ColumnMap {
 public:
  ColumnMap() = default;
  /// Column i goes to column i.  @pre source.count() == target.count(), law is not Slip.
  ColumnMap(Columns source, Columns target, const MapOptions& options = {}, ColumnLaw law = ColumnLaw::Thickness);
  /// Flexural slip; the columns of the two lines are independent of each other.
  /// @param source_pin  arc length on the source, m; the pin line is the normal there (at a corner its rung).
  static ColumnMap slip(Columns source, double source_pin, Columns target, double target_pin,
                        const MapOptions& options = {});

  [[nodiscard]] const Columns& source() const { return source_; }
  [[nodiscard]] const Columns& target() const { return target_; }
  [[nodiscard]] ColumnLaw law() const { return law_; }
  /// The map back.
  [[nodiscard]] ColumnMap swapped() const;

  /// Slip: the point of the target at a distance along its bed from the pin line, at that depth; and the distances at
  /// which the beds of that depth have their corners. Metres.
  /// @param hint  for points near each other in turn.
  [[nodiscard]] geom::Point target_point(double from_pin, double depth, ColumnId& hint) const;
  [[nodiscard]] std::vector<double> target_corners(double depth) const;
  /// A place on a line that is laid out: at a vertex (part 0), or in the piece behind it, where a corner of the target
  /// bends that.
  struct LaidPoint {
    std::size_t vertex = 0;
    double part = 0.0;
    geom::Point point;
  };
  /// Slip: a line laid out on the target from the pin line on, piece by piece: each keeps its length and changes its
  /// depth as told (by its length at most).
  /// @param arc, names  of its vertices: arc lengths, m, and names with their depths.
  /// @param start   the vertex on the pin line.
  /// @param travel  +1 along the target, vertex by vertex up; -1 against it, down.
  /// @return from `start` on.
  [[nodiscard]] std::vector<LaidPoint> lay(const std::vector<double>& arc, const std::vector<ColumnPoint>& names,
                                           std::size_t start, double travel) const;

  /// The name of a point. O(log n).
  [[nodiscard]] Located locate(geom::Point p) const { return source_.locate(p, tolerances_.side); }
  /// The point of that name on the target.
  [[nodiscard]] geom::Point image(const ColumnPoint& name) const { return carry_name(name); }
  using Hint = Cell;
  /// Where a single point goes. O(log n).  @param hint  the cell of a point near it; becomes that of this one.
  [[nodiscard]] geom::Point map(geom::Point p, Cell& hint) const {
    hint = locate(p, hint).cell;
    return carry(hint, p).image;
  }
  [[nodiscard]] geom::Point map(geom::Point p) const {
    Cell hint;
    return map(p, hint);
  }
  /// Where a line goes.
  [[nodiscard]] MappedLine map(const geom::Polyline& line) const { return trace(*this, line); }

  // What Tracer asks (trace.cpp). Cell: source column; for Slip also the target column.
  using Entered = Cell;
  [[nodiscard]] static Cell enter(Cell cell) { return cell; }
  [[nodiscard]] Spot locate(geom::Point p, Cell hint) const;
  [[nodiscard]] std::array<double, 4> beyond(Cell cell, geom::Point p) const;
  [[nodiscard]] Carried carry(Cell cell, geom::Point p) const;
  [[nodiscard]] bool keeps(const Spot& spot, geom::Point p, const Spot& nearest) const;
  [[nodiscard]] static Hint hint_back(Cell cell) { return cell; }
  [[nodiscard]] geom::Point back(geom::Point image, Cell& hint) const;
  [[nodiscard]] bool is_outer(Cell cell, geom::Point) const { return source_.is_outer(ColumnId(cell.first)); }
  [[nodiscard]] bool bends() const { return law_ != ColumnLaw::Slip; }
  /// det F at a point by the formula of a cell.
  [[nodiscard]] double determinant(Cell cell, geom::Point p) const;
  [[nodiscard]] const TraceTolerances& tolerances() const { return tolerances_; }

 private:
  /// Distance along the bed at a depth, m: arc + lean * depth, 0 at the first rung.
  struct BedLine {
    double arc = 0.0;
    double lean = 0.0;
    [[nodiscard]] double at(double depth) const { return arc + lean * depth; }
  };
  static BedLine pin_line(const Columns& columns, double arc);
  static BedLine rung_line(const Columns& columns, std::size_t rung);
  /// Where point p of a column lies along the bed at its depth, from the first rung, m.
  static double along_bed(const Columns::Frame& frame, geom::Point p, double& depth);
  [[nodiscard]] double target_bed(const Columns::Frame& frame, geom::Point p, double& depth) const;
  /// The column in which the bed at this depth has that place.
  static ColumnId column_at(const Columns& columns, double bed, double depth, ColumnId hint);
  static geom::Point point_on_bed(const Columns::Frame& frame, double bed, double depth);
  [[nodiscard]] geom::Point carry_name(const ColumnPoint& name) const;
  static double area_rate(const std::vector<double>& rates, const ColumnPoint& at);
  static std::vector<double> area_rates(const Columns& columns);

  Columns source_;
  Columns target_;
  ColumnLaw law_ = ColumnLaw::Thickness;
  BedLine source_pin_;  ///< Slip only.
  BedLine target_pin_;
  std::vector<double> source_rates_;  ///< Area only: c at each rung, 1/m.
  std::vector<double> target_rates_;
  TraceTolerances tolerances_;
};

/// Cuts both lines at the union of their corners, matched by arc length from the two pins, and maps one onto the other
/// (Slip: without cuts, the two pins on each other).
/// The target is not stretched: where it is too short it goes on straight, where it is longer it is cut off.
/// @param source      top of the section; its right-hand side of travel is the side of the layers.
/// @param source_pin  arc length of the pin on the source, m.
/// @param target      geometry to restore to; right-hand side likewise.
/// @param target_pin  arc length on the target, m, to which the pin goes (may lie beyond its ends).
/// @error DegenerateCurve where a line turns back on itself, with the place.
base::Result<ColumnMap> match_by_length(const geom::Polyline& source, double source_pin, const geom::Polyline& target,
                                        double target_pin, const MapOptions& options = {},
                                        ColumnLaw law = ColumnLaw::Thickness);

}  // namespace recon::maps
