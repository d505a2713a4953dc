#include "recon/core/columns.h"

#include <algorithm>
#include <limits>

#include "recon/core/section.h"

namespace recon::core {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A corner whose mitre is longer than this many times the depth counts as turning back on itself.
constexpr double longest_mitre = 1e6;

}  // namespace

base::Result<Columns> Columns::along(const geom::Polyline& line) { return between(line, geom::arc_lengths(line)); }

base::Result<Columns> Columns::between(const geom::Polyline& line, std::span<const double> arcs) {
  DOBRA_CHECK(!line.closed && line.points.size() >= 2 && arcs.size() >= 2);
  const std::vector<double> line_arcs = geom::arc_lengths(line);
  std::vector<geom::Point> feet;
  std::vector<geom::Vector> tangents;
  std::vector<double> lengths;
  feet.reserve(arcs.size());
  for (const double arc : arcs) {
    const auto corner = std::lower_bound(line_arcs.begin(), line_arcs.end(), arc);
    const bool at_corner = corner != line_arcs.end() && *corner == arc;  // then bit for bit the point that was given
    feet.push_back(at_corner ? line.points[static_cast<std::size_t>(corner - line_arcs.begin())]
                             : geom::point_at(line, line_arcs, arc));
  }
  for (std::size_t i = 0; i + 1 < arcs.size(); ++i) {
    if (!(arcs[i] < arcs[i + 1])) {
      return base::Error{base::ErrorCode::DegenerateCurve,
                         "two points are too near to each other to tell the line's direction", place_at(feet[i])};
    }
    // The direction is that of the whole segment: a short column must not take its direction from rounded feet.
    const double middle = 0.5 * (arcs[i] + arcs[i + 1]);
    const auto next = std::upper_bound(line_arcs.begin() + 1, line_arcs.end() - 1, middle);
    tangents.push_back(geom::normalised(line.segment(static_cast<std::size_t>(next - line_arcs.begin()) - 1).vector()));
    lengths.push_back(arcs[i + 1] - arcs[i]);
  }
  return assemble(std::move(feet), std::move(tangents), std::move(lengths));
}

base::Result<Columns> Columns::assemble(std::vector<geom::Point> feet, std::vector<geom::Vector> tangents,
                                        std::vector<double> lengths) {
  Columns columns;
  columns.rungs_.reserve(feet.size());
  for (std::size_t j = 0; j < feet.size(); ++j) {
    const geom::Vector before = geom::right_of(tangents[j == 0 ? 0 : j - 1]);
    const geom::Vector after = geom::right_of(tangents[std::min(j, tangents.size() - 1)]);
    const geom::Vector sum = before + after;
    const double divisor = 1.0 + geom::dot(before, after);
    if (!(divisor > 0.0 && geom::length(sum) <= longest_mitre * divisor)) {
      return base::Error{base::ErrorCode::DegenerateCurve,
                         "the line turns back on itself, so it has no normal here; remove or move this point",
                         place_at(feet[j])};
    }
    columns.rungs_.push_back(sum / divisor);
  }
  std::vector<geom::Segment> segments;
  segments.reserve(tangents.size());
  for (std::size_t i = 0; i < tangents.size(); ++i) segments.push_back({feet[i], feet[i + 1]});
  columns.tree_ = SegmentTree(std::move(segments));
  columns.feet_ = std::move(feet);
  columns.tangents_ = std::move(tangents);
  columns.lengths_ = std::move(lengths);
  return columns;
}

std::size_t Columns::frame_of(ColumnId column) const {
  return std::clamp<std::size_t>(column.index(), 1, inner_count()) - 1;
}

Columns::Beyond Columns::beyond(ColumnId column, geom::Point p) const {
  const std::size_t i = frame_of(column);
  const geom::Vector t = tangents_[i];
  const geom::Vector from_foot = p - feet_[i];
  const double x = geom::dot(from_foot, t);
  const double depth = geom::dot(from_foot, geom::right_of(t));
  if (column.index() == 0) return {-infinity, x};
  if (column.index() == inner_count() + 1) return {lengths_[i] - x, -infinity};
  return {depth * geom::dot(rungs_[i], t) - x, x - lengths_[i] - depth * geom::dot(rungs_[i + 1], t)};
}

bool Columns::holds(ColumnId column, geom::Point p, double tolerance) const {
  const Beyond out = beyond(column, p);
  // Their sum is minus the length of the offset edge: a column that has shrunk to nothing holds no point.
  return out.left <= tolerance && out.right <= tolerance && out.left + out.right < 0.0;
}

double Columns::distance_to_base(ColumnId column, geom::Point p) const {
  return geom::distance(tree_.segment(frame_of(column)), p);
}

ColumnPoint Columns::name_in(ColumnId column, geom::Point p) const {
  const std::size_t i = frame_of(column);
  const double depth = geom::dot(p - feet_[i], geom::right_of(tangents_[i]));
  const Beyond out = beyond(column, p);
  if (column.index() == 0) return {column, out.right, depth};
  if (is_outer(column)) return {column, -out.left, depth};
  const double edge = -(out.left + out.right);
  const double along = edge > 0.0 ? -out.left / edge : geom::nearest_fraction(tree_.segment(i), p);
  return {column, std::clamp(along, 0.0, 1.0), depth};
}

geom::Point Columns::point(const ColumnPoint& at) const {
  const std::size_t i = frame_of(at.column);
  const geom::Vector t = tangents_[i];
  const geom::Vector down = at.depth * geom::right_of(t);
  if (at.column.index() == 0) return feet_[i] + down + at.along * t;
  if (is_outer(at.column)) return feet_[i] + down + (lengths_[i] + at.along) * t;
  const double left = at.depth * geom::dot(rungs_[i], t);
  const double right = lengths_[i] + at.depth * geom::dot(rungs_[i + 1], t);
  return feet_[i] + down + ((1.0 - at.along) * left + at.along * right) * t;
}

Located Columns::locate(geom::Point p, double tolerance) const {
  ColumnId found;
  const auto accept = [&](std::size_t segment) {
    const ColumnId inner(segment + 1);
    if (holds(inner, p, tolerance)) {
      found = inner;
    } else if (segment == 0 && holds(ColumnId(0), p, tolerance)) {
      found = ColumnId(0);
    } else if (segment + 1 == inner_count() && holds(ColumnId(inner_count() + 1), p, tolerance)) {
      found = ColumnId(inner_count() + 1);
    } else {
      return false;
    }
    return true;
  };
  if (const auto best = tree_.nearest(p, accept)) return {name_in(found, p), best->distance, Foot::InColumn};
  const auto nearest = tree_.nearest(p, [](std::size_t) { return true; });
  return {name_in(ColumnId(nearest->index + 1), p), nearest->distance, Foot::NoColumn};
}

}  // namespace recon::core
