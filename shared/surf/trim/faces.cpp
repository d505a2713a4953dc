#include "shared/surf/trim/faces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "shared/surf/trim/meetings.h"
#include "shared/topo/insert.h"

namespace dobra::surf::trim {

using base::Error;
using base::ErrorCode;
using geom::Point;
using geom::Polyline;
using topo::FaceId;
using topo::HalfEdgeId;
using topo::Subdivision;

namespace {

/// Chords of an arc, from vertex to vertex, none longer than `chord` or turning by more than ten degrees.
Polyline chords_of(const Arcs& arcs, const Arc& arc, double chord, double& sag) {
  Polyline line{{arcs.vertices[arc.start]}, false};
  const std::vector<double> parts = smooth_parts_of(arcs, arc.strand, arc.from, arc.to);
  const bool closed = arc.start == arc.end;
  for (std::size_t k = 0; k + 1 < parts.size(); ++k) {
    constexpr int looks = 16;
    double length = 0.0, turn = 0.0;
    Arcs::At before = arcs.on(arc.strand, parts[k]);
    for (int i = 1; i <= looks; ++i) {
      const Arcs::At here = arcs.on(arc.strand, std::lerp(parts[k], parts[k + 1], static_cast<double>(i) / looks));
      length += geom::distance(before.at, here.at);
      turn += std::abs(std::atan2(cross(before.first, here.first), dot(before.first, here.first)));
      before = here;
    }
    const bool is_straight = turn < 1e-12;
    const double ten_degrees = 0.1745 * std::min(1.0, chord / 0.02);
    int count = is_straight ? 1 : static_cast<int>(std::ceil(std::max({length / chord, turn / ten_degrees, 2.0})));
    if (closed && parts.size() == 2) count = std::max(count, 4);
    if (!is_straight) sag = std::max(sag, length / count * turn / count);
    for (int i = 1; i <= count; ++i) {
      const Point p = arcs.on(arc.strand, std::lerp(parts[k], parts[k + 1], static_cast<double>(i) / count)).at;
      line.points.push_back({std::clamp(p.x, 0.0, 1.0), std::clamp(p.y, 0.0, 1.0)});
    }
  }
  line.points.back() = arcs.vertices[arc.end];
  return geom::without_repeated_points(std::move(line));
}

/// The subdivision, if it has the vertices of the chords and no others; else the place of one that is not.
base::Result<std::optional<Point>> divide(const Arcs& arcs, double chord, Faces& made) {
  std::vector<Polyline> lines;
  std::set<std::pair<double, double>> points;
  std::size_t edges = 0;
  made = {};
  for (const Arc& arc : arcs.arcs) {
    lines.push_back(chords_of(arcs, arc, chord, made.sag));
    edges += lines.back().points.size() - 1;
    for (const Point p : lines.back().points) points.emplace(p.x, p.y);
  }
  DOBRA_TRY(const auto paths, insert(made.subdivision, std::span<const Polyline>(lines)));
  for (const topo::VertexId v : made.subdivision.vertices()) {
    const Point p = made.subdivision.point(v);
    if (!points.contains({p.x, p.y})) return std::optional(p);
  }
  for (std::size_t a = 0; a < lines.size(); ++a) {
    if (paths[a].size() + 1 != lines[a].points.size())
      return std::optional(lines[a].points[lines[a].points.size() / 2]);
    for (std::size_t i = 0; i < paths[a].size(); ++i) {
      const std::size_t top = std::max(paths[a][i].index(), Subdivision::twin(paths[a][i]).index()) + 1;
      if (made.chords.size() < top) made.chords.resize(top);
      made.chords[paths[a][i].index()] = {a, true, i == 0};
      made.chords[Subdivision::twin(paths[a][i]).index()] = {a, false, i + 1 == paths[a].size()};
    }
  }
  if (made.subdivision.edge_count() != edges) return std::optional(lines.front().points.front());
  return std::optional<Point>{};
}

}  // namespace

base::Result<Faces> faces_of(const Surface& surface, const Arcs& arcs, double chord) {
  Faces made;
  std::optional<Point> wrong;
  constexpr int halvings = 7;
  for (int round = 0; round < halvings; ++round, chord *= 0.5) {
    DOBRA_TRY(wrong, divide(arcs, chord, made));
    if (!wrong) return made;
  }
  const Point uv = arcs.uv(*wrong);
  return Error{ErrorCode::CannotMesh,
               "lines of the chart run so near to each other here that what they bound cannot be told; let them cross, "
               "part or coincide",
               place_of(surface, uv)};
}

std::vector<std::vector<HalfEdgeId>> loops_round(const Faces& faces, const Parts& parts, int number) {
  const Subdivision& sub = faces.subdivision;
  const auto part = [&](HalfEdgeId h) { return parts[sub.face(h).index()]; };
  const auto bounds = [&](HalfEdgeId h) { return part(h) == number && part(Subdivision::twin(h)) != number; };
  std::vector<std::uint8_t> seen(faces.chords.size(), 0);
  std::vector<std::vector<HalfEdgeId>> loops;
  for (const topo::EdgeId e : sub.edges()) {
    for (const HalfEdgeId start : {Subdivision::half_edge(e), Subdivision::twin(Subdivision::half_edge(e))}) {
      if (!bounds(start) || seen[start.index()] != 0 || !faces.chords[start.index()].first) continue;
      std::vector<HalfEdgeId> loop;
      HalfEdgeId h = start;
      do {
        seen[h.index()] = 1;
        loop.push_back(h);
        h = sub.next(h);
        while (!bounds(h)) h = sub.next(Subdivision::twin(h));  // past lines inside
      } while (h != start);
      loops.push_back(std::move(loop));
    }
  }
  return loops;
}

double turned_area(const Faces& faces, const std::vector<HalfEdgeId>& loop) {
  const Subdivision& sub = faces.subdivision;
  const Point base = sub.point(sub.origin(loop.front()));
  double twice = 0.0;
  for (const HalfEdgeId h : loop) {
    const geom::Segment s = sub.segment(h);
    twice += cross(s.from - base, s.to - base);
  }
  return twice;
}

}  // namespace dobra::surf::trim
