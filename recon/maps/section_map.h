#pragma once
// The map of a section, whatever the method: where any point, line or polygon goes, and where it came from. It is one
// value, built by methods.h. Each mapped point tells whether the map is single-valued there.
// Page: docs/algorithms/unfold.md

#include <array>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "recon/maps/map.h"
#include "recon/maps/ruled_map.h"
#include "recon/maps/shear_map.h"
#include "shared/base/progress.h"

namespace recon::maps {

/// Where a point goes.
struct MappedPoint {
  geom::Point at;
  /// NoColumn: no part of the grid holds the point; it went with the nearest base segment.
  Foot foot = Foot::InColumn;
};

/// Gradient of a map, F = d(image) / d(point), row by row.
struct Gradient {
  double xx = 1.0, xy = 0.0;
  double yx = 0.0, yy = 1.0;
  [[nodiscard]] double determinant() const { return xx * yy - xy * yx; }
};

class SectionMap {
 public:
  SectionMap() = default;
  explicit SectionMap(ColumnMap map) : map_(std::move(map)) {}
  explicit SectionMap(ShearMap map) : map_(std::move(map)) {}
  explicit SectionMap(RuledMap map) : map_(std::move(map)) {}

  /// O(log n) a point; faster for points in the order of a line (spans go in parallel, the same result at any number of
  /// threads).
  [[nodiscard]] MappedPoint forward(geom::Point p) const;
  [[nodiscard]] geom::Point inverse(geom::Point p) const;
  /// @param images one a point. @error Cancelled
  base::Result<void> forward(std::span<const geom::Point> points, std::span<geom::Point> images,
                             const base::Progress& progress = {}) const;
  base::Result<void> inverse(std::span<const geom::Point> points, std::span<geom::Point> images,
                             const base::Progress& progress = {}) const;

  /// A line with its image, exact in every cell (trace.h). A closed one comes back closed, and starts where it did.
  [[nodiscard]] MappedLine forward(const geom::Polyline& line) const;

  /// An open line with a vertex wherever it passes from cell to cell (Traced::Cells).
  [[nodiscard]] MappedLine through_cells(const geom::Polyline& line) const;

  /// The gradient of the formula that holds at p, by central differences (exact to rounding where it is affine).
  [[nodiscard]] Gradient gradient(geom::Point p) const;
  /// The cell that holds a point, or nothing.  @param hint  for points near each other in turn.
  [[nodiscard]] std::optional<Cell> cell_of(geom::Point p, Cell& hint) const;
  /// det F at points by the formula of a cell: exact; not finite where that cell has no area.
  void determinants(Cell cell, std::span<const geom::Point> points, std::span<double> values) const;
  /// Whether det F is 1 everywhere.
  [[nodiscard]] bool keeps_areas() const;
  /// The map back as a map of its own, with the columns of the target as its grid. Of Slip, shear and rulings it is the
  /// inverse; of the other laws too, where the point has one foot on either base.
  [[nodiscard]] SectionMap swapped() const;

  [[nodiscard]] const TraceTolerances& tolerances() const;
  /// nullptr for methods without columns.
  [[nodiscard]] const ColumnMap* columns() const { return std::get_if<ColumnMap>(&map_); }
  /// nullptr for methods without rulings.
  [[nodiscard]] const RuledMap* ruled() const { return std::get_if<RuledMap>(&map_); }

 private:
  std::variant<ColumnMap, ShearMap, RuledMap> map_;
};

}  // namespace recon::maps
