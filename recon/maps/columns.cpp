#include "recon/maps/columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/geom/place.h"

namespace recon::maps {

namespace {

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
  columns.frames_.reserve(tangents.size());
  columns.open_depths_ = {-infinity, infinity};
  double arc = 0.0;
  double bend = 0.0;
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    segments.push_back({feet[i], feet[i + 1]});
    const geom::Vector t = tangents[i];
    const Frame frame{feet[i], t,   lengths[i], geom::dot(t, columns.rungs_[i]), geom::dot(t, columns.rungs_[i + 1]),
                      arc,     bend};
    const double widening = frame.widening();
    if (widening < 0.0) columns.open_depths_.greatest = std::min(columns.open_depths_.greatest, -lengths[i] / widening);
    if (widening > 0.0) columns.open_depths_.least = std::max(columns.open_depths_.least, -lengths[i] / widening);
    arc += lengths[i];
    bend += widening;
    columns.frames_.push_back(frame);
  }
  const geom::Vector chord = feet.back() - feet.front();
  const double least_advance = 1e-6 * geom::length(chord);
  columns.graph_ = least_advance > 0.0 && std::all_of(tangents.begin(), tangents.end(), [&](geom::Vector t) {
                     return geom::dot(t, chord) > least_advance;
                   });
  columns.tree_ = geom::SegmentTree(std::move(segments));
  columns.feet_ = std::move(feet);
  return columns;
}

Columns::Beyond Columns::beyond(ColumnId column, geom::Point p) const {
  const Frame& f = frame(column);
  const geom::Vector from_foot = p - f.foot;
  const double x = geom::dot(from_foot, f.tangent);
  const double depth = geom::dot(from_foot, geom::right_of(f.tangent));
  if (column.index() == 0) return {-infinity, x};
  if (column.index() == inner_count() + 1) return {f.length - x, -infinity};
  return {depth * f.left - x, x - f.length - depth * f.right};
}

bool Columns::holds(ColumnId column, geom::Point p, double tolerance) const {
  const Beyond out = beyond(column, p);
  // Their sum is minus the length of the offset edge: a column that has shrunk to nothing holds no point.
  return out.left <= tolerance && out.right <= tolerance && out.left + out.right < 0.0;
}

double Columns::distance_to_base(ColumnId column, geom::Point p) const {
  return std::sqrt(tree_.squared_distance(frame_of(column), p));
}

ColumnPoint Columns::name_in(ColumnId column, geom::Point p) const {
  const Frame& f = frame(column);
  const double depth = geom::dot(p - f.foot, geom::right_of(f.tangent));
  const Beyond out = beyond(column, p);
  if (column.index() == 0) return {column, out.right, depth};
  if (is_outer(column)) return {column, -out.left, depth};
  const double edge = -(out.left + out.right);
  const double along = edge > 0.0 ? -out.left / edge : geom::nearest_fraction(tree_.segment(frame_of(column)), p);
  // A little room beyond the rungs, so that the formula of the column can be differentiated at them.
  return {column, std::clamp(along, -0.1, 1.1), depth};
}

geom::Point Columns::point(const ColumnPoint& at) const {
  const Frame& f = frame(at.column);
  const geom::Vector down = at.depth * geom::right_of(f.tangent);
  if (at.column.index() == 0) return f.foot + down + at.along * f.tangent;
  if (is_outer(at.column)) return f.foot + down + (f.length + at.along) * f.tangent;
  const double left = at.depth * f.left;
  const double right = f.length + at.depth * f.right;
  return f.foot + down + ((1.0 - at.along) * left + at.along * right) * f.tangent;
}

ColumnId Columns::holder(std::size_t segment, geom::Point p, double tolerance) const {
  if (holds(ColumnId(segment + 1), p, tolerance)) return ColumnId(segment + 1);
  if (segment == 0 && holds(ColumnId(0), p, tolerance)) return ColumnId(0);
  if (segment + 1 == inner_count() && holds(ColumnId(inner_count() + 1), p, tolerance))
    return ColumnId(inner_count() + 1);
  return {};
}

/// Is a column that holds p certainly that of the nearest segment? Where the base is a graph over one direction and no
/// column has closed down to depth D, its parallels down to there are graphs, one below the other: every point has one
/// depth up to D and one place. The nearest segment would give a second place, at a depth up to its distance.
bool Columns::is_certain(double squared_distance, double depth) const {
  const double open = depth >= 0.0 ? open_depths_.greatest : -open_depths_.least;
  return graph_ && squared_distance < (1.0 - 1e-6) * open * open;
}

/// The segment beside whose rungs p lies, by halving: right where columns are certain.
std::size_t Columns::halve(geom::Point p) const {
  std::size_t low = 0;
  std::size_t high = inner_count() - 1;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (beyond(ColumnId(middle + 1), p).right > 0.0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

/// A few steps from a segment to one that can hold p; then the tree only confirms that none is nearer.
std::optional<Columns::Found> Columns::find_from(std::size_t segment, geom::Point p, double tolerance) const {
  constexpr int most_steps = 8;
  const auto accept = [&](std::size_t i) { return holder(i, p, tolerance).valid(); };
  for (int step = 0; step < most_steps; ++step) {
    const Frame& f = frames_[segment];
    const geom::Vector from_foot = p - f.foot;
    const double x = geom::dot(from_foot, f.tangent);
    const double depth = geom::dot(from_foot, geom::right_of(f.tangent));
    const double before = depth * f.left - x;
    const double after = x - f.length - depth * f.right;
    const double squared = tree_.squared_distance(segment, p);
    const bool inside = before <= tolerance && after <= tolerance && before + after < 0.0;
    const ColumnId held = inside ? ColumnId(segment + 1) : holder(segment, p, tolerance);
    if (held.valid() && !is_certain(squared, depth)) {
      const geom::SegmentTree::Nearest best = tree_.nearest_from(segment, p, accept);
      return Found{holder(best.index, p, tolerance), best.distance(), Foot::InColumn};
    }
    if (held.valid()) {
      geom::SegmentTree::Nearest best{segment, squared};
      const auto consider = [&](std::size_t i) {
        if (!accept(i)) return false;
        const geom::SegmentTree::Nearest candidate{i, tree_.squared_distance(i, p)};
        if (candidate.before(best)) best = candidate;
        return true;
      };
      // Within the tolerance (and some rounding) of a rung both columns hold p.
      const double near = -16.0 * tolerance;
      for (std::size_t i = segment; i > 0 && (i < segment || before > near) && consider(i - 1); --i) {
      }
      for (std::size_t i = segment; i + 1 < inner_count() && (i > segment || after > near) && consider(i + 1); ++i) {
      }
      return Found{best.index == segment ? held : holder(best.index, p, tolerance), best.distance(), Foot::InColumn};
    }
    if (after > before ? segment + 1 == inner_count() : segment == 0) break;
    segment = after > before ? segment + 1 : segment - 1;
  }
  return std::nullopt;
}

Columns::Found Columns::find(geom::Point p, double tolerance, ColumnId hint) const {
  if (hint.valid()) {
    if (const auto found = find_from(frame_of(hint), p, tolerance)) return *found;
  }
  if (graph_) {
    if (const auto found = find_from(halve(p), p, tolerance)) return *found;
  }
  if (const auto best = tree_.nearest(p, [&](std::size_t i) { return holder(i, p, tolerance).valid(); }))
    return {holder(best->index, p, tolerance), best->distance(), Foot::InColumn};
  const auto nearest = tree_.nearest(p, [](std::size_t) { return true; });
  return {ColumnId(nearest->index + 1), nearest->distance(), Foot::NoColumn};
}

Located Columns::locate(geom::Point p, double tolerance, ColumnId hint) const {
  const Found at = find(p, tolerance, hint);
  return {name_in(at.column, p), at.distance, at.foot};
}

}  // namespace recon::maps
