#include "recon/faults/parting.h"

#include <algorithm>
#include <optional>

#include "shared/geom/intersect.h"

namespace recon::faults {

namespace {

std::optional<geom::Point> beyond(const std::vector<Fault>& faults, const Fault& fault, const FaultEnd& end,
                                  const geom::Segment& last, double size) {
  if (end.kind == EndKind::Tip) return std::nullopt;
  const geom::Vector way = geom::normalised(last.to - last.from);
  if (end.kind != EndKind::Border) {
    const geom::Vector to = end.at - last.to;
    const bool short_of_it = geom::length(to) > 1e-9 * size && geom::dot(to, way) > 0.0;
    return short_of_it ? end.at + 1e-9 * size * geom::normalised(to) : last.to + 1e-9 * size * way;
  }
  geom::Point far = last.to + 20.0 * size * way;
  for (const Fault& other : faults) {
    if (&other == &fault) continue;
    const geom::Polyline line = own_line(other);
    for (std::size_t i = 0; i < line.segment_count(); ++i) {
      const geom::Intersection hit = geom::intersect({last.to, far}, line.segment(i));
      if (hit.kind != geom::IntersectionKind::None && hit.start.point != last.to)
        far = hit.start.point + 1e-9 * size * way;
    }
  }
  return far;
}

/// Takes away what of a line leads past the fault that it ends on.
void cut_past(const std::vector<Fault>& faults, const FaultEnd& end, std::vector<geom::Point>& points) {
  const auto on = std::find_if(faults.begin(), faults.end(), [&](const Fault& f) { return f.name == end.on; });
  if (on == faults.end() || end.gap <= 0.0) return;
  const geom::Polyline other = own_line(*on);
  double past = 0.0;
  for (std::size_t i = points.size() - 1; i > 0 && past <= 20.0 * end.gap; --i) {
    for (std::size_t k = 0; k < other.segment_count(); ++k) {
      const geom::Intersection hit = geom::intersect({points[i - 1], points[i]}, other.segment(k));
      if (hit.kind == geom::IntersectionKind::None) continue;
      if (past + geom::distance(hit.start.point, points[i]) > 20.0 * end.gap) return;
      points.resize(i);
      if (points.back() != hit.start.point) points.push_back(hit.start.point);
      return;
    }
    past += geom::distance(points[i - 1], points[i]);
  }
}

}  // namespace

std::vector<geom::Polyline> parting_lines(const std::vector<Fault>& faults, double size) {
  std::vector<geom::Polyline> lines;
  for (const Fault& fault : faults) {
    geom::Polyline line = own_line(fault);
    std::vector<geom::Point>& points = line.points;
    cut_past(faults, fault.upper, points);
    std::reverse(points.begin(), points.end());
    cut_past(faults, fault.lower, points);
    std::reverse(points.begin(), points.end());
    if (points.size() < 2) points = own_line(fault).points;
    const auto up = beyond(faults, fault, fault.upper, {points[points.size() - 2], points.back()}, size);
    const auto down = beyond(faults, fault, fault.lower, {points[1], points.front()}, size);
    if (up) points.push_back(*up);
    if (down) points.insert(points.begin(), *down);
    lines.push_back(std::move(line));
  }
  return lines;
}

geom::Polyline frame_of(const geom::Box& box, double size) {
  const geom::Box round = box.grown(3.0 * size);
  return {{round.low, {round.high.x, round.low.y}, round.high, {round.low.x, round.high.y}}, true};
}

base::DisjointSets cells_of(const section::Arrangement& arrangement, std::size_t parting) {
  const topo::Subdivision& sub = arrangement.subdivision();
  std::size_t highest = 0;
  for (const topo::FaceId f : sub.faces()) highest = std::max(highest, f.index());
  base::DisjointSets cells(highest + 1);
  for (const topo::EdgeId e : sub.edges()) {
    const std::vector<std::uint32_t>& lines = arrangement.lines_on(e);
    if (!lines.empty() && lines.front() <= parting) continue;  // ascending
    const topo::HalfEdgeId h = topo::Structure::half_edge(e);
    cells.join(sub.face(h).index(), sub.face(topo::Structure::twin(h)).index());
  }
  return cells;
}

}  // namespace recon::faults
