#include "recon/maps/map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon::maps {

namespace {

ColumnId column_of(std::uint32_t index) { return ColumnId(index); }
std::uint32_t index_of(ColumnId column) { return static_cast<std::uint32_t>(column.index()); }

/// The depth d of which d + rate d^2 / 2 is `area`; beyond the depth at which the columns close, that depth.
double depth_of_area(double area, double rate) {
  const double root = 1.0 + 2.0 * rate * area;
  return 2.0 * area / (1.0 + std::sqrt(std::max(0.0, root)));
}

}  // namespace

TraceTolerances tolerances_for(const geom::Box& source, const geom::Box& target, const MapOptions& options) {
  geom::Box box = source;
  box.add(target);
  const double size = std::max(source.diagonal(), target.diagonal());
  // Rounding grows with the coordinates, not only with the size: far from the origin the tolerance must follow.
  const double reach = std::max({std::abs(box.low.x), std::abs(box.high.x), std::abs(box.low.y), std::abs(box.high.y)});
  return {options.rung_tolerance * size + 1e-15 * reach, options.tear_tolerance * size + 1e-12 * reach,
          options.chord_tolerance * size, options.most_halvings};
}

ColumnMap::ColumnMap(Columns source, Columns target, const MapOptions& options, ColumnLaw law)
    : source_(std::move(source)), target_(std::move(target)), law_(law) {
  DOBRA_CHECK(law == ColumnLaw::Slip || source_.count() == target_.count());
  tolerances_ = tolerances_for(source_.base_line().box(), target_.base_line().box(), options);
  if (law == ColumnLaw::Area) {
    source_rates_ = area_rates(source_);
    target_rates_ = area_rates(target_);
  }
}

ColumnMap ColumnMap::slip(Columns source, double source_pin, Columns target, double target_pin,
                          const MapOptions& options) {
  ColumnMap map(std::move(source), std::move(target), options, ColumnLaw::Slip);
  map.source_pin_ = pin_line(map.source_, source_pin);
  map.target_pin_ = pin_line(map.target_, target_pin);
  return map;
}

ColumnMap ColumnMap::swapped() const {
  ColumnMap back = *this;
  std::swap(back.source_, back.target_);
  std::swap(back.source_pin_, back.target_pin_);
  std::swap(back.source_rates_, back.target_rates_);
  return back;
}

// Slip. Along the bed at depth d, column i begins at arc_i + d bend_i; a point at x along its segment stands at
// arc_i + x + d (bend_i - left_i).

ColumnMap::BedLine ColumnMap::rung_line(const Columns& columns, std::size_t rung) {
  if (rung < columns.inner_count()) {
    const Columns::Frame& frame = columns.frame(ColumnId(rung + 1));
    return {frame.arc, frame.bend};
  }
  const Columns::Frame& frame = columns.frame(ColumnId(rung));
  return {frame.arc + frame.length, frame.bend + frame.widening()};
}

ColumnMap::BedLine ColumnMap::pin_line(const Columns& columns, double arc) {
  const std::size_t count = columns.inner_count();
  const double total = rung_line(columns, count).arc;
  std::size_t low = 0;
  std::size_t high = count;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    (rung_line(columns, middle).arc < arc ? low : high) = middle + (rung_line(columns, middle).arc < arc ? 1 : 0);
  }
  for (const std::size_t rung : {low == 0 ? 0 : low - 1, low}) {
    if (std::abs(rung_line(columns, rung).arc - arc) <= 1e-12 * total) return rung_line(columns, rung);
  }
  const Columns::Frame& frame = columns.frame(ColumnId(std::clamp<std::size_t>(low, 1, count)));
  return {arc, frame.bend - frame.left};
}

double ColumnMap::along_bed(const Columns::Frame& frame, geom::Point p, double& depth) {
  const geom::Vector from_foot = p - frame.foot;
  depth = geom::dot(from_foot, geom::right_of(frame.tangent));
  return frame.arc + geom::dot(from_foot, frame.tangent) + depth * (frame.bend - frame.left);
}

double ColumnMap::target_bed(const Columns::Frame& frame, geom::Point p, double& depth) const {
  const double bed = along_bed(frame, p, depth);
  return bed - source_pin_.at(depth) + target_pin_.at(depth);
}

geom::Point ColumnMap::point_on_bed(const Columns::Frame& frame, double bed, double depth) {
  const double x = bed - frame.arc - depth * (frame.bend - frame.left);
  return frame.foot + x * frame.tangent + depth * geom::right_of(frame.tangent);
}

ColumnId ColumnMap::column_at(const Columns& columns, double bed, double depth, ColumnId hint) {
  const std::size_t count = columns.inner_count();
  const auto starts_after = [&](std::size_t rung) { return bed < rung_line(columns, rung).at(depth); };
  // Where some column has closed, the beds turn back, and only the search below does not depend on the hint.
  const Columns::DepthRange open = columns.open_depths();
  if (hint.valid() && depth > open.least && depth < open.greatest) {
    std::size_t column = std::min<std::size_t>(hint.index(), count + 1);  // between rungs column - 1 and column
    for (int step = 0; step < 8; ++step) {
      if (column <= count && !starts_after(column)) {
        ++column;
      } else if (column > 0 && starts_after(column - 1)) {
        --column;
      } else {
        return ColumnId(column);
      }
    }
  }
  std::size_t low = 0;
  std::size_t high = count + 1;  // the first rung that starts after `bed` is in [low, high]
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (starts_after(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return ColumnId(low);
}

geom::Point ColumnMap::target_point(double from_pin, double depth, ColumnId& hint) const {
  const double bed = from_pin + target_pin_.at(depth);
  hint = column_at(target_, bed, depth, hint);
  return point_on_bed(target_.frame(hint), bed, depth);
}

std::vector<double> ColumnMap::target_corners(double depth) const {
  std::vector<double> corners;
  for (std::size_t rung = 0; rung < target_.rung_count(); ++rung)
    corners.push_back(rung_line(target_, rung).at(depth) - target_pin_.at(depth));
  return corners;
}

std::vector<ColumnMap::LaidPoint> ColumnMap::lay(const std::vector<double>& arc, const std::vector<ColumnPoint>& names,
                                                 std::size_t start, double travel) const {
  const bool up = travel > 0.0;
  const std::size_t pieces = up ? arc.size() - 1 - start : start;
  double depth = names[start].depth;
  ColumnId column = column_at(target_, target_pin_.at(depth), depth, ColumnId{});
  geom::Point p = point_on_bed(target_.frame(column), target_pin_.at(depth), depth);
  std::vector<LaidPoint> laid;
  laid.reserve(pieces + 1);
  laid.push_back({start, 0.0, p});
  for (std::size_t i = 0, vertex = start; i < pieces; ++i) {
    const std::size_t next = up ? vertex + 1 : vertex - 1;
    const double length = std::abs(arc[next] - arc[vertex]);
    // Over a jump of the bed, which has no length, it falls at once.
    const double limit = length > 1e-10 * arc.back() ? length : infinity;
    const double drop = std::clamp(names[next].depth - depth, -limit, limit);
    const double along = std::sqrt(std::max(0.0, length * length - drop * drop));
    double left_to_go = 1.0;
    while (true) {
      const Columns::Frame& frame = target_.frame(column);
      const geom::Point goal =
          p + (travel * along * left_to_go) * frame.tangent + (drop * left_to_go) * geom::right_of(frame.tangent);
      const Columns::Beyond there = target_.beyond(column, goal);
      const double end = up ? there.right : there.left;
      if (!(end > 0.0)) {
        p = goal;
        break;
      }
      const Columns::Beyond here = target_.beyond(column, p);
      const double from = up ? here.right : here.left;
      if (!(end > from)) {
        p = goal;
        break;
      }
      const double part = std::clamp(-from / (end - from), 0.0, 1.0);
      p = geom::interpolate(p, goal, part);
      left_to_go *= 1.0 - part;
      laid.push_back({vertex, 1.0 - left_to_go, p});
      column = ColumnId(up ? column.index() + 1 : column.index() - 1);
    }
    depth += drop;
    vertex = next;
    laid.push_back({vertex, 0.0, p});
  }
  return laid;
}

// Area.

std::vector<double> ColumnMap::area_rates(const Columns& columns) {
  const std::size_t count = columns.inner_count();
  std::vector<double> rates(count + 1);
  for (std::size_t rung = 0; rung <= count; ++rung) {
    double widening = 0.0;
    double length = 0.0;
    for (const std::size_t column : {rung, rung + 1}) {
      if (column == 0 || column > count) continue;
      widening += columns.frame(ColumnId(column)).widening();
      length += columns.frame(ColumnId(column)).length;
    }
    rates[rung] = widening / length;
  }
  return rates;
}

double ColumnMap::area_rate(const std::vector<double>& rates, const ColumnPoint& at) {
  if (at.column.index() == 0) return rates.front();
  if (at.column.index() >= rates.size()) return rates.back();
  return (1.0 - at.along) * rates[at.column.index() - 1] + at.along * rates[at.column.index()];
}

geom::Point ColumnMap::carry_name(const ColumnPoint& name) const {
  DOBRA_CHECK(law_ != ColumnLaw::Slip);
  if (law_ == ColumnLaw::Thickness) return target_.point(name);
  ColumnPoint goal = name;
  const double area = name.depth * (1.0 + 0.5 * area_rate(source_rates_, name) * name.depth);
  goal.depth = depth_of_area(area, area_rate(target_rates_, name));
  return target_.point(goal);
}

// What Tracer asks.

Spot ColumnMap::locate(geom::Point p, Cell hint) const {
  const Columns::Found found = source_.find(p, tolerances_.side, column_of(hint.first));
  Spot spot{{index_of(found.column), 0}, found.distance, found.foot};
  if (law_ == ColumnLaw::Slip) {
    double depth = 0.0;
    const double bed = target_bed(source_.frame(found.column), p, depth);
    spot.cell.second = index_of(column_at(target_, bed, depth, column_of(hint.second)));
  }
  return spot;
}

std::array<double, 4> ColumnMap::beyond(Cell cell, geom::Point p) const {
  const Columns::Beyond out = source_.beyond(column_of(cell.first), p);
  if (law_ != ColumnLaw::Slip) return {out.left, out.right, -infinity, -infinity};
  double depth = 0.0;
  const double bed = target_bed(source_.frame(column_of(cell.first)), p, depth);
  const bool first = cell.second == 0;
  const bool last = cell.second == target_.inner_count() + 1;
  return {out.left, out.right, first ? -infinity : rung_line(target_, cell.second - 1).at(depth) - bed,
          last ? -infinity : bed - rung_line(target_, cell.second).at(depth)};
}

Carried ColumnMap::carry(Cell cell, geom::Point p) const {
  const ColumnPoint name = source_.name_in(column_of(cell.first), p);
  if (law_ != ColumnLaw::Slip) return {name, carry_name(name)};
  double depth = 0.0;
  const double bed = target_bed(source_.frame(column_of(cell.first)), p, depth);
  return {name, point_on_bed(target_.frame(column_of(cell.second)), bed, depth)};
}

double ColumnMap::determinant(Cell cell, geom::Point p) const {
  if (law_ == ColumnLaw::Slip) return 1.0;
  const ColumnId column = column_of(cell.first);
  const ColumnPoint name = source_.name_in(column, p);
  // The area of a piece of column is that of its name times the length of the offset edge.
  const auto edge = [&](const Columns& columns, double depth) {
    const Columns::Frame& frame = columns.frame(column);
    return columns.is_outer(column) ? 1.0 : frame.length + depth * frame.widening();
  };
  if (law_ == ColumnLaw::Thickness) return edge(target_, name.depth) / edge(source_, name.depth);
  const double rate = area_rate(source_rates_, name);
  const double goal_rate = area_rate(target_rates_, name);
  const double depth = depth_of_area(name.depth * (1.0 + 0.5 * rate * name.depth), goal_rate);
  return edge(target_, depth) / edge(source_, name.depth) * (1.0 + rate * name.depth) / (1.0 + goal_rate * depth);
}

bool ColumnMap::keeps(const Spot& spot, geom::Point p, const Spot& nearest) const {
  return columns_keep(source_, spot, p, nearest, tolerances_.side);
}

geom::Point ColumnMap::back(geom::Point image, Cell& hint) const {
  const Columns::Found found = target_.find(image, tolerances_.side, column_of(hint.second));
  hint.second = index_of(found.column);
  if (law_ != ColumnLaw::Slip) {
    ColumnPoint name = target_.name_in(found.column, image);
    if (law_ == ColumnLaw::Area) {
      const double area = name.depth * (1.0 + 0.5 * area_rate(target_rates_, name) * name.depth);
      name.depth = depth_of_area(area, area_rate(source_rates_, name));
    }
    return source_.point(name);
  }
  double depth = 0.0;
  const double on_target = along_bed(target_.frame(found.column), image, depth);
  const double bed = on_target - target_pin_.at(depth) + source_pin_.at(depth);
  const ColumnId column = column_at(source_, bed, depth, column_of(hint.first));
  hint.first = index_of(column);
  return point_on_bed(source_.frame(column), bed, depth);
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
                                        double target_pin, const MapOptions& options, ColumnLaw law) {
  if (law == ColumnLaw::Slip) {
    DOBRA_TRY(Columns from, Columns::along(source));
    DOBRA_TRY(Columns to, Columns::along(target));
    return ColumnMap::slip(std::move(from), source_pin, std::move(to), target_pin, options);
  }
  const Cuts cuts = common_cuts(geom::arc_lengths(source), source_pin, geom::arc_lengths(target), target_pin);
  DOBRA_TRY(Columns from, Columns::between(source, cuts.on_source));
  DOBRA_TRY(Columns to, Columns::between(target, cuts.on_target));
  return ColumnMap(std::move(from), std::move(to), options, law);
}

}  // namespace recon::maps
