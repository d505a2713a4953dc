#include "recon/section/arrangement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <span>
#include <unordered_map>

#include "shared/geom/place.h"
#include "shared/topo/insert.h"

namespace recon::section {

base::Result<Arrangement> Arrangement::make(std::vector<geom::Polyline> lines) {
  Arrangement made;
  DOBRA_TRY_VOID(made.add(std::move(lines)));
  return made;
}

base::Result<void> Arrangement::add(std::vector<geom::Polyline> lines) {
  stretches_.add(lines);
  std::move(lines.begin(), lines.end(), std::back_inserter(lines_));
  DOBRA_TRY_VOID(draw());
  if (chords_stand()) return {};
  // Rounded crossings have drawn lines, which drew others, beyond the margin: now every segment stands for itself.
  stretches_.cut_all();
  return draw();
}

/// All lines at once: one that comes later may bend earlier ones onto each other, and only the paths in the end tell.
base::Result<void> Arrangement::draw() {
  subdivision_ = {};
  drawn_.clear();
  std::vector<geom::Polyline> curves;
  for (std::uint32_t line = 0; line < lines_.size(); ++line) {
    const std::vector<Stretch>& stretches = drawn_.emplace_back(stretches_.of(line));
    geom::Polyline& curve = curves.emplace_back(geom::Polyline{{}, lines_[line].closed});
    for (const Stretch stretch : stretches) curve.points.push_back(vertex_of(line, stretch.first));
    if (!curve.closed && !stretches.empty()) curve.points.push_back(lines_[line].points.back());
    if (stretches.empty()) curve = lines_[line];
  }
  DOBRA_TRY(paths_, topo::insert(subdivision_, curves));
  std::size_t highest = 0;
  for (const topo::EdgeId e : subdivision_.edges()) highest = std::max(highest, e.index());
  lines_on_.assign(highest + 1, {});
  chords_.assign(highest + 1, {});
  for (std::uint32_t line = 0; line < lines_.size(); ++line) {
    for (const topo::HalfEdgeId h : paths_[line]) {
      std::vector<std::uint32_t>& owners = lines_on_[topo::Structure::edge(h).index()];
      if (owners.empty() || owners.back() != line) owners.push_back(line);
    }
    mark_chords(line);
  }
  return {};
}

void Arrangement::mark_chords(std::uint32_t line) {
  for (const Stretch stretch : drawn_[line]) {
    if (stretch.is_segment()) continue;
    const topo::HalfEdgeId h = chord_of(line, stretch);
    if (!h.valid()) continue;  // chords_stand will tell
    chords_[topo::Structure::edge(h).index()] = {line, stretch};
  }
}

/// Is every stretch the edge that it was drawn as?
bool Arrangement::chords_stand() const {
  for (std::uint32_t line = 0; line < drawn_.size(); ++line) {
    for (const Stretch stretch : drawn_[line]) {
      if (stretch.is_segment()) continue;
      const topo::HalfEdgeId h = chord_of(line, stretch);
      if (!h.valid() || lines_on(topo::Structure::edge(h)).size() != 1) return false;
    }
  }
  return true;
}

geom::Point Arrangement::vertex_of(std::uint32_t line, std::uint32_t vertex) const {
  const std::vector<geom::Point>& points = lines_[line].points;
  return points[vertex == points.size() ? 0 : vertex];
}

/// From the first vertex of the stretch to the last one.
topo::HalfEdgeId Arrangement::chord_of(std::uint32_t line, Stretch stretch) const {
  const auto from = subdivision_.vertex_at(vertex_of(line, stretch.first));
  const auto to = subdivision_.vertex_at(vertex_of(line, stretch.last));
  return from && to ? subdivision_.between(*from, *to) : topo::HalfEdgeId();
}

const std::vector<std::uint32_t>& Arrangement::lines_on(topo::EdgeId edge) const { return lines_on_[edge.index()]; }

bool Arrangement::runs_along(topo::EdgeId edge, std::uint32_t line) const {
  const std::vector<std::uint32_t>& owners = lines_on(edge);
  return std::binary_search(owners.begin(), owners.end(), line);
}

void Arrangement::append(topo::HalfEdgeId h, std::vector<geom::Point>& points) const {
  const Chord chord = chords_[topo::Structure::edge(h).index()];
  const geom::Point origin = subdivision_.point(subdivision_.origin(h));
  points.push_back(origin);
  const auto [first, last] = chord.stretch;
  if (last == 0) return;
  const std::vector<geom::Point>& line = lines_[chord.line].points;
  const auto inner = [&](std::uint32_t i) { return line.begin() + i; };
  if (origin == line[first]) {
    points.insert(points.end(), inner(first + 1), inner(last));
  } else {
    points.insert(points.end(), std::reverse_iterator(inner(last)), std::reverse_iterator(inner(first + 1)));
  }
}

double Arrangement::area(topo::FaceId face) const {
  double area = 0.0;
  for (const topo::LoopId loop : subdivision_.loops(face)) {
    geom::Polyline contour{{}, true};
    for (const topo::HalfEdgeId h : subdivision_.half_edges(loop)) append(h, contour.points);
    area += geom::signed_area(contour);
  }
  return area;
}

std::vector<topo::HalfEdgeId> Arrangement::path(std::uint32_t line) const {
  std::vector<topo::HalfEdgeId> path;
  for (const topo::HalfEdgeId h : paths_[line]) {
    if (!path.empty() && path.back() == topo::Structure::twin(h)) {
      path.pop_back();
    } else {
      path.push_back(h);
    }
  }
  if (!lines_[line].closed) return path;
  std::size_t spur = 0;  // over the first point
  while (2 * (spur + 1) < path.size() && path[spur] == topo::Structure::twin(path[path.size() - 1 - spur])) ++spur;
  return {path.begin() + static_cast<std::ptrdiff_t>(spur), path.end() - static_cast<std::ptrdiff_t>(spur)};
}

namespace {

/// How often rings wind round each face, by ring, zeros left out: from the unbounded face on, each differs from its
/// neighbours by the rings between them.
class Windings {
 public:
  using Counts = std::map<std::uint32_t, int>;

  Windings(const topo::Subdivision& sub, std::span<const std::vector<topo::HalfEdgeId>> rings) {
    std::unordered_map<std::size_t, Counts> rise;  // by half-edge: of its left-hand side over the other one
    for (std::uint32_t ring = 0; ring < rings.size(); ++ring) {
      for (const topo::HalfEdgeId h : rings[ring]) {
        ++rise[h.index()][ring];
        --rise[topo::Structure::twin(h).index()][ring];
      }
    }
    std::vector<topo::FaceId> open{topo::Structure::unbounded()};
    by_face_.emplace(open.front().index(), Counts());
    while (!open.empty()) {
      const topo::FaceId f = open.back();
      open.pop_back();
      for (const topo::LoopId loop : sub.loops(f)) {
        for (const topo::HalfEdgeId h : sub.half_edges(loop)) {
          const topo::FaceId beyond = sub.face(topo::Structure::twin(h));
          if (by_face_.contains(beyond.index())) continue;
          Counts counts = by_face_.at(f.index());
          if (const auto here = rise.find(h.index()); here != rise.end()) subtract(here->second, counts);
          by_face_.emplace(beyond.index(), std::move(counts));
          open.push_back(beyond);
        }
      }
    }
  }

  [[nodiscard]] const Counts& of(topo::FaceId face) const { return by_face_.at(face.index()); }

 private:
  static void subtract(const Counts& less, Counts& counts) {
    for (const auto& [ring, count] : less) {
      if ((counts[ring] -= count) == 0) counts.erase(ring);
    }
  }

  std::unordered_map<std::size_t, Counts> by_face_;
};

/// What may be missing where all of a ring's edges have been drawn to places within rounding of their own.
double rounding(const geom::Polyline& ring) {
  const geom::Box box = ring.box();
  const double greatest =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)});
  return 0x1p-40 * greatest * geom::length(ring);
}

}  // namespace

base::Result<std::vector<std::vector<std::uint32_t>>> Arrangement::holders(
    std::uint32_t first, const std::vector<std::string>& names) const {
  const Windings windings(subdivision_, std::span(paths_).subspan(first, names.size()));
  const std::vector<topo::FaceId> faces = subdivision_.faces();
  std::size_t highest = 0;
  for (const topo::FaceId f : faces) highest = std::max(highest, f.index());
  std::vector<std::vector<std::uint32_t>> holders(highest + 1);
  std::vector<double> areas;
  for (std::size_t ring = 0; ring < names.size(); ++ring) areas.push_back(geom::signed_area(lines_[first + ring]));
  std::vector<double> held(names.size(), 0.0);
  for (const topo::FaceId f : faces) {
    const Windings::Counts& counts = windings.of(f);
    const double area = counts.empty() ? 0.0 : this->area(f);
    for (const auto& [ring, count] : counts) {
      if ((count > 0) != (areas[ring] > 0.0)) continue;
      holders[f.index()].push_back(ring);
      held[ring] += area;
    }
  }
  for (std::size_t ring = 0; ring < names.size(); ++ring) {
    const geom::Polyline& course = lines_[first + ring];
    const double area = std::abs(areas[ring]);
    if (!(std::abs(held[ring] - area) > rounding(course))) continue;
    return base::Error{base::ErrorCode::CannotRestore,
                       fmt::format("its area is {:.9g} m2, and {:.9g} m2 where it lies upon the other lines; move its "
                                   "edges off those that they nearly coincide with, or onto them (share_edges)",
                                   area, held[ring]),
                       place_at(course.points.front(), names[ring])};
  }
  return holders;
}

namespace {

/// How a first line passes a second one: at each vertex that they share.
class Passage {
 public:
  Passage(const Arrangement& arrangement, std::uint32_t second) : sub_(arrangement.subdivision()) {
    const std::vector<topo::HalfEdgeId> path = arrangement.path(second);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const topo::VertexId from = sub_.origin(path[i]);
      ways_[from.index()].on = path[i];
      ways_[sub_.target(path[i]).index()].back = topo::Structure::twin(path[i]);
    }
  }

  [[nodiscard]] bool meets(topo::VertexId v) const { return ways_.count(v.index()) > 0; }

  /// Of a half-edge that leaves a shared vertex: 1 to the left of the second line, -1 to its right, 0 where that ends.
  [[nodiscard]] int side(topo::HalfEdgeId h) const {
    const Ways& ways = ways_.at(sub_.origin(h).index());
    if (!ways.on.valid() || !ways.back.valid()) return 0;
    const auto to = [&](topo::HalfEdgeId way) { return sub_.point(sub_.target(way)); };
    return topo::within(sub_.point(sub_.origin(h)), to(ways.on), to(ways.back), to(h)) ? 1 : -1;
  }

 private:
  struct Ways {
    topo::HalfEdgeId on;    ///< Leaves towards the end of the second line.
    topo::HalfEdgeId back;  ///< Towards its beginning.
  };
  const topo::Subdivision& sub_;
  std::unordered_map<std::size_t, Ways> ways_;
};

}  // namespace

base::Result<LineMeeting> meeting_of(const geom::Polyline& first, const geom::Polyline& second) {
  DOBRA_TRY(const Arrangement arrangement, Arrangement::make({first, second}));
  const topo::Subdivision& sub = arrangement.subdivision();
  const Passage passage(arrangement, 1);
  LineMeeting meeting;
  int came_from = 0;
  bool together = false;
  topo::VertexId met;
  const auto part = [&](int to) {
    const bool crosses = came_from * to < 0;
    if (meeting.touches + meeting.crossings == 0 || (crosses && meeting.crossings == 0)) meeting.place = sub.point(met);
    ++(crosses ? meeting.crossings : meeting.touches);
    together = false;
  };
  for (const topo::HalfEdgeId h : arrangement.path(0)) {
    const topo::VertexId from = sub.origin(h);
    const bool along = arrangement.runs_along(topo::Structure::edge(h), 1);
    if (!together && passage.meets(from)) {  // only where the first line begins on the second
      together = true;
      came_from = 0;
      met = from;
    }
    if (along) continue;
    if (together) part(passage.side(h));
    const topo::VertexId to = sub.target(h);
    if (!passage.meets(to)) continue;
    together = true;
    came_from = passage.side(topo::Structure::twin(h));
    met = to;
  }
  if (together) part(0);
  return meeting;
}

}  // namespace recon::section
