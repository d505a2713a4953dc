#include "shared/canvas/line_edit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "shared/base/text.h"
#include "shared/geom/box.h"
#include "shared/geom/intersect.h"
#include "shared/geom/place.h"

namespace dobra::canvas {

namespace {

using geom::Point;
using geom::Polyline;

base::Error degenerate(const char* message, const Polyline& line) {
  const Point at = line.points.empty() ? Point{} : line.points.front();
  return {base::ErrorCode::DegenerateCurve, base::translated(message), geom::place_at(at)};
}

std::ptrdiff_t offset(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }

/// From place `from` to place `to` along an open line.
Polyline between(const Polyline& line, const OnSegment& from, const OnSegment& to) {
  Polyline part{{from.at}, false};
  for (std::size_t i = from.segment + 1; i <= to.segment; ++i) part.points.push_back(line.points[i]);
  part.points.push_back(to.at);
  return geom::without_repeated_points(std::move(part));
}

bool before(const Polyline& line, const OnSegment& a, const OnSegment& b) {
  if (a.segment != b.segment) return a.segment < b.segment;
  return geom::before_along(line.segment(a.segment), a.at, b.at);
}

/// Where an open line meets others, along it.
std::vector<OnSegment> meetings(const Polyline& line, std::span<const Polyline> others) {
  std::vector<OnSegment> found;
  const geom::Box reach = line.box();
  for (const Polyline& other : others) {
    for (std::size_t k = 0; k < other.segment_count(); ++k) {
      const geom::Segment crossing = other.segment(k);
      const Point ends[] = {crossing.from, crossing.to};
      if (!geom::box_of(ends).overlaps(reach)) continue;
      for (std::size_t i = 0; i < line.segment_count(); ++i) {
        const geom::Intersection at = geom::intersect(line.segment(i), crossing);
        if (at.kind == geom::IntersectionKind::None) continue;
        found.push_back({i, at.start.point});
        if (at.kind == geom::IntersectionKind::Overlap) found.push_back({i, at.end.point});
      }
    }
  }
  std::sort(found.begin(), found.end(), [&](const OnSegment& a, const OnSegment& b) { return before(line, a, b); });
  return found;
}

/// The nearest meeting of the ray with the segment, as a distance along the ray.
std::optional<double> ray_meets(Point from, geom::Vector way, const geom::Segment& s) {
  const geom::Vector side = s.to - s.from;
  const double turn = cross(way, side);
  if (turn == 0.0) return std::nullopt;
  const double along = cross(s.from - from, side) / turn;
  const double t = cross(s.from - from, way) / turn;
  if (!(along > 0.0) || t < 0.0 || t > 1.0) return std::nullopt;
  return along;
}

}  // namespace

Polyline with_vertex_moved(Polyline line, std::size_t i, Point to) {
  line.points[i] = to;
  return line;
}

Polyline with_vertex(Polyline line, const OnSegment& where) {
  line.points.insert(line.points.begin() + offset(where.segment) + 1, where.at);
  return line;
}

base::Result<Polyline> without_vertices(const Polyline& line, const std::set<std::size_t>& vertices) {
  Polyline left{{}, line.closed};
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    if (!vertices.contains(i)) left.points.push_back(line.points[i]);
  }
  if (left.points.size() < (line.closed ? 3U : 2U))
    return degenerate("too few points would be left; delete the whole line instead", line);
  return left;
}

base::Result<std::pair<Polyline, Polyline>> split_at(const Polyline& line, const OnSegment& where) {
  if (line.closed) {
    Polyline open{{where.at}, false};
    for (std::size_t k = 1; k <= line.points.size(); ++k)
      open.points.push_back(line.points[(where.segment + k) % line.points.size()]);
    open.points.push_back(where.at);
    return std::pair{geom::without_repeated_points(std::move(open)), Polyline{}};
  }
  const OnSegment first{0, line.points.front()};
  const OnSegment last{line.segment_count() - 1, line.points.back()};
  std::pair<Polyline, Polyline> parts{between(line, first, where), between(line, where, last)};
  if (parts.first.points.size() < 2 || parts.second.points.size() < 2)
    return degenerate("a line is not split at its end", line);
  return parts;
}

base::Result<Polyline> joined(const Polyline& a, const Polyline& b) {
  if (a.closed || b.closed) return degenerate("a closed line has no end to join", a.closed ? a : b);
  const auto ends = [](const Polyline& line, End end) {
    return end == End::First ? line.points.front() : line.points.back();
  };
  std::pair<End, End> nearest{End::Last, End::First};
  for (const End of_a : {End::Last, End::First}) {
    for (const End of_b : {End::First, End::Last}) {
      if (geom::distance(ends(a, of_a), ends(b, of_b)) <
          geom::distance(ends(a, nearest.first), ends(b, nearest.second)))
        nearest = {of_a, of_b};
    }
  }
  // Of b what follows a's last point, or comes before its first.
  const bool behind = nearest.first == End::Last;
  const Polyline other = (nearest.second == End::First) == behind ? b : geom::reversed(b);
  Polyline first = behind ? a : other;
  const Polyline& second = behind ? other : a;
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  return geom::without_repeated_points(std::move(first));
}

base::Result<Polyline> extended_to(Polyline line, End end, std::span<const Polyline> others) {
  if (line.closed) return degenerate("a closed line has no end to extend", line);
  if (end == End::First) line = geom::reversed(std::move(line));
  const Point from = line.points.back();
  const geom::Vector way = from - line.points[line.points.size() - 2];
  double least = std::numeric_limits<double>::infinity();
  for (const Polyline& other : others) {
    for (std::size_t k = 0; k < other.segment_count(); ++k)
      least = std::min(least, ray_meets(from, way, other.segment(k)).value_or(least));
  }
  if (!std::isfinite(least)) return degenerate("the line, drawn straight on, meets no other line", line);
  line.points.push_back(from + least * way);
  if (end == End::First) line = geom::reversed(std::move(line));
  return line;
}

base::Result<std::vector<Polyline>> trimmed(const Polyline& line, std::span<const Polyline> others,
                                            const OnSegment& pointed) {
  if (line.closed) return degenerate("a closed line is not trimmed; split it first", line);
  const std::vector<OnSegment> met = meetings(line, others);
  const auto after = std::find_if(met.begin(), met.end(), [&](const OnSegment& m) { return before(line, pointed, m); });
  std::vector<Polyline> left;
  const auto keep = [&](const OnSegment& from, const OnSegment& to) {
    Polyline part = between(line, from, to);
    if (part.points.size() > 1) left.push_back(std::move(part));
  };
  if (after != met.begin()) keep({0, line.points.front()}, *std::prev(after));
  if (after != met.end()) keep(*after, {line.segment_count() - 1, line.points.back()});
  if (left.empty()) return degenerate("the line meets no other line here, so there is nothing to trim it at", line);
  return left;
}

Polyline rectangle(Point corner, Point opposite) {
  const Point low{std::min(corner.x, opposite.x), std::min(corner.y, opposite.y)};
  const Point high{std::max(corner.x, opposite.x), std::max(corner.y, opposite.y)};
  return {{low, {high.x, low.y}, high, {low.x, high.y}}, true};
}

Polyline regular_polygon(Point centre, Point vertex, std::size_t sides) {
  const geom::Vector arm = vertex - centre;
  Polyline polygon{{}, true};
  for (std::size_t k = 0; k < sides; ++k) {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(sides);
    const double c = std::cos(turn), s = std::sin(turn);
    polygon.points.push_back(centre + geom::Vector{c * arm.x - s * arm.y, s * arm.x + c * arm.y});
  }
  return polygon;
}

}  // namespace dobra::canvas
