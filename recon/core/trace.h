#pragma once
// How lines go through a map that is made of cells: columns of a grid, strips of a shear, quadrangles of a ruled band.
// In a cell the map is smooth and has a formula; the walk goes from cell to cell along each straight piece and puts a
// vertex wherever it crosses a side. Every map of sections (map.h, shear_map.h, ruled_map.h) is traced by this one
// walk. Page: docs/algorithms/unfold.md

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "recon/core/columns.h"
#include "shared/geom/polyline.h"

namespace recon::core {

/// Where a map has one formula. What the two numbers count is the map's own affair.
struct Cell {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// The cell of a point.
struct Spot {
  Cell cell;
  double distance = 0.0;  ///< To what the cell stands on (its base segment), m; decides between cells that overlap.
  Foot foot = Foot::InColumn;  ///< NoColumn: no cell holds the point; the nearest one was taken.
};

/// A point in a cell: its name there, and where it goes.
struct Carried {
  ColumnPoint name;
  geom::Point image;
};

struct TraceTolerances {
  double side = 0.0;       ///< How far beyond a side a point still counts as inside, m.
  double tear = 0.0;       ///< Images farther apart than this are a tear, m.
  double chord = 0.0;      ///< Straight pieces whose image is curved are halved until the chord is this near, m ...
  int most_halvings = 12;  ///< ... but no more often than this.
};

/// A place where a line passes from one cell into another that is not its neighbour (it crosses the medial axis of the
/// base), so that its image jumps. Nothing is lost: the image is joined across the jump.
struct Tear {
  std::size_t index = 0;  ///< `before[index]` and `before[index + 1]` are the same point; their images are not.
  geom::Point place;      ///< On the line before.
  double gap = 0.0;       ///< Between the two images, m.
};

/// A line and its image, vertex by vertex.
struct MappedLine {
  geom::Polyline before;           ///< The given line with a vertex wherever it crosses from cell to cell.
  geom::Polyline after;            ///< Its image, the same number of vertices.
  std::vector<ColumnPoint> names;  ///< The same number: column, along, depth.
  std::vector<std::size_t> given;  ///< Where the vertices of the given line stand in `before`.
  std::vector<Tear> tears;
  std::size_t without_column = 0;        ///< Given vertices that no cell holds; mapped by the nearest base segment.
  std::size_t beyond_ends = 0;           ///< Given vertices beyond the ends of the base.
  std::size_t not_reversible = 0;        ///< Given vertices that the map back does not bring home.
  std::optional<geom::Point> beyond_at;  ///< The first of those beyond the ends.
  std::optional<geom::Point> doubtful;   ///< The first place where the map is not single-valued: of a tear, or of a
                                         ///< vertex that no cell holds.
};

/// Walks along a line. Places on a straight piece are u in [0, 1].
///   1. From u, in cell c, find where the piece leaves c: an intersection of straight lines.
///   2. Look which cell holds it a little later. If both give the same image here, the piece goes on there.
///   3. Otherwise it has crossed the medial axis on the way, or does so here: bisect for the last place that c keeps,
///   and
///      emit that place in both cells (a tear).
/// Map: `locate(p, hint)`, `beyond(cell, p)`: metres beyond each side of a cell, linear along straight lines,
/// `carry(cell, p)`, `keeps(cell, p, spot)`, `back(image, hint)`, `is_outer(cell)`, `bends()`, `tolerances()`.
template <class Map>
class Tracer {
 public:
  explicit Tracer(const Map& map) : map_(map), tolerances_(map.tolerances()) {}

  /// @param line n >= 1 points.
  MappedLine run(const geom::Polyline& line) {
    const std::size_t count = line.points.size();
    result_.before.points.reserve(2 * count);
    result_.after.points.reserve(2 * count);
    result_.names.reserve(2 * count);
    result_.given.reserve(count);
    spot_ = map_.locate(line.points.front(), {});
    back_hint_ = spot_.cell;
    given(line.points.front());
    for (std::size_t i = 1; i < count; ++i) piece(line.points[i - 1], line.points[i]);
    return std::move(result_);
  }

 private:
  /// Steps smaller than this part of a piece are not resolved.
  static constexpr double smallest_step = 1e-9;

  void doubt(geom::Point p) {
    if (!result_.doubtful) result_.doubtful = p;
  }

  /// A vertex of the given line, in the cell of `spot_`.
  void given(geom::Point p) {
    const Carried carried = map_.carry(spot_.cell, p);
    emit(p, carried);
    result_.given.push_back(result_.before.points.size() - 1);
    if (spot_.foot == Foot::NoColumn) {
      ++result_.without_column;
      doubt(p);
    }
    if (map_.is_outer(spot_.cell)) {
      ++result_.beyond_ends;
      if (!result_.beyond_at) result_.beyond_at = p;
    }
    if (geom::distance(map_.back(carried.image, back_hint_), p) > tolerances_.tear) ++result_.not_reversible;
  }

  void emit(geom::Point p, const Carried& carried) {
    result_.before.points.push_back(p);
    result_.after.points.push_back(carried.image);
    result_.names.push_back(carried.name);
  }

  /// What a curved image between the last vertex and p (still to be emitted) needs.
  void bend_to(geom::Point p, const Carried& carried, Cell cell) {
    if (!map_.bends()) return;
    refine(result_.before.points.back(), result_.after.points.back(), p, carried.image, cell,
           tolerances_.most_halvings);
  }

  void refine(geom::Point from, geom::Point from_image, geom::Point to, geom::Point to_image, Cell cell, int halvings) {
    if (halvings == 0) return;
    const geom::Point middle = geom::midpoint(from, to);
    const Carried carried = map_.carry(cell, middle);
    if (geom::distance(geom::Segment{from_image, to_image}, carried.image) <= tolerances_.chord) return;
    refine(from, from_image, middle, carried.image, cell, halvings - 1);
    emit(middle, carried);
    refine(middle, carried.image, to, to_image, cell, halvings - 1);
  }

  /// Where, not before `from`, the piece leaves the cell; 1 if it does not.
  [[nodiscard]] double exit_after(double from, geom::Point a, geom::Point b) const {
    const auto at_a = map_.beyond(spot_.cell, a);
    const auto at_b = map_.beyond(spot_.cell, b);
    double out = 1.0;
    for (std::size_t side = 0; side < at_a.size(); ++side) {
      const double start = at_a[side];
      const double end = at_b[side];
      if (end > tolerances_.side && end > start) out = std::min(out, -start / (end - start));
    }
    return std::clamp(out, from, 1.0);
  }

  /// The last place in [from, to] that the cell keeps, to rounding.
  [[nodiscard]] double bisect(double from, double to, geom::Point a, geom::Point b) const {
    for (int i = 0; i < 60 && to - from > 1e-16; ++i) {
      const double middle = 0.5 * (from + to);
      const geom::Point p = geom::interpolate(a, b, middle);
      (map_.keeps(spot_, p, map_.locate(p, spot_.cell)) ? from : to) = middle;
    }
    return from;
  }

  /// The cell of the place a little after u.
  [[nodiscard]] Spot later_than(double u, double step, geom::Point a, geom::Point b) const {
    const double later = std::min(1.0, u + step);
    return map_.locate(later == 1.0 ? b : geom::interpolate(a, b, later), spot_.cell);
  }

  /// Goes to p, the place u, and there from `spot_` into the cell `next`.
  void cross(double u, geom::Point p, const Spot& next) {
    const Carried old = map_.carry(spot_.cell, p);
    const Carried now = map_.carry(next.cell, p);
    const double gap = geom::distance(old.image, now.image);
    if (u > smallest_step) {
      bend_to(p, old, spot_.cell);
      emit(p, old);
    }
    if (gap > tolerances_.tear) {
      if (u <= smallest_step) emit(p, old);
      result_.tears.push_back({result_.before.points.size() - 1, p, gap});
      doubt(p);
      emit(p, now);
    }
    spot_ = next;
  }

  void piece(geom::Point a, geom::Point b) {
    const Spot at_end = map_.locate(b, spot_.cell);
    double step = smallest_step;  // how far ahead the next cell is looked up
    double u = 0.0;
    while (true) {
      double out = exit_after(u, a, b);
      Spot next = at_end;
      if (out == 1.0) {
        if (next.cell == spot_.cell || map_.keeps(spot_, b, next)) break;
        out = bisect(u, 1.0, a, b);
        next = later_than(out, step, a, b);
      } else {
        next = later_than(out, step, a, b);
        if (next.cell == spot_.cell) {  // along a side, within rounding: look farther ahead, so that this ends
          if (out + step >= 1.0) break;
          u = out;
          step *= 2.0;
          continue;
        }
        const geom::Point p = geom::interpolate(a, b, out);
        const bool joined =
            geom::distance(map_.carry(spot_.cell, p).image, map_.carry(next.cell, p).image) <= tolerances_.tear;
        if (!joined && !map_.keeps(spot_, p, map_.locate(p, spot_.cell))) {
          out = bisect(u, out, a, b);
          next = later_than(out, step, a, b);
        }
      }
      // Cells that change at once, again and again, are rounding along a side.
      const bool stuck = out <= u + smallest_step || next.cell == spot_.cell;
      cross(out, geom::interpolate(a, b, out), next);
      if (out + step >= 1.0) break;
      u = out;
      step = stuck ? 2.0 * step : smallest_step;
    }
    const Carried end = map_.carry(spot_.cell, b);
    bend_to(b, end, spot_.cell);
    if (!(at_end.cell == spot_.cell)) {
      const double gap = geom::distance(end.image, map_.carry(at_end.cell, b).image);
      if (gap > tolerances_.tear) {
        emit(b, end);
        result_.tears.push_back({result_.before.points.size() - 1, b, gap});
        doubt(b);
      }
    }
    spot_ = at_end;
    given(b);
  }

  const Map& map_;
  TraceTolerances tolerances_;
  MappedLine result_;
  Spot spot_;       ///< Where the walk is.
  Cell back_hint_;  ///< For the map back.
};

}  // namespace recon::core
