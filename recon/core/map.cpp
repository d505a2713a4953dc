#include "recon/core/map.h"

#include <algorithm>

namespace recon::core {

ColumnMap::ColumnMap(Columns source, Columns target, const MapOptions& options)
    : source_(std::move(source)), target_(std::move(target)), options_(options) {
  DOBRA_CHECK(source_.count() == target_.count());
  geom::Box box = source_.base_line().box();
  box.add(target_.base_line().box());
  const double size = std::max(source_.base_line().box().diagonal(), target_.base_line().box().diagonal());
  // Rounding grows with the coordinates, not only with the size: far from the origin the tolerance must follow.
  const double reach = std::max({std::abs(box.low.x), std::abs(box.high.x), std::abs(box.low.y), std::abs(box.high.y)});
  rung_tolerance_ = options.rung_tolerance * size + 1e-15 * reach;
  tear_tolerance_ = options.tear_tolerance * size + 1e-12 * reach;
  chord_tolerance_ = options.chord_tolerance * size;
}

/// Walks along a straight piece of a line from column to column. Places on it are u in [0, 1].
///   1. From u, in column c, find where the piece leaves c (an intersection of straight lines).
///   2. If c is still nearest there, the piece goes on in the neighbour. Otherwise it has crossed the medial axis on
///   the way:
///      bisect for the place.
///   3. Emit that place in the old column, and again in the new one if the two images differ (a tear).
class ColumnMap::Tracer {
 public:
  explicit Tracer(const ColumnMap& map) : map_(map), source_(map.source_) {}

  MappedLine run(const geom::Polyline& line) {
    start(line.points.front());
    for (std::size_t i = 1; i < line.points.size(); ++i) piece(line.points[i - 1], line.points[i]);
    return std::move(result_);
  }

 private:
  /// Steps smaller than this part of a piece are not resolved.
  static constexpr double smallest_step = 1e-9;

  void start(geom::Point p) {
    const Located located = map_.locate(p);
    count(p, located);
    result_.given.push_back(0);
    emit(p, located.at);
    column_ = located.at.column;
    foot_ = located.foot;
  }

  void count(geom::Point p, const Located& located) {
    if (located.foot == Foot::NoColumn) ++result_.without_column;
    if (source_.is_outer(located.at.column)) ++result_.beyond_ends;
    const geom::Point image = map_.image(located.at);
    const Located back = map_.target_.locate(image, map_.rung_tolerance_);
    if (geom::distance(source_.point(back.at), p) > map_.tear_tolerance_) ++result_.not_reversible;
  }

  void emit(geom::Point p, const ColumnPoint& name) {
    result_.before.points.push_back(p);
    result_.after.points.push_back(map_.image(name));
    result_.names.push_back(name);
  }

  /// The place p in `column`; before it the halvings that its curved image needs.
  void go(geom::Point p, ColumnId column) {
    const ColumnPoint name = source_.name_in(column, p);
    refine(result_.before.points.back(), result_.after.points.back(), p, map_.image(name), column,
           map_.options_.most_halvings);
    emit(p, name);
  }

  void refine(geom::Point from, geom::Point from_image, geom::Point to, geom::Point to_image, ColumnId column,
              int halvings) {
    if (halvings == 0) return;
    const geom::Point middle = geom::midpoint(from, to);
    const ColumnPoint name = source_.name_in(column, middle);
    const geom::Point image = map_.image(name);
    if (geom::distance(geom::Segment{from_image, to_image}, image) <= map_.chord_tolerance_) return;
    refine(from, from_image, middle, image, column, halvings - 1);
    emit(middle, name);
    refine(middle, image, to, to_image, column, halvings - 1);
  }

  /// Passes at p (already emitted in the old column) into the column `to`.
  void enter(geom::Point p, ColumnId to) {
    const ColumnPoint name = source_.name_in(to, p);
    const double gap = geom::distance(result_.after.points.back(), map_.image(name));
    if (gap > map_.tear_tolerance_) {
      result_.tears.push_back({result_.before.points.size() - 1, p, gap});
      emit(p, name);
    }
    column_ = to;
  }

  /// Does `column` still hold p as the nearest one does?
  [[nodiscard]] bool keeps(ColumnId column, geom::Point p, const Located& nearest) const {
    if (nearest.foot == Foot::NoColumn || foot_ == Foot::NoColumn) return nearest.at.column == column;
    return source_.distance_to_base(column, p) <= nearest.distance + map_.rung_tolerance_;
  }

  /// Where, at least `step` after `from`, the piece leaves the column; 1 if it does not.
  [[nodiscard]] double exit_after(double from, double step, geom::Point a, geom::Point b) const {
    const Columns::Beyond at_a = source_.beyond(column_, a);
    const Columns::Beyond at_b = source_.beyond(column_, b);
    double out = 1.0;
    for (const auto& [start, end] : {std::pair{at_a.left, at_b.left}, std::pair{at_a.right, at_b.right}}) {
      const double tolerance = map_.rung_tolerance_;
      if (end > tolerance && end > start) out = std::min(out, (tolerance - start) / (end - start));
    }
    return std::clamp(out, std::min(1.0, from + step), 1.0);
  }

  /// The last place in [from, to] that `column_` keeps, to rounding.
  [[nodiscard]] double bisect(double from, double to, geom::Point a, geom::Point b) const {
    for (int i = 0; i < 60 && to - from > 1e-16; ++i) {
      const double middle = 0.5 * (from + to);
      const geom::Point p = geom::interpolate(a, b, middle);
      (keeps(column_, p, map_.locate(p)) ? from : to) = middle;
    }
    return from;
  }

  /// Passes at u, already emitted, into the column that holds the piece a little later; returns how much later.
  double pass(double u, double step, geom::Point a, geom::Point b) {
    const double later = std::min(1.0, u + step);
    const Located next = map_.locate(later == 1.0 ? b : geom::interpolate(a, b, later));
    foot_ = next.foot;
    enter(u == 0.0 ? a : geom::interpolate(a, b, u), next.at.column);
    return later;
  }

  void piece(geom::Point a, geom::Point b) {
    double step = smallest_step;
    double u = pass(0.0, step, a, b);
    while (u < 1.0) {
      double out = exit_after(u, step, a, b);
      const geom::Point p = out == 1.0 ? b : geom::interpolate(a, b, out);
      const bool kept = keeps(column_, p, map_.locate(p));
      if (kept && out == 1.0) break;
      if (!kept) out = bisect(u, out, a, b);
      go(geom::interpolate(a, b, out), column_);
      const ColumnId old = column_;
      u = pass(out, step, a, b);
      // A piece that runs along a rung within rounding would otherwise be cut without end.
      step = column_ == old ? 2.0 * step : smallest_step;
    }
    go(b, column_);
    result_.given.push_back(result_.before.points.size() - 1);
    const Located located = map_.locate(b);
    foot_ = located.foot;
    count(b, located);
  }

  const ColumnMap& map_;
  const Columns& source_;
  MappedLine result_;
  ColumnId column_;  ///< Where the walk is.
  Foot foot_ = Foot::InColumn;
};

MappedLine ColumnMap::map(const geom::Polyline& line) const {
  DOBRA_CHECK(!line.points.empty());
  return Tracer(*this).run(line);
}

namespace {

/// Places nearer to each other than this part of the length are one corner: rounding of the two arc lengths.
constexpr double same_corner = 1e-12;

struct Cuts {
  std::vector<double> on_source;
  std::vector<double> on_target;
};

/// Corners of both lines within the source, in order, each with its place on either line.
Cuts common_cuts(const std::vector<double>& source, double source_pin, const std::vector<double>& target,
                 double target_pin) {
  const double length = source.back();
  const double tolerance = same_corner * (length + std::abs(source_pin) + std::abs(target_pin));
  Cuts cuts;
  std::size_t k = 0;
  for (std::size_t j = 0; j < source.size(); ++j) {
    const double here = source[j] - source_pin + target_pin;
    for (; k < target.size() && target[k] < here - tolerance; ++k) {
      if (j == 0 || target[k] <= cuts.on_target.back() + tolerance)
        continue;  // before the source begins, or no new corner
      cuts.on_source.push_back(target[k] - target_pin + source_pin);
      cuts.on_target.push_back(target[k]);
    }
    const bool same = k < target.size() && target[k] <= here + tolerance;
    cuts.on_source.push_back(source[j]);
    cuts.on_target.push_back(same ? target[k] : here);
    if (same) ++k;
  }
  return cuts;
}

}  // namespace

base::Result<ColumnMap> match_by_length(const geom::Polyline& source, double source_pin, const geom::Polyline& target,
                                        double target_pin, const MapOptions& options) {
  const Cuts cuts = common_cuts(geom::arc_lengths(source), source_pin, geom::arc_lengths(target), target_pin);
  DOBRA_TRY(Columns from, Columns::between(source, cuts.on_source));
  DOBRA_TRY(Columns to, Columns::between(target, cuts.on_target));
  return ColumnMap(std::move(from), std::move(to), options);
}

}  // namespace recon::core
