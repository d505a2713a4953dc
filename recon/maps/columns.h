#pragma once
// The columns of a grid: the strip beside a base line, cut by transversals ("rungs") on the bisectors of its corners.
// The name of a point is (column, place along the offset edge at its depth, depth). Restoration keeps that name.
//
//   P = P_i + d b_i + along * (L_i + d (t_i.b_{i+1} - t_i.b_i)) t_i
//   t_i  unit direction of base segment i;  n_i = t_i turned right;  L_i its length
//   b_j  mitre vector of corner j: (n_{j-1} + n_j) / (1 + n_{j-1}.n_j); the normal at the two ends
//   d    depth, m: distance from the line of segment i, positive on the right-hand side of travel
//
// One outer column, without end, lies before the first rung and one after the last.
// Page: docs/algorithms/unfold.md. Source: [carvalho2005offset].

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "shared/base/id.h"
#include "shared/base/result.h"
#include "shared/geom/polyline.h"
#include "shared/geom/segment_tree.h"

namespace recon {
namespace base = dobra::base;
namespace geom = dobra::geom;
}  // namespace recon

namespace recon::maps {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

struct ColumnTag {
  static constexpr const char* prefix = "column";
};
/// 0 is the outer column before the first rung, 1..n the columns of the n base segments, n + 1 the outer one after the
/// last.
using ColumnId = base::Id<ColumnTag>;

struct ColumnPoint {
  ColumnId column;
  double along = 0.0;  ///< Fraction 0..1 of the offset edge at this depth; in an outer column metres from its rung.
  double depth = 0.0;  ///< m, positive on the right-hand side of travel.
};

enum class Foot {
  InColumn,  ///< The point lies in the column of its nearest base segment that can hold it.
  NoColumn,  ///< No column holds it; the nearest base segment was taken.
};

struct Located {
  ColumnPoint at;
  double distance = 0.0;  ///< To the base segment of the column, m.
  Foot foot = Foot::InColumn;
};

class Columns {
 public:
  Columns() = default;

  /// One column for each segment of `line`.
  /// @param line open, n >= 2 points, no two consecutive ones equal.
  /// @error DegenerateCurve where the line turns back on itself (its mitre would be infinite), with the place.
  static base::Result<Columns> along(const geom::Polyline& line);

  /// Columns between the given places of `line`, which may lie beyond its ends (the end segments then go on straight).
  /// Corners of the line that are to bend the columns must be among the places.
  /// @param arcs   m >= 2 increasing distances from the first point of the line, m.
  /// @error as above.
  static base::Result<Columns> between(const geom::Polyline& line, std::span<const double> arcs);

  [[nodiscard]] std::size_t inner_count() const { return frames_.size(); }
  [[nodiscard]] std::size_t count() const { return inner_count() + 2; }
  [[nodiscard]] bool is_outer(ColumnId column) const {
    return column.index() == 0 || column.index() == inner_count() + 1;
  }

  /// The column of the nearest base segment whose column holds p; the first of equally near ones. O(log n).
  /// @param tolerance how far beyond a rung still counts as inside, m.
  /// @param hint      a column near p, such as that of the point before: the same result, sooner.
  [[nodiscard]] Located locate(geom::Point p, double tolerance, ColumnId hint = {}) const;
  /// That column, without the name of the point in it.
  struct Found {
    ColumnId column;
    double distance = 0.0;  ///< To the base segment of the column, m.
    Foot foot = Foot::InColumn;
  };
  [[nodiscard]] Found find(geom::Point p, double tolerance, ColumnId hint = {}) const;

  /// The name of p in the given column, wherever p lies.
  [[nodiscard]] ColumnPoint name_in(ColumnId column, geom::Point p) const;
  /// The point of that name.
  [[nodiscard]] geom::Point point(const ColumnPoint& at) const;

  /// Distance of p beyond the rungs of the column, m: first before the left one, second after the right one; negative
  /// inside, -infinity where an outer column has no rung. Both are linear along any straight line.
  struct Beyond {
    double left;
    double right;
  };
  [[nodiscard]] Beyond beyond(ColumnId column, geom::Point p) const;
  /// Distance of p to the base segment of a column (an outer one: of the end segment), m.
  [[nodiscard]] double distance_to_base(ColumnId column, geom::Point p) const;

  /// The segment a column stands on, its turn, and what sums over the columns before it: all that maps need of it.
  struct Frame {
    geom::Point foot;      ///< Left end of the base segment.
    geom::Vector tangent;  ///< Unit.
    double length = 0.0;   ///< L, m.
    double left = 0.0;     ///< t.b of the left rung: how far it leans along the segment a metre of depth.
    double right = 0.0;    ///< t.b of the right rung.
    double arc = 0.0;      ///< Base length from the first rung to this segment, m.
    double bend = 0.0;     ///< Sum of (right - left) of the columns before: their edges at depth d have arc + d bend.
    /// Change of length of the offset edge a metre of depth.
    [[nodiscard]] double widening() const { return right - left; }
  };
  /// Of an outer column: that of the end segment.
  [[nodiscard]] const Frame& frame(ColumnId column) const { return frames_[frame_of(column)]; }
  /// Depths (least, greatest) between which every offset edge has a length; infinite where nothing limits them.
  struct DepthRange {
    double least;
    double greatest;
  };
  [[nodiscard]] DepthRange open_depths() const { return open_depths_; }

  [[nodiscard]] std::size_t rung_count() const { return feet_.size(); }
  [[nodiscard]] geom::Point foot(std::size_t rung) const { return feet_[rung]; }
  /// Displacement along the rung for one metre of depth.
  [[nodiscard]] geom::Vector rung_vector(std::size_t rung) const { return rungs_[rung]; }
  /// The base line with a vertex at every rung.
  [[nodiscard]] geom::Polyline base_line() const { return {feet_, false}; }

 private:
  static base::Result<Columns> assemble(std::vector<geom::Point> feet, std::vector<geom::Vector> tangents,
                                        std::vector<double> lengths);
  [[nodiscard]] std::size_t frame_of(ColumnId column) const {
    return std::clamp<std::size_t>(column.index(), 1, inner_count()) - 1;
  }
  /// The column of base segment `segment`, or the outer one beside it, that holds p; none if neither does.
  [[nodiscard]] ColumnId holder(std::size_t segment, geom::Point p, double tolerance) const;
  [[nodiscard]] bool holds(ColumnId column, geom::Point p, double tolerance) const;
  [[nodiscard]] bool is_certain(double squared_distance, double depth) const;
  [[nodiscard]] std::size_t halve(geom::Point p) const;
  [[nodiscard]] std::optional<Found> find_from(std::size_t segment, geom::Point p, double tolerance) const;

  std::vector<geom::Point> feet_;    ///< n + 1 feet of rungs on the base line.
  std::vector<geom::Vector> rungs_;  ///< n + 1 mitre vectors.
  std::vector<Frame> frames_;        ///< n, one a base segment.
  DepthRange open_depths_{};
  bool graph_ = false;  ///< Every segment advances in one direction, so that a depth at which no column has closed has
                        ///< but one place along the base.
  geom::SegmentTree tree_;  ///< Of the n base segments.
};

}  // namespace recon::maps
