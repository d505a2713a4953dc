#include "recon/maps/trace.h"

#include <algorithm>
#include <array>
#include <limits>

#include "recon/maps/map.h"
#include "recon/maps/ruled_map.h"
#include "recon/maps/shear_map.h"

namespace recon::maps {

namespace {

/// Walks along a line. Places on a straight piece are u in [0, 1].
///   1. From u, in cell c, find where the piece leaves c: an intersection of straight lines.
///   2. Look which cell holds it a little later. If both give the same image here, the piece goes on there.
///   3. Otherwise it has crossed the medial axis on the way, or does so here: bisect for the last place that c keeps,
///   and
///      emit that place in both cells (a tear).
/// Map: `locate(p, hint)`, `enter(cell)`: what the map needs to know of the cell for the next two, `beyond(entered,
/// p)`: metres beyond each side of a cell, linear along straight lines, `carry(entered, p)`, `keeps(spot, p, nearest)`,
/// `back(image, hint)`, `hint_back(cell)`, `is_outer(cell, p)`, `bends()`, `tolerances()`. Where `beyond` is dear:
/// `sides`, and `beyond(entered, side, p)` of one. `first_holds`: see look_ahead.
template <class Map>
class Tracer {
 public:
  explicit Tracer(const Map& map, Traced wanted = Traced::Everything)
      : map_(map), wanted_(wanted), tolerances_(map.tolerances()) {}

  /// @param line n >= 1 points.
  MappedLine run(const geom::Polyline& line) {
    const std::size_t count = line.points.size();
    result_.before.points.reserve(2 * count + 2);
    result_.after.points.reserve(2 * count + 2);
    result_.names.reserve(2 * count + 2);
    result_.given.reserve(count);
    spot_ = map_.locate(line.points.front(), {});
    cell_ = map_.enter(spot_.cell);
    back_hint_ = map_.hint_back(spot_.cell);
    given(line.points.front(), map_.carry(cell_, line.points.front()));
    for (std::size_t i = 1; i < count; ++i) piece(line.points[i - 1], line.points[i]);
    return std::move(result_);
  }

 private:
  using Entered = typename Map::Entered;

  /// Steps smaller than this part of a piece are not resolved.
  static constexpr double smallest_step = 1e-9;

  static bool apart(geom::Point a, geom::Point b, double tolerance) {
    return geom::length_squared(b - a) > tolerance * tolerance;
  }

  void doubt(geom::Point p) {
    if (!result_.doubtful) result_.doubtful = p;
  }

  /// A vertex of the given line, in the cell of `spot_`.
  void given(geom::Point p, const Carried& carried) {
    emit(p, carried);
    result_.given.push_back(result_.before.points.size() - 1);
    if (spot_.foot == Foot::NoColumn) {
      ++result_.without_column;
      doubt(p);
    }
    if (map_.is_outer(spot_.cell, p)) {
      ++result_.beyond_ends;
      if (!result_.beyond_at) result_.beyond_at = p;
    }
    if (wanted_ == Traced::Everything && apart(map_.back(carried.image, back_hint_), p, tolerances_.tear))
      ++result_.not_reversible;
  }

  void emit(geom::Point p, const Carried& carried) {
    result_.before.points.push_back(p);
    result_.after.points.push_back(carried.image);
    result_.names.push_back(carried.name);
  }

  void tear(geom::Point p, const Carried& old, const Carried& now) {
    emit(p, old);
    result_.tears.push_back({result_.before.points.size() - 1, p, geom::distance(old.image, now.image)});
    doubt(p);
  }

  /// What a curved image between the last vertex and p (still to be emitted) needs.
  void bend_to(geom::Point p, const Carried& carried) {
    if (wanted_ == Traced::Cells || !map_.bends()) return;
    refine(result_.before.points.back(), result_.after.points.back(), p, carried.image, tolerances_.most_halvings);
  }

  void refine(geom::Point from, geom::Point from_image, geom::Point to, geom::Point to_image, int halvings) {
    if (halvings == 0) return;
    const geom::Point middle = geom::midpoint(from, to);
    const Carried carried = map_.carry(cell_, middle);
    const geom::Segment chord{from_image, to_image};
    const geom::Point on_chord = geom::interpolate(from_image, to_image, geom::nearest_fraction(chord, carried.image));
    if (!apart(on_chord, carried.image, tolerances_.chord)) return;
    refine(from, from_image, middle, carried.image, halvings - 1);
    emit(middle, carried);
    refine(middle, carried.image, to, to_image, halvings - 1);
  }

  /// Where, not before `from`, the piece leaves the cell; 1 if it does not.
  [[nodiscard]] double exit_after(double from, geom::Point a, geom::Point b) const {
    double out = 1.0;
    if constexpr (requires { Map::sides; }) {  // most sides are not passed: no need to know how far a is from them
      for (std::size_t side = 0; side < Map::sides; ++side) {
        const double end = map_.beyond(cell_, side, b);
        if (!(end > tolerances_.side)) continue;
        const double start = map_.beyond(cell_, side, a);
        if (end > start) out = std::min(out, -start / (end - start));
      }
    } else {
      const auto at_a = map_.beyond(cell_, a);
      const auto at_b = map_.beyond(cell_, b);
      for (std::size_t side = 0; side < at_a.size(); ++side) {
        const double start = at_a[side];
        const double end = at_b[side];
        if (end > tolerances_.side && end > start) out = std::min(out, -start / (end - start));
      }
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

  /// Where cells before a side hold what lies beside it within the tolerance, the next one is found beyond that.
  [[nodiscard]] double look_ahead(geom::Point a, geom::Point b) const {
    double step = smallest_step;
    if constexpr (requires { Map::first_holds; }) {
      const double length = geom::distance(a, b);
      while (step < 1.0 && step * length <= tolerances_.side) step *= 2.0;
    }
    return step;
  }

  /// The cell of the place a little after u.
  [[nodiscard]] Spot later_than(double u, double step, geom::Point a, geom::Point b, const Spot& at_end) const {
    const double later = u + step;
    return later >= 1.0 ? at_end : map_.locate(geom::interpolate(a, b, later), spot_.cell);
  }

  /// Goes to p, the place u, and there from `spot_` into the cell `next`.
  void cross(double u, geom::Point p, const Carried& old, const Carried& now, const Spot& next,
             const Entered& next_cell) {
    const bool torn = apart(old.image, now.image, tolerances_.tear);
    if (u > smallest_step) bend_to(p, old);
    if (torn) {
      tear(p, old, now);
      emit(p, now);
    } else if (u > smallest_step) {
      emit(p, old);
    }
    spot_ = next;
    cell_ = next_cell;
  }

  void piece(geom::Point a, geom::Point b) {
    const Spot at_end = map_.locate(b, spot_.cell);
    const double first_step = look_ahead(a, b);
    double step = first_step;  // how far ahead the next cell is looked up
    double u = 0.0;
    while (true) {
      double out = exit_after(u, a, b);
      geom::Point p = b;
      Spot next = at_end;
      Entered next_cell = cell_;
      Carried old;
      Carried now;
      const auto carry_at = [&](double place) {
        p = geom::interpolate(a, b, place);
        next_cell = map_.enter(next.cell);
        old = map_.carry(cell_, p);
        now = map_.carry(next_cell, p);
      };
      bool missed = false;  // the medial axis is crossed before `out`
      if (out == 1.0) {
        if (next.cell == spot_.cell || map_.keeps(spot_, b, next)) break;
        missed = true;
      } else {
        next = later_than(out, step, a, b, at_end);
        if (next.cell == spot_.cell) {  // along a side, within rounding: look farther ahead, so that this ends
          if (out + step >= 1.0) break;
          u = out;
          step *= 2.0;
          continue;
        }
        carry_at(out);
        missed = apart(old.image, now.image, tolerances_.tear) && !map_.keeps(spot_, p, map_.locate(p, spot_.cell));
      }
      if (missed) {
        out = bisect(u, out, a, b);
        next = later_than(out, step, a, b, at_end);
        carry_at(out);
      }
      // Cells that change at once, again and again, are rounding along a side.
      const bool stuck = out <= u + smallest_step || next.cell == spot_.cell;
      cross(out, p, old, now, next, next_cell);
      if (out + step >= 1.0) break;
      u = out;
      step = stuck ? 2.0 * step : first_step;
    }
    Carried end = map_.carry(cell_, b);
    bend_to(b, end);
    if (!(at_end.cell == spot_.cell)) {
      cell_ = map_.enter(at_end.cell);
      const Carried there = map_.carry(cell_, b);
      if (apart(end.image, there.image, tolerances_.tear)) tear(b, end, there);
      end = there;
    }
    spot_ = at_end;
    given(b, end);
  }

  const Map& map_;
  Traced wanted_;
  TraceTolerances tolerances_;
  MappedLine result_;
  Spot spot_;                     ///< Where the walk is.
  Entered cell_;                  ///< Its cell.
  typename Map::Hint back_hint_;  ///< For the map back.
};

/// Columns laid out straight: (place along the base, depth). No line is torn by it but on the medial axis.
class Unrolled {
 public:
  using Entered = Cell;
  Unrolled(const Columns& columns, const TraceTolerances& tolerances) : columns_(columns), tolerances_(tolerances) {}

  [[nodiscard]] Spot locate(geom::Point p, Cell hint) const {
    const Columns::Found found = columns_.find(p, tolerances_.side, ColumnId(hint.first));
    return {{static_cast<std::uint32_t>(found.column.index()), 0}, found.distance, found.foot};
  }
  [[nodiscard]] static Cell enter(Cell cell) { return cell; }
  [[nodiscard]] std::array<double, 2> beyond(Cell cell, geom::Point p) const {
    const Columns::Beyond out = columns_.beyond(ColumnId(cell.first), p);
    return {out.left, out.right};
  }
  [[nodiscard]] Carried carry(Cell cell, geom::Point p) const {
    const ColumnPoint name = columns_.name_in(ColumnId(cell.first), p);
    const Columns::Frame& frame = columns_.frame(name.column);
    const double along = is_outer(cell, p) ? name.along : name.along * frame.length;
    const double begin = cell.first > columns_.inner_count() ? frame.arc + frame.length : frame.arc;
    return {name, {begin + along, name.depth}};
  }
  [[nodiscard]] bool keeps(const Spot& spot, geom::Point p, const Spot& nearest) const {
    return columns_keep(columns_, spot, p, nearest, tolerances_.side);
  }
  using Hint = Cell;
  [[nodiscard]] static Hint hint_back(Cell cell) { return cell; }
  [[nodiscard]] static geom::Point back(geom::Point image, Hint&) { return image; }
  [[nodiscard]] bool is_outer(Cell cell, geom::Point) const { return columns_.is_outer(ColumnId(cell.first)); }
  [[nodiscard]] static bool bends() { return false; }
  [[nodiscard]] const TraceTolerances& tolerances() const { return tolerances_; }

 private:
  const Columns& columns_;
  const TraceTolerances& tolerances_;
};

}  // namespace

bool columns_keep(const Columns& columns, const Spot& spot, geom::Point p, const Spot& nearest, double tolerance) {
  if (nearest.foot == Foot::NoColumn || spot.foot == Foot::NoColumn) return nearest.cell.first == spot.cell.first;
  return columns.distance_to_base(ColumnId(spot.cell.first), p) <= nearest.distance + tolerance;
}

MappedLine trace(const ColumnMap& map, const geom::Polyline& line, Traced wanted) {
  return Tracer(map, wanted).run(line);
}
MappedLine trace(const RuledMap& map, const geom::Polyline& line, Traced wanted) {
  return Tracer(map, wanted).run(line);
}
MappedLine trace(const ShearMap& map, const geom::Polyline& line, Traced wanted) {
  return Tracer(map, wanted).run(line);
}

MappedLine measure_along(const Columns& columns, const TraceTolerances& tolerances, const geom::Polyline& line) {
  const Unrolled unrolled(columns, tolerances);
  return Tracer(unrolled).run(line);
}

}  // namespace recon::maps
