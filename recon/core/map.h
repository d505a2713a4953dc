#pragma once
// The map of constant-thickness restoration: the columns of the source grid onto those of the target grid, column by
// column. It keeps the arc length of the base line and the depth of every point, and swapped it is its own inverse. It
// does not keep area nor the length of deeper beds: det F = (1 - k' d) / (1 - k d) with the curvatures k, k' of the two
// bases. Method: requirements C.3 (E-10, E-11, E-12), restoration.md 2.2.  Page: docs/algorithms/unfold.md

#include <vector>

#include "recon/core/columns.h"
#include "shared/base/result.h"
#include "shared/geom/polyline.h"

namespace recon::core {

struct MapOptions {
  double rung_tolerance =
      1e-12;  ///< How far beyond a rung a point still counts as inside, relative to the base line's box.
  double tear_tolerance = 1e-9;   ///< Images farther apart than this are a tear, relative to the base line's box.
  double chord_tolerance = 1e-6;  ///< Straight pieces whose image is curved are halved until the chord is this near,
                                  ///< relative to the base line's box.
  int most_halvings = 12;  ///< But no more often than this.
};

/// A place where a line passes from one column into another that is not its neighbour: it crosses the medial axis of
/// the base, and its image jumps. Nothing is lost: the image is joined across the jump.
struct Tear {
  std::size_t index = 0;  ///< `before[index]` and `before[index + 1]` are the same point; their images are not.
  geom::Point place;      ///< On the line before.
  double gap = 0.0;       ///< Between the two images, m.
};

/// A line and its image, vertex by vertex.
struct MappedLine {
  geom::Polyline before;           ///< The given line with a vertex wherever it crosses a rung.
  geom::Polyline after;            ///< Its image, the same number of vertices.
  std::vector<ColumnPoint> names;  ///< The same number: column, along, depth.
  std::vector<std::size_t> given;  ///< Where the vertices of the given line stand in `before`.
  std::vector<Tear> tears;
  std::size_t without_column = 0;  ///< Given vertices that no column holds; mapped by the nearest base segment.
  std::size_t beyond_ends = 0;     ///< Given vertices in an outer column.
  std::size_t not_reversible = 0;  ///< Given vertices whose image belongs to another column of the target.
};

/// Source and target columns; column i goes to column i.
class ColumnMap {
 public:
  ColumnMap() = default;
  /// @pre source.count() == target.count().
  ColumnMap(Columns source, Columns target, const MapOptions& options = {});

  [[nodiscard]] const Columns& source() const { return source_; }
  [[nodiscard]] const Columns& target() const { return target_; }
  /// The map back.
  [[nodiscard]] ColumnMap swapped() const { return {target_, source_, options_}; }

  /// The name of a point. O(log n).
  [[nodiscard]] Located locate(geom::Point p) const { return source_.locate(p, rung_tolerance_); }
  /// The point of that name on the target.
  [[nodiscard]] geom::Point image(const ColumnPoint& name) const { return target_.point(name); }
  /// Where a single point goes. O(log n).
  [[nodiscard]] geom::Point map(geom::Point p) const { return image(locate(p).at); }

  /// Where a line goes, exact up to the chord tolerance. O((n + x) log m) for n vertices, x rung crossings, m columns.
  /// @param line open, n >= 1 points.
  [[nodiscard]] MappedLine map(const geom::Polyline& line) const;

 private:
  class Tracer;

  Columns source_;
  Columns target_;
  MapOptions options_;
  double rung_tolerance_ = 0.0;  ///< m
  double tear_tolerance_ = 0.0;
  double chord_tolerance_ = 0.0;
};

/// Cuts both lines at the union of their corners, matched by arc length from the two pins, and maps one onto the other.
/// The target is not stretched: where it is too short it goes on straight, where it is longer it is cut off.
/// @param source      top of the section; its right-hand side of travel is the side of the layers.
/// @param source_pin  arc length of the pin on the source, m.
/// @param target      geometry to restore to; right-hand side likewise.
/// @param target_pin  arc length on the target, m, to which the pin goes (may lie beyond its ends).
/// @error DegenerateCurve where a line turns back on itself, with the place.
base::Result<ColumnMap> match_by_length(const geom::Polyline& source, double source_pin, const geom::Polyline& target,
                                        double target_pin, const MapOptions& options = {});

}  // namespace recon::core
