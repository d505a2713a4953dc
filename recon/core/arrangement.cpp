#include "recon/core/arrangement.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>

#include "shared/topo/insert.h"

namespace recon::core {

base::Result<Arrangement> Arrangement::make(std::vector<geom::Polyline> lines) {
  Arrangement made;
  DOBRA_TRY_VOID(made.add(std::move(lines)));
  return made;
}

base::Result<void> Arrangement::add(std::vector<geom::Polyline> lines) {
  const auto old = static_cast<std::uint32_t>(lines_.size());
  stretches_.add(lines);
  for (std::uint32_t i = 0; i < old; ++i) refine(i);
  std::move(lines.begin(), lines.end(), std::back_inserter(lines_));
  DOBRA_TRY_VOID(draw_from(old));
  if (chords_stand()) return {};
  // Rounded crossings have drawn lines, which drew others, beyond the margin: now every segment stands for itself.
  stretches_.cut_all();
  subdivision_ = {};
  drawn_.clear();
  chords_.clear();
  return draw_from(0);
}

base::Result<void> Arrangement::draw_from(std::uint32_t first) {
  for (std::uint32_t line = first; line < lines_.size(); ++line) DOBRA_TRY_VOID(draw(line));
  return {};
}

base::Result<void> Arrangement::draw(std::uint32_t line) {
  const std::vector<Stretch>& stretches = drawn_.emplace_back(stretches_.of(line));
  geom::Polyline drawn{{}, lines_[line].closed};
  for (const Stretch stretch : stretches) drawn.points.push_back(vertex_of(line, stretch.first));
  if (!drawn.closed && !stretches.empty()) drawn.points.push_back(lines_[line].points.back());
  DOBRA_TRY(const topo::Inserted inserted, topo::insert(subdivision_, stretches.empty() ? lines_[line] : drawn));
  for (const topo::HalfEdgeId h : inserted.path) own(topo::Structure::edge(h), line);
  mark_chords(line);
  return {};
}

/// Gives the line the vertices between its stretches that have been cut.
void Arrangement::refine(std::uint32_t line) {
  std::vector<Stretch> now = stretches_.of(line);
  if (now.size() == drawn_[line].size()) return;
  auto part = now.begin();
  for (const Stretch old : drawn_[line]) {
    if (part->last < old.last) {
      topo::HalfEdgeId h = chord_of(line, old);
      chords_[topo::Structure::edge(h).index()] = {};
      for (; part->last < old.last; ++part) {
        const topo::EdgeId edge = topo::Structure::edge(h);
        subdivision_.split(edge, vertex_of(line, part->last));
        if (topo::Structure::half_edge(edge) == h) h = subdivision_.next(h);  // otherwise h is what is left of it
      }
    }
    ++part;
  }
  drawn_[line] = std::move(now);
  mark_chords(line);
}

void Arrangement::mark_chords(std::uint32_t line) {
  for (const Stretch stretch : drawn_[line]) {
    if (stretch.is_segment()) continue;
    const topo::HalfEdgeId h = chord_of(line, stretch);
    if (!h.valid()) continue;  // chords_stand will tell
    const std::size_t edge = topo::Structure::edge(h).index();
    if (edge >= chords_.size()) chords_.resize(edge + edge / 2 + 1);
    chords_[edge] = {line, stretch};
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

void Arrangement::own(topo::EdgeId edge, std::uint32_t line) {
  std::vector<std::uint32_t> owners = lines_on(edge);
  if (std::binary_search(owners.begin(), owners.end(), line)) return;
  owners.insert(std::upper_bound(owners.begin(), owners.end(), line), line);
  const auto [known, is_new] = set_number_.try_emplace(owners, static_cast<std::uint32_t>(sets_.size()));
  if (is_new) sets_.push_back(std::move(owners));
  subdivision_.attribute(edge) = known->second;
}

const std::vector<std::uint32_t>& Arrangement::lines_on(topo::EdgeId edge) const {
  const auto* number = std::any_cast<std::uint32_t>(&subdivision_.attribute(edge));
  return sets_[number == nullptr ? 0 : *number];
}

bool Arrangement::runs_along(topo::EdgeId edge, std::uint32_t line) const {
  const std::vector<std::uint32_t>& owners = lines_on(edge);
  return std::binary_search(owners.begin(), owners.end(), line);
}

void Arrangement::append(topo::HalfEdgeId h, std::vector<geom::Point>& points) const {
  const std::size_t edge = topo::Structure::edge(h).index();
  const Chord chord = edge < chords_.size() ? chords_[edge] : Chord{};
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
  const geom::Polyline& course = lines_[line];
  const auto start = subdivision_.vertex_at(course.points.front());
  std::vector<topo::HalfEdgeId> path;
  if (!start) return path;
  const auto next_of = [&](topo::VertexId v, topo::HalfEdgeId arrived) {
    const topo::HalfEdgeId first = subdivision_.leaving(v);
    for (topo::HalfEdgeId h = first; h.valid();) {
      const bool back = arrived.valid() && h == topo::Structure::twin(arrived);
      if (!back && runs_along(topo::Structure::edge(h), line)) return h;
      h = subdivision_.turned(h);
      if (h == first) break;
    }
    return topo::HalfEdgeId();
  };
  for (topo::HalfEdgeId h = next_of(*start, {}); h.valid();) {
    path.push_back(h);
    const topo::VertexId v = subdivision_.target(h);
    if (v == *start || path.size() > subdivision_.edge_count()) break;
    h = next_of(v, h);
  }
  if (!course.closed || path.empty()) return path;
  // A ring has no first half-edge of its own: the second point decides the direction.
  std::vector<topo::HalfEdgeId> turned(path.size());
  std::transform(path.rbegin(), path.rend(), turned.begin(),
                 [](topo::HalfEdgeId h) { return topo::Structure::twin(h); });
  double area = 0.0;
  for (const topo::HalfEdgeId h : path) {
    const geom::Segment s = subdivision_.segment(h);
    area += geom::cross(s.from - course.points.front(), s.to - course.points.front());
  }
  return (area > 0.0) == (geom::signed_area(course) > 0.0) ? path : turned;
}

std::vector<bool> Arrangement::faces_within(std::uint32_t ring) const {
  std::size_t highest = 0;
  for (const topo::FaceId f : subdivision_.faces()) highest = std::max(highest, f.index());
  std::vector<bool> within(highest + 1, false);
  std::vector<topo::FaceId> open;
  const auto enter = [&](topo::FaceId f) {
    if (within[f.index()] || f == topo::Structure::unbounded()) return;
    within[f.index()] = true;
    open.push_back(f);
  };
  for (const topo::HalfEdgeId h : path(ring)) enter(subdivision_.face(h));
  while (!open.empty()) {
    const topo::FaceId f = open.back();
    open.pop_back();
    for (const topo::LoopId loop : subdivision_.loops(f)) {
      for (const topo::HalfEdgeId h : subdivision_.half_edges(loop)) {
        if (!runs_along(topo::Structure::edge(h), ring)) enter(subdivision_.face(topo::Structure::twin(h)));
      }
    }
  }
  return within;
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

}  // namespace recon::core
